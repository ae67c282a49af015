#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::test;

TEST_CASE("what is known near the interface only is zero elsewhere, wherever cells lie in their tiles") {
    const auto of_vesicle_at = [](int x) {
        Parameters parameters = deforming_spheroid(48, 9.0);
        parameters.vesicles[0].centre = {24.0 + x, 24.0, 24.0};
        return make_engine(parameters, 1);
    };
    const auto here = of_vesicle_at(0);
    const auto there = of_vesicle_at(3);
    for (const char* name :
         {"mean_curvature", "gaussian_curvature", "normal", "bending_force", "tension_force"}) {
        INFO(name);
        const DenseField a = here->field(name);
        const DenseField b = there->field(name);
        int different = 0;
        std::size_t known = 0;
        for (int row = 0; row < 48 * 48; ++row)
            for (int x = 0; x < 48; ++x)
                for (int k = 0; k < a.components; ++k) {
                    const auto at = [&](int cell) {
                        return static_cast<std::size_t>((row * 48 + cell % 48) * a.components + k);
                    };
                    different += a.values[at(x)] != b.values[at(x + 3)] ? 1 : 0;
                    known += a.values[at(x)] != 0.0 ? 1u : 0u;
                }
        CHECK(different == 0);
        CHECK(known > 0);
        CHECK(known < a.values.size() / 2);
    }
}

TEST_CASE("a droplet that fades away far from the vesicle is given back to it, whatever the density") {
    // Too faint for a layer of its own from the start; the band forgets it when it follows the moving
    // vesicle.
    Parameters parameters = deforming_spheroid(48, 6.0);
    parameters.fluid.density = GENERATE(1.0, 100.0);
    parameters.types[0].area.constraint = NoConstraint{};
    parameters.vesicles[0].shape = SphereShape{};
    parameters.vesicles[0].centre = {12.0, 12.0, 12.0};
    const auto engine = make_engine(parameters, 1);
    EngineState state = engine->save();
    const std::size_t droplet = (36 * 48 + 36) * 48 + 36;
    REQUIRE(state.band[droplet] == 0);
    state.minority[droplet] = 0.24 * parameters.numerics.cutoff;
    state.band[droplet] = 1;
    engine->load(state);
    const double mass = engine->snapshot().vesicles[0].colour_mass;
    const double cells_before = engine->interface_fraction();
    state = engine->save();
    for (std::size_t i = 0; i < state.populations.size(); ++i) // all moves along x
        for (double& g : state.populations[i]) {
            const double c = i == 1 || i == 2 || i == 8 || i == 10 || i == 15   ? 1.0
                             : i == 4 || i == 5 || i == 6 || i == 12 || i == 17 ? -1.0
                                                                                : 0.0;
            const double weight = i == 0 ? 1.0 / 3 : i == 1 || i == 5 ? 1.0 / 18 : 1.0 / 36;
            g += 3.0 * weight * parameters.fluid.density * 0.1 * c;
        }
    engine->load(state);
    run(*engine, 40);
    CHECK(engine->interface_fraction() < 0.95 * cells_before); // the droplet's part of the band is gone
    CHECK(engine->snapshot().vesicles[0].colour_mass == Approx(mass).epsilon(1e-12));
}

TEST_CASE("several vesicles start where they are put, and all their membranes are of one form") {
    Parameters parameters = deforming_spheroid(40, 6.0);
    parameters.vesicles.front().shape = SphereShape{};
    parameters.vesicles.push_back(parameters.vesicles.front());
    parameters.vesicles[0].centre = {10.0, 10.0, 20.0};
    parameters.vesicles[1].centre = {30.0, 30.0, 38.0}; // across a face
    const auto engine = make_engine(parameters, 1);
    const DenseField phase = engine->field("phase");
    double inside = 0.0;
    for (const double phi : phase.values)
        inside += 0.5 * (1.0 + phi);
    // A layer of width 1/beta about a sphere of R holds pi^2/(4 beta^2 R^2) of its volume more.
    const double pi = 3.14159265358979;
    const double width = 1.0 / (parameters.fluid.segregation * 6.0);
    const double sphere = 4.0 / 3.0 * pi * 6.0 * 6.0 * 6.0 * (1.0 + 0.25 * pi * pi * width * width);
    CHECK(inside == Approx(2.0 * sphere).epsilon(1e-3));
    const auto at = [&](int x, int y, int z) {
        return phase.values[static_cast<std::size_t>((z * 40 + y) * 40 + x)];
    };
    CHECK(at(10, 10, 20) > 0.99);
    CHECK(at(30, 30, 0) > 0.9);
    CHECK(at(20, 20, 20) < -0.99);

    parameters.types.push_back(parameters.types.front());
    parameters.vesicles[1].type = 1;
    CHECK_NOTHROW(make_engine(parameters, 1));
    parameters.types[1].bending.form = PaperBending{};
    CHECK_THROWS_WITH(make_engine(parameters, 1), Catch::Contains("several bending forms"));
}
