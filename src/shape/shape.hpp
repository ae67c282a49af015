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

    /// Exact near the surface; where its modulus exceeds `reach` it may be a bound of the right sign that
    /// exceeds `reach` as well.
    static constexpr double reach = 16.0;
    virtual double signed_distance(const Vec3<double>& position) const = 0;

    /// Radius about the vesicle's centre beyond which everything is outside.
    virtual double bounding_radius() const = 0;

    virtual double volume() const = 0;
    virtual double area() const = 0;

    /// The smallest radius of curvature (in modulus) on the surface; decides whether the lattice resolves it.
    virtual double smallest_radius_of_curvature() const = 0;
};

/// Builds shape, perturbations and placement of one vesicle: volume (4 pi/3) radius^3, centre of volume at
/// `centre`, the shape's z along `axis` and its x where the smallest rotation from e_z to `axis` takes e_x.
/// Throws InputError for parameters out of range, reduced volumes outside the tabulated range and meshes that
/// cannot serve.
std::unique_ptr<const Shape> make_shape(const VesicleParameters& vesicle);

} // namespace vesica
