#include "shape/axisymmetric_shape.hpp"
#include "shape/evans_fung.hpp"
#include "shape/helfrich.hpp"
#include "shape/placed_shape.hpp"
#include "shape/shape.hpp"
#include "shape/spheroid.hpp"

#include "core/input_error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace vesica {
namespace {

std::unique_ptr<const AxisymmetricShape> smooth_shape(const SphereShape&, double radius)
{
    return std::make_unique<Spheroid>(radius, 1.0);
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const SpheroidShape& shape, double radius)
{
    if (!(shape.aspect >= 0.02 && shape.aspect <= 50.0))
        throw InputError(fmt::format("aspect is {}; expected 0.02 to 50, the length along the axis over the width; "
                                     "try 0.5 for an oblate or 2 for a prolate",
                                     shape.aspect));
    return std::make_unique<Spheroid>(radius, shape.aspect);
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const HelfrichShape& shape, double radius)
{
    return std::make_unique<AxisymmetricShape>(helfrich_meridian(shape).normalised(radius));
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const EvansFungShape&, double radius)
{
    return std::make_unique<AxisymmetricShape>(evans_fung_meridian().normalised(radius));
}

std::unique_ptr<const AxisymmetricShape> smooth_shape(const MeshShape& shape, double)
{
    throw InputError(fmt::format("{}: shapes read from a mesh are not available", shape.file));
}

} // namespace

std::unique_ptr<const Shape> make_shape(const VesicleParameters& vesicle)
{
    if (!(vesicle.radius > 0.0) || !std::isfinite(vesicle.radius))
        throw InputError(fmt::format("radius is {}; expected a positive number of cells, the radius of the sphere of "
                                     "equal volume; try 15",
                                     vesicle.radius));
    const Frame frame = Frame::along(vesicle.axis);
    std::unique_ptr<const Shape> shape =
        std::visit([&](const auto& form) { return smooth_shape(form, vesicle.radius); }, vesicle.shape);
    return std::make_unique<PlacedShape>(std::move(shape), vesicle.centre, frame);
}

} // namespace vesica
