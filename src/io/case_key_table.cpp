#include "io/case_key_parts.hpp"
#include "io/case_keys.hpp"

#include <limits>

namespace vesica {
namespace {

constexpr KeyRange positive{.low = 0.0, .low_open = true};
constexpr KeyRange relaxation_rate{.low = 0.0, .high = 2.0, .low_open = true, .high_open = true};
constexpr KeyRange step_count{.low = 0.0, .high = 1e15};
constexpr double inverse_sqrt_two = 0.70710678118654752;

std::vector<CaseKey> fluid_keys() {
    const auto rate = [](const std::string& name, const std::string& meaning) {
        return CaseKey{.path = "fluid.collision.ghost_rates." + name,
                       .kind = KeyKind::number,
                       .meaning = meaning,
                       .example = "1.0",
                       .range = relaxation_rate};
    };
    return {
        {.path = "fluid.kinematic_viscosity",
         .kind = KeyKind::number,
         .meaning = "of the outer fluid",
         .example = "0.1666667",
         .need = Need::one_of,
         .group = "the viscosity",
         .dimension = dimension::kinematic_viscosity,
         .range = {.low = 0.0, .high = 100.0, .low_open = true}},
        {.path = "fluid.relaxation_time",
         .kind = KeyKind::number,
         .meaning =
             "of the outer fluid's stress, in steps: viscosity (relaxation_time - 1/2)/3. Where [units] has "
             "density or reynolds it stands beside a viscosity with a unit and fixes the step; 1 if absent",
         .example = "1.0",
         .need = Need::one_of,
         .group = "the viscosity",
         .range = {.low = 0.5, .high = 300.5, .low_open = true},
         .reason = "which makes the viscosity positive"},
        {.path = "fluid.dynamic_viscosity",
         .kind = KeyKind::number,
         .meaning = "of the outer fluid; with fluid.density or units.density",
         .example = "\"1.2 mPa s\"",
         .need = Need::one_of,
         .group = "the viscosity",
         .dimension = dimension::dynamic_viscosity,
         .si = true,
         .range = positive},
        {.path = "fluid.density",
         .kind = KeyKind::number,
         .meaning = "of both fluids at rest; with a unit it fixes the scale of mass",
         .default_value = "1.0",
         .dimension = dimension::density,
         .range = {.low = 0.0, .high = 1000.0, .low_open = true}},
        {.path = "fluid.segregation",
         .kind = KeyKind::number,
         .meaning = "beta: the interface's half-width is 1/beta cells",
         .default_value = "0.67",
         .range = {.low = 0.0, .high = inverse_sqrt_two, .low_open = true},
         .reason = "1/sqrt 2, up to which both colours stay positive"},
        {.path = "fluid.collision.model",
         .kind = KeyKind::choice,
         .meaning = "many relaxation rates, or one",
         .default_value = "\"mrt\"",
         .choices = {"mrt", "bgk"}},
        {.path = "fluid.collision.basis",
         .kind = KeyKind::choice,
         .meaning = "of the moments: orthogonal and symmetric under the cube's 48 symmetries, or that of "
                    "Spendlove et "
                    "al. 2021, Table VI (corrected)",
         .default_value = "\"symmetric\"",
         .choices = {"symmetric", "paper"},
         .condition = {"model", {"mrt"}, true}},
        {.path = "fluid.collision.ghost_rates",
         .kind = KeyKind::choice_or_table,
         .meaning = "of the moments without hydrodynamic meaning: all one (symmetric basis only), two rates "
                    "bound by "
                    "`magic`, or a table of rates",
         .default_value = "\"regularised\"",
         .choices = {"regularised", "trt"},
         .condition = {"model", {"mrt"}, true}},
        {.path = "fluid.collision.magic",
         .kind = KeyKind::number,
         .meaning = "(1/lambda_even - 1/2)(1/lambda_odd - 1/2); 3/16 puts walls half-way between cells",
         .default_value = "0.1875",
         .range = {.low = 0.0, .high = 10.0, .low_open = true},
         .condition = {"ghost_rates", {"trt"}}},
        rate("even", "both even families (symmetric basis, with odd)"),
        rate("odd", "both odd families (symmetric basis, with even)"),
        rate("even_scalar", "of 3c^4 - 6c^2 + 1 (symmetric basis, with the three below)"),
        rate("even_tensor", "of (2c^2 - 3)(3c_x^2 - c^2) and (2c^2 - 3)(c_y^2 - c_z^2)"),
        rate("odd_vector", "of (3c^2 - 5) c"),
        rate("odd_twist", "of (c_y^2 - c_z^2) c_x and cyclic"),
        rate("l10", "lambda_10 (paper's basis, with the three below)"),
        rate("l11", "lambda_11 to lambda_13"),
        rate("l14", "lambda_14 to lambda_16"),
        rate("l17", "lambda_17 and lambda_18"),
    };
}

std::vector<CaseKey> vesicle_type_keys() {
    const std::string type = "vesicle_type.*.";
    const KeyRange modulus{.low = 0.0, .high = 1000.0};
    return {
        {.path = type + "viscosity_ratio",
         .kind = KeyKind::number,
         .meaning = "inner over outer",
         .default_value = "1.0",
         .range = {.low = 0.0, .high = 1000.0, .low_open = true}},
        {.path = type + "bending.modulus",
         .kind = KeyKind::number,
         .meaning = "kappa in the energy (kappa/2) int (2H - C0)^2 dA; 0 for a drop",
         .example = "0.25",
         .need = Need::one_of,
         .group = "the bending modulus",
         .dimension = dimension::energy,
         .range = modulus},
        {.path = type + "bending.paper_modulus",
         .kind = KeyKind::number,
         .meaning = "kappa_B = 4 kappa of Spendlove et al. 2021",
         .example = "1.0",
         .need = Need::one_of,
         .group = "the bending modulus",
         .dimension = dimension::energy,
         .range = {.low = 0.0, .high = 4000.0}},
        {.path = type + "bending.spontaneous_curvature",
         .kind = KeyKind::number,
         .meaning = "C0, positive where the membrane likes to be convex; 0 in the paper's form",
         .default_value = "0.0",
         .dimension = dimension::curvature,
         .range = {.low = -10.0, .high = 10.0}},
        {.path = type + "bending.form",
         .kind = KeyKind::choice,
         .meaning = "of the force: the energy's derivative, or that of Spendlove et al. 2021",
         .default_value = "\"helfrich\"",
         .choices = {"helfrich", "paper"}},
        {.path = type + "bending.laplacian_coefficient",
         .kind = KeyKind::number,
         .meaning = "c in kappa_B (c Lap_s H + H^3 - HK): 1.5 (their Eqs 13, 42) or 0.5 (Eq 32)",
         .default_value = "1.5",
         .condition = {"form", {"paper"}}},
        {.path = type + "area.constraint",
         .kind = KeyKind::choice,
         .meaning = "what holds the area: a tension that is exactly the needed one, a spring, the paper's "
                    "spring, or "
                    "nothing (a drop)",
         .default_value = "\"multiplier\"",
         .choices = {"multiplier", "penalty", "paper", "none"}},
        {.path = type + "area.modulus",
         .kind = KeyKind::number,
         .meaning = "K_A in the tension K_A (A - A_target)/A_target",
         .example = "0.01",
         .need = Need::required,
         .dimension = dimension::tension,
         .range = {.low = 0.0, .high = 100.0, .low_open = true},
         .condition = {"constraint", {"penalty"}}},
        {.path = type + "area.alpha",
         .kind = KeyKind::number,
         .meaning = "alpha in the tension (alpha/2) A (A - A_target)",
         .example = "1e-9",
         .need = Need::required,
         .dimension = dimension::tension_per_area_squared,
         .range = {.low = 0.0, .high = 100.0, .low_open = true},
         .condition = {"constraint", {"paper"}}},
        {.path = type + "area.deflation",
         .kind = KeyKind::number,
         .meaning =
             "target area over the area of the sphere of equal volume; absent: the initial area is kept",
         .example = "1.31",
         .need = Need::at_most_one,
         .group = "the target area",
         .range = {.low = 1.0, .high = 20.0},
         .reason = "since no surface around a volume is smaller than its sphere",
         .condition = {"constraint", {"multiplier", "penalty", "paper"}, true}},
        {.path = type + "area.reduced_volume",
         .kind = KeyKind::number,
         .meaning = "the same as deflation^(-3/2)",
         .example = "0.65",
         .need = Need::at_most_one,
         .group = "the target area",
         .range = {.low = 0.02, .high = 1.0},
         .reason = "1 being the sphere",
         .condition = {"constraint", {"multiplier", "penalty", "paper"}, true}},
        {.path = type + "area.ramp",
         .kind = KeyKind::steps,
         .meaning = "from the initial to the target area; over 5 eta R^3/kappa gives smooth shapes",
         .default_value = "0",
         .dimension = dimension::time,
         .range = step_count,
         .condition = {"constraint", {"multiplier", "penalty", "paper"}, true}},
        {.path = type + "tension.sigma",
         .kind = KeyKind::number,
         .meaning = "constant tension, added to the constraint's",
         .default_value = "0.0",
         .dimension = dimension::tension,
         .range = {.low = 0.0, .high = 10.0}},
        {.path = type + "buoyancy",
         .kind = KeyKind::point,
         .meaning = "force per volume on what is inside, as of another density; in a box without walls "
                    "everything is "
                    "pushed back by as much in all",
         .default_value = "[0, 0, 0]",
         .dimension = dimension::force_density,
         .range = {.low = -1.0, .high = 1.0}},
    };
}

std::vector<CaseKey> vesicle_keys() {
    const std::string mode = "vesicle[].perturbation[].";
    return {
        {.path = "vesicle[].centre",
         .kind = KeyKind::point,
         .meaning = "cell i spans [i, i + 1): a box of 80 cells has its centre at 40.0",
         .example = "[32, 32, 32]",
         .need = Need::required,
         .dimension = dimension::length},
        {.path = "vesicle[].radius",
         .kind = KeyKind::number,
         .meaning = "of the sphere of equal volume; may be left out for a mesh whose units are cells",
         .example = "15",
         .dimension = dimension::length,
         .range = positive},
        {.path = "vesicle[].axis",
         .kind = KeyKind::direction,
         .meaning = "of symmetry, of any length",
         .default_value = "[0, 0, 1]"},
        {.path = "vesicle[].buoyancy",
         .kind = KeyKind::point,
         .meaning = "of this vesicle, instead of its type's",
         .example = "[0, 0, 1e-6]",
         .dimension = dimension::force_density,
         .range = {.low = -1.0, .high = 1.0}},
        {.path = mode + "l",
         .kind = KeyKind::degree,
         .meaning = "degree of the spherical harmonic, or [lowest, highest] for random ones",
         .example = "2",
         .need = Need::required,
         .range = {.low = 2.0, .high = 32.0}},
        {.path = mode + "m",
         .kind = KeyKind::integer,
         .meaning = "order of the harmonic about the vesicle's axis, from -l to l; negative: sine",
         .default_value = "0",
         .range = {.low = -32.0, .high = 32.0},
         .condition = {"l", {"a whole number"}}},
        {.path = mode + "amplitude",
         .kind = KeyKind::number,
         .meaning = "relative to the radius; r.m.s. of all harmonics where they are random",
         .example = "-0.01",
         .need = Need::required,
         .range = {.low = -0.9, .high = 0.9}},
        {.path = mode + "seed",
         .kind = KeyKind::integer,
         .meaning = "of the random harmonics",
         .default_value = "1",
         .range = {.low = 0.0},
         .condition = {"l", {"[lowest, highest]"}}},
    };
}

std::vector<CaseKey> all_keys() {
    std::vector<CaseKey> keys{
        {.path = "title",
         .kind = KeyKind::text,
         .meaning = "of the case, for people",
         .example = "\"A resting vesicle\"",
         .default_value = "\"\""},
        {.path = "lattice.size",
         .kind = KeyKind::cells,
         .meaning = "of the fluid's box, periodic but where [boundary] or [flow.shear] has walls",
         .example = "[64, 64, 64]",
         .need = Need::required,
         .range = {.low = 1.0, .high = 65536.0}},
    };
    for (const auto& part :
         {fluid_keys(), vesicle_type_keys(), detail::shape_keys("vesicle[]"), vesicle_keys(),
          detail::suspension_keys(), detail::flow_keys(), detail::run_and_output_keys()})
        keys.insert(keys.end(), part.begin(), part.end());
    return keys;
}

} // namespace

const std::vector<CaseKey>& case_keys() {
    static const std::vector<CaseKey> keys = all_keys();
    return keys;
}

} // namespace vesica
