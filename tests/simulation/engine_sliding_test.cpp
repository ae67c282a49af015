#include "lattice/velocity_set.hpp"
#include "measure/surface.hpp"
#include "measure/whole_cells.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

Parameters sliding_box(const Vec3<int>& size, int velocity, int gradient, double rate) {
    Parameters parameters;
    parameters.size = size;
    parameters.flow.shear = ShearFlow{rate, velocity, gradient, {}, ShearBy::lees_edwards};
    return parameters;
}

/// body(index, cell) for every cell of a box, in the order of a field's values.
template <class Body>
void for_each_cell_of(const Vec3<int>& size, const Body& body) {
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                body(at++, Vec3<int>{x, y, z});
}

Vec3<double> centre_of(const Vec3<int>& cell) {
    return {cell.x + 0.5, cell.y + 0.5, cell.z + 0.5};
}

/// The fluid's velocity everywhere, with the equilibrium's populations.
template <class Velocity>
void set_velocity(Engine& engine, const Velocity& u_at) {
    EngineState state = engine.save();
    for_each_cell_of(state.size, [&](std::size_t at, const Vec3<int>& cell) {
        const Vec3<double> u = u_at(centre_of(cell));
        for (int i = 0; i < direction_count; ++i) {
            const double cu = velocity(i, 0) * u.x + velocity(i, 1) * u.y + velocity(i, 2) * u.z;
            state.populations[static_cast<std::size_t>(i)][at] =
                weight(i) * (3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
        }
    });
    engine.load(state);
}

/// The vesicle's measurements, in the plane of the shear.
MetricsRow sheared_metrics(const Engine& engine) {
    const Snapshot snapshot = engine.snapshot();
    return measure(snapshot.vesicles.front(), snapshot,
                   baseline_of(snapshot.vesicles.front(), 0, ShearPlane{{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}));
}

double area_of(const SurfaceMesh& mesh) {
    double sum = 0.0;
    for (const auto& corners : mesh.triangles) {
        const Vec3<double>& a = mesh.points[corners[0]];
        sum += 0.5 * norm(cross(mesh.points[corners[1]] - a, mesh.points[corners[2]] - a));
    }
    return sum;
}

/// In a shear along x over z, from the start on.
Parameters sheared_spheroid(const Vec3<double>& centre) {
    Parameters parameters = sliding_box({40, 32, 36}, 0, 2, 8e-4);
    const Parameters spheroid = deforming_spheroid();
    parameters.types = spheroid.types;
    parameters.types.front().area.constraint = MultiplierConstraint{};
    parameters.types.front().sigma = 0.0;
    parameters.vesicles = spheroid.vesicles;
    parameters.vesicles.front().axis = {1.0, 0.0, 0.5};
    parameters.vesicles.front().centre = centre;
    return parameters;
}

void shear_at_once(Engine& engine) {
    set_velocity(engine, [&](const Vec3<double>& r) { return Vec3<double>{8e-4 * (r.z - 18.0), 0.0, 0.0}; });
}

} // namespace

TEST_CASE("a box that slides past its images shears the fluid evenly, along any pair of axes") {
    const int gradient = GENERATE(0, 1, 2);
    const int along = (gradient + GENERATE(1, 2)) % 3;
    Vec3<int> size{11, 10, 13};
    size[gradient] = 12;
    Parameters parameters = sliding_box(size, along, gradient, 1.3e-3);
    parameters.fluid.kinematic_viscosity = 1.0 / 3.0;
    const auto engine = make_engine(parameters, 2);
    run(*engine, 2501); // odd: what streams in place must not matter
    const DenseField u = engine->field("velocity");
    const DenseField density = engine->field("density");
    double worst = 0.0;
    double mass = 0.0;
    for_each_cell_of(size, [&](std::size_t at, const Vec3<int>& cell) {
        for (int a = 0; a < 3; ++a)
            worst =
                std::max(worst, std::abs(u.values[3 * at + static_cast<std::size_t>(a)] -
                                         (a == along ? 1.3e-3 * (centre_of(cell)[gradient] - 6.0) : 0.0)));
        mass += density.values[at] - 1.0;
    });
    CHECK(worst < 1e-11);
    CHECK(std::abs(mass) < 1e-11);
}

/// The largest difference of Kelvin's wave, u = A cos(k (x_along - strain x_across)) along the third axis,
/// after a strain of 1.25: it is carried by the shear, and nothing but nu k(t)^2 damps it.
double error_of_wave(int edge, int along, int across, double sign, Precision precision) {
    const double rate = sign * 0.02 * 16.0 / (edge * edge); // the same Re, and speeds that fall with the edge
    const double nu = 0.02;
    const double k = 2.0 * 3.14159265358979323846 / edge;
    const int beside = 3 - along - across;
    Vec3<int> size{edge, edge, edge};
    size[beside] = 10;
    Parameters parameters = sliding_box(size, along, across, rate);
    parameters.fluid.kinematic_viscosity = nu;
    parameters.numerics.precision = precision;
    const auto engine = make_engine(parameters, 1);
    const double half = 0.5 * edge;
    const double amplitude = 0.02 * 16.0 / edge;
    set_velocity(*engine, [&](const Vec3<double>& r) {
        Vec3<double> u{};
        u[along] = rate * (r[across] - half);
        u[beside] = amplitude * std::cos(k * r[along]);
        return u;
    });
    const int steps = static_cast<int>(1.25 / std::abs(rate));
    run(*engine, steps);
    const double strain = rate * steps;
    const double damping = std::exp(-nu * k * k * steps * (1.0 + strain * strain / 3.0));
    const DenseField u = engine->field("velocity");
    const DenseField density = engine->field("density");
    double worst = 0.0;
    double mass = 0.0;
    for_each_cell_of(size, [&](std::size_t at, const Vec3<int>& cell) {
        const Vec3<double> r = centre_of(cell);
        const double expected = amplitude * damping * std::cos(k * (r[along] - strain * (r[across] - half)));
        worst = std::max(worst, std::abs(u.values[3 * at + static_cast<std::size_t>(beside)] - expected));
        mass += density.values[at] - 1.0;
    });
    CHECK(std::abs(mass) / static_cast<double>(density.values.size()) <
          (precision == Precision::double_precision ? 1e-15 : 2e-8));
    return worst / amplitude;
}

TEST_CASE("a wave that is sheared follows Kelvin's solution through sliding faces") {
    const double coarse = error_of_wave(16, 0, 2, 1.0, Precision::double_precision);
    const double fine = error_of_wave(32, 0, 2, 1.0, Precision::double_precision);
    CHECK(fine < 2e-3);
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("sliding faces slide the right way, along any pair of axes") {
    const int across = GENERATE(0, 1, 2);
    const int along = (across + GENERATE(1, 2)) % 3;
    const double sign = GENERATE(1.0, -1.0);
    const double forwards = error_of_wave(16, 0, 2, 1.0, Precision::double_precision);
    CHECK(error_of_wave(16, along, across, sign, Precision::double_precision) ==
          Approx(forwards).epsilon(0.01));
    CHECK(error_of_wave(16, along, across, sign, Precision::single_precision) ==
          Approx(forwards).epsilon(0.02));
}

TEST_CASE("a vesicle that lies across a sliding face is the vesicle in the middle of the box") {
    const auto inside = make_engine(sheared_spheroid({20.0, 16.0, 17.0}), 2);
    const auto across = make_engine(sheared_spheroid({20.0, 16.0, 35.0}), 2);
    const double mass = across->snapshot().vesicles.front().colour_mass;
    for (Engine* engine : {inside.get(), across.get()}) {
        shear_at_once(*engine);
        run(*engine, 600);
    }
    const MetricsRow a = sheared_metrics(*inside);
    const MetricsRow b = sheared_metrics(*across);
    CHECK(across->snapshot().vesicles.front().colour_mass == Approx(mass).epsilon(1e-11));
    // Values between cells are interpolated: with a radius of 7 that costs something (a fifth of it at 14).
    CHECK(b.area == Approx(a.area).epsilon(4e-4));
    CHECK(b.volume == Approx(a.volume).epsilon(4e-4));
    CHECK(b.inclination == Approx(a.inclination).margin(1.0));
    CHECK(b.taylor_deformation == Approx(a.taylor_deformation).margin(2.5e-3));
    CHECK(b.bending_energy == Approx(a.bending_energy).epsilon(1e-3));
    // It stays near the face, and moves with the fluid there.
    CHECK(b.z == Approx(35.0).margin(0.03));
    CHECK(b.x == Approx(20.0 + 600 * 8e-4 * 17.0).margin(0.1));
    CHECK(b.vx == Approx(8e-4 * 17.0).epsilon(0.02));
    // In one piece, though its halves lie on lattices that have slid past each other.
    const SurfaceMesh surface = extract_surface(on_whole_cells(across->snapshot().vesicles.front()));
    const double corners = static_cast<double>(surface.points.size());
    const double faces = static_cast<double>(surface.triangles.size());
    CHECK(corners - 1.5 * faces + faces == 2.0);
    CHECK(area_of(surface) == Approx(b.area).epsilon(0.01));
}

TEST_CASE("a sheared box goes on from its saved state as if it had never stopped") {
    const Parameters parameters = sheared_spheroid({20.0, 16.0, 3.0});
    const auto engine = make_engine(parameters, 2);
    shear_at_once(*engine);
    run(*engine, 151); // the images have moved by more than four cells, and a part of one
    const auto other = make_engine(parameters, 1);
    other->load(engine->save());
    for (Engine* each : {engine.get(), other.get()})
        run(*each, 90);
    CHECK(same_state(engine->save(), other->save()));
    CHECK(engine->profile().of(StepPart::follow) > 0.0); // the band was laid out anew on the way
}

TEST_CASE("how far the images have moved is the sum of all steps' speeds") {
    FlowTimes times{100, 400, 50};
    double sum = 0.0;
    for (std::int64_t step = 0; step < 600; ++step) {
        CHECK(times.total(step) == Approx(sum).margin(1e-9));
        sum += times.strength(step);
    }
    times.ramp = 0;
    CHECK(times.total(1000) == 300.0);
}
