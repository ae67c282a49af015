#include "geometry/curvature.hpp"
#include "geometry/normal.hpp"
#include "geometry/paper_frames.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace vesica;

namespace {

/// A surface's shape at a point: unit normal, two tangents, and the curvatures along them.
struct Patch {
    Vec3<double> n;
    Vec3<double> e1;
    Vec3<double> e2;
    double kappa1 = 0.0;
    double kappa2 = 0.0;

    /// d_j n_i = kappa1 e1 e1 + kappa2 e2 e2
    Jacobian<double> shape_operator() const {
        const auto row = [&](int i) {
            return kappa1 * e1[i] * e1 + kappa2 * e2[i] * e2;
        };
        return {row(0), row(1), row(2)};
    }
    double H() const { return 0.5 * (kappa1 + kappa2); }
    double K() const { return kappa1 * kappa2; }

    /// K as curvatures_of() states it: a lattice's derivatives see kappa - kappa (kappa1^2 + kappa2^2)/6,
    /// which is given back. `divergence` is that of the normals.
    double restored_K(double divergence) const {
        const double factor = 1.0 + (divergence * divergence - 2.0 * K()) / 6.0;
        return factor * factor * K();
    }
};

Vec3<double> random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return unit_vector(Vec3<double>{normal(random), normal(random), normal(random)});
}

Patch random_patch(std::mt19937_64& random) {
    std::uniform_real_distribution<double> curvature(-1.0, 1.0);
    Patch patch;
    patch.n = random_direction(random);
    patch.e1 = unit_vector(cross(patch.n, random_direction(random)));
    patch.e2 = cross(patch.n, patch.e1);
    patch.kappa1 = curvature(random);
    patch.kappa2 = curvature(random);
    return patch;
}

} // namespace

TEST_CASE("H and K are half the sum and the product of the principal curvatures, K less the stencil's error",
          "[geometry]") {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const Patch patch = random_patch(random);
        const Curvatures<double> found = curvatures_of(patch.shape_operator(), patch.n);
        CHECK(std::abs(found.H - patch.H()) < 1e-14);
        CHECK(std::abs(found.K - patch.restored_K(2.0 * patch.H())) < 1e-14);
    }
}

TEST_CASE("K does not see what the normals do along the normal, and H only as their divergence",
          "[geometry]") {
    // A lattice's d_j n_i has parts a_i n_j + n_i b_j that no surface has.
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        const Patch patch = random_patch(random);
        const Vec3<double> a = random_direction(random);
        const Vec3<double> b = random_direction(random);
        Jacobian<double> G = patch.shape_operator();
        G.x = G.x + a.x * patch.n + patch.n.x * b;
        G.y = G.y + a.y * patch.n + patch.n.y * b;
        G.z = G.z + a.z * patch.n + patch.n.z * b;
        const Curvatures<double> found = curvatures_of(G, patch.n);
        CHECK(std::abs(found.H - 0.5 * G.divergence()) < 1e-14);
        CHECK(std::abs(found.K - patch.restored_K(G.divergence())) < 1e-14);
    }
}

TEST_CASE("K is the determinant of what the normals do along the surface, symmetric or not", "[geometry]") {
    // On a lattice W need not be symmetric: with w (e1 e2 - e2 e1) added the determinant grows by w^2.
    std::mt19937_64 random(6);
    for (const double w : {0.3, -0.7}) {
        const Patch patch = random_patch(random);
        Jacobian<double> G = patch.shape_operator();
        G.x = G.x + w * (patch.e1.x * patch.e2 - patch.e2.x * patch.e1);
        G.y = G.y + w * (patch.e1.y * patch.e2 - patch.e2.y * patch.e1);
        G.z = G.z + w * (patch.e1.z * patch.e2 - patch.e2.z * patch.e1);
        const double determinant = patch.K() + w * w;
        const double restored = 1.0 + (4.0 * patch.H() * patch.H() - 2.0 * determinant) / 6.0;
        CHECK(curvatures_of(G, patch.n).K == Approx(restored * restored * determinant).epsilon(1e-13));
    }
}

TEST_CASE(
    "the paper's three frames give the same curvatures, whichever is chosen, and so does the projection",
    "[geometry]") {
    std::mt19937_64 random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const Patch patch = random_patch(random);
        const Jacobian<double> G = patch.shape_operator();
        const Curvatures<double> projected = curvatures_of(G, patch.n);
        const Curvatures<double> framed[] = {
            curvatures_in_frame_of<0>(G, patch.n), curvatures_in_frame_of<1>(G, patch.n),
            curvatures_in_frame_of<2>(G, patch.n), paper_curvatures_of(G, patch.n)};
        CHECK(std::abs(projected.K - patch.restored_K(2.0 * patch.H())) < 1e-12);
        for (int frame = 0; frame < 4; ++frame) {
            // A frame divides by 1 - N_a^2; the choice keeps that above 2/3.
            const double conditioning = frame < 3 ? 1.0 - patch.n[frame] * patch.n[frame] : 1.0;
            INFO("frame " << frame);
            CHECK(std::abs(framed[frame].H - projected.H) < 1e-12 / conditioning);
            CHECK(std::abs(framed[frame].K - patch.K()) < 1e-12 / conditioning);
        }
    }
}

TEST_CASE("the frame is chosen so that normals along any axis are harmless", "[geometry]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Patch patch;
            patch.n[axis] = sign;
            patch.e1[(axis + 1) % 3] = 1.0;
            patch.e2[(axis + 2) % 3] = 1.0;
            patch.kappa1 = 0.3;
            patch.kappa2 = -0.2;
            const Curvatures<double> found = paper_curvatures_of(patch.shape_operator(), patch.n);
            CHECK(found.H == Approx(0.05).epsilon(1e-13));
            CHECK(found.K == Approx(-0.06).epsilon(1e-13));
        }
}

TEST_CASE("the curvatures of parallel surfaces lead back to the middle one exactly", "[geometry]") {
    // Principal radii of a parallel surface at distance s grow by s: kappa = kappa0/(1 + s kappa0).
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> curvature(-0.1, 0.1);
    std::uniform_real_distribution<double> distance(-3.0, 3.0);
    const auto check = [](double k1, double k2, double s) {
        const double here1 = k1 / (1.0 + s * k1);
        const double here2 = k2 / (1.0 + s * k2);
        const Curvatures<double> here{0.5 * (here1 + here2), here1 * here2};
        const Curvatures<double> middle = map_to_mid_surface(here, s);
        CHECK(std::abs(middle.H - 0.5 * (k1 + k2)) < 1e-15);
        CHECK(std::abs(middle.K - k1 * k2) < 1e-16);
        CHECK(area_to_mid_surface(here, s) == Approx(1.0 / ((1.0 + s * k1) * (1.0 + s * k2))));
    };
    for (int trial = 0; trial < 200; ++trial)
        check(curvature(random), curvature(random), distance(random));
    for (const double s : {-3.0, -0.5, 0.0, 2.0}) {
        check(1.0 / 12.0, 1.0 / 12.0, s); // sphere
        check(1.0 / 12.0, 0.0, s);        // cylinder
        check(0.0, 0.0, s);               // plane
    }
}

TEST_CASE("where layers meet and s is no distance, J stays between 1/10 and 10 and the curvatures finite",
          "[geometry]") {
    const Curvatures<double> sphere{0.5, 0.25};
    CHECK(area_to_mid_surface(sphere, 1.2) == Approx(0.16)); // (1 - s/R)^2, as it is
    CHECK(area_to_mid_surface(sphere, 2.0) == 0.1);          // the sphere's own centre: no area at all
    CHECK(map_to_mid_surface(sphere, 2.0).K == Approx(2.5));
    CHECK(area_to_mid_surface(Curvatures<double>{0.0, -0.25}, 4.0) == 0.1); // a saddle: negative
    CHECK(area_to_mid_surface(sphere, -4.0) == Approx(9.0));
    CHECK(area_to_mid_surface(sphere, -8.0) == 10.0);
}

TEST_CASE("a unit vector has length one; where there is no gradient there is no normal, and no infinity",
          "[geometry]") {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        const Vec3<double> a = 1e-3 * random_direction(random);
        CHECK(norm(unit_vector(a)) == Approx(1.0).epsilon(1e-15));
        CHECK(norm(cross(unit_vector(a), a)) < 1e-18);
    }
    CHECK(unit_vector(Vec3<double>{}) == Vec3<double>{});
    CHECK(unit_vector(Vec3<float>{}) == Vec3<float>{});
}
