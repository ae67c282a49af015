#include "simulation/run_profiles.hpp"

#include "measure/suspension_profile.hpp"
#include "simulation/flow_drive.hpp"

#include <span>
#include <string>
#include <vector>

namespace vesica {

namespace {

const std::vector<std::string> profile_columns{"step",        "time",     "position",      "cells",
                                               "haematocrit", "velocity", "inner_velocity"};
const std::vector<std::string> suspension_columns{
    "step", "time", "haematocrit", "discharge_haematocrit", "velocity", "cell_free_layer"};

MetricsFile file_for(const OutputDirectory& directory, const char* name,
                     const std::vector<std::string>& columns, std::optional<std::int64_t> resumed) {
    const std::filesystem::path path = directory / name;
    return resumed ? MetricsFile::resume(path, columns, *resumed) : MetricsFile(path, columns);
}

} // namespace

RunProfiles::RunProfiles(const Case& what, const OutputDirectory& directory,
                         std::optional<std::int64_t> resumed)
    : output_(*what.output.profiles),
      walls_across_(output_.across_axis >= 0 && what.parameters.has_walls(output_.across_axis)),
      solids_(solid_voxels(what.parameters)),
      profiles_(file_for(directory, "profiles.csv", profile_columns, resumed)),
      suspension_(file_for(directory, "suspension.csv", suspension_columns, resumed)) {}

void RunProfiles::write(const Engine& engine) {
    const DenseField phase = engine.field("phase");
    const DenseField velocity = engine.field("velocity");
    const auto step = static_cast<double>(engine.steps_done());
    const SuspensionProfile profile =
        suspension_profile(phase, velocity, solids_.get(), output_, walls_across_);
    std::vector<std::vector<double>> rows;
    for (const ProfileBin& bin : profile.bins)
        rows.push_back({step, step, bin.position, static_cast<double>(bin.cells), bin.haematocrit,
                        bin.velocity, bin.inner_velocity});
    profiles_.append(rows);
    const std::vector<double> row{step,
                                  step,
                                  profile.haematocrit,
                                  profile.discharge_haematocrit,
                                  profile.velocity,
                                  profile.cell_free_layer};
    suspension_.append(std::span(&row, 1));
}

void RunProfiles::flush() {
    profiles_.flush();
    suspension_.flush();
}

} // namespace vesica
