#include "measure/suspension_profile.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace vesica;

namespace {

struct Fields {
    DenseField phase;
    DenseField velocity;
};

Fields fields(const Vec3<int>& size, const std::function<double(const Vec3<double>&)>& phase,
              const std::function<double(const Vec3<double>&)>& velocity, int along) {
    Fields f{{size, 1, {}}, {size, 3, {}}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const Vec3<double> centre{x + 0.5, y + 0.5, z + 0.5};
                f.phase.values.push_back(phase(centre));
                for (int a = 0; a < 3; ++a)
                    f.velocity.values.push_back(a == along ? velocity(centre) : 77.0);
            }
    return f;
}

} // namespace

TEST_CASE("a slab between walls: its place, its velocity, and how far it stays away") {
    const double lower = 5.3;
    const double upper = 14.1;
    const auto phase = [&](const Vec3<double>& x) {
        return std::tanh(std::min(x.z - lower, upper - x.z));
    };
    const auto velocity = [](const Vec3<double>& x) {
        return 0.01 * x.z * (20.0 - x.z);
    };
    const Fields f = fields({6, 4, 20}, phase, velocity, 1);
    const ProfileOutput output{1, 1, 2};
    const SuspensionProfile profile = suspension_profile(f.phase, f.velocity, nullptr, output, true);
    REQUIRE(profile.bins.size() == 20);
    double inside = 0.0;
    double flow = 0.0;
    double inner_flow = 0.0;
    for (int k = 0; k < 20; ++k) {
        const ProfileBin& bin = profile.bins[static_cast<std::size_t>(k)];
        const Vec3<double> place{0.0, 0.0, k + 0.5};
        CHECK(bin.position == k + 0.5);
        CHECK(bin.cells == 24);
        CHECK(bin.haematocrit == Approx(0.5 * (1.0 + phase(place))));
        CHECK(bin.velocity == Approx(velocity(place)));
        inside += bin.haematocrit / 20.0;
        flow += bin.velocity / 20.0;
        inner_flow += bin.haematocrit * bin.velocity / 20.0;
    }
    CHECK(profile.haematocrit == Approx(inside));
    CHECK(profile.velocity == Approx(flow));
    CHECK(profile.discharge_haematocrit == Approx(inner_flow / flow));
    CHECK(profile.discharge_haematocrit > profile.haematocrit); // the middle is faster
    CHECK(profile.cell_free_layer == Approx(0.5 * (lower + 20.0 - upper)).margin(0.05));
    CHECK(std::isnan(suspension_profile(f.phase, f.velocity, nullptr, output, false).cell_free_layer));
}

TEST_CASE("a core in a tube: only its fluid counts, by the distance from the middle line") {
    const Vec3<int> size{8, 40, 40};
    const double wall = 18.0;
    const double core = 13.0;
    SolidVoxels solids(size);
    const auto radius = [](const Vec3<double>& x) {
        return std::hypot(x.y - 20.0, x.z - 20.0);
    };
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 8; ++x)
                if (radius({x + 0.5, y + 0.5, z + 0.5}) > wall)
                    solids.set({x, y, z});
    const Fields f = fields(
        size, [&](const Vec3<double>& x) { return std::tanh(3.0 * (core - radius(x))); },
        [&](const Vec3<double>& x) { return 1.0 - std::pow(radius(x) / wall, 2); }, 0);
    const SuspensionProfile profile = suspension_profile(f.phase, f.velocity, &solids, {1, 0, -1}, false);
    REQUIRE(profile.bins.size() == 18);
    std::int64_t cells = 0;
    for (const ProfileBin& bin : profile.bins) {
        cells += bin.cells;
        CHECK(bin.velocity == Approx(1.0 - std::pow(bin.position / wall, 2)).margin(0.03));
        if (bin.position < core - 1.5)
            CHECK(bin.haematocrit > 0.99);
        if (bin.position > core + 1.5)
            CHECK(bin.haematocrit < 0.01);
    }
    CHECK(cells == static_cast<std::int64_t>(8 * 40 * 40 - solids.count()));
    CHECK(profile.haematocrit == Approx(std::pow(core / wall, 2)).epsilon(0.02));
    CHECK(profile.cell_free_layer == Approx(wall - core).margin(0.3));
    CHECK(std::isnan(profile.bins.back().inner_velocity));
}

TEST_CASE("a vesicle that touches a wall leaves no free layer there") {
    const auto phase = [](const Vec3<double>& x) {
        return x.z < 4.0 || (x.z > 7.0 && x.z < 9.0) ? 1.0 : -1.0;
    };
    const Fields f = fields(
        {2, 2, 12}, phase, [](const Vec3<double>&) { return 0.0; }, 0);
    const SuspensionProfile profile = suspension_profile(f.phase, f.velocity, nullptr, {1, 0, 2}, true);
    CHECK(profile.cell_free_layer == Approx(0.5 * (0.0 + 3.0)));
    CHECK(std::isnan(profile.discharge_haematocrit)); // nothing flows
}
