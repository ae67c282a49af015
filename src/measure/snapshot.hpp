#pragma once

#include "core/vec3.hpp"
#include "measure/layer_moment.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace vesica {

/// One cell of a vesicle's diffuse layer with its geometry; always double, whatever the run's precision.
/// Positions are cell centres (cell i has its centre at i + 1/2), unwrapped: continuous across periodic
/// boundaries, so that a vesicle leaning over the edge of the box is in one piece. Normals point outwards.
/// H > 0 on a sphere.
struct InterfaceCell {
    Vec3<double> position{};
    double phi = 0.0; ///< phase field, +1 inside
    double s = 0.0;   ///< signed distance to phi = 0, positive outside; -atanh(phi)/beta
    Vec3<double> n{}; ///< outward unit normal
    double H = 0.0;   ///< mean curvature of the parallel surface through this cell
    double K = 0.0;   ///< its Gaussian curvature
    double H0 = 0.0;  ///< mapped to phi = 0
    double K0 = 0.0;
    double J = 1.0;       ///< area of the mid-surface per area of the parallel surface: 1 - 2 s H + s^2 K
    double density = 1.0; ///< rho
    Vec3<double> u{};     ///< velocity
    double bending_force = 0.0; ///< per membrane area along n
    double tension_force = 0.0; ///< likewise: -2 sigma H0, of the constant tension
    double area_force = 0.0;    ///< likewise: -2 sigma_A H0, of what holds the area
    Vec3<double> force{};       ///< of the membrane on the fluid, per volume
    double weight = 0.0; ///< (beta/2)(1 - phi^2): sum of weight * q approximates int q dA over the layer
    /// From the membrane to the obstacle beside this cell; infinite where there is none.
    double to_obstacle = std::numeric_limits<double>::infinity();
    /// From the membrane through this cell to another vesicle's; infinite where no other's layer reaches.
    double to_vesicle = std::numeric_limits<double>::infinity();
    bool has_geometry =
        false; ///< n, H, K, H0, K0, J are meaningful (inside the band where they are computed)
};

/// A run of cells along x that are purely inside (phi = 1), unwrapped like the cells above:
/// centres (begin + 1/2 + k, y + 1/2, z + 1/2) + rest, k = 0 .. count - 1.
struct InsideSpan {
    int begin = 0;
    int count = 0;
    int y = 0;
    int z = 0;
    Vec3<double> rest{}; ///< parts of a cell, of what lies beyond a sliding face
};

/// One vesicle at one instant: everything the metrics need.
struct VesicleSnapshot {
    std::vector<InterfaceCell> cells;
    std::vector<InsideSpan> inside;
    double beta = 0.67;
    double layer_moment = 0.0; ///< calibrated <s^2> of the layer at this beta, cells^2 (LayerMoments::area)
    LayerMoments layer{};    ///< all of the layer's moments; when all zero, layer_moment serves as for a tanh
    Vec3<double> momentum{}; ///< exact sum of rho_k u over this vesicle's colour
    double bending_modulus = 0.0;
    double spontaneous_curvature = 0.0;
    double viscosity_ratio = 1.0; ///< inner / outer
    double tension = 0.0;         ///< sigma plus the constraint's
    double target_area = std::numeric_limits<double>::quiet_NaN();
    double colour_mass = 0.0; ///< exact sum of this vesicle's density
};

/// A box that slides past its images (Lees-Edwards): those above have moved on.
struct SlidingImages {
    int gradient = 2;          ///< axis
    int velocity = 0;          ///< axis
    double displacement = 0.0; ///< cells, not less whole boxes
    double speed = 0.0;
};

struct Snapshot {
    std::int64_t step = 0;
    std::vector<VesicleSnapshot> vesicles;
    double max_speed = 0.0; ///< over the whole box
    /// What the walls gave the fluid in the last step, per axis the lower and the upper one: force, exact
    /// sums.
    std::array<std::array<Vec3<double>, 2>, 3> wall_force{};
    double reference_density = 1.0;
    double outer_viscosity = 0.0; ///< dynamic
    double shear_rate = 0.0;      ///< at present, of the shear that is driven
    Vec3<double> size{};          ///< of the fluid's box, cells
    Vec3<bool> walls{};           ///< at both ends of an axis
    std::optional<SlidingImages> sliding;
};

} // namespace vesica
