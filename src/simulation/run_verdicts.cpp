#include "simulation/run_verdicts.hpp"

#include "core/input_error.hpp"
#include "shape/helfrich.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {

namespace {

constexpr double pi = std::numbers::pi;

Verdict compare(const std::string& name, int vesicle, const std::string& what, double found, double expected,
                double tolerance) {
    return {name, std::abs(found - expected) <= tolerance,
            fmt::format("vesicle {}: {} is {:.8g}, expected {:.8g} within {:.2g}", vesicle, what, found,
                        expected, tolerance)};
}

struct Branch {
    std::string name;
    double energy = 0.0;
};

/// (kappa/2) int (2H)^2 dA over 8 pi kappa of the exact shape.
double helfrich_energy(const HelfrichShape& shape) {
    double energy = 0.0;
    for (const MeridianSample& sample : helfrich_meridian(shape).samples()) {
        const MeridianPoint& point = sample.point;
        const double twice_H = point.meridional_curvature() + point.azimuthal_curvature();
        energy += 2.0 * pi * point.r * point.speed() * sample.weight * twice_H * twice_H / (16.0 * pi);
    }
    return energy;
}

/// The branch whose energy is nearest, of those that exist at this reduced volume.
std::optional<Branch> nearest_branch(double reduced_volume, double energy) {
    const std::pair<HelfrichBranch, const char*> branches[] = {{HelfrichBranch::discocyte, "discocyte"},
                                                               {HelfrichBranch::prolate, "prolate"},
                                                               {HelfrichBranch::stomatocyte, "stomatocyte"}};
    std::optional<Branch> nearest;
    for (const auto& [branch, name] : branches) {
        const ReducedVolumeRange range = helfrich_range(branch);
        if (!(reduced_volume >= range.lowest && reduced_volume <= range.highest))
            continue;
        const double exact = helfrich_energy({branch, reduced_volume});
        if (!nearest || std::abs(exact - energy) < std::abs(nearest->energy - energy))
            nearest = Branch{name, exact};
    }
    return nearest;
}

void judge_energy(const VesicleType& type, const MetricsRow& row, int vesicle,
                  std::vector<Verdict>& verdicts) {
    const auto* helfrich = std::get_if<HelfrichBending>(&type.bending.form);
    const bool held = !std::holds_alternative<NoConstraint>(type.area.constraint);
    if (type.bending.modulus <= 0.0 || helfrich == nullptr || helfrich->spontaneous_curvature != 0.0 || !held)
        return;
    const auto branch = nearest_branch(row.reduced_volume, row.bending_energy);
    if (!branch)
        return;
    const std::string what =
        fmt::format("the energy over 8 pi kappa, compared with the exact {} of reduced volume "
                    "{:.4f},",
                    branch->name, row.reduced_volume);
    verdicts.push_back(
        compare("bending_energy", vesicle, what, row.bending_energy, branch->energy, 0.02 * branch->energy));
}

} // namespace

std::vector<Verdict> judge_run(const Parameters& parameters, const RunParameters& run, RunEnd end,
                               const std::vector<MetricsRow>& last) {
    std::vector<Verdict> verdicts;
    const bool completed = end == RunEnd::finished || end == RunEnd::steady;
    verdicts.push_back({"completed", completed,
                        completed ? "the run came to its end" : "the run ended before its last step"});
    if (run.stop_when_steady) {
        const SteadyCriterion& steady = *run.stop_when_steady;
        verdicts.push_back({"steady", end == RunEnd::steady,
                            fmt::format("{} {} to {:g} over {} steps", steady.quantity,
                                        end == RunEnd::steady ? "settled" : "did not settle",
                                        steady.relative_change, steady.over)});
    }
    const double round_off = parameters.numerics.precision == Precision::double_precision ? 1e-11 : 1e-5;
    for (std::size_t index = 0; index < last.size(); ++index) {
        const MetricsRow& row = last[index];
        const int vesicle = static_cast<int>(index);
        const VesicleType& type = parameters.types[parameters.vesicles[index].type];
        const bool at_target = !type.area.deflation || row.step >= static_cast<double>(type.area.ramp);
        if (std::holds_alternative<MultiplierConstraint>(type.area.constraint) && at_target)
            verdicts.push_back(
                compare("area", vesicle, "the area over its target", row.area_ratio, 1.0, 1e-4));
        verdicts.push_back(
            compare("mass", vesicle, "the relative change of its mass", row.mass_drift, 0.0, round_off));
        verdicts.push_back(compare("gauss_bonnet", vesicle, "int K dA over pi",
                                   row.gaussian_curvature_over_pi, 4.0, 0.005 * 4.0));
        if (end == RunEnd::steady)
            judge_energy(type, row, vesicle, verdicts);
    }
    return verdicts;
}

} // namespace vesica
