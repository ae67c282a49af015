#include "case/triangle_mesh.hpp"
#include "core/input_error.hpp"
#include "shape/axisymmetric_shape.hpp"
#include "shape/closed_mesh.hpp"
#include "shape/evans_fung.hpp"
#include "shape/helfrich.hpp"
#include "shape/mesh_surface.hpp"
#include "shape/perturbation.hpp"
#include "shape/perturbed_shape.hpp"
#include "shape/placed_shape.hpp"
#include "shape/shape.hpp"
#include "shape/spheroid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

namespace vesica {
namespace {

std::unique_ptr<const AxisymmetricShape> smooth_shape(const SphereShape&, double radius) {
    return std::make_unique<Spheroid>(radius, 1.0);
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const SpheroidShape& shape, double radius) {
    if (!(shape.aspect >= 0.02 && shape.aspect <= 50.0))
        throw InputError(
            fmt::format("aspect is {}; expected 0.02 to 50, the length along the axis over the width; "
                        "try 0.5 for an oblate or 2 for a prolate",
                        shape.aspect));
    return std::make_unique<Spheroid>(radius, shape.aspect);
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const HelfrichShape& shape, double radius) {
    return std::make_unique<AxisymmetricShape>(helfrich_meridian(shape).normalised(radius));
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const EvansFungShape&, double radius) {
    return std::make_unique<AxisymmetricShape>(evans_fung_meridian().normalised(radius));
}

std::unique_ptr<const Shape> perturbed_mesh(const MeshShape& shape, const HarmonicSeries& series,
                                            double radius) {
    if (!shape.mesh)
        throw InputError(
            fmt::format("shape \"mesh\" has no triangles; expected those of file = \"{}\"", shape.file));
    TriangleMesh mesh = normalised(closed_mesh(*shape.mesh), radius);
    if (!series.empty()) {
        for (Vec3<double>& v : mesh.vertices)
            if (const double distance = norm(v); distance > 0.0)
                v = (1.0 + series((1.0 / distance) * v).value) * v;
    }
    return std::make_unique<MeshSurface>(std::move(mesh), radius);
}

std::unique_ptr<const Shape> perturbed(const ShapeParameters& parameters, HarmonicSeries series,
                                       double radius) {
    if (const auto* mesh = std::get_if<MeshShape>(&parameters))
        return perturbed_mesh(*mesh, series, radius);
    std::unique_ptr<const AxisymmetricShape> shape = std::visit(
        [&](const auto& form) -> std::unique_ptr<const AxisymmetricShape> {
            if constexpr (std::is_same_v<decltype(form), const MeshShape&>)
                return nullptr;
            else
                return smooth_shape(form, radius);
        },
        parameters);
    if (series.empty())
        return shape;
    return std::make_unique<PerturbedShape>(std::move(shape), std::move(series), radius);
}

} // namespace

std::unique_ptr<const Shape> make_shape(const VesicleParameters& vesicle) {
    const bool keeps_size = vesicle.radius == 0.0 && std::holds_alternative<MeshShape>(vesicle.shape);
    if (!keeps_size && (!(vesicle.radius > 0.0) || !std::isfinite(vesicle.radius)))
        throw InputError(
            fmt::format("radius is {}; expected a positive number of cells, the radius of the sphere of "
                        "equal volume; try 15",
                        vesicle.radius));
    const Frame frame = Frame::along(vesicle.axis);
    std::unique_ptr<const Shape> shape =
        perturbed(vesicle.shape, harmonic_series(vesicle.perturbations), vesicle.radius);
    return std::make_unique<PlacedShape>(std::move(shape), vesicle.centre, frame);
}

} // namespace vesica
