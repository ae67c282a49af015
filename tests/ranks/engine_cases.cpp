#include "simulation/engine_cases.hpp"

#include "lattice/velocity_set.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <span>

using namespace vesica;
using namespace vesica::test;

namespace {

/// The state with all fluid moving as one.
EngineState in_motion(EngineState state, const Vec3<double>& u) {
    for (int i = 0; i < direction_count; ++i) {
        const double cu = velocity(i, 0) * u.x + velocity(i, 1) * u.y + velocity(i, 2) * u.z;
        const double more = weight(i) * (3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
        for (double& value : state.populations[static_cast<std::size_t>(i)])
            value += more;
    }
    if (state.precision == Precision::single_precision)
        for (auto& population : state.populations)
            for (double& value : population)
                value = static_cast<double>(static_cast<float>(value));
    return state;
}

template <class T>
std::vector<T> cut_out(const std::vector<T>& whole, const Vec3<int>& box, const CellBox& part) {
    std::vector<T> cells;
    for (int z = 0; z < part.size.z; ++z)
        for (int y = 0; y < part.size.y; ++y)
            for (int x = 0; x < part.size.x; ++x)
                cells.push_back(whole[static_cast<std::size_t>(
                    part.begin.x + x + box.x * (part.begin.y + y + box.y * (part.begin.z + z)))]);
    return cells;
}

EngineState part_of(const EngineState& whole, const CellBox& part) {
    EngineState state = whole;
    state.part = part;
    for (auto& population : state.populations)
        population = cut_out(population, whole.size, part);
    state.minority.clear();
    state.band.clear();
    state.label.clear();
    const auto cells = static_cast<std::ptrdiff_t>(CellBox{{}, whole.size}.volume());
    for (std::ptrdiff_t slot = 0; slot < static_cast<std::ptrdiff_t>(whole.slots()); ++slot) {
        const auto append_slot = [&]<class T>(const std::vector<T>& from, std::vector<T>& to) {
            if (from.empty())
                return;
            const std::vector<T> own(from.begin() + slot * cells, from.begin() + (slot + 1) * cells);
            const std::vector<T> cut = cut_out(own, whole.size, part);
            to.insert(to.end(), cut.begin(), cut.end());
        };
        append_slot(whole.minority, state.minority);
        append_slot(whole.band, state.band);
        append_slot(whole.label, state.label);
    }
    return state;
}

std::vector<std::byte> bytes_of(const EngineState& state) {
    std::vector<std::byte> bytes;
    const auto append = [&](const auto& values) {
        const auto more = std::as_bytes(std::span(values));
        bytes.insert(bytes.end(), more.begin(), more.end());
    };
    for (const auto& population : state.populations)
        append(population);
    append(state.minority);
    append(state.band);
    append(state.label);
    append(state.controllers);
    append(std::vector<std::int64_t>{state.step});
    return bytes;
}

/// The engine of this rank's block; and on the first rank, so that it is not done many times over, one that
/// works on the whole box alone.
struct Both {
    Ranks ranks = Ranks::all();
    std::shared_ptr<const Neighbourhood> neighbourhood;
    std::unique_ptr<Engine> shared;
    std::unique_ptr<Engine> alone;

    Both(const Parameters& parameters, const BlockLayout& layout, int threads)
        : neighbourhood(std::make_shared<const Neighbourhood>(ranks, layout)),
          shared(make_engine(parameters, threads, neighbourhood)) {
        if (ranks.leads())
            alone = make_engine(parameters, 1);
    }

    const CellBox& own() const { return neighbourhood->block().own; }

    void run(int steps) const {
        test::run(*shared, steps);
        if (ranks.leads())
            test::run(*alone, steps);
    }

    /// Both go on from what `change` makes of the state they are in.
    template <class Change>
    void restart(const Change& change) const {
        EngineState state = shared->save();
        change(state);
        shared->load(state);
        if (ranks.leads()) {
            EngineState whole = alone->save();
            change(whole);
            alone->load(whole);
        }
    }

    /// Known to the first rank; the others believe it.
    bool agree() const {
        const std::vector<CellBox> blocks = ranks.gather_all(own());
        const EngineState whole = ranks.leads() ? alone->save() : EngineState();
        bool same = true;
        ranks.gather(bytes_of(shared->save()), [&](int rank, std::span<const std::byte> part) {
            const std::vector<std::byte> expected =
                bytes_of(part_of(whole, blocks[static_cast<std::size_t>(rank)]));
            same = same && std::equal(part.begin(), part.end(), expected.begin(), expected.end());
        });
        return same;
    }
};

BlockLayout layout_of(const Vec3<int>& box, const std::optional<Slide>& slide = {}) {
    const int count = Ranks::all().count();
    return {box, *choose_blocks(box, count, slide), slide};
}

bool same_snapshots(const Snapshot& a, const Snapshot& b) {
    if (a.step != b.step || a.max_speed != b.max_speed || a.vesicles.size() != b.vesicles.size())
        return false;
    for (std::size_t v = 0; v < a.vesicles.size(); ++v) {
        const VesicleSnapshot& s = a.vesicles[v];
        const VesicleSnapshot& t = b.vesicles[v];
        const auto same_cell = [](const InterfaceCell& p, const InterfaceCell& q) {
            const bool same_geometry =
                !p.has_geometry || (p.n == q.n && p.H == q.H && p.K == q.K && p.J == q.J);
            return p.position == q.position && p.phi == q.phi && p.s == q.s && p.u == q.u &&
                   p.density == q.density && p.bending_force == q.bending_force &&
                   p.has_geometry == q.has_geometry && same_geometry;
        };
        const auto same_span = [](const InsideSpan& p, const InsideSpan& q) {
            return p.begin == q.begin && p.count == q.count && p.y == q.y && p.z == q.z && p.rest == q.rest;
        };
        if (!std::equal(s.cells.begin(), s.cells.end(), t.cells.begin(), t.cells.end(), same_cell) ||
            !std::equal(s.inside.begin(), s.inside.end(), t.inside.begin(), t.inside.end(), same_span) ||
            s.colour_mass != t.colour_mass || !(s.momentum == t.momentum) || s.tension != t.tension)
            return false;
    }
    return true;
}

} // namespace

TEST_CASE(
    "a deforming vesicle that is carried across blocks and periodic faces has the same bits on any ranks") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = precision;
    parameters.size = {40, 42, 41};
    parameters.vesicles.front().centre = {33.0, 35.0, 9.0};
    parameters.types.front().area.constraint = MultiplierConstraint{};
    const int threads = precision == Precision::double_precision ? 1 : 2;
    const Both engines(parameters, layout_of(parameters.size), threads);
    REQUIRE(engines.agree());
    engines.restart([](EngineState& state) { state = in_motion(state, {0.04, 0.03, 0.05}); });
    const Snapshot before = engines.shared->snapshot();
    for (int part = 0; part < 5; ++part) {
        engines.run(100);
        INFO("after " << 100 * (part + 1) << " steps");
        CHECK(engines.agree());
    }
    // It went fifteen cells and more along each axis: round the box's end and across blocks.
    const Snapshot after = engines.shared->snapshot();
    if (engines.ranks.leads()) {
        const auto place = [](const Snapshot& snapshot) {
            return measure(snapshot.vesicles.front(), snapshot, baseline_of(snapshot.vesicles.front(), 0));
        };
        CHECK(std::abs(std::remainder(place(after).x - place(before).x - 20.0, 40.0)) < 1.5);
    }
    CHECK(engines.shared->profile().of(StepPart::follow) > 0.0); // the band was laid out anew on the way
}

TEST_CASE("what is measured, drawn and watched on several ranks is what one would say") {
    Parameters parameters = deforming_spheroid();
    parameters.size = {44, 40, 42};
    parameters.vesicles.front().centre = {43.0, 1.0, 40.0}; // over all periodic faces
    parameters.types.front().viscosity_ratio = 3.0;
    const Both engines(parameters, layout_of(parameters.size), 1);
    engines.run(21);
    CHECK(engines.agree());
    const bool leads = engines.ranks.leads();
    const Snapshot together = engines.shared->snapshot();
    if (leads)
        CHECK(same_snapshots(together, engines.alone->snapshot()));
    else
        CHECK(together.vesicles.empty());
    for (const std::string& name : field_names()) {
        INFO(name);
        const DenseField shared = engines.shared->field(name);
        if (!leads) {
            CHECK(shared.values.empty());
            continue;
        }
        const DenseField alone = engines.alone->field(name);
        const bool same = shared.components == alone.components && shared.values == alone.values;
        CHECK(same);
    }
    CHECK_FALSE(engines.shared->trouble());
    // A density that is far too large, in a cell of one rank: all must hear of it, in the same words.
    engines.restart([](EngineState& state) {
        const Vec3<int> place{5, 33, 21};
        const Vec3<int> here = place - state.part.begin;
        const Vec3<int> size = state.part.size;
        if (std::min({here.x, here.y, here.z}) >= 0 && here.x < size.x && here.y < size.y && here.z < size.z)
            state.populations[5][static_cast<std::size_t>(here.x + size.x * (here.y + size.y * here.z))] =
                2.0;
    });
    const std::optional<Trouble> heard = engines.shared->trouble();
    REQUIRE(heard.has_value());
    CHECK(heard->cell == Vec3<int>{5, 33, 21});
    if (!leads)
        return;
    const std::optional<Trouble> expected = engines.alone->trouble();
    REQUIRE(expected.has_value());
    CHECK(heard->cell == expected->cell);
    CHECK(heard->cause == expected->cause);
    CHECK(heard->vesicle == expected->vesicle);
}

TEST_CASE(
    "any way of cutting the box gives the same bits, with blocks that hold nothing of the vesicle too") {
    const int count = Ranks::all().count();
    Parameters parameters = deforming_spheroid();
    parameters.size = {83, 30, 34};
    parameters.vesicles.front().centre = {11.0, 29.0, 16.0};
    for (int x = 1; x <= count; ++x)
        for (int y = 1; x * y <= count; ++y) {
            const Vec3<int> blocks{x, y, count / (x * y)};
            if (blocks.x * blocks.y * blocks.z != count || !fits(parameters.size, blocks))
                continue;
            INFO(blocks.x << " x " << blocks.y << " x " << blocks.z);
            BlockLayout layout(parameters.size, blocks);
            std::vector<double> weight(static_cast<std::size_t>(parameters.size.x), 1.0);
            weight[5] = 20.0;
            layout.balance(0, weight); // uneven, and within tiles
            const Both engines(parameters, layout, 1);
            engines.run(16);
            CHECK(engines.agree());
        }
}

TEST_CASE("a vesicle across sliding faces has the same bits on any ranks") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    const int gradient = GENERATE(0, 1, 2);
    const Slide slide{gradient, (gradient + 1 + gradient % 2) % 3};
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = precision;
    parameters.size = {43, 42, 41};
    parameters.flow.shear = ShearFlow{2.2e-3, slide.velocity, slide.gradient, {}, ShearBy::lees_edwards};
    parameters.vesicles.front().centre = {3.0, 40.0, 38.0}; // near all ends of the box
    parameters.types.front().area.constraint = MultiplierConstraint{};
    const BlockLayout layout = layout_of(parameters.size, slide);
    const Both engines(parameters, layout, precision == Precision::double_precision ? 1 : 2);
    REQUIRE(engines.agree());
    for (int part = 0; part < 3; ++part) {
        engines.run(25);
        INFO("after " << 25 * (part + 1) << " steps");
        CHECK(engines.agree());
    }
    const Snapshot together = engines.shared->snapshot();
    if (engines.ranks.leads())
        CHECK(same_snapshots(together, engines.alone->snapshot()));
    CHECK(engines.shared->profile().of(StepPart::follow) > 0.0); // the images moved on by some cells
    const std::vector<Vec3<double>> places{{3.2, 40.9, 0.3}, {42.9, 41.8, 40.7}, {-20.0, 100.3, 82.1}};
    const auto told = engines.shared->velocities(places);
    if (engines.ranks.leads())
        CHECK(told == engines.alone->velocities(places));
}

TEST_CASE("one fluid has no band to tell of") {
    Parameters parameters;
    parameters.size = {40, 42, 41};
    const Both engines(parameters, layout_of(parameters.size), 1);
    engines.restart([](EngineState& state) {
        std::size_t at = 0;
        const CellBox& part = state.part;
        for (int z = 0; z < part.size.z; ++z)
            for (int y = 0; y < part.size.y; ++y)
                for (int x = 0; x < part.size.x; ++x, ++at)
                    state.populations[1][at] =
                        1e-3 * ((part.begin.x + x + 3 * (part.begin.y + y) + 5 * (part.begin.z + z)) % 7);
    });
    engines.run(25);
    CHECK(engines.agree());
    CHECK(engines.shared->traffic().band_messages == 0);
    CHECK(engines.shared->traffic().population_messages > 0);
}

TEST_CASE("a vesicle that is sheared along a wall it sinks to has the same bits on any ranks") {
    const Precision precision = GENERATE(Precision::double_precision, Precision::single_precision);
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = precision;
    parameters.size = {40, 42, 39};
    parameters.ends[1] = WallEnds{};
    parameters.flow.shear = ShearFlow{1e-3, 2, 1, {5, 60, 10}};
    parameters.flow.body_force = BodyForce{{1e-6, 0.0, 2e-6}, {}};
    parameters.types.front().buoyancy = {0.0, -3e-4, 0.0};
    parameters.types.front().viscosity_ratio = 2.0;
    parameters.vesicles.front().centre = {39.0, 11.0, 1.0};
    const BlockLayout layout = layout_of(parameters.lattice());
    const Both engines(parameters, layout, 2);
    REQUIRE(engines.agree());
    engines.run(80);
    CHECK(engines.agree());
    const Snapshot together = engines.shared->snapshot();
    const DenseField velocity = engines.shared->field("velocity");
    CHECK_FALSE(engines.shared->trouble());
    if (!engines.ranks.leads())
        return;
    const Snapshot one = engines.alone->snapshot();
    CHECK(same_snapshots(together, one));
    CHECK(together.wall_force == one.wall_force);
    CHECK(velocity.size == parameters.size);
    CHECK(velocity.values == engines.alone->field("velocity").values);
}

TEST_CASE("fluid that comes in at one end and leaves at the other has the same bits on any ranks") {
    Parameters parameters;
    parameters.size = {40, 30, 33};
    parameters.ends[0] = OpenEnds{true, 0.02, true, 0.0, {0, FlowTimes::never, 20}};
    parameters.ends[2] = WallEnds{};
    const Both engines(parameters, layout_of(parameters.lattice()), 1);
    engines.run(120);
    CHECK(engines.agree());
}

TEST_CASE("vesicles that are pressed together have the same bits on any ranks, in a box at rest or sliding") {
    const bool slides = GENERATE(false, true);
    Parameters parameters = deforming_spheroid();
    parameters.numerics.precision = slides ? Precision::single_precision : Precision::double_precision;
    parameters.size = {40, 42, 39};
    if (slides)
        parameters.flow.shear = ShearFlow{5e-3, 0, 2, {}, ShearBy::lees_edwards};
    parameters.types.front().buoyancy = {0.0, 0.0, 3e-4};
    parameters.types.front().area.constraint = MultiplierConstraint{};
    VesicleType other = parameters.types.front();
    other.buoyancy = {0.0, 0.0, -3e-4};
    other.viscosity_ratio = 2.0;
    parameters.types.push_back(other);
    VesicleParameters vesicle = parameters.vesicles.front();
    vesicle.shape = SpheroidShape{0.7};
    vesicle.axis = {0.1, 0.2, 1.0};
    parameters.vesicles.clear();
    const Vec3<double> centres[] = {
        {20.0, 21.0, 11.0}, {22.0, 19.0, 26.0}, {39.0, 3.0, 36.0}, {2.0, 1.0, 12.0}};
    for (std::size_t k = 0; k < 4; ++k) {
        vesicle.centre = centres[k];
        vesicle.type = k % 2;
        parameters.vesicles.push_back(vesicle);
    }
    const BlockLayout layout =
        layout_of(parameters.lattice(), slides ? std::optional(Slide{2, 0}) : std::nullopt);
    const Both engines(parameters, layout, 1);
    REQUIRE(engines.agree());
    engines.run(41);
    CHECK(engines.agree());
    engines.restart([](EngineState&) {});
    engines.run(5);
    CHECK(engines.agree());
    const Snapshot together = engines.shared->snapshot();
    const DenseField phase = engines.shared->field("phase");
    const DenseField curvature = engines.shared->field("mean_curvature");
    CHECK_FALSE(engines.shared->trouble());
    if (!engines.ranks.leads())
        return;
    CHECK(engines.alone->save().slots() > 1);
    CHECK(same_snapshots(together, engines.alone->snapshot()));
    const bool same_phase = phase.values == engines.alone->field("phase").values; // not to be printed
    const bool same_curvature = curvature.values == engines.alone->field("mean_curvature").values;
    CHECK(same_phase);
    CHECK(same_curvature);
}
