#include "io/case_template_parts.hpp"

#include <array>

namespace vesica {
namespace {

// clang-format off
constexpr std::array<CaseTemplate, 4> templates{{
{"shear", "a prolate vesicle tank-treads between moving walls", R"toml(title = "A vesicle tank-treads in shear"

# In a weak enough shear, and with equal viscosities, a vesicle takes a steady angle with the flow while its membrane
# goes round. Give it a viscosity_ratio of 8 and it tumbles.

[lattice]
size = [72, 48, 72]                  # at least 6 R0 along the flow and the gradient, or the walls decide the angle

[fluid]
kinematic_viscosity = 0.5

[flow.shear]                         # walls at z = 0 and z = 72 move against each other
rate = 2e-4                          # Re = rate R0^2/nu = 0.06, Ca_kappa = 3.5
velocity = "x"
gradient = "z"
start = 0                            # optional, as are stop and ramp

[vesicle_type.lipid]
viscosity_ratio = 1.0
[vesicle_type.lipid.bending]
modulus = 0.05

[[vesicle]]
type = "lipid"
shape = "prolate"
reduced_volume = 0.9
centre = [36, 24, 36]
radius = 12
axis = [1, 0, 0.8]

[run]
steps = 40000

[output]
metrics = { every = 200 }            # inclination, tank_treading_frequency, effective_viscosity among them
surfaces = { every = 2000 }
checkpoint = { every = 10000, keep = 2 }
)toml"},
{"channel", "a vesicle carried along a channel moves towards its middle", R"toml(title = "A vesicle carried along a straight channel"

[lattice]
size = [60, 48, 60]

[fluid]
kinematic_viscosity = 0.3333333
[fluid.collision]
ghost_rates = "trt"                  # with magic = 3/16: walls lie exactly half-way

[boundary]
wetting = -0.005                     # walls repel vesicles
[boundary.z]                         # x and y stay periodic
lower = { type = "wall" }
upper = { type = "wall" }

[flow.poiseuille]
mean_velocity = 2e-3                 # of the fluid alone; or pressure_gradient
velocity = "x"

[vesicle_type.lipid]
[vesicle_type.lipid.bending]
modulus = 0.1

[[vesicle]]
type = "lipid"
shape = "prolate"
reduced_volume = 0.9
centre = [30, 24, 24]                # off the middle
radius = 12
axis = [1, 0, 0.5]

[run]
steps = 60000

[output]
metrics = { every = 500 }
surfaces = { every = 5000 }
checkpoint = { every = 20000, keep = 2 }
)toml"},
{"rbc-shear", "a red-cell-like vesicle in shear, in micrometres", R"toml(title = "A red-cell-like vesicle in shear, in micrometres"

# The membrane bends like a red cell's and keeps its area, but has no cytoskeleton: `vesica check --model`.
# `vesica check` prints real units and the lattice's side by side.

[units]
cell = "0.2 um"
reynolds = 0.1                       # rho gamma R0^2/eta of the lattice: inertia is scaled up to it (the real cell has
                                     # 1e-4, which no lattice can afford); viscosities, moduli and times stay real

[lattice]
size = [72, 56, 72]                  # 14.4 x 11.2 x 14.4 um

[fluid]
dynamic_viscosity = "1.2 mPa s"      # plasma
density = "1000 kg/m^3"
relaxation_time = 1.09               # the lattice's own choice, which sets the step

[flow.shear]
rate = "15 1/s"
velocity = "x"
gradient = "z"
start = "20 ms"

[vesicle_type.red-cell]
viscosity_ratio = 5.0                # haemoglobin: 6 mPa s
[vesicle_type.red-cell.bending]
modulus = "2e-19 J"
[vesicle_type.red-cell.area]
constraint = "multiplier"

[[vesicle]]
type = "red-cell"
shape = "discocyte"
reduced_volume = 0.65
centre = [36, 28, 36]
radius = "2.82 um"                   # of the sphere of equal volume, 94 um^3
axis = [0.5, 0, 1]

[run]
time = "1.5 s"

[output]
metrics = { every = "2 ms" }
surfaces = { every = "20 ms" }
checkpoint = { every = "200 ms", keep = 2 }
)toml"},
{"suspension-shear", "cells packed at random and sheared without walls", R"toml(title = "A suspension in shear"

# Cells are packed at random, then sheared by faces that slide past each other: no walls, so that effective_viscosity is
# the suspension's own. The initial places are transient: average over the strains after the first two or so.

[lattice]
size = [96, 64, 96]

[fluid]
kinematic_viscosity = 0.3333333

[flow.shear]
rate = 2e-4                          # Re = rate R0^2/nu = 0.09, Ca_kappa = 1.3
velocity = "x"
gradient = "z"
with = "lees-edwards"

[vesicle_type.cell]
[vesicle_type.cell.bending]
modulus = 0.1

[suspension]
type = "cell"
shape = "discocyte"                  # as of a [[vesicle]]
reduced_volume = 0.8
radius = 12.5                        # of the sphere of equal volume
haematocrit = 0.2                    # or count = 14
orientation = "random"               # random | aligned (axis) | spread (axis, spread)
seed = 1                             # of places and orientations

[run]
steps = 30000                        # six strains

[output]
metrics = { every = 200 }            # effective_viscosity, particle_stress, gap; a row per cell
profiles = { every = 1000, across = "z" }
surfaces = { every = 2500 }
checkpoint = { every = 10000, keep = 2 }
)toml"},
}};
// clang-format on

} // namespace

std::span<const CaseTemplate> detail::flow_templates() {
    return templates;
}

} // namespace vesica
