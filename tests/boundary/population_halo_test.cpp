#include "boundary/periodic.hpp"
#include "boundary/population_halo.hpp"
#include "lattice/block_samples.hpp"

#include <catch2/catch.hpp>

#include <deque>
#include <random>
#include <vector>

using namespace vesica;
using namespace vesica::test;

namespace {

constexpr double nobody = -1.0;

/// One block of populations whose collision leaves them as they are.
struct FlyingBlock {
    Block block;
    Grid grid;
    Field<double> field;
    PopulationView<double> f;
    PeriodicBoundary<double> own_faces;
    PopulationHalo<double> halo;
    std::vector<HaloPart> parts;

    explicit FlyingBlock(const Block& b)
        : block(b),
          grid(b.own.size),
          field(direction_count, grid.cells()),
          f(field.view(), grid),
          own_faces(f, grid),
          halo(f, grid, b),
          parts(halo_parts(b)) {
        for (int i = 0; i < direction_count; ++i)
            std::fill_n(f.slot(i), grid.cells(), nobody);
    }

    template <class Body>
    void for_each_cell(const Body& body) const {
        for (int z = 0; z < grid.size().z; ++z)
            for (int y = 0; y < grid.size().y; ++y)
                for (int x = 0; x < grid.size().x; ++x)
                    body(Vec3<int>{x, y, z});
    }

    template <Streaming streaming>
    void fly() {
        for_each_cell([&](const Vec3<int>& x) {
            double g[direction_count];
            for_each_direction(
                [&](auto i) { g[i] = *f.arriving<streaming, decltype(i)::value>(grid.index(x)); });
            for_each_direction(
                [&](auto i) { *f.departing<streaming, decltype(i)::value>(grid.index(x)) = g[i]; });
        });
    }

    void publish_own_faces() const {
        const Vec3<int> size = grid.size();
        for (int z = 0; z < size.z && !block.divided.x; ++z)
            for (int y = 0; y < size.y; ++y)
                own_faces.publish_row(y, z);
        for (int z = 0; z < size.z && !block.divided.y; ++z)
            own_faces.publish_y(z);
        for (int y = -1; y <= size.y && !block.divided.z; ++y)
            own_faces.publish_z(y);
    }
    void collect_own_faces() const {
        const Vec3<int> size = grid.size();
        for (int y = -1; y <= size.y && !block.divided.z; ++y)
            own_faces.collect_z(y);
        for (int z = 0; z < size.z && !block.divided.y; ++z)
            own_faces.collect_y(z);
        for (int z = 0; z < size.z && !block.divided.x; ++z)
            for (int y = 0; y < size.y; ++y)
                own_faces.collect_row(y, z);
    }
};

struct FlyingBox {
    CutBox cut;
    std::deque<FlyingBlock> blocks;

    explicit FlyingBox(const CutBox& c) : cut(c) {
        for (int k = 0; k < cut.count(); ++k)
            blocks.emplace_back(cut.block(k));
    }

    /// Messages go out before any block has closed its own faces, as they do between ranks.
    template <Streaming streaming>
    void step() {
        std::vector<std::vector<std::vector<double>>> messages;
        for (FlyingBlock& block : blocks) {
            block.fly<streaming>();
            auto& sent = messages.emplace_back();
            for (const HaloPart& part : block.parts) {
                sent.emplace_back(static_cast<std::size_t>(block.halo.numbers(part)), nobody);
                if (streaming == Streaming::arrived)
                    block.halo.pack_to_publish(part, sent.back().data());
                else
                    block.halo.pack_to_collect(part, sent.back().data());
            }
        }
        for (int self = 0; self < cut.count(); ++self) {
            FlyingBlock& block = blocks[static_cast<std::size_t>(self)];
            if (streaming == Streaming::arrived)
                block.publish_own_faces();
            for (const HaloPart& part : block.parts) {
                const auto other = static_cast<std::size_t>(cut.neighbour(self, part.link));
                const std::size_t theirs = opposite_part(blocks[other].parts, part.link);
                const std::vector<double>& message = messages[other][theirs];
                REQUIRE(message.size() == static_cast<std::size_t>(block.halo.numbers(part)));
                if (streaming == Streaming::arrived)
                    block.halo.unpack_published(part, message.data());
                else
                    block.halo.unpack_collected(part, message.data());
            }
            if (streaming == Streaming::turned)
                block.collect_own_faces();
        }
    }
};

} // namespace

TEST_CASE("populations fly through a box cut into blocks as through a whole one", "[boundary]") {
    for (const CutBox& cut : cut_boxes()) {
        INFO("box " << cut.box.x << " x " << cut.box.y << " x " << cut.box.z);
        FlyingBox box(cut);
        std::mt19937_64 random(13);
        std::uniform_real_distribution<double> any(0.0, 1.0);
        const auto at = [&](const Vec3<int>& cell, int i, int steps) {
            Vec3<int> home{};
            for (int a = 0; a < 3; ++a)
                home[a] = (((cell[a] - steps * velocity(i, a)) % cut.box[a]) + cut.box[a]) % cut.box[a];
            return static_cast<std::size_t>(home.x + cut.box.x * (home.y + cut.box.y * home.z));
        };
        std::vector<std::vector<double>> start(direction_count, std::vector<double>(static_cast<std::size_t>(
                                                                    cut.box.x * cut.box.y * cut.box.z)));
        for (auto& population : start)
            for (double& value : population)
                value = any(random);
        for (FlyingBlock& block : box.blocks)
            for (int i = 0; i < direction_count; ++i)
                block.for_each_cell([&](const Vec3<int>& x) {
                    block.f.slot(i)[block.grid.index(x)] =
                        start[static_cast<std::size_t>(i)][at(x + block.block.own.begin, i, 0)];
                });
        for (int steps = 1; steps <= 12; ++steps) {
            if (steps % 2 == 1)
                box.step<Streaming::arrived>();
            else
                box.step<Streaming::turned>();
            const Streaming now = steps % 2 == 1 ? Streaming::turned : Streaming::arrived;
            int wrong = 0;
            for (const FlyingBlock& block : box.blocks)
                for (int i = 0; i < direction_count; ++i)
                    block.for_each_cell([&](const Vec3<int>& x) {
                        const double found = *block.f.find(now, i, block.grid.index(x));
                        const double expected =
                            start[static_cast<std::size_t>(i)][at(x + block.block.own.begin, i, steps)];
                        wrong += found == expected ? 0 : 1;
                    });
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("only the populations that cross a face or an edge travel", "[boundary]") {
    const auto numbers = [](const Vec3<int>& size, const Vec3<bool>& divided) {
        Block block;
        block.box = {100, 100, 100};
        block.own.size = size;
        block.divided = divided;
        const FlyingBlock flying(block);
        std::int64_t sum = 0;
        for (const HaloPart& part : flying.parts)
            sum += flying.halo.numbers(part);
        return sum;
    };
    // Five of nineteen through each of two faces.
    CHECK(numbers({12, 11, 10}, {false, false, true}) == 2 * 5 * 12 * 11);
    // By hand, for a cube of n cells cut off on all sides: per face one population straight on and four
    // aslant, of which a row each crosses an edge instead; one through each of twelve edges.
    const int n = 10;
    CHECK(numbers({n, n, n}, {true, true, true}) == 6 * (n * n + 4 * n * (n - 1)) + 12 * n);
}
