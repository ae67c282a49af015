#include "core/input_error.hpp"
#include "io/checkpoint.hpp"
#include "io/scratch_directory.hpp"
#include "simulation/block_plan.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <numeric>

using namespace vesica;
using namespace vesica::test;

namespace {

template <class CountsOf>
PlaneCounts over_blocks(const BlockLayout& layout, const CountsOf& counts_of) {
    PlaneCounts sum;
    for (std::size_t a = 0; a < 3; ++a)
        sum[a].assign(static_cast<std::size_t>(layout.box()[static_cast<int>(a)]), 0);
    const Vec3<int> n = layout.blocks();
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) {
                const PlaneCounts part = counts_of(layout.block({x, y, z}));
                for (std::size_t a = 0; a < 3; ++a)
                    for (std::size_t k = 0; k < sum[a].size(); ++k)
                        sum[a][k] += part[a].at(k);
            }
    return sum;
}

/// From a saved state of the whole box.
PlaneCounts core_of(const EngineState& state) {
    PlaneCounts counts;
    for (std::size_t a = 0; a < 3; ++a)
        counts[a].assign(static_cast<std::size_t>(state.size[static_cast<int>(a)]), 0);
    std::size_t at = 0;
    for (std::size_t z = 0; z < counts[2].size(); ++z)
        for (std::size_t y = 0; y < counts[1].size(); ++y)
            for (std::size_t x = 0; x < counts[0].size(); ++x)
                if ((state.band[at++] & 1) != 0) {
                    ++counts[0][x];
                    ++counts[1][y];
                    ++counts[2][z];
                }
    return counts;
}

/// Where two slabs along z meet, of a box of ninety planes with so many core cells in some of them.
int cut_between_two(const std::vector<int>& planes, std::uint64_t cells) {
    const Vec3<int> box{20, 20, 90};
    BlockLayout layout(box, {1, 1, 2});
    PlaneCounts core;
    for (std::size_t a = 0; a < 3; ++a)
        core[a].assign(static_cast<std::size_t>(box[static_cast<int>(a)]), 0);
    for (const int plane : planes)
        core[2][static_cast<std::size_t>(plane)] = cells;
    balance_by_interface(layout, core);
    return layout.cut(2, 1);
}

} // namespace

TEST_CASE(
    "the core that blocks find in their parts is that of the whole box, in a case and in a checkpoint") {
    Parameters parameters = deforming_spheroid();
    parameters.size = {44, 40, 42};
    parameters.vesicles.front().centre = {41.0, 2.0, 17.0}; // over periodic faces
    const auto engine = make_engine(parameters, 1);
    const PlaneCounts expected = core_of(engine->save());
    REQUIRE(std::accumulate(expected[0].begin(), expected[0].end(), std::uint64_t{0}) > 1000);
    const ScratchDirectory scratch;
    Checkpoint checkpoint;
    checkpoint.engine = engine->save();
    write_checkpoint(scratch / "a.h5", checkpoint);
    for (const Vec3<int>& blocks : {Vec3<int>{1, 1, 1}, Vec3<int>{2, 2, 2}, Vec3<int>{4, 1, 3}}) {
        const BlockLayout layout(parameters.size, blocks);
        CHECK(over_blocks(layout, [&](const Block& block) { return core_of_case(parameters, block, 1); }) ==
              expected);
        CHECK(over_blocks(layout, [&](const Block& block) {
                  return core_of_checkpoint(scratch / "a.h5", block);
              }) == expected);
    }
}

TEST_CASE("blocks are balanced by the band around the core, across the periodic face, and it costs more than "
          "fluid") {
    CHECK(cut_between_two({}, 0) == 45);
    // The band of a core at the end lies about as much in either slab.
    CHECK(std::abs(cut_between_two({0}, 400) - 45) <= 2);
    CHECK(std::abs(cut_between_two({89}, 400) - 45) <= 2);
    // The more of the band a slab holds, the fewer planes.
    const std::vector<int> low{12, 13, 14, 15};
    CHECK(cut_between_two(low, 50) < 43);
    CHECK(cut_between_two(low, 200) < cut_between_two(low, 50));
}

TEST_CASE("ranks that a box cannot hold are told what it could, and which axis images slide along") {
    const auto refusal = [](const std::optional<Vec3<int>>& blocks, const std::optional<Slide>& slide) {
        try {
            layout_for({64, 16, 16}, 4, blocks, slide);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    CHECK(refusal({}, {}) == "none");
    CHECK_THAT(refusal({}, Slide{2, 0}),
               Catch::Contains("lattice.size is 64 x 16 x 16; expected a box that 4 ranks can share") &&
                   Catch::Contains("of which there is one along x, where the images slide; try mpirun -n 1"));
    CHECK_THAT(refusal(Vec3<int>{4, 1, 1}, Slide{2, 0}),
               Catch::Contains("--blocks is 4,1,1; expected one block along x"));
}
