#pragma once

#include <functional>
#include <vector>

namespace vesica {

/// A point of a meridian curve with its derivatives by the curve's parameter.
struct MeridianPoint {
    double r = 0.0; ///< distance from the axis
    double z = 0.0; ///< along the axis
    double dr = 0.0;
    double dz = 0.0;
    double ddr = 0.0;
    double ddz = 0.0;

    double speed() const;
    /// Along the meridian, 1/cells; positive on a sphere.
    double meridional_curvature() const;
    /// Across it; at a pole the limit, where both are equal.
    double azimuthal_curvature() const;
};

/// Quadrature points of a meridian: weight is the parameter's, so that int f dA = sum 2 pi r speed weight f.
struct MeridianSample {
    MeridianPoint point;
    double weight = 0.0;
};

/// The closest point of a meridian as seen from a point of its half plane.
struct MeridianFoot {
    double distance = 0.0; ///< signed, positive outside
    double normal_r = 0.0; ///< outward unit normal at the closest point
    double normal_z = 0.0;
};

/// The curve (r(t), z(t)) from the north to the south pole whose rotation about the z axis encloses a
/// vesicle: the outward normal is (-dz, dr)/speed. Kept as quintic Hermite pieces between densely sampled
/// points, which is exact to round-off for curves that bend over many pieces.
class Meridian {
public:
    using Curve = std::function<MeridianPoint(double t)>;

    /// Samples `curve` on [0, length]; the ends must be on the axis.
    Meridian(const Curve& curve, double length, int pieces = 1024);
    explicit Meridian(std::vector<MeridianPoint> points, double length);

    /// The same curve scaled to volume (4 pi/3) radius^3 and shifted to its centre of volume.
    Meridian normalised(double radius) const;

    /// Closest point to (r, z), r >= 0: exact to round-off.
    MeridianFoot closest(double r, double z) const;

    MeridianPoint at(double t) const;
    double length() const { return length_; }
    int pieces() const { return static_cast<int>(points_.size()) - 1; }

    /// Gauss-Legendre points of every `stride`-th union of pieces, north to south.
    std::vector<MeridianSample> samples(int stride = 1) const;

    double volume() const { return volume_; }
    double area() const { return area_; }
    double bounding_radius() const { return bounding_radius_; }
    double largest_curvature() const { return largest_curvature_; }

private:
    struct Piece {
        double r[6];
        double z[6];
    };
    struct Block { ///< a disc that holds a run of points
        double r;
        double z;
        double radius;
    };

    MeridianPoint evaluate(int piece, double u) const;
    double refine(double r, double z, int node) const;
    void integrate();

    std::vector<MeridianPoint> points_;
    std::vector<Piece> pieces_;
    std::vector<Block> blocks_;
    double length_;
    double step_;
    double longest_chord_ = 0.0;
    double volume_ = 0.0;
    double area_ = 0.0;
    double centre_ = 0.0;
    double bounding_radius_ = 0.0;
    double largest_curvature_ = 0.0;
};

} // namespace vesica
