#include "boundary/periodic.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace vesica;

namespace {

const Vec3<int> odd_boxes[] = {{1, 1, 1}, {3, 1, 7}, {1, 9, 3}, {7, 3, 1}, {8, 8, 8}, {9, 17, 7}};

int wrapped(int x, int size) {
    return ((x % size) + size) % size;
}

template <class Body>
void for_each_cell(const Vec3<int>& size, const Body& body) {
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                body(Vec3<int>{x, y, z});
}

/// Populations of a periodic box, whose collision leaves them as they are, and their boundary.
struct FreeFlight {
    Grid grid;
    Field<double> field;
    PopulationView<double> f;
    PeriodicBoundary<double> boundary;

    explicit FreeFlight(const Vec3<int>& size)
        : grid(size), field(direction_count, grid.cells()), f(field.view(), grid), boundary(f, grid) {
        for (int i = 0; i < direction_count; ++i)
            std::fill_n(f.slot(i), grid.cells(), -1.0);
    }

    template <Streaming streaming>
    void step() {
        const Vec3<int> size = grid.size();
        for_each_cell(size, [&](const Vec3<int>& x) {
            double g[direction_count];
            for_each_direction(
                [&](auto i) { g[i] = *f.arriving<streaming, decltype(i)::value>(grid.index(x)); });
            for_each_direction(
                [&](auto i) { *f.departing<streaming, decltype(i)::value>(grid.index(x)) = g[i]; });
        });
        if constexpr (streaming == Streaming::arrived) {
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    boundary.publish_row(y, z);
            for (int z = 0; z < size.z; ++z)
                boundary.publish_y(z);
            for (int y = -1; y <= size.y; ++y)
                boundary.publish_z(y);
        } else {
            for (int y = -1; y <= size.y; ++y)
                boundary.collect_z(y);
            for (int z = 0; z < size.z; ++z)
                boundary.collect_y(z);
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    boundary.collect_row(y, z);
        }
    }
};

} // namespace

TEST_CASE("what leaves a periodic box on one side enters it on the other, step after step, in any box",
          "[boundary]") {
    for (const Vec3<int>& size : odd_boxes) {
        INFO("box " << size.x << " x " << size.y << " x " << size.z);
        FreeFlight box(size);
        std::mt19937_64 random(12);
        std::uniform_real_distribution<double> any(0.0, 1.0);
        const auto at = [&](int x, int y, int z) {
            return static_cast<std::size_t>(wrapped(x, size.x) +
                                            size.x * (wrapped(y, size.y) + size.y * wrapped(z, size.z)));
        };
        std::vector<std::vector<double>> start(
            direction_count, std::vector<double>(static_cast<std::size_t>(size.x * size.y * size.z)));
        for (int i = 0; i < direction_count; ++i)
            for_each_cell(size, [&](const Vec3<int>& x) {
                start[static_cast<std::size_t>(i)][at(x.x, x.y, x.z)] = any(random);
                box.f.slot(i)[box.grid.index(x)] = start[static_cast<std::size_t>(i)][at(x.x, x.y, x.z)];
            });

        const auto misplaced_after = [&](int steps, Streaming streaming) {
            int wrong = 0;
            for (int i = 0; i < direction_count; ++i)
                for_each_cell(size, [&](const Vec3<int>& x) {
                    const std::size_t origin = at(x.x - steps * velocity(i, 0), x.y - steps * velocity(i, 1),
                                                  x.z - steps * velocity(i, 2));
                    const double found = *box.f.find(streaming, i, box.grid.index(x));
                    wrong += found != start[static_cast<std::size_t>(i)][origin] ? 1 : 0;
                });
            return wrong;
        };
        for (int steps = 1; steps <= 12; ++steps) {
            if (steps % 2 == 1)
                box.step<Streaming::arrived>();
            else
                box.step<Streaming::turned>();
            CHECK(misplaced_after(steps, steps % 2 == 1 ? Streaming::turned : Streaming::arrived) == 0);
        }
    }
}
