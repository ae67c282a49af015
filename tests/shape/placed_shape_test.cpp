#include "core/input_error.hpp"
#include "shape/directions.hpp"
#include "shape/placed_shape.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

TEST_CASE("A frame is right-handed and orthonormal, with its z along the axis") {
    std::vector<Vec3<double>> axes = directions(40);
    axes.push_back({0.0, 0.0, 2.0});
    axes.push_back({0.0, 0.0, -3.0});
    axes.push_back({1e-9, 0.0, -1.0});
    axes.push_back({-3e-200, 1e-200, -1.0});
    for (const Vec3<double>& axis : axes) {
        const Frame f = Frame::along(axis);
        CHECK(norm(f.z - (1.0 / norm(axis)) * axis) < 1e-15);
        CHECK(norm(cross(f.x, f.y) - f.z) < 1e-14);
        CHECK(std::abs(norm(f.x) - 1.0) < 1e-14);
        CHECK(std::abs(dot(f.x, f.y)) < 1e-14);
        CHECK(norm(f.vector(f.components({1.0, -2.0, 3.0})) - Vec3<double>{1.0, -2.0, 3.0}) < 1e-14);
    }
    CHECK(Frame::along({0.0, 0.0, 5.0}).x == Vec3<double>{1.0, 0.0, 0.0});
}

TEST_CASE("A frame turns by the smallest rotation: the direction across both axes stays") {
    for (const Vec3<double>& axis : directions(40)) {
        const Frame f = Frame::along(axis);
        Vec3<double> across = cross({0.0, 0.0, 1.0}, axis);
        across = (1.0 / norm(across)) * across;
        CHECK(norm(f.vector(across) - across) < 1e-14);
    }
}

TEST_CASE("A vesicle turned and moved with its surroundings keeps its distances") {
    VesicleParameters vesicle;
    vesicle.radius = 12.0;
    for (const ShapeParameters& form : {ShapeParameters{SpheroidShape{0.5}},
                                        ShapeParameters{HelfrichShape{HelfrichBranch::stomatocyte, 0.6}}}) {
        vesicle.shape = form;
        vesicle.axis = {0.0, 0.0, 1.0};
        vesicle.centre = {0.0, 0.0, 0.0};
        const auto upright = make_shape(vesicle);
        vesicle.axis = {2.0, -1.0, 0.5};
        vesicle.centre = {31.5, 20.25, 40.0};
        const auto tilted = make_shape(vesicle);
        const Frame frame = Frame::along(vesicle.axis);
        for (const Vec3<double>& u : directions(100)) {
            const Vec3<double> x = 13.0 * u;
            CHECK(tilted->signed_distance(vesicle.centre + frame.vector(x)) ==
                  Approx(upright->signed_distance(x)).margin(1e-12));
        }
        CHECK(tilted->volume() == upright->volume());
    }
}

TEST_CASE("An axis without direction is refused") {
    CHECK_THROWS_WITH(Frame::along({0.0, 0.0, 0.0}),
                      "axis is [0, 0, 0]; expected a direction; try [0, 0, 1]");
}
