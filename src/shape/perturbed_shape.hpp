#pragma once

#include "shape/axisymmetric_shape.hpp"
#include "shape/spherical_harmonics.hpp"
#include "shape/triangle_tree.hpp"

#include <memory>

namespace vesica {

/// A smooth shape whose points x moved to x (1 + Y(x/|x|)), then scaled back to the volume (4 pi/3) radius^3
/// and shifted back to its centre of volume. A point is outside if x/(1 + Y) is outside the smooth shape; the
/// distance is that to the true closest point, found on a net of triangles and polished by Newton's method to
/// 1e-10 of a cell. Farther than `reach` from the surface the polish is left out. Where two parts of the
/// surface are equally close to about 1e-2 of a cell, either may be taken.
class PerturbedShape final : public Shape {
public:
    PerturbedShape(std::unique_ptr<const AxisymmetricShape> shape, HarmonicSeries series, double radius);

    double signed_distance(const Vec3<double>& position) const override;
    double bounding_radius() const override { return bounding_radius_; }
    double volume() const override { return volume_; }
    double area() const override { return area_; }
    double smallest_radius_of_curvature() const override { return smallest_radius_; }

private:
    struct Level {
        double value = 0.0; ///< vanishes on the perturbed surface, signed as the distance
        Vec3<double> gradient{};
    };
    struct Curvature { ///< the normal's derivative on two tangents
        Vec3<double> first{};
        Vec3<double> second{};
        double w11 = 0.0;
        double w12 = 0.0;
        double w22 = 0.0;
    };

    Vec3<double> moved(const Vec3<double>& x) const;
    Level level(const Vec3<double>& x) const;
    Vec3<double> unit_normal(const Vec3<double>& x) const;
    Curvature curvature(const Vec3<double>& x, const Vec3<double>& n) const;
    double polished(const Vec3<double>& x, Vec3<double> y, double fallback) const;
    void integrate(double radius);
    void lay_net();

    std::unique_ptr<const AxisymmetricShape> shape_;
    HarmonicSeries series_;
    Vec3<double>
        centre_{}; ///< of volume, before scaling and shifting; lengths below `level` are before scaling
    double scale_ = 1.0;
    TriangleMesh net_;
    std::unique_ptr<const TriangleTree> tree_;
    double bounding_radius_ = 0.0;
    double volume_ = 0.0;
    double area_ = 0.0;
    double smallest_radius_ = 0.0;
};

} // namespace vesica
