#include "core/input_error.hpp"
#include "shape/directions.hpp"
#include "shape/initial_phase.hpp"
#include "shape/sample_meshes.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace vesica;
using std::numbers::pi;

namespace {

VesicleParameters vesicle(ShapeParameters shape, double radius = 15.0) {
    VesicleParameters parameters;
    parameters.shape = std::move(shape);
    parameters.centre = {32.0, 30.0, 28.0};
    parameters.radius = radius;
    return parameters;
}

MeshShape mesh_of(TriangleMesh triangles) {
    MeshShape shape;
    shape.file = triangles.source;
    shape.mesh = std::make_shared<const TriangleMesh>(std::move(triangles));
    return shape;
}

} // namespace

TEST_CASE("Every shape has the volume of the sphere of its radius, no less area, and an inside at most "
          "points of it") {
    for (const ShapeParameters& form :
         {ShapeParameters{SphereShape{}}, ShapeParameters{SpheroidShape{2.0}},
          ShapeParameters{EvansFungShape{}}, ShapeParameters{HelfrichShape{HelfrichBranch::stomatocyte, 0.6}},
          ShapeParameters{mesh_of(icosphere(3))}})
        for (const bool perturbed : {false, true}) {
            VesicleParameters parameters = vesicle(form);
            if (perturbed)
                parameters.perturbations = {HarmonicPerturbation{2, 1, 0.02}};
            const auto shape = make_shape(parameters);
            CHECK(shape->volume() == Approx(4.0 * pi / 3.0 * 3375.0).epsilon(1e-10));
            CHECK(shape->area() >= 4.0 * pi * 225.0 * (1.0 - 1e-9));
            CHECK(shape->smallest_radius_of_curvature() < 15.1); // a mesh estimates it
            for (const Vec3<double>& u : directions(50))
                CHECK(shape->signed_distance(parameters.centre + 1.001 * shape->bounding_radius() * u) > 0.0);
        }
}

TEST_CASE("An l = 2, m = 0 perturbation stretches a vesicle along its axis") {
    VesicleParameters parameters = vesicle(SphereShape{});
    parameters.axis = {1.0, 0.0, 0.0};
    parameters.perturbations = {HarmonicPerturbation{2, 0, 0.05}};
    const auto shape = make_shape(parameters);
    const double R = 15.0 / std::cbrt(1.0 + 0.6 * 0.0025 + 2.0 / 35.0 * 0.000125);
    CHECK(shape->signed_distance(parameters.centre + Vec3<double>{1.05 * R, 0.0, 0.0}) ==
          Approx(0.0).margin(1e-10));
    CHECK(shape->signed_distance(parameters.centre + Vec3<double>{0.0, 0.975 * R, 0.0}) ==
          Approx(0.0).margin(1e-10));
}

TEST_CASE("A perturbed mesh is close to the perturbed sphere that it approximates") {
    VesicleParameters parameters = vesicle(SphereShape{});
    parameters.perturbations = {RandomPerturbation{2, 4, 0.05, 3}};
    const auto smooth = make_shape(parameters);
    parameters.shape = mesh_of(icosphere(5));
    const auto mesh = make_shape(parameters);
    for (const Vec3<double>& u : directions(100))
        CHECK(mesh->signed_distance(parameters.centre + 15.5 * u) ==
              Approx(smooth->signed_distance(parameters.centre + 15.5 * u)).margin(0.01));
    CHECK(mesh->area() == Approx(smooth->area()).epsilon(1e-3));
}

TEST_CASE("A mesh without a radius keeps its size") {
    CHECK(make_shape(vesicle(mesh_of(cube()), 0.0))->volume() == Approx(8.0));
}

TEST_CASE("The initial phase field is one inside, minus one outside, zero on the surface") {
    const auto shape = make_shape(vesicle(SphereShape{}));
    const Vec3<double> centre{32.0, 30.0, 28.0};
    CHECK(initial_phase(*shape, centre, 0.67) == Approx(1.0).margin(1e-8));
    CHECK(initial_phase(*shape, centre + Vec3<double>{0.0, 15.0, 0.0}, 0.67) == Approx(0.0).margin(1e-12));
    CHECK(initial_phase(*shape, centre + Vec3<double>{16.0, 0.0, 0.0}, 0.67) == Approx(-std::tanh(0.67)));
    CHECK(initial_phase(*shape, centre + Vec3<double>{90.0, 0.0, 0.0}, 0.67) == Approx(-1.0).margin(1e-8));
}

TEST_CASE("Shapes that cannot be are refused") {
    CHECK_THROWS_WITH(
        make_shape(vesicle(SphereShape{}, 0.0)),
        "radius is 0; expected a positive number of cells, the radius of the sphere of equal volume; try 15");
    CHECK_THROWS_WITH(
        make_shape(vesicle(SpheroidShape{-1.0})),
        "aspect is -1; expected 0.02 to 50, the length along the axis over the width; try 0.5 for an oblate "
        "or 2 for a prolate");
    CHECK_THROWS_AS(make_shape(vesicle(HelfrichShape{HelfrichBranch::discocyte, 0.4})), InputError);
    MeshShape unread;
    unread.file = "cell.stl";
    CHECK_THROWS_WITH(make_shape(vesicle(unread)),
                      "shape \"mesh\" has no triangles; expected those of file = \"cell.stl\"");
}
