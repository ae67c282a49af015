#include "io/scratch_directory.hpp"
#include "simulation/engine_cases.hpp"
#include "simulation/run_tracers.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace vesica;
using namespace vesica::test;

namespace {

/// Rows of tracers.csv.
std::vector<std::vector<double>> rows_in(const std::filesystem::path& directory) {
    std::ifstream file(directory / "tracers.csv");
    std::string line;
    std::getline(file, line);
    REQUIRE(line == "step,time,tracer,seed,released,x,y,z,vx,vy,vz");
    std::vector<std::vector<double>> rows;
    while (std::getline(file, line)) {
        rows.emplace_back();
        std::istringstream numbers(line);
        for (std::string number; std::getline(numbers, number, ',');)
            rows.back().push_back(std::stod(number));
    }
    return rows;
}

/// Runs with tracers as a run does.
void carry_along(RunTracers& tracers, const TracerOutput& output, Engine& engine, std::int64_t last) {
    const auto due = [&] {
        if (engine.steps_done() % output.every == 0)
            tracers.write(engine);
        if (output.carried_at(engine.steps_done()))
            tracers.carry(engine);
    };
    if (engine.steps_done() == 0)
        due();
    while (engine.steps_done() < last) {
        engine.step();
        due();
    }
}

Case sheared_fluid(ShearBy with) {
    Case what;
    what.parameters.size = {12, 11, 20};
    what.parameters.fluid.kinematic_viscosity = 1.0 / 3.0;
    what.parameters.flow.shear = ShearFlow{2e-3, 0, 2, {}, with};
    if (with == ShearBy::walls)
        what.parameters.ends[2] = WallEnds{};
    return what;
}

} // namespace

TEST_CASE("velocities between cells are those of a shear, in every image of the box") {
    const ShearBy with = GENERATE(ShearBy::walls, ShearBy::lees_edwards);
    const Case what = sheared_fluid(with);
    const auto engine = make_engine(what.parameters, 2);
    run(*engine, 4000);
    const auto u = engine->velocities({{3.2, 4.0, 7.7}, {-20.1, 40.2, 10.0}, {0.1, 0.2, 13.9}});
    CHECK(u[0].x == Approx(2e-3 * (7.7 - 10.0)).epsilon(1e-6));
    CHECK(u[1].x == Approx(0.0).margin(1e-9));
    CHECK(u[2].x == Approx(2e-3 * 3.9).epsilon(1e-6));
    CHECK(u[0].y == Approx(0.0).margin(1e-12));
    const Vec3<double> outside = engine->velocities({{3.0, 4.0, 45.3}}).front();
    if (with == ShearBy::walls)
        CHECK(std::isnan(outside.x));
    else // images above move on as the fluid there does
        CHECK(outside.x == Approx(2e-3 * 35.3).epsilon(1e-6));
}

TEST_CASE("tracers are carried by the fluid, through sliding faces too, and released again and again") {
    Case what = sheared_fluid(ShearBy::lees_edwards);
    TracerOutput& output = what.output.tracers.emplace();
    output.every = 100;
    output.start = 4000;
    output.release = 300;
    output.seeds = {{{6.0, 5.0, 2.0}, {6.0, 5.0, 18.0}, 3}, {{1.0, 1.0, 19.9}, {1.0, 1.0, 19.9}, 1}};
    what.parameters.flow.body_force = BodyForce{{0.0, 0.0, 1e-6}, {0, FlowTimes::never, 0}};
    const ScratchDirectory folder;
    const auto engine = make_engine(what.parameters, 2);
    {
        RunTracers tracers(what, OutputDirectory::create(folder.path() / "run", false), {});
        carry_along(tracers, output, *engine, 4700);
    }
    const auto rows = rows_in(folder.path() / "run");
    // At 4000, 4100, 4200: 4 points; from 4300 on 8, from 4600 on 12.
    REQUIRE(rows.size() == 3 * 4 + 3 * 8 + 2 * 12);
    CHECK(rows.front()[0] == 4000.0);
    CHECK(rows[3][3] == 3.0); // the second line's seed
    CHECK(rows.back()[4] == 4600.0);
    // The force lifts the shear as a whole: each keeps its velocity along, over the box's upper end too.
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& first = rows[k];
        const auto& last = rows[rows.size() - 12 + k];
        REQUIRE(first[2] == last[2]);
        const double t = 700.0;
        const double v0 = first[10];
        CHECK(last[7] == Approx(first[7] + v0 * t + 0.5e-6 * t * t).margin(1e-4));
        CHECK(last[5] == Approx(first[5] + first[8] * t).margin(5e-3));
        CHECK(last[8] == Approx(first[8]).epsilon(1e-4));
    }
    CHECK(rows[rows.size() - 9][7] > 20.0);
}

TEST_CASE("tracers go on from their notes as if nothing had been") {
    Case what = sheared_fluid(ShearBy::lees_edwards);
    TracerOutput& output = what.output.tracers.emplace();
    output.every = 20;
    output.release = 50;
    output.seeds = {{{6.0, 5.0, 1.0}, {6.0, 5.0, 19.0}, 2}};
    const ScratchDirectory folder;
    const auto whole = make_engine(what.parameters, 1);
    RunTracers first(what, OutputDirectory::create(folder.path() / "run", false), {});
    carry_along(first, output, *whole, 133);
    const auto notes = first.notes();
    const EngineState state = whole->save();
    carry_along(first, output, *whole, 300);
    const auto rows = rows_in(folder.path() / "run");
    const auto end = first.notes();
    const auto again = make_engine(what.parameters, 1);
    again->load(state);
    RunTracers second(what, OutputDirectory::open(folder.path() / "run"), 133);
    second.restore(notes);
    carry_along(second, output, *again, 300);
    CHECK(second.notes() == end);
    CHECK(rows_in(folder.path() / "run") == rows);
}

TEST_CASE("points round a vesicle lie on its surface, evenly turned") {
    Parameters parameters = deforming_spheroid();
    parameters.vesicles.front().axis = {0.0, 0.0, 1.0};
    const auto engine = make_engine(parameters, 1);
    const auto points =
        contour_points(engine->snapshot().vesicles.front(), {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 8);
    REQUIRE(points.size() == 8);
    const double width = 7.0 / std::cbrt(1.8);
    CHECK(points[0].x == Approx(16.0 + width).margin(0.06));
    CHECK(points[2].z == Approx(16.0 + 1.8 * width).margin(0.1));
    CHECK(points[6].z == Approx(16.0 - 1.8 * width).margin(0.1));
    const Vec3<double> oblique = points[1] - Vec3<double>{16.0, 16.0, 16.0};
    CHECK(oblique.x == Approx(oblique.z).margin(1e-6));
    CHECK(oblique.x * oblique.x + oblique.z * oblique.z / 3.24 == Approx(width * width).epsilon(0.02));
}

TEST_CASE("a tracer that is nowhere in the fluid is let go, the others stay") {
    Case what = sheared_fluid(ShearBy::walls);
    SolidVoxels solids(what.parameters.size);
    for (int z = 4; z < 8; ++z)
        for (int y = 3; y < 7; ++y)
            for (int x = 3; x < 7; ++x)
                solids.set({x, y, z});
    ObstacleParameters obstacles;
    obstacles.voxels = std::make_shared<const SolidVoxels>(solids);
    what.parameters.obstacles = obstacles;
    TracerOutput& output = what.output.tracers.emplace();
    output.every = 10;
    output.seeds = {{{5.0, 5.0, 6.0}, {5.0, 5.0, 16.0}, 2}};
    const ScratchDirectory folder;
    const auto engine = make_engine(what.parameters, 1);
    RunTracers tracers(what, OutputDirectory::create(folder.path() / "run", false), {});
    carry_along(tracers, output, *engine, 20);
    const auto rows = rows_in(folder.path() / "run");
    REQUIRE(rows.size() == 3);
    for (const auto& row : rows)
        CHECK(row[2] == 1.0);
}
