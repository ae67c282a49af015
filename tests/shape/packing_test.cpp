#include "shape/packing.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace vesica;

namespace {

std::shared_ptr<const Shape> shape(const ShapeParameters& what, double radius) {
    VesicleParameters vesicle;
    vesicle.shape = what;
    vesicle.radius = radius;
    return make_shape(vesicle);
}

PackingTask task_in(const Vec3<double>& size, const ShapeParameters& what, double radius, std::size_t count) {
    PackingTask task;
    task.size = size;
    task.end = size;
    task.kinds = {shape(what, radius)};
    task.count = count;
    task.gap = 3.0;
    task.end_gaps = {3.0, 3.0, 3.0};
    task.first_axis = [](RandomNumbers& random) {
        return random.direction();
    };
    return task;
}

/// The least sum of distances to both, over a fine grid around the second: their gap, found from nothing the
/// packing uses.
double gap_of(const Shape& a, const PackedBody& at_a, const Shape& b, const PackedBody& at_b,
              const Vec3<double>& size, const std::array<bool, 3>& periodic) {
    const Frame frame_a = Frame::along(at_a.axis);
    const Frame frame_b = Frame::along(at_b.axis);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 27; ++k) {
        const Vec3<int> image{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        Vec3<double> centre = at_b.centre;
        bool exists = true;
        for (int axis = 0; axis < 3; ++axis) {
            exists = exists && (image[axis] == 0 || periodic[static_cast<std::size_t>(axis)]);
            centre[axis] += image[axis] * size[axis];
        }
        const double reach = b.bounding_radius() + 4.0;
        if (!exists || norm(centre - at_a.centre) > a.bounding_radius() + reach)
            continue;
        for (double z = -reach; z <= reach; z += 0.75)
            for (double y = -reach; y <= reach; y += 0.75)
                for (double x = -reach; x <= reach; x += 0.75) {
                    const Vec3<double> r{x, y, z};
                    const double from_a = a.signed_distance(frame_a.components(centre + r - at_a.centre));
                    if (from_a < least)
                        least = std::min(least, from_a + b.signed_distance(frame_b.components(r)));
                }
    }
    return least;
}

double least_gap(const PackingTask& task, const PackingResult& packed) {
    std::vector<PackedBody> all = task.fixed;
    all.insert(all.end(), packed.bodies.begin(), packed.bodies.end());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b)
            least = std::min(least, gap_of(*task.kinds[all[a].kind], all[a], *task.kinds[all[b].kind], all[b],
                                           task.size, task.periodic));
    return least;
}

} // namespace

TEST_CASE("packed discocytes keep their gaps, through periodic edges too") {
    const PackingTask task =
        task_in({56.0, 60.0, 52.0}, HelfrichShape{HelfrichBranch::discocyte, 0.65}, 10.0, 10);
    const PackingResult packed = pack(task);
    REQUIRE(packed.scale == 1.0);
    REQUIRE(packed.bodies.size() == 10);
    CHECK(least_gap(task, packed) > 2.9);
    for (const PackedBody& body : packed.bodies) {
        CHECK(norm(body.axis) == Approx(1.0));
        for (int a = 0; a < 3; ++a)
            CHECK((body.centre[a] >= 0.0 && body.centre[a] < task.size[a]));
    }
}

TEST_CASE("the same packing gives the same bits, and another seed another one") {
    PackingTask task = task_in({40.0, 40.0, 40.0}, SpheroidShape{0.6}, 6.0, 9);
    task.turning = GENERATE(false, true);
    if (!task.turning)
        task.first_axis = [](RandomNumbers&) {
            return Vec3<double>{0.0, 0.0, 1.0};
        };
    const PackingResult first = pack(task);
    const PackingResult second = pack(task);
    REQUIRE(first.scale == 1.0);
    for (std::size_t k = 0; k < first.bodies.size(); ++k) {
        CHECK(first.bodies[k].centre == second.bodies[k].centre);
        CHECK(first.bodies[k].axis == second.bodies[k].axis);
        CHECK((task.turning || first.bodies[k].axis == Vec3<double>{0.0, 0.0, 1.0}));
    }
    task.seed = 2;
    CHECK(pack(task).bodies.front().centre != first.bodies.front().centre);
}

TEST_CASE("what is packed keeps away from ends, from solids, and from what is there already") {
    PackingTask task = task_in({64.0, 48.0, 40.0}, SphereShape{}, 6.0, 12);
    task.periodic = {true, true, false};
    SolidVoxels solids({64, 48, 40});
    for (int z = 0; z < 40; ++z)
        for (int y = 16; y < 32; ++y)
            for (int x = 56; x < 64; ++x)
                solids.set({x, y, z});
    task.solids = std::make_shared<const SolidDistance>(solids, task.periodic);
    task.kinds.push_back(shape(HelfrichShape{HelfrichBranch::prolate, 0.8}, 8.0));
    task.fixed.push_back({1, {20.0, 24.0, 20.0}, {1.0, 0.0, 0.0}});
    const PackingResult packed = pack(task);
    REQUIRE(packed.scale == 1.0);
    CHECK(least_gap(task, packed) > 2.9);
    for (const PackedBody& body : packed.bodies) {
        CHECK(body.centre.z > 6.0 + 3.0 - 0.1);
        CHECK(body.centre.z < 40.0 - 9.0 + 0.1);
        double nearest = std::numeric_limits<double>::infinity();
        for (int y = 16; y < 32; ++y)
            for (int x = 56; x < 64; ++x)
                for (const double image : {-64.0, 0.0})
                    nearest = std::min(nearest,
                                       std::hypot(body.centre.x - image - x - 0.5, body.centre.y - y - 0.5));
        CHECK(nearest - 0.5 - 6.0 > 2.7);
    }
}

TEST_CASE("what does not fit says how large a part of it did") {
    const PackingResult packed = pack(task_in({30.0, 30.0, 30.0}, SphereShape{}, 7.0, 14));
    CHECK(packed.scale < 1.0);
    CHECK(packed.scale > 0.5);
}

TEST_CASE("dense packings come about: 45 % of spheres and of discocytes") {
    const auto shape_of = GENERATE(ShapeParameters{SphereShape{}},
                                   ShapeParameters{HelfrichShape{HelfrichBranch::discocyte, 0.65}});
    PackingTask task = task_in({64.0, 64.0, 64.0}, shape_of, 10.0, 28);
    task.gap = 1.0;
    const double filled = 28 * 4.0 / 3.0 * std::numbers::pi * 1000.0 / (64.0 * 64.0 * 64.0);
    REQUIRE(filled == Approx(0.447).margin(1e-3));
    const PackingResult packed = pack(task);
    REQUIRE(packed.scale == 1.0);
    CHECK(least_gap(task, packed) > 0.9);
}

TEST_CASE("a region's ends hold on a periodic axis, and one body too large for it is no packing") {
    PackingTask task = task_in({64.0, 40.0, 40.0}, SphereShape{}, 6.0, 3);
    task.begin = {0.0, 0.0, 0.0};
    task.end = {22.0, 40.0, 40.0};
    const PackingResult packed = pack(task);
    REQUIRE(packed.scale == 1.0);
    for (const PackedBody& body : packed.bodies) {
        CHECK(body.centre.x > 8.9);
        CHECK(body.centre.x < 13.1);
    }
    task.end = {14.0, 40.0, 40.0};
    const PackingResult squeezed = pack(task);
    CHECK(squeezed.scale < 0.9);
    CHECK(squeezed.scale > 0.3);
}

TEST_CASE("the distance to solids is that of the nearest solid cell, round periodic ends as well") {
    SolidVoxels solids({20, 12, 10});
    solids.set({1, 2, 3});
    const SolidDistance periodic(solids, {true, true, true});
    const SolidDistance closed(solids, {false, true, true});
    const auto centre = [](int x, int y, int z) {
        return Vec3<double>{x + 0.5, y + 0.5, z + 0.5};
    };
    CHECK(periodic.at(centre(4, 6, 3)).distance == Approx(5.0 - 0.5));
    CHECK(periodic.at(centre(18, 2, 3)).distance == Approx(3.0 - 0.5));
    CHECK(closed.at(centre(18, 2, 3)).distance == Approx(17.0 - 0.5));
    CHECK(periodic.at(centre(1, 11, 3)).distance == Approx(3.0 - 0.5));
    CHECK(periodic.at(centre(1, 2, 3)).distance == Approx(-0.5));
    CHECK(periodic.at({4.7, 2.5, 3.5}).distance == Approx(3.2 - 0.5));
    CHECK(periodic.at({4.7, 2.5, 3.5}).gradient.x > 0.95);
}
