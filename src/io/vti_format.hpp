#pragma once

#include "case/solid_voxels.hpp"

#include <string>
#include <string_view>

namespace vesica {

/// The cells whose value is not zero in a file of VTK's image data ("XML file formats", VTK User's Guide):
/// one piece; format ascii, binary or appended (raw or base64), little-endian and not compressed. The array
/// called `name` is taken, or the only scalar one if `name` is empty; it is on the points or on the cells,
/// and its extent must be `size` values. Throws InputError.
SolidVoxels parse_vti(std::string_view contents, const Vec3<int>& size, const std::string& name,
                      const std::string& source);

} // namespace vesica
