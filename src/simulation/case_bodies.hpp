#pragma once

#include "case/case.hpp"
#include "case/solid_voxels.hpp"
#include "shape/shape.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace vesica {

/// The shape of a vesicle. What the reader could not know to be impossible is refused here, at its place in
/// the case: an InputError.
std::unique_ptr<const Shape> shape_of(const Case& what, std::size_t vesicle);

/// The shape of one that stands in the case at `path` ("vesicle[0]", "suspension").
std::unique_ptr<const Shape> shape_of(const Case& what, const VesicleParameters& vesicle,
                                      const std::string& path);

/// The cells that obstacles make solid; null without. What the reader could not know to be impossible is
/// refused here.
std::shared_ptr<const SolidVoxels> obstacles_of(const Case& what);

} // namespace vesica
