#include "simulation/step_profile.hpp"

#include <fmt/format.h>

namespace vesica {

double StepProfile::core_nanoseconds(double part_seconds, double per, int threads) {
    return per > 0.0 ? 1e9 * part_seconds * threads / per : 0.0;
}

double StepProfile::per_cell(int threads) const {
    return core_nanoseconds(of(StepPart::fluid), cells, threads);
}

double StepProfile::per_interface_cell(int threads) const {
    return core_nanoseconds(total() - of(StepPart::fluid) - of(StepPart::waiting), interface_cells, threads);
}

std::map<std::string, double> StepProfile::numbers(int threads) const {
    std::map<std::string, double> found;
    for (std::size_t k = 0; k < step_part_count; ++k)
        found[fmt::format("seconds_{}", name_of(static_cast<StepPart>(k)))] = seconds[k];
    found["steps"] = static_cast<double>(steps);
    found["core_nanoseconds_per_cell"] = per_cell(threads);
    found["core_nanoseconds_more_per_interface_cell"] = per_interface_cell(threads);
    found["interface_cells_per_step"] = steps > 0 ? interface_cells / static_cast<double>(steps) : 0.0;
    return found;
}

std::string StepProfile::text(int threads) const {
    if (steps == 0 || total() <= 0.0)
        return "no steps were done, so there is nothing to say of their cost\n";
    const double count = static_cast<double>(steps);
    std::string text = fmt::format("where {} steps went, {} thread{}; a cell's cost is of one core\n", steps,
                                   threads, threads == 1 ? "" : "s");
    text += fmt::format("  {:<12}{:>12}{:>9}{:>14}\n", "part", "ms a step", "share", "ns a cell");
    for (std::size_t k = 0; k < step_part_count; ++k) {
        const auto part = static_cast<StepPart>(k);
        text += fmt::format("  {:<12}{:>12.3f}{:>7.1f} %", name_of(part), 1e3 * of(part) / count,
                            100.0 * of(part) / total());
        const bool everywhere = part == StepPart::fluid;
        text += part == StepPart::waiting
                    ? "                for other ranks\n"
                    : fmt::format("{:>14.1f}  of {}\n",
                                  core_nanoseconds(of(part), everywhere ? cells : interface_cells, threads),
                                  everywhere ? "all cells" : "the interface's cells");
    }
    text += fmt::format("  {:<12}{:>12.3f}\n", "all", 1e3 * total() / count);
    text += fmt::format("  a cell costs {:.1f} ns, one of the interface ({:.1f} % of all) {:.1f} ns more\n",
                        per_cell(threads), 100.0 * interface_cells / cells, per_interface_cell(threads));
    return text;
}

} // namespace vesica
