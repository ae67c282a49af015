#include "collision/sample_states.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::sample;

TEST_CASE("ghost rates of one are the regularised collision", "[collision]") {
    std::mt19937_64 random(1);
    for (int trial = 0; trial < 100; ++trial) {
        const Cell cell = random_cell(random);
        CHECK(largest_difference(collided(SymmetricMrt<FreeGhostRates>{}, cell),
                                 collided(RegularisedCollision{}, cell)) < 1e-15);
    }
}

TEST_CASE("the regularised collision forgets the ghosts: what follows is a function of ten moments",
          "[collision]") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> any(-0.05, 0.05);
    for (int trial = 0; trial < 100; ++trial) {
        const Cell cell = random_cell(random);
        Cell haunted = cell;
        for (int mode = 0; mode < ghost_mode_count; ++mode) {
            const double amplitude = any(random);
            for (int i = 0; i < direction_count; ++i)
                haunted.before[i] += amplitude * weight(i) * ghost_mode(mode, i);
        }
        CHECK(largest_difference(collided(RegularisedCollision{}, haunted),
                                 collided(RegularisedCollision{}, cell)) < 2e-16);
    }
}

TEST_CASE("rates of one in the paper's basis are another operator than the regularised one", "[collision]") {
    std::mt19937_64 random(3);
    const Cell cell = random_cell(random);
    CHECK(largest_difference(collided(PaperMrt{}, cell), collided(RegularisedCollision{}, cell)) > 1e-4);
}

TEST_CASE("two relaxation times are the same in the paper's basis and in the symmetric one", "[collision]") {
    std::mt19937_64 random(4);
    for (const double magic : {3.0 / 16.0, 0.25})
        for (int trial = 0; trial < 100; ++trial) {
            const Cell cell = random_cell(random);
            const double odd = paired_rate(cell.rate, magic);
            const Populations paper = collided(PaperMrt{cell.rate, odd, odd, cell.rate}, cell);
            const Populations symmetric = collided(SymmetricMrt<TwoRelaxationTimes>{{magic}}, cell);
            CHECK(largest_difference(paper, symmetric) < 1e-15);
            const SymmetricMrt<FreeGhostRates> free{{odd, odd, cell.rate, cell.rate}};
            CHECK(largest_difference(collided(free, cell), symmetric) < 1e-15);
        }
}

TEST_CASE("one relaxation time is f + lambda (feq - f) + (1 - lambda/2) Guo's term", "[collision]") {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 100; ++trial) {
        const Cell cell = random_cell(random);
        const Vec3<double> u = velocity_of(moments_of(cell.before.g), cell.rho0, cell.force);
        const Populations target = equilibrium(cell.rho0 + moment(cell.before, 0, 0, 0), cell.rho0, u);
        const Populations source = guo_term(cell.force, u);
        Populations expected = cell.before;
        for (int i = 0; i < direction_count; ++i)
            expected[i] += cell.rate * (target[i] - cell.before[i]) + (1.0 - 0.5 * cell.rate) * source[i];
        CHECK(largest_difference(collided(SymmetricMrt<SingleRelaxationTime>{}, cell), expected) < 1e-15);
        CHECK(largest_difference(collided(PaperMrt{cell.rate, cell.rate, cell.rate, cell.rate}, cell),
                                 expected) < 1e-15);
    }
}

TEST_CASE("each family of ghosts decays with its own rate and leaves the others alone", "[collision]") {
    const FreeGhostRates rates{1.1, 1.3, 0.9, 1.7};
    std::mt19937_64 random(6);
    for (int trial = 0; trial < 20; ++trial) {
        const Cell cell = random_cell(random);
        const Populations after = collided(SymmetricMrt<FreeGhostRates>{rates}, cell);
        for (int mode = 0; mode < ghost_mode_count; ++mode) {
            const double rate = mode < 3 ? 1.1 : mode < 6 ? 1.3 : mode == 6 ? 0.9 : 1.7;
            double before_sum = 0.0;
            double after_sum = 0.0;
            for (int i = 0; i < direction_count; ++i) {
                before_sum += ghost_mode(mode, i) * cell.before[i];
                after_sum += ghost_mode(mode, i) * after[i];
            }
            CHECK(std::abs(after_sum - (1.0 - rate) * before_sum) < 1e-15);
        }
    }
}
