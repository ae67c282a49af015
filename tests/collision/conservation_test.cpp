#include "collision/collision.hpp"
#include "collision/sample_states.hpp"

#include <catch2/catch.hpp>

using namespace vesica;
using namespace vesica::sample;

static_assert(CollisionModel<RegularisedCollision>);
static_assert(CollisionModel<SymmetricMrt<SingleRelaxationTime>>);
static_assert(CollisionModel<SymmetricMrt<TwoRelaxationTimes>>);
static_assert(CollisionModel<SymmetricMrt<FreeGhostRates>>);
static_assert(CollisionModel<PaperMrt>);
static_assert(!CollisionModel<FreeGhostRates>);

TEST_CASE("a collision keeps the mass and changes the momentum by the force, whatever its rates",
          "[collision]") {
    for_each_collision([](const auto& collision, const char* name) {
        INFO(name);
        std::mt19937_64 random(1);
        for (int trial = 0; trial < 200; ++trial) {
            const Cell cell = random_cell(random);
            const Populations after = collided(collision, cell);
            CHECK(std::abs(moment(after, 0, 0, 0) - moment(cell.before, 0, 0, 0)) < 1e-15);
            CHECK(std::abs(moment(after, 1, 0, 0) - moment(cell.before, 1, 0, 0) - cell.force.x) < 1e-15);
            CHECK(std::abs(moment(after, 0, 1, 0) - moment(cell.before, 0, 1, 0) - cell.force.y) < 1e-15);
            CHECK(std::abs(moment(after, 0, 0, 1) - moment(cell.before, 0, 0, 1) - cell.force.z) < 1e-15);
        }
    });
}

TEST_CASE("the equilibrium is the fixed point of every collision", "[collision]") {
    for_each_collision([](const auto& collision, const char* name) {
        INFO(name);
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> speed(-0.1, 0.1);
        for (int trial = 0; trial < 100; ++trial) {
            Cell cell = random_cell(random);
            cell.force = {};
            cell.before = equilibrium(1.1, cell.rho0, {speed(random), speed(random), speed(random)});
            CHECK(largest_difference(collided(collision, cell), cell.before) < 1e-15);
        }
    });
}

TEST_CASE("uniform fluid under a uniform force gains exactly F per step in its velocity u = (j + F/2)/rho",
          "[collision]") {
    for_each_collision([](const auto& collision, const char* name) {
        INFO(name);
        Cell cell;
        cell.force = {1e-4, -2e-4, 3e-4};
        cell.rate = 0.8;
        cell.before = equilibrium(1.0, 1.0, {0.01, 0.0, -0.02});
        const Vec3<double> start = velocity_of(moments_of(cell.before.g), 1.0, cell.force);
        for (int step = 0; step < 10; ++step)
            cell.before = collided(collision, cell);
        const Vec3<double> end = velocity_of(moments_of(cell.before.g), 1.0, cell.force);
        CHECK(norm(end - start - 10.0 * cell.force) < 1e-15);
    });
}

TEST_CASE("single precision collides as double precision does, to its own round-off", "[collision]") {
    for_each_collision([](const auto& collision, const char* name) {
        INFO(name);
        std::mt19937_64 random(3);
        const Cell cell = random_cell(random);
        const Populations after = collided(collision, cell);
        float g[direction_count];
        for (int i = 0; i < direction_count; ++i)
            g[i] = static_cast<float>(cell.before[i]);
        const Vec3<float> F{static_cast<float>(cell.force.x), static_cast<float>(cell.force.y),
                            static_cast<float>(cell.force.z)};
        collision(g, F, static_cast<float>(cell.rate), static_cast<float>(cell.rho0));
        for (int i = 0; i < direction_count; ++i)
            CHECK(std::abs(static_cast<double>(g[i]) - after[i]) < 1e-7);
    });
}
