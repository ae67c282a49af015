#include "simulation/run_verdicts.hpp"

#include "core/input_error.hpp"
#include "shape/helfrich.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace vesica {

namespace {

constexpr double pi = std::numbers::pi;

void settle(Verdict& verdict)
{
    verdict.passed = std::abs(verdict.found - verdict.expected) <= verdict.tolerance;
}

struct Branch {
    std::string name;
    double energy = 0.0;
};

/// (kappa/2) int (2H)^2 dA over 8 pi kappa of the exact shape.
double helfrich_energy(const HelfrichShape& shape)
{
    double energy = 0.0;
    for (const MeridianSample& sample : helfrich_meridian(shape).samples()) {
        const MeridianPoint& point = sample.point;
        const double twice_H = point.meridional_curvature() + point.azimuthal_curvature();
        energy += 2.0 * pi * point.r * point.speed() * sample.weight * twice_H * twice_H / (16.0 * pi);
    }
    return energy;
}

/// The branch whose energy is nearest, of those that exist at this reduced volume.
std::optional<Branch> nearest_branch(double reduced_volume, double energy)
{
    const std::pair<HelfrichBranch, const char*> branches[] = {{HelfrichBranch::discocyte, "discocyte"},
                                                               {HelfrichBranch::prolate, "prolate"},
                                                               {HelfrichBranch::stomatocyte, "stomatocyte"}};
    std::optional<Branch> nearest;
    for (const auto& [branch, name] : branches) {
        const ReducedVolumeRange range = helfrich_range(branch);
        if (!(reduced_volume >= range.lowest && reduced_volume <= range.highest)) continue;
        const double exact = helfrich_energy({branch, reduced_volume});
        if (!nearest || std::abs(exact - energy) < std::abs(nearest->energy - energy)) nearest = Branch{name, exact};
    }
    return nearest;
}

void judge_energy(const VesicleType& type, RunEnd end, const MetricsRow& row, int vesicle,
                  std::vector<Verdict>& verdicts)
{
    const auto* helfrich = std::get_if<HelfrichBending>(&type.bending.form);
    const bool held = !std::holds_alternative<NoConstraint>(type.area.constraint);
    if (type.bending.modulus <= 0.0 || helfrich == nullptr || helfrich->spontaneous_curvature != 0.0 || !held) return;
    const auto branch = nearest_branch(row.reduced_volume, row.bending_energy);
    if (!branch) return;
    Verdict verdict{"bending_energy", vesicle,
                    fmt::format("is the bending energy that of the exact {} of reduced volume {:.4f}?", branch->name,
                                row.reduced_volume),
                    row.bending_energy, branch->energy, 0.02 * branch->energy, std::nullopt};
    // A shape on its way need not be a minimum.
    if (end == RunEnd::steady) settle(verdict);
    verdicts.push_back(verdict);
}

} // namespace

std::vector<Verdict> judge_run(const Parameters& parameters, const RunParameters& run, RunEnd end,
                               std::int64_t steps, const std::vector<MetricsRow>& last)
{
    std::vector<Verdict> verdicts;
    Verdict completed{"completed", -1, "did the run do all its steps, or become steady before?",
                      static_cast<double>(steps), static_cast<double>(run.steps), 0.0,
                      end == RunEnd::finished || end == RunEnd::steady};
    verdicts.push_back(completed);
    if (run.stop_when_steady)
        verdicts.push_back({"steady", -1,
                            fmt::format("did {} settle to {:g} over {} steps?", run.stop_when_steady->quantity,
                                        run.stop_when_steady->relative_change, run.stop_when_steady->over),
                            end == RunEnd::steady ? 1.0 : 0.0, 1.0, 0.0, end == RunEnd::steady});
    for (std::size_t index = 0; index < last.size(); ++index) {
        const MetricsRow& row = last[index];
        const int vesicle = static_cast<int>(index);
        const VesicleType& type = parameters.types[parameters.vesicles[index].type];
        if (std::holds_alternative<MultiplierConstraint>(type.area.constraint)) {
            Verdict area{"area", vesicle, "is the area its target?", row.area_ratio, 1.0, 1e-4, std::nullopt};
            if (!type.area.deflation || row.step >= static_cast<double>(type.area.ramp)) settle(area);
            verdicts.push_back(area);
        }
        const double round_off = parameters.numerics.precision == Precision::double_precision ? 1e-11 : 1e-5;
        Verdict mass{"mass", vesicle, "is the vesicle's mass what it was?", row.mass_drift, 0.0, round_off, std::nullopt};
        settle(mass);
        verdicts.push_back(mass);
        Verdict topology{"gauss_bonnet", vesicle, "is int K dA that of a closed surface without holes, 4 pi?",
                         row.gaussian_curvature_over_pi, 4.0, 0.005 * 4.0, std::nullopt};
        settle(topology);
        verdicts.push_back(topology);
        judge_energy(type, end, row, vesicle, verdicts);
    }
    return verdicts;
}

} // namespace vesica
