#include "simulation/crew.hpp"

#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "simulation/crew_post.hpp"
#include "simulation/plan_cost.hpp"

#include <utility>

namespace vesica {

namespace {

/// The whole box behind the interface of one engine.
class LeadingEngine final : public Engine {
public:
    explicit LeadingEngine(CrewPost& post) : post_(post) {}

    void step() override { post_.all(Order::step); }
    std::int64_t steps_done() const override { return own().steps_done(); }

    Snapshot snapshot() const override {
        post_.announce(Order::snapshot);
        return post_.together([&] { return own().snapshot(); });
    }
    std::vector<VesicleSnapshot> vesicles(int first, int count) const override {
        post_.announce(Order::vesicles);
        return post_.vesicles(first, count);
    }
    FieldPart own_field(std::string_view name) const override { return own().own_field(name); }
    DenseField field(std::string_view name) const override {
        post_.announce(Order::field);
        return post_.field(std::string(name));
    }
    std::vector<Vec3<double>> velocities(const std::vector<Vec3<double>>& places) const override {
        post_.announce(Order::velocities);
        return post_.velocities(places);
    }
    std::optional<Trouble> trouble() const override {
        post_.announce(Order::trouble);
        return post_.together([&] { return own().trouble(); });
    }

    /// Of the first rank's block, as the others have theirs.
    EngineState save() const override { return own().save(); }
    std::unique_ptr<StatePlanes> planes() const override { return own().planes(); }
    void load(const EngineState&) override {
        throw RunError("the state of several ranks is loaded from a file, by each its part");
    }

    std::size_t bytes_allocated() const override {
        return static_cast<std::size_t>(post_.shared_out().bytes);
    }
    double interface_fraction() const override { return post_.shared_out().interface_fraction; }
    std::string_view instruction_set() const override { return own().instruction_set(); }
    const StepProfile& profile() const override { return own().profile(); }
    RankTraffic traffic() const override { return own().traffic(); }

private:
    Engine& own() const { return post_.engine(); }

    CrewPost& post_;
};

/// Each call is an order.
class OrderedFields final : public FieldCrew {
public:
    explicit OrderedFields(CrewPost& post) : post_(post) {}

    void sample() override { post_.all(Order::sample_fields); }
    FieldStep write(const std::filesystem::path& path, const FieldStep& geometry) override {
        return post_.together([&] {
            post_.announce(Order::write_fields);
            return post_.fields().write(path, geometry, post_.engine());
        });
    }
    FieldSums sums() const override { return post_.fields().sums(); }
    void keep(const PlacedArrays& places) override {
        post_.together([&] {
            post_.announce(Order::keep_fields);
            post_.fields().keep(places);
        });
    }
    void restore(const std::filesystem::path& checkpoint, int samples) override {
        post_.together([&] {
            post_.announce(Order::restore_fields);
            post_.fields().restore(checkpoint, samples, post_.engine());
        });
    }

private:
    CrewPost& post_;
};

} // namespace

Crew::Crew(const Ranks& ranks) : post_(std::make_unique<CrewPost>(ranks)), ranks_(ranks) {}

Crew::~Crew() {
    dismiss(1); // somebody forgot to say how it ended
}

void Crew::dismiss(int status) {
    if (std::exchange(dismissed_, true))
        return;
    post_->announce(Order::end, status);
}

int Crew::default_threads() const {
    return post_->together([&] {
        post_->announce(Order::threads);
        return vesica::default_threads(ranks_);
    });
}

std::unique_ptr<Engine> Crew::build(const Case& what, const CrewSettings& settings,
                                    const std::optional<std::filesystem::path>& from) {
    const std::string text = resolved_toml(what);
    const std::string checkpoint = from ? from->string() : std::string();
    auto engine = std::make_unique<LeadingEngine>(*post_);
    post_->together([&] {
        post_->announce(Order::build);
        post_->build(text, what.source_file, settings, checkpoint);
    });
    return engine;
}

void Crew::load(const std::filesystem::path& checkpoint, const StateChange& change) {
    const std::string path = checkpoint.string();
    post_->together([&] {
        post_->announce(Order::load);
        post_->load(path, change);
    });
}

ParallelSummary Crew::report() {
    return post_->shared_out().summary;
}

std::unique_ptr<FieldCrew> Crew::fields() {
    return std::make_unique<OrderedFields>(*post_);
}

void Crew::write_state(const StateFile& file, const StatePlanes& own_part) {
    post_->together([&] {
        post_->announce(Order::write);
        post_->write(file, &own_part);
    });
}

Digest Crew::digest(const std::filesystem::path& file, std::uint64_t offset, std::uint64_t length,
                    const std::filesystem::path& target) {
    const std::string path = file.string();
    const std::string name = target.string();
    return post_->together([&] {
        post_->announce(Order::digest);
        return post_->digest(path, offset, length, name);
    });
}

int follow_orders(const Ranks& ranks) {
    CrewPost post(ranks);
    for (;;) {
        const auto [next, number] = post.next();
        const Order order = next; // clang 14 lets no lambda have a binding
        if (order == Order::end)
            return static_cast<int>(number);
        try {
            post.together([&] { post.carry_out(order); });
        } catch (const Agreed&) {
            // The rank that leads tells the user.
        }
    }
}

} // namespace vesica
