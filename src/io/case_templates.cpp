#include "io/case_templates.hpp"

#include "io/case_template_parts.hpp"

#include <array>
#include <vector>

namespace vesica {
namespace {

// clang-format off
constexpr std::array<CaseTemplate, 6> templates{{
{"discocyte", "a sphere deflated to a discocyte", R"toml(title = "A discocyte from a deflated sphere"

[lattice]
size = [64, 64, 64]

[fluid]
kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and fluid.density
density = 1.0
segregation = 0.67                   # beta; interface half-width 1/beta
[fluid.collision]
model = "mrt"                        # mrt | bgk
basis = "symmetric"                  # symmetric | paper
ghost_rates = "regularised"          # regularised (symmetric basis only) | trt (with magic = 0.1875) | { even = ..., odd = ... } | { l10, l11, l14, l17 } in the paper's basis

[vesicle_type.rbc]
viscosity_ratio = 1.0                # inner / outer
[vesicle_type.rbc.bending]
modulus = 0.25                       # kappa; the paper's kappa_B = 4 kappa as paper_modulus
spontaneous_curvature = 0.0
form = "helfrich"                    # helfrich | paper, then laplacian_coefficient = 1.5 or 0.5
[vesicle_type.rbc.area]
constraint = "multiplier"            # multiplier | penalty (modulus = K_A) | paper (alpha) | none
deflation = 1.31                     # A_target / area of the sphere of equal volume; or reduced_volume; absent: keep the initial area
ramp = 12000                         # steps from the initial to the target area
[vesicle_type.rbc.tension]
sigma = 1e-5

[[vesicle]]
type = "rbc"
shape = "sphere"                     # sphere | spheroid (aspect = length along axis / width) | discocyte, prolate, stomatocyte (exact Helfrich shape of reduced_volume) | evans-fung | mesh (file)
centre = [32, 32, 32]
radius = 15                          # of the sphere of equal volume
axis = [0, 0, 1]
[[vesicle.perturbation]]             # spherical harmonics; or { amplitude, l = [2, 6], seed } for seeded random ones
l = 2
m = 0
amplitude = -0.01

[numerics]
geometry = "mapped"                  # mapped (physics.md, section 3) | paper (Eq 38 and the three frames)
cutoff = 1e-2                        # forces are tapered to zero below this 1 - phi^2
precision = "double"                 # double | single
device = "cpu"                       # cpu | cuda | auto

[run]
steps = 40000                        # or time
stop_when_steady = { quantity = "bending_energy", relative_change = 1e-7, over = 2000 }   # optional
wall_time = "2 h"                    # optional

[output]
metrics = { every = 200 }
fields = { every = 10000, names = ["phase", "velocity", "pressure", "force", "mean_curvature", "gaussian_curvature"] }   # optional region, stride, average
surfaces = { every = 2000 }
checkpoint = { every = 10000, keep = 2 }
)toml"},
{"prolate", "an exact prolate shape at rest", R"toml(title = "A prolate vesicle at rest"

# Starts from the exact minimiser of the bending energy at this reduced volume and lets the lattice find its own
# equilibrium, which should stay within a percent: bending_energy 1.387 in metrics.csv (a sphere has 1).

[lattice]
size = [44, 44, 88]                  # cells; the box is periodic

[fluid]
kinematic_viscosity = 0.5            # a viscous fluid keeps inertia small
segregation = 0.67                   # beta; the interface is about 2/beta = 3 cells wide

[vesicle_type.lipid]
viscosity_ratio = 1.0                # inner over outer
[vesicle_type.lipid.bending]
modulus = 1.0                        # kappa; shapes relax over eta R0^3/kappa = 4000 steps
[vesicle_type.lipid.area]
constraint = "multiplier"            # without deflation: the initial area is kept

[[vesicle]]
type = "lipid"
shape = "prolate"
reduced_volume = 0.8                 # 1 is a sphere
centre = [22, 22, 44]
radius = 20                          # of the sphere of equal volume
axis = [0, 0, 1]

[run]
steps = 12000
stop_when_steady = { quantity = "bending_energy", relative_change = 1e-5, over = 2000 }

[output]
metrics = { every = 100 }
surfaces = { every = 2000 }
checkpoint = { every = 4000, keep = 2 }
)toml"},
{"stomatocyte", "an exact stomatocyte (cup) at rest", R"toml(title = "A stomatocyte at rest"

# The cup-shaped minimiser of the bending energy. Its rim is tightly curved, so it wants more cells than a discocyte:
# `vesica check` prints beta times the smallest radius of curvature, which should be at least 3.5.

[lattice]
size = [68, 68, 60]

[fluid]
kinematic_viscosity = 0.5
segregation = 0.67

[vesicle_type.lipid]
viscosity_ratio = 1.0
[vesicle_type.lipid.bending]
modulus = 1.0
[vesicle_type.lipid.area]
constraint = "multiplier"            # keeps the initial area

[[vesicle]]
type = "lipid"
shape = "stomatocyte"
reduced_volume = 0.65                # exists up to about 0.66
centre = [34, 34, 30]
radius = 28
axis = [0, 0, 1]                     # the cup opens along it

[run]
steps = 6000

[output]
metrics = { every = 100 }
surfaces = { every = 1000 }
checkpoint = { every = 3000, keep = 2 }
)toml"},
{"relaxation", "a drop without membrane relaxes to a sphere", R"toml(title = "A drop relaxes to a sphere"

# No membrane: constant surface tension only, as between two fluids. The l = 2 ripple decays at the rate
# 40 (1 + r)/((2 r + 3)(19 r + 16)) sigma/(eta R), r = viscosity ratio: 1/3280 steps here.

[lattice]
size = [48, 48, 48]

[fluid]
kinematic_viscosity = 0.5
density = 1.0
segregation = 0.67

[vesicle_type.drop]
viscosity_ratio = 1.0
[vesicle_type.drop.bending]
modulus = 0.0                        # nothing resists bending
[vesicle_type.drop.area]
constraint = "none"                  # the area is free
[vesicle_type.drop.tension]
sigma = 0.005                        # surface tension

[[vesicle]]
type = "drop"
shape = "sphere"
centre = [24, 24, 24]
radius = 15
axis = [0, 0, 1]
[[vesicle.perturbation]]             # r -> r (1 + amplitude Y_lm)
l = 2
m = 0
amplitude = 0.05                     # elongated along the axis

[run]
steps = 8000

[output]
metrics = { every = 50 }
surfaces = { every = 1000 }
)toml"},
{"real-units", "a red-cell-like vesicle in micrometres", R"toml(title = "A red-cell-like vesicle in micrometres"

# The shape of a red cell (Evans and Fung 1972) is not the one that bending alone prefers: it relaxes towards the
# discocyte of the same area and volume. Values with a unit are converted by [units]; numbers without one are in cells
# and steps. `vesica check` prints both side by side.

[units]
cell = "0.18 um"
reynolds = 0.2                       # rho kappa/(eta^2 R0): inertia is scaled up to it (the real cell has 5e-5, which no
                                     # lattice can afford); viscosity, moduli, lengths and times stay real

[lattice]
size = [56, 56, 40]                  # 10.1 x 10.1 x 7.2 um

[fluid]
dynamic_viscosity = "1.2 mPa s"      # plasma
density = "1000 kg/m^3"
relaxation_time = 1.0                # the lattice's own choice, which sets the step
segregation = 0.67

[vesicle_type.red-cell]
viscosity_ratio = 5.0                # haemoglobin: 6 mPa s
[vesicle_type.red-cell.bending]
modulus = "2e-19 J"
[vesicle_type.red-cell.area]
constraint = "multiplier"            # keeps the initial area, 134 um^2

[[vesicle]]
type = "red-cell"
shape = "evans-fung"
centre = [28, 28, 20]
radius = "2.8216 um"                 # of the sphere of equal volume, 94.09 um^3
axis = [0, 0, 1]

[run]
time = "0.1 s"

[output]
metrics = { every = "1 ms" }
surfaces = { every = "10 ms" }
checkpoint = { every = "50 ms", keep = 2 }
)toml"},
{"spheroid", "an elongated spheroid relaxes, perturbed by seeded ripples", R"toml(title = "An elongated spheroid finds its shape"

# A spheroid is not a shape of least bending energy. With its area and volume kept it relaxes to the prolate vesicle of
# the same reduced volume; seeded random ripples make sure that no symmetry of the start is left.

[lattice]
size = [48, 48, 80]

[fluid]
kinematic_viscosity = 0.5
segregation = 0.67

[vesicle_type.lipid]
viscosity_ratio = 1.0
[vesicle_type.lipid.bending]
modulus = 1.0
spontaneous_curvature = 0.0          # C0: what the membrane would like 2H to be
[vesicle_type.lipid.area]
constraint = "multiplier"

[[vesicle]]
type = "lipid"
shape = "spheroid"
aspect = 2.0                         # length along the axis over width; below 1: oblate
centre = [24, 24, 40]
radius = 18
axis = [0, 0, 1]
[[vesicle.perturbation]]
l = [2, 6]                           # every harmonic of these degrees,
amplitude = 0.005                    # 0.5 % of the radius altogether (r.m.s.),
seed = 1                             # the same ones every time

[run]
steps = 12000
stop_when_steady = { quantity = "bending_energy", relative_change = 1e-5, over = 2000 }

[output]
metrics = { every = 100 }
fields = { every = 4000, names = ["phase", "velocity", "pressure"], region = [[0, 24, 0], [48, 25, 80]] }
surfaces = { every = 2000 }
checkpoint = { every = 4000, keep = 2 }
)toml"},
}};
// clang-format on

} // namespace

std::span<const CaseTemplate> case_templates() {
    static const std::vector<CaseTemplate> all = [] {
        std::vector<CaseTemplate> list(templates.begin(), templates.end());
        const auto flow = detail::flow_templates();
        list.insert(list.end(), flow.begin(), flow.end());
        return list;
    }();
    return all;
}

} // namespace vesica
