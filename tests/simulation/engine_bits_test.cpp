#include "core/input_error.hpp"
#include "simulation/engine_cases.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace vesica;
using namespace vesica::test;

namespace {

/// The state with every cell moved by `shift`, periodically.
EngineState moved(const EngineState& state, const Vec3<int>& shift) {
    EngineState result = state;
    const Vec3<int> n = state.size;
    std::size_t at = 0;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x, ++at) {
                const auto to = static_cast<std::size_t>(
                    ((z + shift.z) % n.z * n.y + (y + shift.y) % n.y) * n.x + (x + shift.x) % n.x);
                for (std::size_t i = 0; i < state.populations.size(); ++i)
                    result.populations[i][to] = state.populations[i][at];
                result.minority[to] = state.minority[at];
                result.band[to] = state.band[at];
            }
    return result;
}

/// After so many steps with one thread and with each of these numbers of threads.
void check_same_bits(const Parameters& parameters, int steps, std::initializer_list<int> threads) {
    const auto one = make_engine(parameters, 1);
    run(*one, steps);
    const EngineState expected = one->save();
    for (const int count : threads) {
        INFO(count << " threads");
        const auto several = make_engine(parameters, count);
        run(*several, steps);
        CHECK(same_state(several->save(), expected));
    }
}

} // namespace

TEST_CASE("a deforming vesicle has the same bits with one thread, two and three") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = precision;
    check_same_bits(parameters, 150, {2, 3});
}

TEST_CASE("bits do not depend on threads where rows are worked on in blocks and viscosities differ") {
    Parameters parameters = deforming_spheroid(48);
    parameters.types.front().viscosity_ratio = 3.0;
    parameters.vesicles.front().centre = {24.0, 46.0, 2.0};
    check_same_bits(parameters, 60, {2, 5});
}

TEST_CASE("a run that is saved and loaded has the same bits as one never stopped") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    const int first = GENERATE(60, 61); // both halves of the streaming pattern
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = precision;
    const auto whole = make_engine(parameters, 1);
    const auto before = make_engine(parameters, 1);
    run(*before, first);
    const auto after = make_engine(parameters, 2);
    after->load(before->save());
    CHECK(same_state(after->save(), before->save()));
    run(*whole, first + 90);
    run(*after, 90);
    CHECK(same_state(after->save(), whole->save()));
}

TEST_CASE("a vesicle that leans over all periodic faces moves as one in the middle, bit for bit") {
    Parameters parameters = deforming_spheroid();
    parameters.size = {32, 30, 35}; // rows that end within a tile, and such that do not
    parameters.vesicles[0].centre = {16.0, 15.0, 17.5};
    const auto middle = make_engine(parameters, 1);
    const auto corner = make_engine(parameters, 2);
    const Vec3<int> shift{16, 15, 17};
    corner->load(moved(middle->save(), shift));
    run(*middle, 200);
    run(*corner, 200);
    CHECK(same_state(corner->save(), moved(middle->save(), shift)));
    const MetricsRow a = metrics_of(*middle);
    const MetricsRow b = metrics_of(*corner);
    CHECK(b.volume == Approx(a.volume).epsilon(1e-12));
    CHECK(b.inertia_1 == Approx(a.inertia_1).epsilon(1e-9));
    CHECK(std::fmod(b.x - a.x - shift.x + 64.0, 32.0) == Approx(0.0).margin(1e-9));
}

TEST_CASE("a box side that is no multiple of the tile, or shorter than one, gives the same as a long one") {
    // Nothing depends on x here but the vesicle; a shear wave along z must not see the box's width in x.
    Parameters parameters;
    parameters.size = {GENERATE(1, 3, 8, 13), 4, 24};
    const auto engine = make_engine(parameters, 1);
    EngineState state = engine->save();
    std::size_t at = 0;
    for (int z = 0; z < 24; ++z)
        for (int k = 0; k < parameters.size.x * 4; ++k, ++at)
            for (std::size_t i = 0; i < 19; ++i) {
                const double cx = i == 1 || i == 2 || i == 8 || i == 10 || i == 15   ? 1.0
                                  : i == 4 || i == 5 || i == 6 || i == 12 || i == 17 ? -1.0
                                                                                     : 0.0;
                state.populations[i][at] =
                    cx * std::sin(2 * 3.14159265358979323846 * (z + 0.5) / 24) * 1e-3 / 12;
            }
    engine->load(state);
    run(*engine, 100);
    const DenseField velocity = engine->field("velocity");
    double reference = 0.0;
    {
        Parameters wide = parameters;
        wide.size.x = 16;
        const auto other = make_engine(wide, 1);
        EngineState wide_state = other->save();
        for (std::size_t i = 0; i < 19; ++i)
            for (std::size_t k = 0; k < wide_state.populations[i].size(); ++k)
                wide_state.populations[i][k] =
                    state.populations[i][k / 64 * static_cast<std::size_t>(parameters.size.x) * 4];
        other->load(wide_state);
        run(*other, 100);
        reference = other->field("velocity").values[3 * 64 * 5];
    }
    CHECK(velocity.values[3 * static_cast<std::size_t>(parameters.size.x) * 4 * 5] == reference);
    CHECK(reference != 0.0);
}

TEST_CASE("instruction sets agree to 1e-10 over a thousand steps") {
    Parameters parameters = deforming_spheroid(24, 6.0);
    parameters.vesicles[0].shape = SpheroidShape{1.2};
    const auto best = make_engine(parameters, 2);
    const auto baseline = make_engine(parameters, 2, "baseline");
    if (best->instruction_set() == "baseline")
        WARN("this machine has the baseline only");
    run(*best, 1000);
    run(*baseline, 1000);
    const EngineState a = best->save();
    const EngineState b = baseline->save();
    double largest = 0.0;
    for (std::size_t i = 0; i < a.populations.size(); ++i)
        for (std::size_t k = 0; k < a.populations[i].size(); ++k)
            largest = std::max(largest, std::abs(a.populations[i][k] - b.populations[i][k]));
    CHECK(largest < 1e-10);
}

TEST_CASE("instruction sets that fuse products and sums have the same bits, however many cells a register "
          "holds") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    const double viscosity_ratio = GENERATE(1.0, 3.0);
    Parameters parameters = deforming_spheroid(48);
    parameters.size.x = 36; // an odd number of tiles, the last of them not full
    parameters.numerics.precision = precision;
    parameters.types.front().viscosity_ratio = viscosity_ratio;
    parameters.vesicles.front().centre = {24.0, 46.0, 2.0};
    std::unique_ptr<Engine> shorter;
    std::unique_ptr<Engine> longer;
    try {
        shorter = make_engine(parameters, 1, "avx2");
        longer = make_engine(parameters, 1, "avx512");
    } catch (const InputError& missing) {
        WARN(missing.what());
        return;
    }
    run(*shorter, 60);
    run(*longer, 60);
    CHECK(same_state(longer->save(), shorter->save()));
}
