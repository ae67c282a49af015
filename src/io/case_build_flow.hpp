#pragma once

#include "case/parameters.hpp"
#include "io/case_values.hpp"

#include <filesystem>
#include <optional>

namespace vesica {

/// What bounds and drives the fluid: the tables [boundary] and [flow]. `parameters` has its size and its
/// fluid. Throws InputError with the place of what does not fit together.
void build_flow(const CaseValues& values, Parameters& parameters);

/// The table [obstacles]; files are relative to `folder`. Throws InputError.
std::optional<ObstacleParameters> build_obstacles(const CaseValues& values, const Vec3<int>& size,
                                                  const std::filesystem::path& folder);

/// The mean velocity of one fluid in a duct under a pressure gradient of one: between walls a distance
/// `height` apart, and `width` apart across if that is not infinite. The viscosity is dynamic. White, Viscous
/// Fluid Flow, section 3-3.
double mean_velocity_of_duct(double height, double width, double viscosity);

} // namespace vesica
