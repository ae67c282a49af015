#pragma once

#include "shape/axisymmetric_shape.hpp"

namespace vesica {

/// An ellipsoid of revolution with semi-axes `width` across and `height` along the axis; a sphere if equal.
class Spheroid final : public AxisymmetricShape {
public:
    /// aspect = length along the axis / width; radius is that of the sphere of equal volume, in cells.
    Spheroid(double radius, double aspect);

    MeridianFoot closest(double r, double z) const override;

private:
    double width_;
    double height_;
};

} // namespace vesica
