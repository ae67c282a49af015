#pragma once

#include "parallel/agreement.hpp"
#include "simulation/crew.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vesica {

/// What the rank that leads can order; its arguments follow as broadcasts.
enum class Order : std::int32_t {
    build,
    load,
    step,
    snapshot,
    vesicles,
    field,
    velocities,
    trouble,
    write,
    sample_fields,
    write_fields,
    keep_fields,
    restore_fields,
    digest,
    threads,
    report,
    end,
};

/// How the work is shared out at present, all ranks together.
struct SharedOut {
    ParallelSummary summary;
    double bytes = 0.0;
    double interface_fraction = 0.0;
};

/// One rank's place in a crew: its engine, and what it does on each order. The rank that leads announces an
/// order and carries it out; the others wait for the next.
class CrewPost {
public:
    explicit CrewPost(const Ranks& ranks) : ranks_(ranks) {}

    const Ranks& ranks() const { return ranks_; }
    Engine& engine() const { return *engine_; }
    FieldWork& fields() { return *fields_; }

    /// For what ranks do together. What all have agreed cannot be done, all throw; should one fail by itself
    /// in the middle, the others would wait for ever, and all end at once.
    template <class Body>
    auto together(const Body& body) const {
        try {
            return body();
        } catch (const Agreed&) {
            throw;
        } catch (const std::exception& error) {
            ranks_.abandon(1, error);
        }
    }

    void announce(Order order, std::int64_t number = 0) const;
    std::pair<Order, std::int64_t> next() const;

    /// On the ranks that follow; the arguments come with the order.
    void carry_out(Order order);

    void all(Order order) {
        announce(order);
        carry_out(order);
    }

    /// Both sides of the orders that have arguments: those of the rank that leads count. What all have agreed
    /// cannot be done, all throw.
    void build(const std::string& case_text, const std::string& name, const CrewSettings& settings,
               const std::string& from);
    void load(const std::string& checkpoint, const StateChange& change);
    void write(const StateFile& file, const StatePlanes* own_part);
    Digest digest(const std::string& file, std::uint64_t offset, std::uint64_t length,
                  const std::string& target);
    DenseField field(const std::string& name);
    std::vector<VesicleSnapshot> vesicles(int first, int count);
    std::vector<Vec3<double>> velocities(const std::vector<Vec3<double>>& places);
    SharedOut shared_out();

private:
    SharedOut gather_reports() const;
    BlockLayout balanced_layout(const Parameters& parameters, BlockLayout layout, const std::string& from,
                                int threads) const;

    Ranks ranks_;
    Vec3<int> blocks_{};
    std::shared_ptr<const Neighbourhood> neighbourhood_;
    std::unique_ptr<Engine> engine_;
    std::optional<FieldWork> fields_;
    RankTraffic before_stepping_;
};

} // namespace vesica
