#include "measure/metrics.hpp"

#include "core/input_error.hpp"
#include "measure/area.hpp"
#include "measure/curvature_integrals.hpp"
#include "measure/diameter.hpp"
#include "measure/in_flow.hpp"
#include "measure/solid_body.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vesica {
namespace {

struct Column {
    const char* name;
    double MetricsRow::*value;
};

constexpr std::array columns = {
    Column{"step", &MetricsRow::step},
    Column{"time", &MetricsRow::time},
    Column{"vesicle", &MetricsRow::vesicle},
    Column{"area", &MetricsRow::area},
    Column{"area_ratio", &MetricsRow::area_ratio},
    Column{"volume", &MetricsRow::volume},
    Column{"reduced_volume", &MetricsRow::reduced_volume},
    Column{"bending_energy", &MetricsRow::bending_energy},
    Column{"mean_curvature_integral", &MetricsRow::mean_curvature_integral},
    Column{"gaussian_curvature_over_pi", &MetricsRow::gaussian_curvature_over_pi},
    Column{"inertia_1", &MetricsRow::inertia_1},
    Column{"inertia_2", &MetricsRow::inertia_2},
    Column{"inertia_3", &MetricsRow::inertia_3},
    Column{"x", &MetricsRow::x},
    Column{"y", &MetricsRow::y},
    Column{"z", &MetricsRow::z},
    Column{"vx", &MetricsRow::vx},
    Column{"vy", &MetricsRow::vy},
    Column{"vz", &MetricsRow::vz},
    Column{"deformation_index", &MetricsRow::deformation_index},
    Column{"taylor_deformation", &MetricsRow::taylor_deformation},
    Column{"inclination", &MetricsRow::inclination},
    Column{"tension", &MetricsRow::tension},
    Column{"max_speed", &MetricsRow::max_speed},
    Column{"mass_drift", &MetricsRow::mass_drift},
    Column{"gap", &MetricsRow::gap},
    Column{"tank_treading_frequency", &MetricsRow::tank_treading_frequency},
    Column{"particle_stress", &MetricsRow::particle_stress},
    Column{"effective_viscosity", &MetricsRow::effective_viscosity},
    Column{"wall_stress", &MetricsRow::wall_stress},
};

const Column& column_named(std::string_view name) {
    for (const Column& column : columns)
        if (name == column.name)
            return column;
    std::string message =
        "quantity is \"" + std::string(name) + "\"; expected a column of metrics.csv; try one of ";
    for (const Column& column : columns) {
        if (&column != columns.data())
            message += ", ";
        message += column.name;
    }
    throw InputError(message);
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The walls' mean stress along the flow: half of what the upper one drives and the lower one holds.
double wall_stress(const Snapshot& snapshot, const ShearPlane& plane) {
    const int axis = plane.gradient.x != 0.0 ? 0 : plane.gradient.y != 0.0 ? 1 : 2;
    if (!snapshot.walls[axis])
        return unknown;
    const auto& force = snapshot.wall_force[static_cast<std::size_t>(axis)];
    const double area = snapshot.size.x * snapshot.size.y * snapshot.size.z / snapshot.size[axis];
    return 0.5 * dot(force[1] - force[0], plane.flow) / area;
}

void measure_flow(const VesicleSnapshot& vesicle, const Snapshot& snapshot, const MetricsBaseline& baseline,
                  MetricsRow& row) {
    row.tank_treading_frequency = row.particle_stress = row.effective_viscosity = row.wall_stress = unknown;
    if (!baseline.shear_plane)
        return;
    const ShearPlane& plane = *baseline.shear_plane;
    row.tank_treading_frequency = tank_treading_frequency(vesicle, plane);
    row.particle_stress = particle_stress(vesicle, plane, snapshot.outer_viscosity);
    if (snapshot.shear_rate == 0.0)
        return;
    row.wall_stress = wall_stress(snapshot, plane);
    const double volume = snapshot.size.x * snapshot.size.y * snapshot.size.z;
    row.effective_viscosity =
        1.0 + row.particle_stress / (snapshot.outer_viscosity * std::abs(snapshot.shear_rate) * volume);
}

} // namespace

const std::vector<std::string>& metrics_columns() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Column& column : columns)
            list.emplace_back(column.name);
        return list;
    }();
    return names;
}

std::vector<double> metrics_values(const MetricsRow& row) {
    std::vector<double> values;
    values.reserve(columns.size());
    for (const Column& column : columns)
        values.push_back(row.*column.value);
    return values;
}

double metrics_value(const MetricsRow& row, std::string_view column) {
    return row.*column_named(column).value;
}

void require_metrics_column(std::string_view column) {
    column_named(column);
}

MetricsBaseline baseline_of(const VesicleSnapshot& vesicle, int index,
                            const std::optional<ShearPlane>& shear_plane) {
    return {index, vesicle.colour_mass, largest_diameter(vesicle), shear_plane};
}

MetricsRow measure(const VesicleSnapshot& vesicle, const Snapshot& snapshot,
                   const MetricsBaseline& baseline) {
    const double whole_area = area(vesicle);
    const Vec3<double> centre = centre_of_mass(vesicle);
    const SolidBody body = solid_body(vesicle, centre, whole_area);
    const std::array<double, 3> inertia = principal_inertia(body, snapshot.reference_density);
    const Vec3<double> velocity = (1.0 / vesicle.colour_mass) * vesicle.momentum;
    const PlaneDeformation deformation = plane_deformation(body, baseline.shear_plane);

    MetricsRow row;
    row.step = static_cast<double>(snapshot.step);
    row.time = static_cast<double>(snapshot.step);
    row.vesicle = baseline.vesicle;
    row.area = whole_area;
    row.area_ratio = row.area / vesicle.target_area;
    row.volume = body.volume;
    row.reduced_volume = reduced_volume(body.volume, row.area);
    row.bending_energy = bending_energy(vesicle, whole_area);
    row.mean_curvature_integral = mean_curvature_integral(vesicle, whole_area);
    row.gaussian_curvature_over_pi = gaussian_curvature_integral(vesicle, whole_area) / std::numbers::pi;
    row.inertia_1 = inertia[0];
    row.inertia_2 = inertia[1];
    row.inertia_3 = inertia[2];
    row.x = centre.x;
    row.y = centre.y;
    row.z = centre.z;
    row.vx = velocity.x;
    row.vy = velocity.y;
    row.vz = velocity.z;
    row.deformation_index = deformation_index(largest_diameter(vesicle), baseline.diameter);
    row.taylor_deformation = deformation.taylor;
    row.inclination = deformation.inclination;
    row.tension = vesicle.tension;
    row.max_speed = snapshot.max_speed;
    row.mass_drift = vesicle.colour_mass / baseline.colour_mass - 1.0;
    double gap = distance_to_walls(vesicle, snapshot);
    for (const InterfaceCell& cell : vesicle.cells)
        gap = std::min({gap, cell.to_obstacle, cell.to_vesicle});
    row.gap = std::isfinite(gap) ? gap : unknown;
    measure_flow(vesicle, snapshot, baseline, row);
    return row;
}

} // namespace vesica
