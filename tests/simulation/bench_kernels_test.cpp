#include "core/input_error.hpp"
#include "simulation/bench_kernels.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <map>
#include <set>
#include <vector>

using namespace vesica;

namespace {

using Displacement = std::array<int, 3>;

struct Cell {
    int x = 0;
    int y = 0;
    int z = 0;
    std::ptrdiff_t in(const BenchBox& box) const {
        return box.first_cell() + x + y * box.row_stride + z * box.layer_stride;
    }
};

/// Where a mark on direction i of `from` is after an even and an odd step; fails unless it stayed whole.
template <class Real>
Displacement travel(const BenchKernels<Real>& kernels, const BenchBox& box, const Cell& from, int i) {
    std::vector<Real> f(box.numbers(), Real(1));
    f[static_cast<std::size_t>(i * box.direction_stride + from.in(box))] = Real(5);
    kernels.stream_even(box, f.data(), 2);
    kernels.stream_odd(box, f.data(), 2);

    // Each step halves what stands out above one.
    int marks = 0;
    Displacement found{};
    for (int z = 0; z < box.cells_per_edge; ++z)
        for (int y = 0; y < box.cells_per_edge; ++y)
            for (int x = 0; x < box.cells_per_edge; ++x) {
                const std::ptrdiff_t cell = Cell{x, y, z}.in(box);
                for (int j = 0; j < direction_count; ++j) {
                    const Real value = f[static_cast<std::size_t>(j * box.direction_stride + cell)];
                    if (value == Real(1))
                        continue;
                    ++marks;
                    REQUIRE(value == Real(2));
                    REQUIRE(j == i);
                    found = {x - from.x, y - from.y, z - from.z};
                }
            }
    REQUIRE(marks == 1);
    return found;
}

std::vector<std::string> instruction_sets_here() {
    std::vector<std::string> names;
    for (const char* name : {"baseline", "avx2", "avx512"}) {
        try {
            bench_kernels<double>(name);
            names.emplace_back(name);
        } catch (const InputError&) {
        }
    }
    return names;
}

} // namespace

TEST_CASE("streaming in place moves every population one cell per step along its own direction of D3Q19") {
    const BenchBox box(16);
    for (const std::string& name : instruction_sets_here()) {
        std::set<Displacement> seen;
        std::map<int, int> by_length;
        for (int i = 0; i < direction_count; ++i) {
            const Displacement in_double = travel(bench_kernels<double>(name), box, {7, 8, 9}, i);
            CHECK(in_double == travel(bench_kernels<float>(name), box, {7, 8, 9}, i));
            seen.insert(in_double);
            int square = 0;
            for (const int component : in_double)
                square += component * component / 4;
            ++by_length[square];
        }
        CHECK(seen.size() == 19);
        CHECK(by_length == std::map<int, int>{{0, 1}, {1, 6}, {2, 12}});
    }
}

TEST_CASE("the read-modify-write pass touches every population of every cell once") {
    const BenchBox box(16);
    std::vector<double> f(box.numbers(), 0.0);
    bench_kernels<double>().fill(box, f.data(), 2);
    for (double& value : f)
        value = 3.0;
    bench_kernels<double>().read_modify_write(box, f.data(), 2);
    for (int i = 0; i < direction_count; ++i)
        for (int z = 0; z < 16; ++z)
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x)
                    REQUIRE(f[static_cast<std::size_t>(i * box.direction_stride + Cell{x, y, z}.in(box))] ==
                            2.0);
}

TEST_CASE("directions never lie a power of two apart") {
    for (const int edge : {32, 64, 112, 128, 240, 256}) {
        const auto stride = static_cast<std::size_t>(BenchBox(edge).direction_stride);
        CHECK((stride & (stride - 1)) != 0);
        CHECK(stride % 32 == 16);
    }
}

TEST_CASE("an instruction set that does not exist is the user's error") {
    CHECK_THROWS_AS(bench_kernels<double>("sse9"), InputError);
}
