#pragma once

#include "measure/equivalent_ellipsoid.hpp"
#include "measure/snapshot.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// A row of metrics.csv: one vesicle at one instant, lattice units, in the columns' order. What cannot be
/// known (curvature without geometry, inclination without flow, ...) is NaN.
struct MetricsRow {
    double step = 0.0;
    double time = 0.0;
    double vesicle = 0.0;
    double area = 0.0;
    double area_ratio = 0.0;
    double volume = 0.0;
    double reduced_volume = 0.0;
    double bending_energy = 0.0;
    double mean_curvature_integral = 0.0;
    double gaussian_curvature_over_pi = 0.0;
    double inertia_1 = 0.0;
    double inertia_2 = 0.0;
    double inertia_3 = 0.0;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double vx = 0.0;
    double vy = 0.0;
    double vz = 0.0;
    double deformation_index = 0.0;
    double taylor_deformation = 0.0;
    double inclination = 0.0;
    double tension = 0.0;
    double max_speed = 0.0;
    double mass_drift = 0.0;
    double gap = 0.0;
    double tank_treading_frequency = 0.0;
    double particle_stress = 0.0;
    double effective_viscosity = 0.0;
    double wall_stress = 0.0;
};

/// The names of the columns, in order.
const std::vector<std::string>& metrics_columns();

/// The row's values in the columns' order.
std::vector<double> metrics_values(const MetricsRow& row);

/// The value in the column of this name. Throws InputError, listing the known names, for any other.
double metrics_value(const MetricsRow& row, std::string_view column);

/// Throws InputError, listing the known names, unless there is a column of this name.
void require_metrics_column(std::string_view column);

/// What a vesicle is compared with.
struct MetricsBaseline {
    int vesicle = 0;                       ///< its index
    double colour_mass = 0.0;              ///< at step 0
    double diameter = 0.0;                 ///< D_0, the largest diameter at flow start (or step 0), cells
    std::optional<ShearPlane> shear_plane; ///< absent without a flow
};

MetricsBaseline baseline_of(const VesicleSnapshot& vesicle, int index,
                            const std::optional<ShearPlane>& shear_plane = {});

/// Measures everything. `snapshot` supplies what belongs to the whole box. x, y, z are this snapshot's own; a
/// CentreTracker removes their jumps.
MetricsRow measure(const VesicleSnapshot& vesicle, const Snapshot& snapshot, const MetricsBaseline& baseline);

} // namespace vesica
