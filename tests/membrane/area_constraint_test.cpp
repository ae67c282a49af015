#include "membrane/area_constraint.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;

TEST_CASE("the target area goes straight from the initial to the final one and stays there", "[membrane]") {
    const AreaTarget target{100.0, 140.0, 1000};
    CHECK(target.at(0) == 100.0);
    CHECK(target.at(250) == Approx(110.0));
    CHECK(target.at(1000) == 140.0);
    CHECK(target.at(5000) == 140.0);
    CHECK(AreaTarget{100.0, 140.0, 0}.at(0) == 140.0);
}

TEST_CASE("too large an area gives a tension, too small a one a compression", "[membrane]") {
    CHECK(AreaPenalty{0.2}.tension(110.0, 100.0) == Approx(0.02));
    CHECK(AreaPenalty{0.2}.tension(95.0, 100.0) == Approx(-0.01));
    // sigma_A = (alpha/2) A (A - A0): K_A = alpha A A0/2.
    const double A = 110.0;
    const double A0 = 100.0;
    CHECK(PaperAreaPenalty{1e-4}.tension(A, A0) == Approx(AreaPenalty{0.5 * 1e-4 * A * A0}.tension(A, A0)));
    CHECK(PaperAreaPenalty{1e-4}.tension(95.0, A0) < 0.0);
}

TEST_CASE("the multiplier brings the area to its target and ends at the tension the shape needs",
          "[membrane]") {
    // A membrane that resists by `needed` and follows the rest of the tension, as a mass of fluid on a
    // spring: e'' = -(omega^2/K)(sigma_A - needed) - damping e'.
    AreaMultiplier multiplier({0.5, 300.0, 30.0, -1.0});
    const double needed = 0.01;
    const double omega_squared = 1e-3;
    double excess = 0.02;
    double rate = 0.0;
    double tension = 0.0;
    for (int step = 0; step < 20000; ++step) {
        tension = multiplier.tension(100.0 * (1.0 + excess), 100.0);
        rate += -(omega_squared / 0.5) * (tension - needed) - 1e-3 * rate;
        excess += rate;
    }
    CHECK(std::abs(excess) < 1e-6);
    CHECK(tension == Approx(needed).epsilon(1e-3));
}

TEST_CASE("each part of the multiplier's law counts as stated: excess, its sum and its growth",
          "[membrane]") {
    AreaMultiplier multiplier({2.0, 10.0, 5.0, -100.0});
    // sigma_A = K (e + sum e/T_i + T_d (e - previous e)); nothing is known of growth at first.
    CHECK(multiplier.tension(101.0, 100.0) == Approx(2.0 * (0.01 + 0.01 / 10.0)));
    CHECK(multiplier.tension(103.0, 100.0) == Approx(2.0 * (0.03 + 0.04 / 10.0 + 5.0 * 0.02)));
    CHECK(multiplier.tension(102.0, 100.0) == Approx(2.0 * (0.02 + 0.06 / 10.0 - 5.0 * 0.01)));
}

TEST_CASE("the multiplier takes up sigma from the first step on", "[membrane]") {
    AreaMultiplier multiplier({2.0, 10.0, 5.0, -100.0, -0.3});
    CHECK(multiplier.tension(100.0, 100.0) == Approx(-0.3));
    CHECK(multiplier.tension(101.0, 100.0) == Approx(-0.3 + 2.0 * (0.01 + 0.01 / 10.0 + 5.0 * 0.01)));
}

TEST_CASE("the multiplier never compresses beyond its limit, nor pays for it afterwards", "[membrane]") {
    AreaMultiplier multiplier({1.0, 100.0, 0.0, -0.05});
    for (int step = 0; step < 10000; ++step)
        CHECK(multiplier.tension(90.0, 100.0) == -0.05);
    // Ten thousand steps of a sum that was not frozen would hold it at the limit for as many again.
    CHECK(multiplier.state().integral == 0.0);
    CHECK(multiplier.tension(100.0, 100.0) == Approx(0.0).margin(1e-15));
    CHECK(multiplier.tension(101.0, 100.0) > 0.0);
}

TEST_CASE("a multiplier that is saved and restored goes on as if nothing had happened", "[membrane]") {
    const AreaMultiplier::Gains gains{0.5, 300.0, 30.0, -1.0};
    AreaMultiplier whole(gains);
    AreaMultiplier before(gains);
    AreaMultiplier after(gains);
    for (int step = 0; step < 20; ++step) {
        const double area = 100.0 + std::sin(0.3 * step);
        const double expected = whole.tension(area, 100.0);
        if (step < 10)
            CHECK(before.tension(area, 100.0) == expected);
        if (step == 9)
            after.restore(before.state());
        if (step >= 10)
            CHECK(after.tension(area, 100.0) == expected);
    }
}
