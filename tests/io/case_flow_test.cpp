#include "case_file_samples.hpp"
#include "io/case_build_flow.hpp"

#include <limits>

using namespace vesica;

namespace {

/// What the reader says of the discocyte with these overrides.
std::string with(const std::vector<std::string>& overrides) {
    return verdict(discocyte_text(), overrides);
}

Case read_with(const std::vector<std::string>& overrides) {
    return read_case_text(discocyte_text(), "case.toml", overrides);
}

const std::string walls_z = "boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }";

} // namespace

TEST_CASE("flows that fit together are accepted") {
    CHECK(with({"flow.shear={ rate = 1e-4 }"}) == "accepted");
    CHECK(with({walls_z, "flow.poiseuille={ mean_velocity = 0.001, velocity = \"y\" }"}) == "accepted");
    CHECK(with({walls_z, "flow.body_force={ force = [1e-7, 0, 0] }"}) == "accepted");
    CHECK(with({"flow.extension={ rate = 1e-5 }"}) == "accepted");
    CHECK(with({"boundary.x={ lower = { type = \"inlet\", velocity = [0.01, 0, 0] }, upper = { type = "
                "\"outlet\" } }"}) == "accepted");
}

TEST_CASE("the walls of a shear are those of its gradient, and the lattice has room for them") {
    const Case sliding = read_with({"flow.shear={ rate = 2e-4, with = \"lees-edwards\" }"});
    CHECK(sliding.parameters.sliding() != nullptr);
    CHECK_FALSE(sliding.parameters.is_bounded());
    CHECK(sliding.parameters.lattice() == sliding.parameters.size);
    const Case sheared = read_with({"flow.shear={ rate = 2e-4, velocity = \"y\", gradient = \"x\" }"});
    CHECK(sheared.parameters.has_walls(0));
    CHECK_FALSE(sheared.parameters.has_walls(1));
    CHECK(sheared.parameters.lattice() == Vec3<int>{66, 64, 64});
    CHECK(sheared.parameters.flow.shear->times.strength(0) == 1.0);
}

TEST_CASE("a wall's own velocity has times of its own, and is not gentle unless asked") {
    const Case moved =
        read_with({"boundary.z={ lower = { type = \"wall\" }, upper = { type = \"wall\", velocity = "
                   "[0.01, 0, 0], start = 100, stop = 300, ramp = 40 } }"});
    const auto& walls = std::get<WallEnds>(moved.parameters.ends[2]);
    CHECK(walls.upper_times == FlowTimes{100, 300, 40});
    CHECK(walls.lower_times == FlowTimes{});
    const Case entered =
        read_with({"boundary.x={ lower = { type = \"inlet\", velocity = [0.01, 0, 0], start = 50 }, "
                   "upper = { type = \"outlet\" } }"});
    CHECK(std::get<OpenEnds>(entered.parameters.ends[0]).times == FlowTimes{50, FlowTimes::never, 200});
}

TEST_CASE("a flow grows from its start on and dies from its end on") {
    const FlowTimes times{100, 200, 50};
    CHECK(times.strength(99) == 0.0);
    CHECK(times.strength(125) == 0.5);
    CHECK(times.strength(170) == 1.0);
    CHECK(times.strength(225) == 0.5);
    CHECK(times.strength(250) == 0.0);
    const FlowTimes sudden{10, 20, 0};
    CHECK(sudden.strength(9) == 0.0);
    CHECK(sudden.strength(10) == 1.0);
    CHECK(sudden.strength(20) == 0.0);
}

TEST_CASE("a mean velocity becomes the pressure gradient that drives it") {
    const Case plane = read_with({walls_z, "flow.poiseuille={ mean_velocity = 0.001 }"});
    CHECK(plane.parameters.flow.poiseuille->pressure_gradient ==
          Approx(12.0 * 0.1666667 * 0.001 / (64.0 * 64.0)).epsilon(1e-6));
    // A square duct resists 28.4542/12 times as much as a plane channel of its width (f Re = 14.2271).
    const double square = mean_velocity_of_duct(1.0, 1.0, 1.0);
    CHECK(1.0 / square == Approx(28.4541).epsilon(1e-4));
    CHECK(mean_velocity_of_duct(1.0, 1e6, 1.0) == Approx(1.0 / 12.0).epsilon(1e-5));
    CHECK(mean_velocity_of_duct(2.0, std::numeric_limits<double>::infinity(), 3.0) == Approx(4.0 / 36.0));
}

TEST_CASE("the inertia of a shear is scaled up to the Reynolds number of the lattice") {
    for (const CaseTemplate& item : case_templates()) {
        if (item.name != "rbc-shear")
            continue;
        const Case cell = read_case_text(std::string(item.text), "case.toml");
        const double radius = cell.parameters.vesicles.front().radius;
        const double rate = cell.parameters.flow.shear->rate;
        CHECK(rate * radius * radius / cell.parameters.fluid.kinematic_viscosity ==
              Approx(0.1).epsilon(1e-9));
        // 1000 kg/m^3, 15 1/s, 2.82 um, 1.2 mPa s
        CHECK(cell.inertia->true_reynolds ==
              Approx(1000.0 * 15.0 * 2.82e-6 * 2.82e-6 / 1.2e-3).epsilon(1e-9));
        CHECK(cell.scales->to_si(rate, dimension::rate).value == Approx(15.0).epsilon(1e-12));
    }
}

TEST_CASE("flows that do not fit together are refused with the remedy") {
    const std::vector<std::pair<std::vector<std::string>, std::string>> rows{
        {{walls_z, "flow.shear={ rate = 1e-4, with = \"lees-edwards\" }"},
         "flow.shear.with is \"lees-edwards\"; expected no [boundary.z] with it"},
        {{"boundary.y={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }",
          "flow.shear={ rate = 1e-4, with = \"lees-edwards\" }"},
         "flow.shear.with is \"lees-edwards\"; expected no [boundary.y] with it"},
        {{"lattice.size=[64, 64, 9]", "flow.shear={ rate = 1e-4, with = \"lees-edwards\" }"},
         "expected at least 10 cells along z, where flow.shear with lees-edwards lets the images slide; try "
         "10"},
        {{"tracers={ every = 50 }"},
         "expected points as well; try [[tracers.seeds]] with from, to and count"},
        {{"tracers={ every = 50, seeds = [{ from = [1, 2, 3], count = 4 }] }"},
         "tracers.seeds[0].count is 4; expected 1, as the first point is the last"},
        {{"tracers={ every = 50, seeds = [{ from = [1, 2, 3], to = [4, 5, 6] }] }"},
         "expected no second point, as tracers.seeds[0].count is 1"},
        {{"tracers={ every = 50, seeds = [{ from = [1, 2, 64.5] }] }"},
         "expected a point in the box, from 0 to 64 along z"},
        {{"flow.shear={ rate = 1e-4, with = \"pistons\" }"}, "flow.shear.with is \"pistons\""},
        {{"flow.shear={ rate = 1e-4, velocity = \"z\" }"},
         "expected two different axes for velocity and gradient"},
        {{walls_z, "flow.shear={ rate = 1e-4 }"},
         "boundary.z is there; expected nothing there, as flow.shear makes the walls across its gradient"},
        {{"boundary.x={ lower = { type = \"wall\" }, upper = { type = \"wall\" } }",
          "flow.shear={ rate = 1e-4 }"},
         "expected no walls across the flow's own axis"},
        {{"boundary.z={ lower = { type = \"wall\" } }"},
         "boundary.z.upper is missing; expected both ends of the axis, or none where it is periodic, and "
         "boundary.z.lower is a wall; try upper = { type = \"wall\" }"},
        {{"boundary.x={ lower = { type = \"inlet\", velocity = [0.01, 0, 0] } }"},
         "boundary.x.lower is an inlet; try upper = { type = \"outlet\" }"},
        {{"boundary.x={ lower = { type = \"inlet\", velocity = [0.01, 0, 0] }, upper = { type = \"wall\" } "
          "}"},
         "boundary.x.upper.type is \"wall\"; expected \"outlet\", as boundary.x.lower is an inlet"},
        {{"boundary.x={ lower = { type = \"inlet\" }, upper = { type = \"outlet\" } }"},
         "expected a velocity straight into the box; try velocity = [0.01, 0, 0]"},
        {{"boundary.x={ lower = { type = \"outlet\" }, upper = { type = \"inlet\", velocity = [0.01, 0, 0] } "
          "}"},
         "try velocity = [-0.01, 0, 0]"},
        {{"boundary.x={ lower = { type = \"inlet\", velocity = [0.01, 0, 0], profile = \"parabolic\" }, "
          "upper = { type = "
          "\"outlet\" } }"},
         "expected walls across another axis, between which the parabola lies"},
        {{"boundary.z={ lower = { type = \"wall\", velocity = [0, 0, 0.01] }, upper = { type = \"wall\" } }"},
         "expected a velocity along the wall, 0 along z"},
        {{"flow.poiseuille={ mean_velocity = 0.001 }"}, "expected walls that hold the fluid"},
        {{walls_z, "flow.poiseuille={ mean_velocity = 0.001, velocity = \"z\" }"},
         "expected an axis without walls; try velocity = \"x\""},
        {{walls_z, "flow.poiseuille={ mean_velocity = 0.001, pressure_gradient = 1e-6 }"},
         "expected the strength of the flow to be stated once"},
        {{"flow.extension={ rate = 1e-5 }", "flow.shear={ rate = 1e-4 }"},
         "expected no other flow beside flow.extension"},
        {{"flow.shear={ rate = 1e-4, start = 100, stop = 50 }"},
         "flow.shear.stop is 50; expected at least flow.shear.start, which is 100"},
        {{"flow.shear={ rate = \"3 um\" }"}, "flow.shear.rate is \"3 um\""},
        {{"fluid.kinematic_viscosity=\"3 um\""}, "fluid.kinematic_viscosity is \"3 um\""},
    };
    for (const auto& [overrides, part] : rows) {
        const std::string message = with(overrides);
        INFO(message);
        INFO(part);
        CHECK(message.find(part) != std::string::npos);
    }
}

TEST_CASE("profiles are asked for across another axis than the flow's") {
    CHECK(with({"output.profiles={ every = 100, across = \"z\" }"}) == "accepted");
    const Case radial = read_with({"output.profiles={ every = 100, across = \"radius\", along = \"y\" }"});
    CHECK(radial.output.profiles == ProfileOutput{100, 1, -1});
    CHECK(read_case_text(resolved_toml(radial), "again").output == radial.output);
    CHECK_FALSE(read_with({"output.profiles={ every = 0, across = \"z\" }"}).output.profiles);
    CHECK(with({"output.profiles={ every = 100, across = \"x\" }"})
              .find("output.profiles.across is \"x\"; expected another axis than output.profiles.along; try "
                    "across "
                    "= \"z\"") != std::string::npos);
}
