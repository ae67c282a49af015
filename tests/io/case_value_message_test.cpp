#include "case_file_samples.hpp"

#include <catch2/catch.hpp>

using namespace vesica;

// Each row changes the first occurrence of one text in cases/discocyte.toml and expects the whole message.

TEST_CASE("a value of the wrong type is refused") {
    check_messages({
        {"title = \"A discocyte from a deflated sphere\"", "title = 3",
         "case.toml:1:9: title is 3; expected text; try title = \"A resting vesicle\""},
        {"size = [64, 64, 64]", "size = 64",
         "case.toml:4:8: lattice.size is 64; expected three whole numbers at least 1 and at most 65536; try "
         "size = [64, 64, 64]"},
        {"size = [64, 64, 64]", "size = [64, 64]",
         "case.toml:4:8: lattice.size is [64, 64]; expected three whole numbers at least 1 and at most "
         "65536; try size = [64, 64, 64]"},
        {"size = [64, 64, 64]", "size = [64, 64, 64.5]",
         "case.toml:4:17: lattice.size[2] is 64.5; expected three whole numbers at least 1 and at most "
         "65536; try size = [64, 64, 64]"},
        {"density = 1.0", "density = \"1.0\"",
         "case.toml:8:11: fluid.density is \"1.0\"; expected a density as a number without quotes or as text "
         "with a unit; try density = \"1000 kg/m^3\""},
        {"density = 1.0", "density = true",
         "case.toml:8:11: fluid.density is true; expected a density above 0 and at most 1000; try density = "
         "1.0"},
        {"density = 1.0", "density = 2020-01-01",
         "case.toml:8:11: fluid.density is a date or time; expected a density above 0 and at most 1000; try "
         "density = 1.0"},
        {"segregation = 0.67", "segregation = \"0.67\"",
         "case.toml:9:15: fluid.segregation is \"0.67\"; expected a number above 0 and at most 0.707107, "
         "1/sqrt 2, up to which both colours stay positive; try segregation = 0.67"},
        {"model = \"mrt\"", "model = 1",
         "case.toml:11:9: fluid.collision.model is 1; expected \"mrt\" or \"bgk\"; try model = \"mrt\""},
        {"model = \"mrt\"", "model = \"srt\"",
         "case.toml:11:9: fluid.collision.model is \"srt\"; expected \"mrt\" or \"bgk\"; try model = "
         "\"mrt\""},
        {"ghost_rates = \"regularised\"", "ghost_rates = \"regularized\"",
         "case.toml:13:15: fluid.collision.ghost_rates is \"regularized\"; expected \"regularised\", \"trt\" "
         "or a table; try ghost_rates = \"regularised\""},
        {"viscosity_ratio = 1.0", "viscosity_ratio = [1.0]",
         "case.toml:16:19: vesicle_type.rbc.viscosity_ratio is [1.0]; expected a number above 0 and at most "
         "1000; try viscosity_ratio = 1.0"},
        {"centre = [32, 32, 32]", "centre = [32, \"32\", 32]",
         "case.toml:31:15: vesicle[0].centre[1] is \"32\"; expected a length as a number without quotes or "
         "as text with a unit; try centre = [32, 32, 32]"},
        {"axis = [0, 0, 1]", "axis = [0, 0, \"z\"]",
         "case.toml:33:15: vesicle[0].axis[2] is \"z\"; expected three numbers, not all zero; try axis = [0, "
         "0, 1]"},
        {"l = 2\n", "l = [6, 2]\n",
         "case.toml:35:5: vesicle[0].perturbation[0].l is [6, 2]; expected a whole number or [lowest, "
         "highest], at least 2 and at most 32; try l = 2"},
        {"l = 2\n", "l = [2, 4, 6]\n",
         "case.toml:35:5: vesicle[0].perturbation[0].l is [2, 4, 6]; expected a whole number or [lowest, "
         "highest], at least 2 and at most 32; try l = 2"},
        {"steps = 40000", "steps = \"40000\"",
         "case.toml:46:9: run.steps is \"40000\"; expected a whole number at least 0 and at most 1e+15; try "
         "steps = 40000"},
        {"steps = 40000", "steps = 1.5",
         "case.toml:46:9: run.steps is 1.5; expected a whole number at least 0 and at most 1e+15; try steps "
         "= 40000"},
        {"wall_time = \"2 h\"", "wall_time = 7200",
         "case.toml:48:13: run.wall_time is 7200; expected a time above 0 with its unit; try wall_time = \"2 "
         "h\""},
        {"names = [\"phase\",", "names = [3,",
         "case.toml:52:36: output.fields.names[0] is 3; expected an array of \"phase\", \"velocity\", "
         "\"pressure\", \"force\", \"mean_curvature\" and \"gaussian_curvature\"; try names = [\"phase\", "
         "\"velocity\"]"},
        {"names = [\"phase\",", "names = [\"phases\",",
         "case.toml:52:36: output.fields.names[0] is \"phases\"; expected an array of \"phase\", "
         "\"velocity\", \"pressure\", \"force\", \"mean_curvature\" and \"gaussian_curvature\"; try "
         "\"phase\""},
        {"names = [\"phase\",", "names = [\"force\",",
         "case.toml:52:69: output.fields.names[3] is \"force\"; expected every name once; try names = "
         "[\"phase\", \"velocity\"]"},
        {"metrics = { every = 200 }", "metrics = 200",
         "case.toml:51:11: output.metrics is 200; expected a table; try [output.metrics]"},
        {"metrics = { every = 200 }", "metrics = { every = [200] }",
         "case.toml:51:21: output.metrics.every is [200]; expected a whole number of steps, or a time, at "
         "least 0 and at most 1e+15; try every = 100"},
        {"fields = { every = 10000,", "fields = { every = 10000, average = 1,",
         "case.toml:52:37: output.fields.average is 1; expected true or false; try average = false"},
        {"fields = { every = 10000,", "fields = { every = 10000, region = [0, 64],",
         "case.toml:52:36: output.fields.region is [0, 64]; expected two corners [[x, y, z], [x, y, z]] in "
         "whole cells; try region = [[0, 0, 0], [64, 64, 64]]"},
        {"[[vesicle]]", "[vesicle]",
         "case.toml:28:1: vesicle is a table; expected an array of tables; try [[vesicle]]"},
        {"[lattice]\nsize = [64, 64, 64]", "lattice = 3",
         "case.toml:3:11: lattice is 3; expected a table; try [lattice]"},
        {"[vesicle_type.rbc]\n", "[vesicle_type.\"r b c\"]\n",
         "case.toml:15:15: vesicle_type has the name \"r b c\"; expected letters, digits, _ and -; try "
         "[vesicle_type.rbc]"},
        {"[vesicle_type.rbc]\n", "[vesicle_type]\nmodulus = 3\n[vesicle_type.rbc]\n",
         "case.toml:16:11: vesicle_type.modulus is 3; expected a table named after the type; try "
         "[vesicle_type.rbc]"},
    });
}

TEST_CASE("a unit that is wrong, missing or has no scales is refused") {
    check_messages({
        {"radius = 15", "radius = \"3.9 um\"",
         "case.toml:32:10: vesicle[0].radius is \"3.9 um\"; expected a number in lattice units, since there "
         "is no [units]; try adding [units] with cell and time_step"},
        {"radius = 15", "radius = \"3.9 furlong\"",
         "case.toml:32:10: vesicle[0].radius is \"3.9 furlong\"; expected a known unit instead of furlong: "
         "m, s, kg, g, N, Pa, J, Hz, L, P, dyn, erg with a prefix, min and h"},
        {"radius = 15", "radius = \"3 s\"",
         "case.toml:32:10: vesicle[0].radius is \"3 s\", a time; expected a length; try radius = \"3.9 um\""},
        {"wall_time = \"2 h\"", "wall_time = \"2 m\"",
         "case.toml:48:13: run.wall_time is \"2 m\", a length; expected a time; try wall_time = \"2 h\""},
        {"wall_time = \"2 h\"", "wall_time = \"-2 h\"",
         "case.toml:48:13: run.wall_time is \"-2 h\"; expected a time above 0 with its unit; try wall_time = "
         "\"2 h\""},
        {"centre = [32, 32, 32]", "centre = [32, \"3 um\", 32]",
         "case.toml:31:15: vesicle[0].centre is [32, \"3 um\", 32]; expected a number in lattice units, "
         "since there is no [units]; try adding [units] with cell and time_step"},
        {"kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\n",
         "dynamic_viscosity = \"1.2 mPa s\"\n",
         "case.toml:7:21: fluid.dynamic_viscosity is \"1.2 mPa s\"; expected [units], without which no value "
         "has a unit; try kinematic_viscosity in lattice units, or adding [units] with cell and time_step"},
        {"kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\n",
         "dynamic_viscosity = 0.2\n",
         "case.toml:7:21: fluid.dynamic_viscosity is 0.2; expected a dynamic viscosity above 0 with its "
         "unit; try dynamic_viscosity = \"1.2 mPa s\""},
        {"steps = 40000", "time = \"0.2 s\"",
         "case.toml:46:8: run.time is \"0.2 s\"; expected a number in lattice units, since there is no "
         "[units]; try adding [units] with cell and time_step"},
        {"[numerics]", "[units]\ncell = \"0.2 um\"\n[numerics]",
         "case.toml:39:1: units.time_step is missing; expected exactly one of time_step, density or "
         "reynolds, to state the scales of time and mass; try time_step = \"1 us\""},
        {"[numerics]", "[units]\ntime_step = \"1 us\"\n[numerics]",
         "case.toml:39:1: units.cell is missing; expected a length above 0 with its unit; try cell = \"0.2 "
         "um\""},
        {"[numerics]", "[units]\ncell = 0.2\ntime_step = \"1 us\"\n[numerics]",
         "case.toml:40:8: units.cell is 0.2; expected a length above 0 with its unit; try cell = \"0.2 um\""},
        {"[numerics]", "[units]\ncell = \"0.2 um\"\ntime_step = \"1 us\"\nreynolds = 0.1\n[numerics]",
         "case.toml:42:12: units.reynolds is 0.1; expected the scales of time and mass to be stated once, "
         "but units.time_step is \"1 us\"; try removing one of them"},
        {"[numerics]", "[units]\ncell = \"0.2 um\"\ntime_step = \"1 us\"\n[numerics]",
         "case.toml:8:11: fluid.density is 1.0; expected a density with its unit, which fixes the scale of "
         "mass beside units.time_step; try density = \"1000 kg/m^3\""},
        {"[numerics]", "[units]\ncell = \"0.2 um\"\ndensity = \"1000 kg/m^3\"\n[numerics]",
         "case.toml:7:23: fluid.kinematic_viscosity is 0.1666667; expected a viscosity with its unit, from "
         "which units.density finds the step; try dynamic_viscosity = \"1.2 mPa s\""},
        {"[numerics]", "[units]\ncell = \"0.2 um\"\nreynolds = 0.1\n[numerics]",
         "case.toml:8:11: fluid.density is 1.0; expected a density with its unit, from which units.reynolds "
         "scales the inertia; try density = \"1000 kg/m^3\""},
    });
}

TEST_CASE("a value out of its range is refused") {
    check_messages({
        {"size = [64, 64, 64]", "size = [64, 0, 64]",
         "case.toml:4:13: lattice.size[1] is 0; expected three whole numbers at least 1 and at most 65536; "
         "try size = [64, 64, 64]"},
        {"size = [64, 64, 64]", "size = [64, 64, 100000]",
         "case.toml:4:17: lattice.size[2] is 100000; expected three whole numbers at least 1 and at most "
         "65536; try size = [64, 64, 64]"},
        {"size = [64, 64, 64]", "size = [2000, 2000, 2000]",
         "case.toml:4:8: lattice.size is [2000, 2000, 2000]; expected at most 2147483647 cells, not 8e+09; "
         "try a smaller box"},
        {"= 0.1666667", "= 0.0",
         "case.toml:7:23: fluid.kinematic_viscosity is 0.0; expected a kinematic viscosity above 0 and at "
         "most 100; try kinematic_viscosity = 0.1666667"},
        {"= 0.1666667", "= nan",
         "case.toml:7:23: fluid.kinematic_viscosity is nan; expected a kinematic viscosity above 0 and at "
         "most 100; try kinematic_viscosity = 0.1666667"},
        {"= 0.1666667", "= -inf",
         "case.toml:7:23: fluid.kinematic_viscosity is -inf; expected a kinematic viscosity above 0 and at "
         "most 100; try kinematic_viscosity = 0.1666667"},
        {"kinematic_viscosity = 0.1666667      # or relaxation_time; dynamic_viscosity only with a unit and "
         "fluid.density\n",
         "relaxation_time = 0.5\n",
         "case.toml:7:19: fluid.relaxation_time is 0.5; expected a number above 0.5 and at most 300.5, which "
         "makes the viscosity positive; try relaxation_time = 1.0"},
        {"density = 1.0", "density = 0",
         "case.toml:8:11: fluid.density is 0; expected a density above 0 and at most 1000; try density = "
         "1.0"},
        {"segregation = 0.67", "segregation = 0.75",
         "case.toml:9:15: fluid.segregation is 0.75; expected a number above 0 and at most 0.707107, 1/sqrt "
         "2, up to which both colours stay positive; try segregation = 0.67"},
        {"viscosity_ratio = 1.0", "viscosity_ratio = -1.0",
         "case.toml:16:19: vesicle_type.rbc.viscosity_ratio is -1.0; expected a number above 0 and at most "
         "1000; try viscosity_ratio = 1.0"},
        {"modulus = 0.25", "modulus = -0.25",
         "case.toml:18:11: vesicle_type.rbc.bending.modulus is -0.25; expected an energy at least 0 and at "
         "most 1000; try modulus = 0.25"},
        {"deflation = 1.31", "deflation = 0.9",
         "case.toml:23:13: vesicle_type.rbc.area.deflation is 0.9; expected a number at least 1 and at most "
         "20, since no surface around a volume is smaller than its sphere; try deflation = 1.31"},
        {"deflation = 1.31", "reduced_volume = 1.1",
         "case.toml:23:18: vesicle_type.rbc.area.reduced_volume is 1.1; expected a number at least 0.02 and "
         "at most 1, 1 being the sphere; try reduced_volume = 0.65"},
        {"deflation = 1.31", "reduced_volume = 0",
         "case.toml:23:18: vesicle_type.rbc.area.reduced_volume is 0; expected a number at least 0.02 and at "
         "most 1, 1 being the sphere; try reduced_volume = 0.65"},
        {"ramp = 12000", "ramp = -1",
         "case.toml:24:8: vesicle_type.rbc.area.ramp is -1; expected a whole number of steps, or a time, at "
         "least 0 and at most 1e+15; try ramp = 0"},
        {"sigma = 1e-5", "sigma = -1e-5",
         "case.toml:26:9: vesicle_type.rbc.tension.sigma is -1e-05; expected a tension at least 0 and at "
         "most 10; try sigma = 0.0"},
        {"radius = 15", "radius = 0",
         "case.toml:32:10: vesicle[0].radius is 0; expected a length above 0; try radius = 15"},
        {"radius = 15", "radius = 2.9",
         "case.toml:32:10: vesicle[0].radius is 2.9; expected at least 2.99 cells, as even a sphere is not "
         "resolved otherwise (radius times fluid.segregation below 2); try radius = 15"},
        {"radius = 15", "radius = 33",
         "case.toml:32:10: vesicle[0].radius is 33; expected a vesicle smaller than the box, not 66 cells "
         "wide along x, where lattice.size is 64; try a smaller radius or a larger box"},
        {"centre = [32, 32, 32]", "centre = [32, 70, 32]",
         "case.toml:31:10: vesicle[0].centre is [32, 70, 32]; expected a point in the box, from 0 to 64 "
         "along y; try the middle, 32"},
        {"axis = [0, 0, 1]", "axis = [0, 0, 0]",
         "case.toml:33:8: vesicle[0].axis is [0, 0, 0]; expected three numbers, not all zero; try axis = [0, "
         "0, 1]"},
        {"l = 2\n", "l = 1\n",
         "case.toml:35:5: vesicle[0].perturbation[0].l is 1; expected a whole number or [lowest, highest], "
         "at least 2 and at most 32; try l = 2"},
        {"m = 0", "m = -3",
         "case.toml:36:5: vesicle[0].perturbation[0].m is -3; expected from -2 to 2, as l is 2; try m = 0"},
        {"amplitude = -0.01", "amplitude = 1.5",
         "case.toml:37:13: vesicle[0].perturbation[0].amplitude is 1.5; expected a number at least -0.9 and "
         "at most 0.9; try amplitude = -0.01"},
        {"cutoff = 1e-2", "cutoff = 0.9",
         "case.toml:41:10: numerics.cutoff is 0.9; expected a number above 0 and at most 0.5; try cutoff = "
         "1e-2"},
        {"steps = 40000", "steps = -1",
         "case.toml:46:9: run.steps is -1; expected a whole number at least 0 and at most 1e+15; try steps = "
         "40000"},
        {"over = 2000", "over = 0",
         "case.toml:47:82: run.stop_when_steady.over is 0; expected a whole number of steps, or a time, at "
         "least 1 and at most 1e+15; try over = 2000"},
        {"relative_change = 1e-7", "relative_change = 0",
         "case.toml:47:69: run.stop_when_steady.relative_change is 0; expected a number above 0 and at most "
         "1; try relative_change = 1e-7"},
        {"quantity = \"bending_energy\"", "quantity = \"energy\"",
         "case.toml:47:33: run.stop_when_steady.quantity is \"energy\"; expected \"area\", \"area_ratio\", "
         "\"volume\", \"reduced_volume\", \"bending_energy\", \"mean_curvature_integral\", "
         "\"gaussian_curvature_over_pi\", \"inertia_1\", \"inertia_2\", \"inertia_3\", \"x\", \"y\", \"z\", "
         "\"vx\", \"vy\", \"vz\", \"deformation_index\", \"taylor_deformation\", \"inclination\", "
         "\"tension\", \"tank_treading_frequency\", \"particle_stress\", \"effective_viscosity\", "
         "\"wall_stress\" or \"max_speed\"; try quantity = "
         "\"area\""},
        {"keep = 2", "keep = 0",
         "case.toml:54:38: output.checkpoint.keep is 0; expected a whole number at least 1 and at most "
         "1e+06; try keep = 2"},
        {"fields = { every = 10000,", "fields = { every = 10000, region = [[0, 0, 0], [64, 64, 65]],",
         "case.toml:52:36: output.fields.region is [[0, 0, 0], [64, 64, 65]]; expected two corners within "
         "the box, the second beyond the first; try region = [[0, 0, 0], [64, 64, 64]]"},
        {"fields = { every = 10000,", "fields = { every = 10000, stride = 0,",
         "case.toml:52:36: output.fields.stride is 0; expected a whole number at least 1 and at most 1e+06; "
         "try stride = 1"},
        {"ghost_rates = \"regularised\"", "ghost_rates = { even = 1.0, odd = 2.0 }",
         "case.toml:13:35: fluid.collision.ghost_rates.odd is 2.0; expected a number above 0 and below 2; "
         "try odd = 1.0"},
        {"centre = [32, 32, 32]", "centre = [32, nan, 32]",
         "case.toml:31:15: vesicle[0].centre[1] is nan; expected three numbers of length; try centre = [32, "
         "32, 32]"},
        {"centre = [32, 32, 32]", "centre = [32, 32, inf]",
         "case.toml:31:19: vesicle[0].centre[2] is inf; expected three numbers of length; try centre = [32, "
         "32, 32]"},
        {"axis = [0, 0, 1]", "axis = [0, 0, inf]",
         "case.toml:33:15: vesicle[0].axis[2] is inf; expected three numbers, not all zero; try axis = [0, "
         "0, 1]"},
    });
}
