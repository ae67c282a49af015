#include "simulation/run_profiles.hpp"

#include "measure/solid_body.hpp"
#include "measure/suspension_profile.hpp"
#include "simulation/flow_drive.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace vesica {

namespace {

const std::vector<std::string> profile_columns{"step",        "time",     "position",      "cells",
                                               "haematocrit", "velocity", "inner_velocity"};
const std::vector<std::string> suspension_columns{"step",
                                                  "time",
                                                  "haematocrit",
                                                  "discharge_haematocrit",
                                                  "velocity",
                                                  "cell_free_layer",
                                                  "nearest_neighbour"};
const std::vector<std::string> pair_columns{"step",  "time",         "distance",
                                            "pairs", "distribution", "shear_moment"};

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
      suspension_(file_for(directory, "suspension.csv", suspension_columns, resumed)) {
    const Parameters& parameters = what.parameters;
    box_.size = parameters.size;
    for (int a = 0; a < 3; ++a)
        box_.periodic[a] = !parameters.is_bounded(a);
    box_.solids = solids_.get();
    double radius = 0.0;
    for (const VesicleParameters& vesicle : parameters.vesicles)
        radius = std::max(radius, vesicle.radius);
    pair_width_ = radius / 8.0;
    if (parameters.vesicles.size() > 1)
        pairs_.emplace(file_for(directory, "pairs.csv", pair_columns, resumed));
}

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
    std::vector<Vec3<double>> centres;
    PairBox box = box_;
    if (pairs_) {
        const Snapshot snapshot = engine.snapshot();
        box.sliding = snapshot.sliding;
        for (const VesicleSnapshot& vesicle : snapshot.vesicles)
            centres.push_back(centre_of_mass(vesicle));
        pairs_->append(pair_rows(centres, box, step));
    }
    const std::vector<double> row{step,
                                  step,
                                  profile.haematocrit,
                                  profile.discharge_haematocrit,
                                  profile.velocity,
                                  profile.cell_free_layer,
                                  nearest_neighbour(centres, box)};
    suspension_.append(std::span(&row, 1));
}

std::vector<std::vector<double>> RunProfiles::pair_rows(const std::vector<Vec3<double>>& centres,
                                                        const PairBox& box, double step) const {
    std::vector<std::vector<double>> rows;
    for (const PairBin& bin : pair_statistics(centres, box, pair_width_, output_.along, output_.across_axis))
        rows.push_back(
            {step, step, bin.distance, static_cast<double>(bin.pairs), bin.distribution, bin.shear_moment});
    return rows;
}

void RunProfiles::flush() {
    profiles_.flush();
    suspension_.flush();
    if (pairs_)
        pairs_->flush();
}

} // namespace vesica
