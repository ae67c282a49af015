#pragma once

#include "case/solid_voxels.hpp"

#include <filesystem>
#include <string>

namespace vesica {

/// Reads which cells of a box of `size` cells are solid: those whose value is not zero. By the file's ending:
/// - `.raw`: one byte per cell, x fastest, then y, then z, and nothing else;
/// - `.h5`, `.hdf5`: integers or an enumeration (such as h5py's booleans) of shape (nz, ny, nx); `dataset` is
///   its path in the file, and may be empty if only one data set at the root has three dimensions;
/// - `.vti`: a scalar array of VTK's image data, on its points or cells, whichever are as many as the box has
///   cells along each axis; not compressed; `dataset` is its Name, and may be empty if there is only one.
/// Throws InputError that names the file, what was read, what was expected and the remedy.
SolidVoxels read_voxels(const std::filesystem::path& file, const Vec3<int>& size,
                        const std::string& dataset = {});

} // namespace vesica
