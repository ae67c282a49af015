#include "case/triangle_mesh.hpp"
#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_cost.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/run_fake_engine.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using Severity = Remark::Severity;

namespace {

std::string shipped() {
    return std::string(VESICA_SOURCE_DIR) + "/cases/discocyte.toml";
}

Case discocyte(const std::vector<std::string>& overrides = {}) {
    return read_case(shipped(), overrides);
}

std::string all(const Plan& plan, Severity severity) {
    std::string text;
    for (const std::string& line : texts_of(plan.remarks, severity))
        text += line + "\n";
    return text;
}

bool says(const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("the shipped discocyte is accepted without a warning, with a note on its rim") {
    const Plan plan = make_plan(discocyte());
    CHECK(all(plan, Severity::error).empty());
    CHECK(all(plan, Severity::warning).empty());
    CHECK(says(all(plan, Severity::note), "vesicle[0].radius"));
    CHECK_NOTHROW(refuse_errors(plan));
}

TEST_CASE("groups are those of their definitions") {
    const Plan plan = make_plan(discocyte());
    REQUIRE(plan.vesicles.size() == 1);
    const VesiclePlan& vesicle = plan.vesicles.front();
    const double nu = 0.1666667;
    const double kappa = 0.25;
    CHECK(vesicle.radius == Approx(15.0).epsilon(1e-6));
    CHECK(*vesicle.bending_time == Approx(nu * 15.0 * 15.0 * 15.0 / kappa).epsilon(1e-6));
    CHECK(*vesicle.reynolds == Approx(kappa / (nu * nu * 15.0)).epsilon(1e-6));
    CHECK(*vesicle.bending_over_tension == Approx(kappa / (1e-5 * 15.0 * 15.0)).epsilon(1e-6));
    CHECK(vesicle.confinement == Approx(30.0 / 64.0).epsilon(1e-6));
    CHECK(vesicle.target_reduced_volume == Approx(0.66695).epsilon(1e-4));
    CHECK(plan.relaxation_time == Approx(1.0).epsilon(1e-6));
    CHECK(plan.interface_width == Approx(2.0 / 0.67));
}

TEST_CASE("a sphere to be deflated is judged by the rim of the discocyte, .375 R0") {
    const Plan plan = make_plan(discocyte());
    REQUIRE(plan.vesicles.front().target_smallest_radius);
    CHECK(*plan.vesicles.front().target_smallest_radius == Approx(0.375 * 15.0).epsilon(0.02));
    CHECK(plan.vesicles.front().resolution == Approx(0.67 * 0.375 * 15.0).epsilon(0.02));
}

TEST_CASE("the finer the lattice the milder the judgement: error, warning, note, nothing") {
    const auto with_radius = [](const std::string& radius) {
        return make_plan(discocyte({"vesicle[0].radius=" + radius, "lattice.size=[128,128,128]",
                                    "vesicle[0].centre=[64,64,64]", "vesicle_type.rbc.area.ramp=40000",
                                    "run.steps=200000"}));
    };
    const std::string key = "vesicle[0].radius";
    CHECK(says(all(with_radius("7"), Severity::error), key));
    CHECK(says(all(with_radius("13"), Severity::warning), key));
    CHECK(says(all(with_radius("16"), Severity::note), key));
    const Plan fine = make_plan(
        discocyte({"vesicle[0].radius=21", "lattice.size=[128,128,128]", "vesicle[0].centre=[64,64,64]",
                   "vesicle_type.rbc.area.ramp=40000", "run.steps=200000"}));
    CHECK_FALSE(says(all(fine, Severity::note), key));
}

TEST_CASE("a membrane as soft as the recolouring is refused unless its user knows") {
    const Case soft = discocyte({"vesicle_type.rbc.bending.modulus=0.0025"});
    const Plan refused = make_plan(soft);
    CHECK(says(all(refused, Severity::error), "vesicle_type.rbc.bending.modulus is 0.0025"));
    CHECK_THROWS_AS(refuse_errors(refused), InputError);
    const Plan accepted = make_plan(soft, PlanOptions{true});
    CHECK(all(accepted, Severity::error).empty());
    CHECK(says(all(accepted, Severity::warning), "vesicle_type.rbc.bending.modulus is 0.0025"));
}

TEST_CASE("what is likely to go wrong is accepted with one warning each") {
    const auto only = [](const Case& what) {
        const auto warnings = texts_of(make_plan(what).remarks, Severity::warning);
        CAPTURE(warnings);
        REQUIRE(warnings.size() == 1);
        return warnings.front();
    };
    const Case viscous =
        discocyte({"fluid.kinematic_viscosity=1.1", "vesicle_type.rbc.area.ramp=80000", "run.steps=200000"});
    CHECK(says(only(viscous), "a relaxation time of 3.800; expected at most 3.5"));
    Case narrow = discocyte();
    narrow.parameters.types[0].area.deflation.reset();
    narrow.parameters.size.z = 34;
    CHECK(says(only(narrow), "vesicle[0] and its own periodic image are"));
    Case perfect = discocyte();
    perfect.parameters.vesicles.front().perturbations.clear();
    CHECK(says(only(perfect), "vesicle[0].perturbation is missing"));
}

TEST_CASE("a shape that cannot be is refused at the key that asks for it") {
    const auto refusal = [](const std::vector<std::string>& overrides) -> std::string {
        try {
            make_plan(discocyte(overrides));
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    CHECK(
        says(refusal({"vesicle[0].shape=stomatocyte", "vesicle[0].reduced_volume=0.9"}),
             "--set vesicle[0].reduced_volume=0.9: vesicle[0].reduced_volume is 0.9; expected 0.5 to 0.66"));
    const std::string ripples = refusal({"vesicle[0].perturbation[0].amplitude=-0.9"});
    CHECK(says(ripples, "cases/discocyte.toml:"));
    CHECK(says(ripples, ": vesicle[0].perturbation changes the radius by down to -0.9 of itself"));

    Case meshed = discocyte();
    const auto mesh = std::make_shared<TriangleMesh>(); // a face is missing
    mesh->source = "cell.stl";
    mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}};
    meshed.parameters.vesicles.front().shape = MeshShape{"cell.stl", mesh};
    try {
        make_plan(meshed);
        FAIL("accepted");
    } catch (const InputError& error) {
        CHECK(says(error.what(), ": vesicle[0].file is \"cell.stl\"; cell.stl: the mesh has 3 triangles"));
    }
}

TEST_CASE("a remark begins with its place in the case file") {
    const Plan plan = make_plan(discocyte({"vesicle_type.rbc.area.ramp=1000"}));
    const std::string warnings = all(plan, Severity::warning);
    CHECK(says(warnings, "vesicle_type.rbc.area.ramp is 1000"));
    const Plan unperturbed = make_plan(discocyte({"run.steps=12000"}));
    CHECK(says(all(unperturbed, Severity::warning), "run.steps is 12000"));
}

TEST_CASE("vesicles that overlap are refused, those whose interfaces do are warned of") {
    const auto two = [](double distance) {
        Case what = discocyte();
        what.parameters.types[0].area.deflation.reset();
        what.parameters.size = {128, 64, 64};
        what.parameters.vesicles.push_back(what.parameters.vesicles[0]);
        what.parameters.vesicles[1].centre.x += distance;
        return make_plan(what);
    };
    CHECK(says(all(two(25.0), Severity::error), "vesicle[0] and vesicle[1] overlap"));
    CHECK(says(all(two(33.0), Severity::warning), "vesicle[0] and vesicle[1] are"));
    CHECK(all(two(40.0), Severity::warning).empty());
    // 128 - 95 = 33: through the periodic boundary
    CHECK(says(all(two(95.0), Severity::warning), "vesicle[0] and vesicle[1] are"));
}

TEST_CASE("a vesicle that meets its own image is refused") {
    Case what = discocyte();
    what.parameters.size = {64, 28, 64};
    CHECK(says(all(make_plan(what), Severity::error), "vesicle[0] and its own periodic image overlap"));
}

TEST_CASE("a steady criterion needs metrics often enough") {
    Case what = discocyte();
    what.output.metrics_every = 0;
    CHECK(says(all(make_plan(what), Severity::error), "output.metrics is missing"));
    what.output.metrics_every = 5000;
    CHECK(says(all(make_plan(what), Severity::error), "run.stop_when_steady.over is 2000"));
}

TEST_CASE("a case that needs more memory than there is is refused before it is built") {
    Case what = discocyte();
    what.parameters.size = {60000, 60000, 60000};
    CHECK(says(all(make_plan(what), Severity::error), "lattice.size"));
}

TEST_CASE("the cost of a large case is extrapolated from small boxes") {
    const auto factory = [](const Parameters& parameters, int) -> std::unique_ptr<Engine> {
        return std::make_unique<test::FakeEngine>(parameters);
    };
    const Case what = discocyte();
    CHECK(measure_cost(what.parameters, what.run, what.output, 1, factory).of_this_case);
    Parameters large = what.parameters;
    large.size = {512, 512, 512};
    CHECK_FALSE(measure_cost(large, what.run, what.output, 1, factory).of_this_case);
}

TEST_CASE("the plan reads side by side in lattice and SI units when the case has units") {
    Case what = discocyte();
    what.scales = Scales{2e-7, 1e-8, 1000.0};
    const std::string text = plan_text(what, make_plan(what), std::nullopt, 1);
    CHECK(says(text, "12.8 um x 12.8 um x 12.8 um"));
    CHECK(says(text, "3 um"));
    CHECK(says(text, "accepted, no warnings"));
    what.scales.reset();
    CHECK_FALSE(says(plan_text(what, make_plan(what), std::nullopt, 1), " um"));
}

TEST_CASE("what is not in the model is said") {
    for (const char* missing :
         {"thermal noise", "area-difference elasticity", "adhesion", "osmosis", "shear elasticity"})
        CHECK(says(model_text(), missing));
}

TEST_CASE("groups of a flow are those of their definitions, and too much of it is refused") {
    const Plan plan = make_plan(discocyte({"flow.shear={ rate = 5e-5 }"}));
    REQUIRE(plan.flow.rate.has_value());
    CHECK(*plan.flow.rate == Approx(5e-5));
    CHECK(plan.flow.speed == Approx(5e-5 * 32.0));
    const Case what = discocyte({"flow.shear={ rate = 5e-5 }"});
    const FlowGroups groups =
        flow_groups(what.parameters, *plan.flow.rate, 15.0, what.parameters.types.front());
    CHECK(groups.reynolds == Approx(5e-5 * 225.0 / 0.1666667).epsilon(1e-6));
    CHECK(*groups.capillary_bending == Approx(0.1666667 * 5e-5 * 3375.0 / 0.25).epsilon(1e-6));
    CHECK(*groups.capillary_tension == Approx(0.1666667 * 5e-5 * 15.0 / 1e-5).epsilon(1e-6));
    CHECK(all(plan, Severity::error).empty());
    CHECK(all(plan, Severity::warning).empty());

    const std::string fast = all(make_plan(discocyte({"flow.shear={ rate = 4e-3 }"})), Severity::error);
    CHECK(says(
        fast,
        "flow.shear.rate is 0.004, which makes speeds of 0.128 cells per step, Mach 0.22; expected at most "
        "Mach 0.1"));
    const std::string inert = all(make_plan(discocyte({"flow.shear={ rate = 6e-4 }"})), Severity::warning);
    CHECK(says(inert, "Re = rho gamma R0^2/eta = 0.81; expected at most 0.1"));
    CHECK(says(inert, "raise kinematic_viscosity to 1.3 or lower it to 7.4e-05"));
    const std::string late =
        all(make_plan(discocyte({"flow.shear={ rate = 5e-5, start = 50000 }"})), Severity::warning);
    CHECK(says(late, "flow.shear.start is 50000: the run ends before"));
    const std::string heavy =
        all(make_plan(discocyte({"vesicle_type.rbc.buoyancy=[0, 0, 1e-2]"})), Severity::error);
    CHECK(says(heavy, "vesicle_type.rbc.buoyancy moves vesicle[0]"));
    CHECK(all(make_plan(
                  discocyte({"vesicle_type.rbc.buoyancy=[0, 0, 1e-2]", "vesicle[0].buoyancy=[0, 0, 1e-8]"})),
              Severity::error)
              .empty()); // its own counts
    CHECK(says(all(make_plan(discocyte({"vesicle[0].buoyancy=[0, 0, 1e-2]"})), Severity::error),
               "vesicle[0].buoyancy moves vesicle[0]"));
}

TEST_CASE("a channel's rate is that at its walls, and its fastest fluid is in the middle") {
    const Plan plan =
        make_plan(discocyte({"boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }",
                             "flow.poiseuille={ mean_velocity = 1e-3 }"}));
    CHECK(plan.flow.speed == Approx(1.5e-3).epsilon(1e-9));
    CHECK(*plan.flow.rate == Approx(6.0 * 1e-3 / 64.0).epsilon(1e-9));
}

TEST_CASE("a vesicle beyond the box's end is refused, and one beside it is warned of") {
    const std::string walls = "boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }";
    const std::string inside =
        all(make_plan(discocyte({walls, "vesicle[0].centre=[32, 32, 12]"})), Severity::error);
    CHECK(says(inside, "vesicle[0] and the box's end at z = 0 overlap"));
    const std::string near =
        all(make_plan(discocyte({walls, "vesicle[0].centre=[32, 32, 46]"})), Severity::warning);
    CHECK(says(near, "vesicle[0] and the box's end at z = 64 are"));
    CHECK(all(make_plan(discocyte({walls, "vesicle_type.rbc.area.deflation=1.0001"})), Severity::error)
              .empty());
}

TEST_CASE("what pushes a fluid between walls is judged by the speed it comes to") {
    const std::string walls = "boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }";
    const Plan plan = make_plan(discocyte({walls, "flow.body_force={ force = [0.5, 0, 0] }"}));
    CHECK(says(all(plan, Severity::error), "flow.body_force is"));
    const Plan weak = make_plan(discocyte({walls, "flow.body_force={ force = [1e-7, 0, 0] }"}));
    CHECK(weak.flow.speed == Approx(1e-7 * 64.0 * 64.0 / (8.0 * 0.1666667)).epsilon(1e-6));
    CHECK(all(weak, Severity::error).empty());
}

TEST_CASE("a vesicle too near to an inlet is refused at once") {
    const std::string open = "boundary.x={ lower = { type = \"inlet\", velocity = [0.001, 0, 0] }, upper = { "
                             "type = \"outlet\" } }";
    const std::string text =
        all(make_plan(discocyte({open, "vesicle[0].centre=[23, 32, 32]"})), Severity::error);
    CHECK(says(text, "cells apart; expected at least 10.5"));
}

TEST_CASE("tracers that never appear, or without end, are remarked upon") {
    CHECK(says(all(make_plan(discocyte({"tracers={ every = 100, start = 1000000, membrane = 4 }"})),
                   Severity::warning),
               "tracers.start is 1000000: the run ends before"));
    CHECK(says(all(make_plan(discocyte(
                       {"tracers={ every = 100, release = 1, seeds = [{ from = [1, 1, 1], to = [9, 9, 9], "
                        "count = 100 }] }"})),
                   Severity::error),
               "points in the end; expected at most 1e+06"));
    CHECK(says(
        all(make_plan(discocyte({"boundary.x={ lower = { type = \"inlet\", velocity = [0.001, 0, 0], start = "
                                 "1000000 }, upper = { type = \"outlet\" } }"})),
            Severity::warning),
        "boundary.x.lower.start is 1000000: the run ends before"));
}

TEST_CASE("wetting without solids is remarked upon") {
    CHECK(says(all(make_plan(discocyte({"boundary.wetting=0.001"})), Severity::warning),
               "boundary.wetting is 0.001, but there are no walls or obstacles"));
    CHECK_FALSE(says(all(make_plan(discocyte()), Severity::warning), "boundary.wetting"));
    CHECK_FALSE(says(all(make_plan(discocyte({"boundary.wetting=0.001", "flow.shear={ rate = 1e-5 }"})),
                         Severity::warning),
                     "boundary.wetting"));
}

TEST_CASE("a vesicle that its own image would pass too closely is remarked upon") {
    // At first the image lies straight above, where a slanted spheroid is far from itself.
    const auto passing = [](const std::string& with) {
        return all(make_plan(discocyte({"vesicle[0].shape=spheroid", "vesicle[0].aspect=2.5",
                                        "vesicle[0].radius=14", "vesicle[0].axis=[1, 0, 1]",
                                        "lattice.size=[80, 64, 43]", "vesicle[0].centre=[40, 32, 21.5]",
                                        "flow.shear={ rate = 1e-5, with = \"" + with + "\" }"})),
                   Severity::warning);
    };
    CHECK(says(passing("lees-edwards"), "vesicle[0] and its own image that slides past are"));
    CHECK_FALSE(says(passing("walls"), "slides past"));
}

TEST_CASE("solids do not slide: none may lie at the ends of a box that does") {
    Case what = discocyte({"flow.shear={ rate = 1e-5, with = \"lees-edwards\" }"});
    SolidVoxels solids(what.parameters.size);
    solids.set({7, 9, 20});
    ObstacleParameters obstacles;
    obstacles.voxels = std::make_shared<const SolidVoxels>(solids);
    what.parameters.obstacles = obstacles;
    CHECK(all(make_plan(what), Severity::error).empty());
    solids.set({7, 9, 63});
    what.parameters.obstacles->voxels = std::make_shared<const SolidVoxels>(solids);
    CHECK(says(all(make_plan(what), Severity::error),
               "cell (7, 9, 63) at the end of the box is solid; expected fluid there"));
}

TEST_CASE("a vesicle that reaches an obstacle across the box's edge is refused") {
    Case what = discocyte();
    SolidVoxels solids(what.parameters.size);
    for (int z = 0; z < 64; ++z)
        for (int y = 0; y < 64; ++y)
            for (int x = 60; x < 64; ++x)
                solids.set({x, y, z});
    ObstacleParameters obstacles;
    obstacles.voxels = std::make_shared<const SolidVoxels>(std::move(solids));
    what.parameters.obstacles = obstacles;
    what.parameters.vesicles.front().centre = {10.0, 32.0, 32.0};
    CHECK(says(all(make_plan(what), Severity::error), "vesicle[0] and the obstacles overlap"));
    what.parameters.vesicles.front().centre = {30.0, 32.0, 32.0};
    CHECK(all(make_plan(what), Severity::error).empty());
    what.parameters.flow.poiseuille = PoiseuilleFlow{1e-7, {}, 1, {}};
    CHECK(all(make_plan(what), Severity::error).empty()); // between the slab and itself
}
