#pragma once

#include "case/parameters.hpp"
#include "io/case_values.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace vesica {

/// The vesicle type in the table at `path` ("vesicle_type.rbc"). Throws InputError.
VesicleType build_vesicle_type(const CaseValues& values, const std::string& path);

/// The type that the table at `path` names with its key `type`.
std::size_t type_index(const CaseValues& values, const std::string& path,
                       const std::vector<VesicleType>& types);

/// The shape that the table at `path` states. Mesh files are looked for in `folder`. Throws InputError.
ShapeParameters build_shape(const CaseValues& values, const std::string& path,
                            const std::filesystem::path& folder);

/// The vesicle in the table at `path` ("vesicle[0]"), whose type is one of `types`. Mesh files are looked for
/// in `folder`. Throws InputError.
VesicleParameters build_vesicle(const CaseValues& values, const std::string& path,
                                const std::vector<VesicleType>& types, const std::filesystem::path& folder);

} // namespace vesica
