#include "lattice/populations.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <type_traits>
#include <vector>

using namespace vesica;

namespace {

/// A number that names the population, its cell and nothing else.
double name_of(int i, const Vec3<int>& x) {
    return i + 19.0 * ((x.x + 50) + 100.0 * ((x.y + 50) + 100.0 * (x.z + 50)));
}

template <class Body>
void for_each_cell(const Vec3<int>& begin, const Vec3<int>& end, const Body& body) {
    for (int z = begin.z; z < end.z; ++z)
        for (int y = begin.y; y < end.y; ++y)
            for (int x = begin.x; x < end.x; ++x)
                body(Vec3<int>{x, y, z});
}

/// Streams without colliding, on every cell in [begin, end).
template <Streaming streaming>
void stream(const PopulationView<double>& f, const Grid& grid, const Vec3<int>& begin, const Vec3<int>& end) {
    for_each_cell(begin, end, [&](const Vec3<int>& x) {
        const std::int64_t cell = grid.index(x);
        double g[direction_count];
        for_each_direction([&](auto i) { g[i] = *f.arriving<streaming, decltype(i)::value>(cell); });
        for_each_direction([&](auto i) { *f.departing<streaming, decltype(i)::value>(cell) = g[i]; });
    });
}

Vec3<int> moved(const Vec3<int>& x, int i, int cells) {
    return {x.x + cells * velocity(i, 0), x.y + cells * velocity(i, 1), x.z + cells * velocity(i, 2)};
}

} // namespace

TEST_CASE("an arrived and a turned step without collision move every population by one cell each",
          "[lattice]") {
    const Vec3<int> size{11, 9, 7};
    const Grid grid(size);
    Field<double> field(direction_count, grid.cells());
    const PopulationView<double> f(field.view(), grid);
    for (int i = 0; i < direction_count; ++i)
        for_each_cell({-1, -1, -1}, {size.x + 1, size.y + 1, size.z + 1},
                      [&](const Vec3<int>& x) { f.slot(i)[grid.index(x)] = name_of(i, x); });

    stream<Streaming::arrived>(f, grid, {0, 0, 0}, size);
    bool one_cell = true;
    for (int i = 0; i < direction_count; ++i)
        for_each_cell({1, 1, 1}, {size.x - 1, size.y - 1, size.z - 1}, [&](const Vec3<int>& x) {
            one_cell =
                one_cell && *f.find(Streaming::turned, i, grid.index(x)) == name_of(i, moved(x, i, -1));
        });
    CHECK(one_cell);

    stream<Streaming::turned>(f, grid, {0, 0, 0}, size);
    bool two_cells = true;
    for (int i = 0; i < direction_count; ++i)
        for_each_cell({2, 2, 2}, {size.x - 2, size.y - 2, size.z - 2}, [&](const Vec3<int>& x) {
            two_cells =
                two_cells && *f.find(Streaming::arrived, i, grid.index(x)) == name_of(i, moved(x, i, -2));
        });
    CHECK(two_cells);
}

TEST_CASE("a cell reads and writes the same places, and no two cells share one", "[lattice]") {
    const Vec3<int> size{5, 4, 3};
    const Grid grid(size);
    Field<double> field(direction_count, grid.cells());
    const PopulationView<double> f(field.view(), grid);
    const auto check = [&]<Streaming streaming>(std::integral_constant<Streaming, streaming>) {
        std::vector<const double*> read;
        std::vector<const double*> written;
        for_each_cell({0, 0, 0}, size, [&](const Vec3<int>& x) {
            std::vector<const double*> from;
            std::vector<const double*> to;
            for_each_direction([&](auto i) {
                from.push_back(f.arriving<streaming, decltype(i)::value>(grid.index(x)));
                to.push_back(f.departing<streaming, decltype(i)::value>(grid.index(x)));
                CHECK(from.back() == f.find(streaming, decltype(i)::value, grid.index(x)));
            });
            std::sort(from.begin(), from.end());
            std::sort(to.begin(), to.end());
            CHECK(from == to);
            read.insert(read.end(), from.begin(), from.end());
        });
        std::sort(read.begin(), read.end());
        CHECK(std::adjacent_find(read.begin(), read.end()) == read.end());
    };
    check(std::integral_constant<Streaming, Streaming::arrived>{});
    check(std::integral_constant<Streaming, Streaming::turned>{});
}
