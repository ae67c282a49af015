#include "shape/directions.hpp"
#include "shape/placed_shape.hpp"
#include "shape/triangle_intersection.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

namespace {

using Meeting = bool (*)(const Triangle&, const Triangle&);

/// The answer must not depend on the frame, the order of the two, or the triangles' orientation.
void check(Meeting meet, const Triangle& a, const Triangle& b, bool expected) {
    for (const Vec3<double>& axis : directions(25)) {
        const Frame frame = Frame::along(axis);
        Triangle p = a, q = b;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = frame.vector(a[i]) + 3.0 * axis;
            q[i] = frame.vector(b[i]) + 3.0 * axis;
        }
        CHECK(meet(p, q) == expected);
        CHECK(meet(q, p) == expected);
    }
}

const Triangle flat{Vec3<double>{0, 0, 0}, Vec3<double>{2, 0, 0}, Vec3<double>{0, 2, 0}};

} // namespace

TEST_CASE("Triangles that pierce each other meet, triangles apart do not") {
    check(triangles_meet, flat,
          {Vec3<double>{0.5, 0.5, -1}, Vec3<double>{0.6, 0.5, 1}, Vec3<double>{3, 3, 1}}, true);
    check(triangles_meet, flat,
          {Vec3<double>{0.5, 0.5, 0.1}, Vec3<double>{0.6, 0.5, 1}, Vec3<double>{3, 3, 1}}, false);
    // The line of both planes is met by both, at different places.
    check(triangles_meet, flat,
          {Vec3<double>{2.5, 0.5, -1}, Vec3<double>{2.6, 0.5, 1}, Vec3<double>{3, 0.5, 1}}, false);
    // A corner of one on the face of the other.
    check(triangles_meet, flat, {Vec3<double>{0.5, 0.5, 0}, Vec3<double>{0.6, 0.5, 1}, Vec3<double>{3, 3, 1}},
          true);
}

TEST_CASE("Triangles in one plane meet where they overlap, also one inside the other") {
    check(triangles_meet, flat,
          {Vec3<double>{0.2, 0.2, 0}, Vec3<double>{0.4, 0.2, 0}, Vec3<double>{0.2, 0.4, 0}}, true);
    check(triangles_meet, flat, {Vec3<double>{1, 1.5, 0}, Vec3<double>{1.5, -1, 0}, Vec3<double>{3, 3, 0}},
          true);
    check(triangles_meet, flat, {Vec3<double>{1.1, 1.1, 0}, Vec3<double>{3, 0, 0}, Vec3<double>{3, 3, 0}},
          false);
    check(triangles_meet, flat,
          {Vec3<double>{0, 0, 1e-6}, Vec3<double>{2, 0, 1e-6}, Vec3<double>{0, 2, 1e-6}}, false);
}

TEST_CASE("Neighbours at a corner meet beyond it only if they pierce or overlap") {
    check(triangles_meet_beyond_corner, flat,
          {Vec3<double>{0, 0, 0}, Vec3<double>{-1, 0, 0}, Vec3<double>{0, -1, 0}}, false);
    check(triangles_meet_beyond_corner, flat,
          {Vec3<double>{0, 0, 0}, Vec3<double>{-1, 0, 1}, Vec3<double>{1, 1, 1}}, false);
    check(triangles_meet_beyond_corner, flat,
          {Vec3<double>{0, 0, 0}, Vec3<double>{1, 1, 1}, Vec3<double>{1, 1, -1}}, true);
    check(triangles_meet_beyond_corner, flat,
          {Vec3<double>{0, 0, 0}, Vec3<double>{3, 3, 2}, Vec3<double>{3, 3, -2}}, true);
    check(triangles_meet_beyond_corner, flat,
          {Vec3<double>{0, 0, 0}, Vec3<double>{0.5, 1, 0}, Vec3<double>{1, 0.5, 0}}, true);
}

TEST_CASE("Neighbours at an edge fold onto each other only in one plane and on one side") {
    check(triangles_fold, flat, {Vec3<double>{0, 0, 0}, Vec3<double>{2, 0, 0}, Vec3<double>{1, 1, 0}}, true);
    check(triangles_fold, flat, {Vec3<double>{0, 0, 0}, Vec3<double>{2, 0, 0}, Vec3<double>{1, -1, 0}},
          false);
    check(triangles_fold, flat, {Vec3<double>{0, 0, 0}, Vec3<double>{2, 0, 0}, Vec3<double>{1, 1, 0.01}},
          false);
}
