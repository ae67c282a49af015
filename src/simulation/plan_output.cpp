#include "simulation/plan_output.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vesica {

namespace {

// Seconds as measured on the machine of docs/performance.md; on another they are off as the machine is.
constexpr double to_sample = 15e-9;            ///< a number of a field, of one core
constexpr double to_compress = 45e-9;          ///< the same
constexpr double to_look_at = 20e-6;           ///< a layer, per cell^2 of the membrane
constexpr double to_draw = 40e-6;              ///< its surface, the same
constexpr double to_write = 4e-9;              ///< a byte, and wait until the device has it
constexpr double bytes_of_surface = 4.5 * 204; ///< per cell^2: a point has 60 bytes, and two triangles of 72

double cells_of(const Vec3<int>& size) {
    return 1.0 * size.x * size.y * size.z;
}

double numbers_of(const FieldOutput& fields) {
    double components = 0.0;
    for (const std::string& name : fields.names)
        components += name == "velocity" || name == "force" ? 3.0 : 1.0;
    const Vec3<int> region = fields.region_end - fields.region_begin;
    double samples = 1.0;
    for (int a = 0; a < 3; ++a)
        samples *= std::ceil(1.0 * region[a] / fields.stride);
    return components * samples;
}

/// From step 0 on.
double times(const RunParameters& run, std::int64_t every) {
    return every > 0 ? static_cast<double>(run.steps / every) + 1.0 : 0.0;
}

} // namespace

double membrane_area(const Parameters& parameters) {
    double area = 0.0;
    for (const VesicleParameters& vesicle : parameters.vesicles) {
        const double growth = parameters.types[vesicle.type].area.deflation.value_or(1.0);
        area += 4.0 * std::numbers::pi * vesicle.radius * vesicle.radius * growth;
    }
    return area;
}

OutputCost output_cost(const Parameters& parameters, const RunParameters& run, const OutputParameters& output,
                       int threads) {
    OutputCost cost;
    if (output.fields && output.fields->every > 0) {
        const double outputs = times(run, output.fields->every);
        const double numbers = numbers_of(*output.fields);
        const double compressing = output.fields->compression > 0 ? to_compress : 0.0;
        const double samples = output.fields->average ? 50.0 : 1.0; // as the schedule has it
        cost.bytes += outputs * 4.0 * numbers;
        cost.seconds += outputs * numbers * ((samples * to_sample + compressing) / threads + 4.0 * to_write);
    }
    const double area = membrane_area(parameters);
    if (output.surfaces_every > 0) {
        const double bytes = bytes_of_surface * area;
        const double outputs = times(run, output.surfaces_every);
        cost.bytes += outputs * bytes;
        cost.seconds += outputs * (area * (to_look_at + to_draw) + bytes * to_write);
    }
    cost.seconds += times(run, output.metrics_every) * area * to_look_at;
    // Populations and colours in the run's precision, and the band; where vesicles crowd a cell has several.
    const double number = parameters.numerics.precision == Precision::double_precision ? 8.0 : 4.0;
    const double colours = parameters.vesicles.size() > 1 ? 2.0 * (number + 5.0) : number + 1.0;
    const double checkpoint = cells_of(parameters.lattice()) * (19.0 * number + colours);
    if (output.checkpoint_every > 0) {
        const double written =
            std::ceil(static_cast<double>(run.steps) / static_cast<double>(output.checkpoint_every));
        cost.bytes += checkpoint * std::min(written, 1.0 + output.checkpoint_keep);
        cost.seconds += checkpoint * written * to_write;
    }
    return cost;
}

} // namespace vesica
