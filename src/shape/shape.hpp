#pragma once

#include "case/parameters.hpp"
#include "core/vec3.hpp"

#include <memory>

namespace vesica {

/// A closed surface in space, in cells, known by its signed distance (positive outside).
class Shape {
public:
    Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    virtual ~Shape() = default;

    /// Exact near the surface; farther out it may be a bound of the right sign, at least `reach()` in modulus.
    virtual double signed_distance(const Vec3<double>& position) const = 0;

    /// Radius about the vesicle's centre beyond which everything is outside.
    virtual double bounding_radius() const = 0;

    virtual double volume() const = 0;
    virtual double area() const = 0;

    /// The smallest radius of curvature (in modulus) on the surface; decides whether the lattice resolves it.
    virtual double smallest_radius_of_curvature() const = 0;
};

/// Builds shape, perturbations and placement of one vesicle. Throws InputError for meshes that cannot serve
/// and for reduced volumes outside the tabulated range.
std::unique_ptr<const Shape> make_shape(const VesicleParameters& vesicle);

} // namespace vesica
