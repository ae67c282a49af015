#include "lattice/unwrap.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

TEST_CASE("cells are moved by whole boxes to where the reference is") {
    const Unwrap unwrap({20, 30, 0}, {19.0, 15.0, 5.0});
    CHECK(unwrap.shift({2, 15, 39}) == Vec3<double>{20.0, 0.0, 0.0}); // not periodic along z
    CHECK(unwrap.shift({10, 29, 3}) == Vec3<double>{0.0, 0.0, 0.0});
}

TEST_CASE("a box upwards is also the way the images have slid") {
    const Unwrap unwrap({20, 30, 40}, {10.0, 15.0, 39.0}, Slide{2, 0}, 7.25);
    CHECK(unwrap.shift({5, 15, 38}) == Vec3<double>{0.0, 0.0, 0.0});
    CHECK(unwrap.shift({5, 15, 1}) == Vec3<double>{7.25, 0.0, 40.0});
    CHECK(unwrap.boxes_slid({5, 15, 1}) == 1.0);
    CHECK(unwrap.shift({15, 15, 1}) == Vec3<double>{7.25 - 20.0, 0.0, 40.0}); // and back along the box
    CHECK(Unwrap({20, 30, 40}, {10.0, 15.0, 39.0}, Slide{2, 0}, 3.9999999999999).shift({5, 15, 1}).x == 4.0);
    const Unwrap below({20, 30, 40}, {10.0, 15.0, 1.0}, Slide{2, 0}, 7.25);
    CHECK(below.shift({5, 15, 38}) == Vec3<double>{-7.25 + 20.0, 0.0, -40.0});
}
