#include "shape/triangle_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace vesica {
namespace {

/// Volumes below this over the cube of the extent count as zero: flat faces of rotated solids are planar to
/// round-off only, and must be compared in their plane.
constexpr long double flatness = 1e-14L;

using Point = Vec3<long double>;

Point relative(const Vec3<double>& p, const Vec3<double>& origin) {
    return {static_cast<long double>(p.x) - static_cast<long double>(origin.x),
            static_cast<long double>(p.y) - static_cast<long double>(origin.y),
            static_cast<long double>(p.z) - static_cast<long double>(origin.z)};
}

int sign(long double value, long double tolerance) {
    return value > tolerance ? 1 : value < -tolerance ? -1 : 0;
}

/// Coordinates relative to one corner and the tolerances that go with their extent.
class Arrangement {
public:
    Arrangement(const Triangle& a, const Triangle& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            a_[i] = relative(a[i], a[0]);
            b_[i] = relative(b[i], a[0]);
            for (int k = 0; k < 3; ++k)
                extent_ = std::max({extent_, std::abs(a_[i][k]), std::abs(b_[i][k])});
        }
    }

    const std::array<Point, 3>& a() const { return a_; }
    const std::array<Point, 3>& b() const { return b_; }

    /// Side of p with respect to the plane through t.
    int side(const std::array<Point, 3>& t, const Point& p) const { return orientation(t[0], t[1], t[2], p); }

    int orientation(const Point& p, const Point& q, const Point& r, const Point& s) const {
        return sign(dot(cross(q - p, r - p), s - p), flatness * extent_ * extent_ * extent_);
    }

    /// Whether the segment pq meets the triangle t.
    bool segment_meets(const Point& p, const Point& q, const std::array<Point, 3>& t) const {
        const int sp = side(t, p), sq = side(t, q);
        if (sp * sq > 0)
            return false;
        if (sp == 0 && sq == 0)
            return segment_meets_in_plane(p, q, t);
        const int s0 = orientation(p, q, t[0], t[1]);
        const int s1 = orientation(p, q, t[1], t[2]);
        const int s2 = orientation(p, q, t[2], t[0]);
        return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
    }

    /// The same for a segment in the triangle's plane, projected along the normal's largest component.
    bool segment_meets_in_plane(const Point& p, const Point& q, const std::array<Point, 3>& t) const {
        const Point n = cross(t[1] - t[0], t[2] - t[0]);
        const long double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
        const int drop = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        const int u = (drop + 1) % 3, v = (drop + 2) % 3;
        const auto turn = [&](const Point& a, const Point& b, const Point& c) {
            return sign((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]),
                        flatness * extent_ * extent_);
        };
        const auto inside = [&](const Point& c) {
            const int s0 = turn(t[0], t[1], c), s1 = turn(t[1], t[2], c), s2 = turn(t[2], t[0], c);
            return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
        };
        const auto between = [&](long double a, long double b, long double c, long double d) {
            return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
        };
        const auto segments_meet = [&](const Point& c, const Point& d) {
            return turn(p, q, c) * turn(p, q, d) <= 0 && turn(c, d, p) * turn(c, d, q) <= 0 &&
                   between(p[u], q[u], c[u], d[u]) && between(p[v], q[v], c[v], d[v]);
        };
        if (inside(p) || inside(q))
            return true;
        return segments_meet(t[0], t[1]) || segments_meet(t[1], t[2]) || segments_meet(t[2], t[0]);
    }

private:
    std::array<Point, 3> a_{};
    std::array<Point, 3> b_{};
    long double extent_ = 0.0L;
};

} // namespace

bool triangles_meet(const Triangle& a, const Triangle& b) {
    const Arrangement arrangement(a, b);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (arrangement.segment_meets(arrangement.a()[i], arrangement.a()[j], arrangement.b()))
            return true;
        if (arrangement.segment_meets(arrangement.b()[i], arrangement.b()[j], arrangement.a()))
            return true;
    }
    return false;
}

/// A common segment that starts in the corner ends on the side opposite to it of one triangle or the other.
bool triangles_meet_beyond_corner(const Triangle& a, const Triangle& b) {
    const Arrangement arrangement(a, b);
    return arrangement.segment_meets(arrangement.a()[1], arrangement.a()[2], arrangement.b()) ||
           arrangement.segment_meets(arrangement.b()[1], arrangement.b()[2], arrangement.a());
}

bool triangles_fold(const Triangle& a, const Triangle& b) {
    const Arrangement arrangement(a, b);
    if (arrangement.side(arrangement.a(), arrangement.b()[2]) != 0)
        return false;
    const Point edge = arrangement.a()[1] - arrangement.a()[0];
    const Point up = cross(edge, arrangement.a()[2] - arrangement.a()[0]);
    const Point other = cross(edge, arrangement.b()[2] - arrangement.b()[0]);
    return dot(up, other) > 0.0L;
}

} // namespace vesica
