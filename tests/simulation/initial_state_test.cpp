#include "shape/shape.hpp"
#include "simulation/initial_state.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

namespace {

std::vector<InitialColours::Placed> close_and_tilted() {
    VesicleParameters vesicle;
    vesicle.radius = 8.0;
    vesicle.shape = HelfrichShape{HelfrichBranch::discocyte, 0.65};
    std::vector<InitialColours::Placed> shapes;
    const Vec3<double> axes[] = {{0.0, 0.0, 1.0}, {1.0, 0.4, 0.2}, {0.3, -1.0, 0.5}};
    const Vec3<double> centres[] = {{14.0, 15.0, 14.0}, {15.0, 16.0, 28.0}, {38.0, 3.0, 20.0}};
    for (int k = 0; k < 3; ++k) {
        vesicle.axis = axes[k];
        vesicle.centre = centres[k];
        shapes.push_back({make_shape(vesicle), vesicle.centre, 0});
    }
    return shapes;
}

} // namespace

TEST_CASE("the colours of a cell follow the nearest of all surfaces and their images") {
    const Grid grid({40, 36, 44});
    const double beta = 0.67;
    const double cutoff = 1e-2;
    const auto shapes = close_and_tilted();
    const InitialColours colours(Block::whole(grid.size()), shapes, beta, cutoff, 1);
    const Vec3<int> n = grid.size();
    const double reach = std::atanh(std::sqrt(1.0 - cutoff)) / beta;
    int between = 0; // cells whose nearest surface is not that of the nearest bounding sphere
    std::size_t seed = 0;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x0 = 0; x0 < n.x; x0 += Grid::tile) {
                unsigned core = 0;
                unsigned red = 0;
                for (int k = 0; k < Grid::tile && x0 + k < n.x; ++k) {
                    double nearest = 1e9;
                    double nearest_sphere = 1e9;
                    double of_nearest_sphere = 0.0;
                    for (const auto& placed : shapes)
                        for (int image = 0; image < 27; ++image) {
                            const Vec3<double> at{x0 + k + 0.5 + n.x * (image % 3 - 1),
                                                  y + 0.5 + n.y * (image / 3 % 3 - 1),
                                                  z + 0.5 + n.z * (image / 9 - 1)};
                            const double sphere = norm(at - placed.centre) - placed.shape->bounding_radius();
                            if (sphere > 12.0)
                                continue;
                            const double s = placed.shape->signed_distance(at);
                            nearest = std::min(nearest, s);
                            if (sphere < nearest_sphere) {
                                nearest_sphere = sphere;
                                of_nearest_sphere = s;
                            }
                        }
                    between += nearest < of_nearest_sphere && nearest < 6.0 ? 1 : 0;
                    red |= (nearest < 0.0 ? 1u : 0u) << k;
                    core |= (std::abs(nearest) < reach ? 1u : 0u) << k;
                    if (nearest < 12.0) {
                        const double minor = 1.0 / (1.0 + std::exp(2.0 * beta * std::abs(nearest)));
                        CHECK(colours.chi_at(grid.index(x0 + k, y, z), 0) ==
                              Approx(nearest < 0.0 ? -minor : minor).epsilon(1e-12));
                    }
                }
                const std::int64_t tile = grid.index(x0, y, z) / Grid::tile;
                CHECK((colours.interior()[static_cast<std::size_t>(tile)] == 0) ==
                      (red == grid.interior_bits({x0, y, z})));
                if (core == 0)
                    continue;
                REQUIRE(seed < colours.core().size());
                CHECK(colours.core()[seed].tile == tile);
                CHECK(colours.core()[seed].bits == core);
                ++seed;
            }
    CHECK(seed == colours.core().size());
    CHECK(between > 20);
}

TEST_CASE("the colours do not depend on the threads that found them") {
    const Grid grid({40, 36, 44});
    const InitialColours one(Block::whole(grid.size()), close_and_tilted(), 0.67, 1e-2, 1);
    const InitialColours three(Block::whole(grid.size()), close_and_tilted(), 0.67, 1e-2, 3);
    CHECK(one.interior() == three.interior());
    REQUIRE(one.core().size() == three.core().size());
    for (std::size_t k = 0; k < one.core().size(); ++k) {
        CHECK(one.core()[k].tile == three.core()[k].tile);
        CHECK(one.core()[k].bits == three.core()[k].bits);
    }
}
