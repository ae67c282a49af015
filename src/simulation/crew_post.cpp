#include "simulation/crew_post.hpp"

#include "io/case_file.hpp"
#include "io/posix_file.hpp"
#include "parallel/agreement.hpp"
#include "simulation/block_plan.hpp"
#include "simulation/plan_cost.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>

namespace vesica {

namespace {

template <class T>
T broadcast_value(const Ranks& ranks, T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    ranks.broadcast(std::as_writable_bytes(std::span(&value, 1)));
    return value;
}

struct Message {
    Order order;
    std::int64_t number;
};

/// CrewSettings as bytes.
struct PlainSettings {
    int threads;
    Vec3<int> blocks; ///< 0: to be chosen
    Balance balance;
};

} // namespace

void CrewPost::announce(Order order, std::int64_t number) const {
    broadcast_value(ranks_, Message{order, number});
}

std::pair<Order, std::int64_t> CrewPost::next() const {
    const Message message = broadcast_value(ranks_, Message{});
    return {message.order, message.number};
}

void CrewPost::carry_out(Order order) {
    switch (order) {
    case Order::build:
        build({}, {}, {}, {});
        break;
    case Order::load:
        load({}, {});
        break;
    case Order::step:
        together([&] { engine_->step(); });
        break;
    case Order::snapshot:
        together([&] { engine_->snapshot(); });
        break;
    case Order::vesicles:
        vesicles(0, 0);
        break;
    case Order::field:
        field({});
        break;
    case Order::velocities:
        velocities({});
        break;
    case Order::trouble:
        together([&] { engine_->trouble(); });
        break;
    case Order::write:
        write({}, nullptr);
        break;
    case Order::sample_fields:
        together([&] { fields_->sample(*engine_); });
        break;
    case Order::write_fields:
        together([&] { fields_->write({}, {}, *engine_); });
        break;
    case Order::keep_fields:
        together([&] { fields_->keep({}); });
        break;
    case Order::restore_fields:
        together([&] { fields_->restore({}, 0, *engine_); });
        break;
    case Order::digest:
        digest({}, 0, 0, {});
        break;
    case Order::threads:
        default_threads(ranks_);
        break;
    case Order::report:
        together([&] { gather_reports(); });
        break;
    case Order::end:
        break;
    }
}

void CrewPost::build(const std::string& case_text, const std::string& name, const CrewSettings& settings,
                     const std::string& from) {
    // All read the same text, so that all compute with the same numbers.
    const std::string text = ranks_.broadcast(case_text);
    const std::string source = ranks_.broadcast(name);
    const std::string checkpoint = ranks_.broadcast(from);
    const PlainSettings plain = broadcast_value(
        ranks_, PlainSettings{settings.threads, settings.blocks.value_or(Vec3<int>{}), settings.balance});
    const int share = default_threads(ranks_);
    const int threads = plain.threads > 0 ? plain.threads : share;
    const Case what = agreed(ranks_, [&] { return read_case_text(text, source); });
    BlockLayout layout = agreed(ranks_, [&] {
        return layout_for(what.parameters.lattice(), ranks_.count(),
                          plain.blocks.x > 0 ? std::optional(plain.blocks) : std::nullopt,
                          slide_of(what.parameters));
    });
    if (plain.balance == Balance::interface && !what.parameters.vesicles.empty())
        layout = balanced_layout(what.parameters, layout, checkpoint, threads);
    blocks_ = layout.blocks();
    neighbourhood_ = std::make_shared<const Neighbourhood>(ranks_, layout);
    engine_ = make_engine(what.parameters, threads, neighbourhood_);
    fields_.emplace(what, threads, ranks_);
    before_stepping_ = engine_->traffic();
}

BlockLayout CrewPost::balanced_layout(const Parameters& parameters, BlockLayout layout,
                                      const std::string& from, int threads) const {
    const Neighbourhood even(ranks_, layout);
    PlaneCounts core = agreed(ranks_, [&] {
        return from.empty() ? core_of_case(parameters, even.block(), threads)
                            : core_of_checkpoint(from, even.block());
    });
    for (std::vector<std::uint64_t>& axis : core)
        ranks_.sum(axis);
    balance_by_interface(layout, core);
    return layout;
}

void CrewPost::load(const std::string& checkpoint, const StateChange& change) {
    const std::string path = ranks_.broadcast(checkpoint);
    const StateChange wanted = broadcast_value(ranks_, change);
    const EngineState state = agreed(ranks_, [&] {
        EngineState part = read_state(path, neighbourhood_->block().own);
        wanted.apply(part);
        return part;
    });
    together([&] { engine_->load(state); });
    before_stepping_ = engine_->traffic();
}

DenseField CrewPost::field(const std::string& name) {
    const std::string text = ranks_.broadcast(name);
    return together([&] { return engine_->field(text); });
}

std::vector<VesicleSnapshot> CrewPost::vesicles(int first, int count) {
    const std::array<int, 2> range = broadcast_value(ranks_, std::array{first, count});
    return together([&] { return engine_->vesicles(range[0], range[1]); });
}

std::vector<Vec3<double>> CrewPost::velocities(const std::vector<Vec3<double>>& places) {
    const auto count = broadcast_value(ranks_, static_cast<std::uint64_t>(places.size()));
    std::vector<Vec3<double>> all = places;
    all.resize(count);
    ranks_.broadcast(std::as_writable_bytes(std::span(all)));
    return together([&] { return engine_->velocities(all); });
}

void CrewPost::write(const StateFile& file, const StatePlanes* own_part) {
    StateFile places;
    places.temporary = ranks_.broadcast(file.temporary.string());
    places.target = ranks_.broadcast(file.target.string());
    const auto offsets =
        broadcast_value(ranks_, std::array{file.populations, file.minority, file.band, file.label});
    places.populations = offsets[0];
    places.minority = offsets[1];
    places.band = offsets[2];
    places.label = offsets[3];
    places.floats = broadcast_value(ranks_, file.floats);
    std::unique_ptr<StatePlanes> part;
    agree(ranks_, [&] {
        if (own_part == nullptr)
            part = engine_->planes();
    });
    write_state(places, own_part != nullptr ? *own_part : *part, ranks_);
}

/// Each rank digests its share of the blocks; the rank that leads puts them together.
Digest CrewPost::digest(const std::string& file, std::uint64_t offset, std::uint64_t length,
                        const std::string& target) {
    const std::string path = ranks_.broadcast(file);
    const std::string name = ranks_.broadcast(target);
    const auto range = broadcast_value(ranks_, std::array{offset, length});
    const std::uint64_t blocks = digest_blocks(range[1]);
    const auto ranks = static_cast<std::uint64_t>(ranks_.count());
    const auto rank = static_cast<std::uint64_t>(ranks_.rank());
    const std::vector<Digest> own = agreed(ranks_, [&] {
        return digests_of_blocks(open_file(path, O_RDONLY, "cannot read", name), range[0], range[1],
                                 blocks * rank / ranks, blocks * (rank + 1) / ranks, name);
    });
    std::vector<Digest> all;
    ranks_.gather(std::as_bytes(std::span(own)), [&](int, std::span<const std::byte> part) {
        const std::size_t before = all.size();
        all.resize(before + part.size() / sizeof(Digest));
        std::copy(part.begin(), part.end(), std::as_writable_bytes(std::span(all).subspan(before)).begin());
    });
    return ranks_.leads() ? combine_digests(all) : Digest{};
}

SharedOut CrewPost::shared_out() {
    announce(Order::report);
    return together([&] { return gather_reports(); });
}

SharedOut CrewPost::gather_reports() const {
    struct Report {
        ParallelSummary::Rank rank;
        RankTraffic traffic;
        RankTraffic before; ///< of the building
        double bytes;
    };
    const StepProfile& profile = engine_->profile();
    Report own{};
    own.rank.block = neighbourhood_->block().own;
    own.rank.waiting = profile.of(StepPart::waiting);
    own.rank.working = profile.total() - own.rank.waiting;
    const double cells = static_cast<double>(own.rank.block.volume());
    own.rank.interface_cells = static_cast<std::int64_t>(std::llround(engine_->interface_fraction() * cells));
    own.traffic = engine_->traffic();
    own.before = before_stepping_;
    own.bytes = static_cast<double>(engine_->bytes_allocated());
    SharedOut all;
    all.summary.blocks = blocks_;
    all.summary.steps = profile.steps;
    std::int64_t interface_cells = 0;
    for (const Report& report : ranks_.gather_all(own)) {
        all.summary.ranks.push_back(report.rank);
        all.summary.population_messages +=
            report.traffic.population_messages - report.before.population_messages;
        all.summary.population_bytes += report.traffic.population_bytes - report.before.population_bytes;
        all.summary.band_messages += report.traffic.band_messages - report.before.band_messages;
        all.summary.band_bytes += report.traffic.band_bytes - report.before.band_bytes;
        all.bytes += report.bytes;
        interface_cells += report.rank.interface_cells;
    }
    all.interface_fraction = static_cast<double>(interface_cells) /
                             static_cast<double>(CellBox{{}, neighbourhood_->block().box}.volume());
    return all;
}

} // namespace vesica
