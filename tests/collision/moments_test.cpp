#include "collision/moments.hpp"
#include "collision/sample_states.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::sample;

TEST_CASE("the ten moments are the sums they are named after", "[collision]") {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 50; ++trial) {
        const Populations p = random_cell(random).before;
        const Moments<double> m = moments_of(p.g);
        const double third = moment(p, 0, 0, 0) / 3.0;
        CHECK(m.density_deviation == Approx(moment(p, 0, 0, 0)).margin(1e-16));
        CHECK(m.momentum.x == Approx(moment(p, 1, 0, 0)).margin(1e-16));
        CHECK(m.momentum.y == Approx(moment(p, 0, 1, 0)).margin(1e-16));
        CHECK(m.momentum.z == Approx(moment(p, 0, 0, 1)).margin(1e-16));
        CHECK(m.stress.xx == Approx(moment(p, 2, 0, 0) - third).margin(1e-16));
        CHECK(m.stress.yy == Approx(moment(p, 0, 2, 0) - third).margin(1e-16));
        CHECK(m.stress.zz == Approx(moment(p, 0, 0, 2) - third).margin(1e-16));
        CHECK(m.stress.xy == Approx(moment(p, 1, 1, 0)).margin(1e-16));
        CHECK(m.stress.xz == Approx(moment(p, 1, 0, 1)).margin(1e-16));
        CHECK(m.stress.yz == Approx(moment(p, 0, 1, 1)).margin(1e-16));
    }
}

TEST_CASE("populations made of ten moments have these moments and no ghosts", "[collision]") {
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 50; ++trial) {
        const Moments<double> m = moments_of(random_cell(random).before.g);
        Populations p;
        populations_of(m, p.g);
        const Moments<double> back = moments_of(p.g);
        CHECK(std::abs(back.density_deviation - m.density_deviation) < 1e-15);
        for (int a = 0; a < 3; ++a)
            CHECK(std::abs(back.momentum[a] - m.momentum[a]) < 1e-15);
        CHECK(std::abs(back.stress.xx - m.stress.xx) < 1e-15);
        CHECK(std::abs(back.stress.yy - m.stress.yy) < 1e-15);
        CHECK(std::abs(back.stress.zz - m.stress.zz) < 1e-15);
        CHECK(std::abs(back.stress.xy - m.stress.xy) < 1e-15);
        CHECK(std::abs(back.stress.xz - m.stress.xz) < 1e-15);
        CHECK(std::abs(back.stress.yz - m.stress.yz) < 1e-15);
        for (int mode = 0; mode < ghost_mode_count; ++mode) {
            double ghost = 0.0;
            for (int i = 0; i < direction_count; ++i)
                ghost += ghost_mode(mode, i) * p[i];
            CHECK(std::abs(ghost) < 1e-15);
        }
    }
}

TEST_CASE("equilibrium and force term are what their moments say", "[collision]") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3<double> u{any(random), any(random), any(random)};
        const Vec3<double> F{any(random), any(random), any(random)};
        Populations p;
        populations_of(equilibrium_moments(1.2, 1.0, u), p.g);
        CHECK(largest_difference(p, equilibrium(1.2, 1.0, u)) < 1e-16);
        populations_of(Moments<double>{0.0, F, source_stress(F, u)}, p.g);
        CHECK(largest_difference(p, guo_term(F, u)) < 1e-16);
    }
}

TEST_CASE("in the source the stress goes with delta_ab/3 taken out, as Spendlove's Eq 4 lacks",
          "[collision]") {
    // F_i = t_i {3 F.c + (9/2)(F_a u_b + F_b u_a)(c_a c_b - delta_ab/3)}, so that no mass is made.
    const Vec3<double> u{0.03, -0.05, 0.02};
    const Vec3<double> F{0.01, 0.04, -0.02};
    const Populations p = guo_term(F, u);
    CHECK(std::abs(moment(p, 0, 0, 0)) < 1e-17);
    for (int i = 0; i < direction_count; ++i) {
        double sum = 0.0;
        for (int a = 0; a < 3; ++a) {
            sum += 3.0 * F[a] * velocity(i, a);
            for (int b = 0; b < 3; ++b)
                sum += 4.5 * (F[a] * u[b] + F[b] * u[a]) *
                       (velocity(i, a) * velocity(i, b) - (a == b ? 1.0 / 3.0 : 0.0));
        }
        CHECK(p[i] == Approx(weight(i) * sum).margin(1e-17));
    }
}

TEST_CASE("viscosity and relaxation rate are each other's inverse", "[collision]") {
    for (const double nu : {0.01, 1.0 / 6.0, 0.5, 2.0})
        CHECK(kinematic_viscosity(relaxation_rate(nu)) == Approx(nu));
    CHECK(relaxation_rate(1.0 / 6.0) == Approx(1.0));
    for (const double magic : {3.0 / 16.0, 0.25})
        for (const double rate : {0.4, 1.0, 1.7})
            CHECK((1.0 / rate - 0.5) * (1.0 / paired_rate(rate, magic) - 0.5) == Approx(magic));
}
