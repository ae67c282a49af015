#pragma once

#include "io/surface_file.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace vesica {

/// What a surface file holds: the surfaces of one step, ordered by vesicle.
struct SurfaceStep {
    std::int64_t step = 0;
    double time = 0.0; ///< in the file's unit
    std::vector<SurfaceArrays> surfaces;
};

/// Reads what write_surface_file wrote; `read(write(x)) = x` but for single precision. Throws RunError when
/// the file cannot be read, InputError when it is damaged or of another program.
SurfaceStep read_surface_file(const std::filesystem::path& path);

} // namespace vesica
