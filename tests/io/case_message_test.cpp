#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

// Each row changes the first occurrence of one text in cases/discocyte.toml and expects the whole message.

TEST_CASE("what is stated twice or not at all is refused") {
    check_messages({
        {"kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\n",
         "kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\nrelaxation_time = 1.0\n",
         "case.toml:8:19: fluid.relaxation_time is 1.0; expected the viscosity to be stated once, but "
         "fluid.kinematic_viscosity is 0.1666667; try removing one of them"},
        {"kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\n",
         "",
         "case.toml:6:1: fluid.kinematic_viscosity is missing; expected exactly one of kinematic_viscosity, "
         "relaxation_time or dynamic_viscosity, to state the viscosity; try kinematic_viscosity = 0.1666667"},
        {"modulus = 0.25", "modulus = 0.25\npaper_modulus = 1.0",
         "case.toml:19:17: vesicle_type.rbc.bending.paper_modulus is 1.0; expected the bending modulus to be "
         "stated once, but vesicle_type.rbc.bending.modulus is 0.25; try removing one of them"},
        {"modulus = 0.25  ", "#",
         "case.toml:17:1: vesicle_type.rbc.bending.modulus is missing; expected exactly one of modulus or "
         "paper_modulus, to state the bending modulus; try modulus = 0.25"},
        {"deflation = 1.31", "reduced_volume = 0.65\ndeflation = 1.31",
         "case.toml:24:13: vesicle_type.rbc.area.deflation is 1.31; expected the target area to be stated "
         "once, but vesicle_type.rbc.area.reduced_volume is 0.65; try removing one of them"},
        {"steps = 40000", "steps = 40000\ntime = 40000",
         "case.toml:47:8: run.time is 40000; expected the length of the run to be stated once, but run.steps "
         "is 40000; try removing one of them"},
        {"steps = 40000", "",
         "case.toml:45:1: run.steps is missing; expected exactly one of steps or time, to state the length "
         "of the run; try steps = 40000"},
        {"[lattice]\nsize = [64, 64, 64]", "",
         "case.toml: lattice.size is missing; expected three whole numbers at least 1 and at most 65536; try "
         "size = [64, 64, 64]"},
        {"size = [64, 64, 64]", "",
         "case.toml:3:1: lattice.size is missing; expected three whole numbers at least 1 and at most 65536; "
         "try size = [64, 64, 64]"},
        {"type = \"rbc\"", "",
         "case.toml:28:1: vesicle[0].type is missing; expected text; try type = \"rbc\""},
        {"shape = \"sphere\"", "#",
         "case.toml:28:1: vesicle[0].shape is missing; expected \"sphere\", \"spheroid\", \"discocyte\", "
         "\"prolate\", \"stomatocyte\", \"evans-fung\" or \"mesh\"; try shape = \"sphere\""},
        {"radius = 15", "#",
         "case.toml:28:1: vesicle[0].radius is missing; expected a length above 0, as the shape is no mesh; "
         "try radius = 15"},
        {"centre = [32, 32, 32]", "#",
         "case.toml:28:1: vesicle[0].centre is missing; expected three numbers of length; try centre = [32, "
         "32, 32]"},
        {"l = 2\n", "",
         "case.toml:34:1: vesicle[0].perturbation[0].l is missing; expected a whole number or [lowest, "
         "highest], at least 2 and at most 32; try l = 2"},
        {"fields = { every = 10000, ", "fields = { ",
         "case.toml:52:10: output.fields.every is missing; expected a whole number of steps, or a time, at "
         "least 0 and at most 1e+15; try every = 10000"},
        {"quantity = \"bending_energy\", ", "",
         "case.toml:47:20: run.stop_when_steady.quantity is missing; expected \"area\", \"area_ratio\", "
         "\"volume\", \"reduced_volume\", \"bending_energy\", \"mean_curvature_integral\", "
         "\"gaussian_curvature_over_pi\", \"inertia_1\", \"inertia_2\", \"inertia_3\", \"x\", \"y\", \"z\", "
         "\"vx\", \"vy\", \"vz\", \"deformation_index\", \"taylor_deformation\", \"inclination\", "
         "\"tension\", \"tank_treading_frequency\", \"particle_stress\", \"effective_viscosity\", "
         "\"wall_stress\" or \"max_speed\"; try quantity = "
         "\"bending_energy\""},
    });
}

TEST_CASE("values that do not go together are refused") {
    check_messages({
        {"type = \"rbc\"", "type = \"rcb\"",
         "case.toml:29:8: vesicle[0].type is \"rcb\"; expected \"rbc\"; try type = \"rbc\""},
        {"shape = \"sphere\"", "aspect = 2.0\nshape = \"sphere\"",
         "case.toml:30:10: vesicle[0].aspect is 2.0; expected aspect only with shape = \"spheroid\", but "
         "vesicle[0].shape is \"sphere\"; try removing it"},
        {"shape = \"sphere\"", "shape = \"spheroid\"",
         "case.toml:28:1: vesicle[0].aspect is missing; expected a number at least 0.02 and at most 50; try "
         "aspect = 0.5"},
        {"shape = \"sphere\"", "shape = \"discocyte\"",
         "case.toml:28:1: vesicle[0].reduced_volume is missing; expected a number above 0 and at most 1, 1 "
         "being the sphere; try reduced_volume = 0.65"},
        {"shape = \"sphere\"", "shape = \"mesh\"",
         "case.toml:28:1: vesicle[0].file is missing; expected text; try file = \"cell.stl\""},
        {"amplitude = -0.01", "amplitude = -0.01\nseed = 3",
         "case.toml:38:8: vesicle[0].perturbation[0].seed is 3; expected seed only with l = [lowest, "
         "highest], but vesicle[0].perturbation[0].l is 2; try removing it"},
        {"l = 2\nm = 0\n", "l = [2, 6]\n",
         "case.toml:36:13: vesicle[0].perturbation[0].amplitude is -0.01; expected at least 0, being an "
         "r.m.s. of random harmonics; try amplitude = 0.01"},
        {"constraint = \"multiplier\"", "constraint = \"penalty\"",
         "case.toml:21:1: vesicle_type.rbc.area.modulus is missing; expected a tension above 0 and at most "
         "100; try modulus = 0.01"},
        {"constraint = \"multiplier\"", "constraint = \"paper\"",
         "case.toml:21:1: vesicle_type.rbc.area.alpha is missing; expected a tension per area squared above "
         "0 and at most 100; try alpha = 1e-9"},
        {"constraint = \"multiplier\"", "alpha = 1e-9\nconstraint = \"multiplier\"",
         "case.toml:22:9: vesicle_type.rbc.area.alpha is 1e-09; expected alpha only with constraint = "
         "\"paper\", but vesicle_type.rbc.area.constraint is \"multiplier\"; try removing it"},
        {"form = \"helfrich\"", "laplacian_coefficient = 0.5\nform = \"helfrich\"",
         "case.toml:20:25: vesicle_type.rbc.bending.laplacian_coefficient is 0.5; expected "
         "laplacian_coefficient only with form = \"paper\", but vesicle_type.rbc.bending.form is "
         "\"helfrich\"; try removing it"},
        {"form = \"helfrich\"", "laplacian_coefficient = 1.0\nform = \"paper\"",
         "case.toml:20:25: vesicle_type.rbc.bending.laplacian_coefficient is 1.0; expected 1.5 or 0.5; try "
         "laplacian_coefficient = 1.5"},
        {"spontaneous_curvature = 0.0\nform = \"helfrich\"", "spontaneous_curvature = 0.1\nform = \"paper\"",
         "case.toml:19:25: vesicle_type.rbc.bending.spontaneous_curvature is 0.1; expected 0 with form = "
         "\"paper\", which has no spontaneous curvature; try form = \"helfrich\""},
        {"basis = \"symmetric\"", "basis = \"paper\"",
         "case.toml:13:15: fluid.collision.ghost_rates is \"regularised\"; expected \"trt\" or a table of "
         "l10, l11, l14 and l17 in the paper's basis, where rates of one are not symmetric; try ghost_rates "
         "= \"trt\""},
        {"ghost_rates = \"regularised\"", "ghost_rates = { even = 1.0 }",
         "case.toml:13:15: fluid.collision.ghost_rates.odd is missing; expected even and odd together; try "
         "odd = 1.0"},
        {"ghost_rates = \"regularised\"", "ghost_rates = {}",
         "case.toml:13:15: fluid.collision.ghost_rates is a table; expected a complete set of rates; try "
         "ghost_rates = { even = 1.0, odd = 1.0 }"},
        {"ghost_rates = \"regularised\"", "ghost_rates = { even = 1.0, odd = 1.0, odd_twist = 1.0 }",
         "case.toml:13:52: fluid.collision.ghost_rates.odd_twist is 1.0; expected even and odd, or "
         "even_scalar, even_tensor, odd_vector and odd_twist, in the symmetric basis; try one complete set "
         "of rates of one basis"},
        {"ghost_rates = \"regularised\"", "ghost_rates = { l10 = 1.0, l11 = 1.0, l14 = 1.0, l17 = 1.0 }",
         "case.toml:13:23: fluid.collision.ghost_rates.l10 is 1.0; expected even and odd, or even_scalar, "
         "even_tensor, odd_vector and odd_twist, in the symmetric basis; try one complete set of rates of "
         "one basis"},
        {"ghost_rates = \"regularised\"", "magic = 0.25\nghost_rates = \"regularised\"",
         "case.toml:13:9: fluid.collision.magic is 0.25; expected magic only with ghost_rates = \"trt\", but "
         "fluid.collision.ghost_rates is \"regularised\"; try removing it"},
    });
}

TEST_CASE("an unknown key is refused with the nearest known one") {
    check_messages({
        {"kinematic_viscosity =", "kinematic_viscocity =",
         "case.toml:7:1: fluid.kinematic_viscocity is not a known key; expected kinematic_viscosity, "
         "relaxation_time, dynamic_viscosity, density, segregation or collision; try "
         "fluid.kinematic_viscosity"},
        {"[lattice]", "[latice]",
         "case.toml:3:2: latice is not a known key; expected title, lattice, fluid, "
         "boundary, obstacles, flow, vesicle, suspension, initial, numerics, run, output, tracers, units or "
         "vesicle_type; try "
         "lattice"},
        {"radius = 15", "rad = 15",
         "case.toml:32:1: vesicle[0].rad is not a known key; expected type, shape, aspect, reduced_volume, "
         "file, centre, radius, axis, buoyancy or perturbation; try vesicle[0].radius"},
        {"radius = 15", "viscosity_ratio = 15",
         "case.toml:32:1: vesicle[0].viscosity_ratio is not a known key; expected type, shape, aspect, "
         "reduced_volume, file, centre, radius, axis, buoyancy or perturbation; try "
         "vesicle_type.NAME.viscosity_ratio"},
        {"[vesicle_type.rbc.bending]", "[vesicle_type.rbc.bendin]",
         "case.toml:17:19: vesicle_type.rbc.bendin is not a known key; expected viscosity_ratio, buoyancy, "
         "bending, area or tension; try vesicle_type.rbc.bending"},
        {"viscosity_ratio = 1.0", "modulus = 1.0",
         "case.toml:16:1: vesicle_type.rbc.modulus is not a known key; expected viscosity_ratio, buoyancy, "
         "bending, area or tension; try vesicle_type.rbc.bending.modulus"},
        {"[numerics]", "[numerics]\nevery = 3",
         "case.toml:40:1: numerics.every is not a known key; expected geometry, cutoff, precision or device; "
         "try output.metrics.every"},
        {"[[vesicle.perturbation]]", "[[vesicle.perturbations]]",
         "case.toml:34:11: vesicle[0].perturbations is not a known key; expected type, shape, aspect, "
         "reduced_volume, file, centre, radius, axis, buoyancy or perturbation; try vesicle[0].perturbation"},
        {"metrics = { every = 200 }", "metrics = { ever = 200 }",
         "case.toml:51:13: output.metrics.ever is not a known key; expected every; try output.metrics.every"},
    });
}

TEST_CASE("what is not available yet is refused and says so") {
    check_messages({
        {"device = \"cpu\"", "device = \"cuda\"",
         "case.toml:43:10: numerics.device is \"cuda\"; that is not available yet; expected \"cpu\" or "
         "\"auto\"; try device = \"cpu\""},
    });
}

TEST_CASE("text that is no TOML is refused at its place") {
    check_messages({
        {"title = \"A", "title = A",
         "case.toml:1:9: the text is no TOML (Error while parsing value: could not determine value type); "
         "expected TOML 1.0; try completing or correcting the text at this place"},
        {"[numerics]", "[fluid]\n[numerics]",
         "case.toml:39:1: the text is no TOML (Error while parsing table header: cannot redefine existing "
         "table 'fluid'); expected TOML 1.0; try completing or correcting the text at this place"},
        {"segregation = 0.67", "segregation = 0.67\nsegregation = 0.67",
         "case.toml:10:15: the text is no TOML (Error while parsing key-value pair: cannot redefine existing "
         "floating-point 'segregation'); expected TOML 1.0; try completing or correcting the text at this "
         "place"},
        {"keep = 2 }", "",
         "case.toml:54:31: the text is no TOML (Error while parsing inline table: expected key or closing "
         "'}', saw '\\n'); expected TOML 1.0; try completing or correcting the text at this place"},
    });
}
