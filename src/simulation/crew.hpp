#pragma once

#include "case/case.hpp"
#include "io/run_summary.hpp"
#include "io/state_file.hpp"
#include "parallel/ranks.hpp"
#include "simulation/block_plan.hpp"
#include "simulation/engine.hpp"
#include "simulation/field_work.hpp"
#include "simulation/start_state.hpp"

#include <memory>
#include <optional>

namespace vesica {

class CrewPost;

struct CrewSettings {
    int threads = 0;                 ///< of each rank; 0: its share of the machine's processors
    std::optional<Vec3<int>> blocks; ///< along each axis; chosen from the box otherwise
    Balance balance = Balance::interface;
};

/// The ranks of a run as the first of them sees them: it reads, decides, writes and speaks, and every call
/// here is an order that the others carry out with it (follow_orders). When the crew goes, so do they.
class Crew final : public Colleagues {
public:
    /// On the rank that leads.
    explicit Crew(const Ranks& ranks);
    ~Crew() override;

    const Ranks& ranks() const { return ranks_; }

    /// Threads a rank takes if nobody says otherwise.
    int default_threads() const;

    /// An engine for the whole box: what it is asked for, all ranks do in their blocks. `from` names the
    /// checkpoint it will go on from, if any, by whose interfaces the blocks are cut. Throws InputError.
    std::unique_ptr<Engine> build(const Case& what, const CrewSettings& settings,
                                  const std::optional<std::filesystem::path>& from);

    /// Takes up a verified checkpoint's state, each rank its part.
    void load(const std::filesystem::path& checkpoint, const StateChange& change);

    /// How the work was shared out and what travelled, since the engine was built.
    ParallelSummary report();

    /// What all ranks do for the case's fields.
    std::unique_ptr<FieldCrew> fields();

    void write_state(const StateFile& file, const StatePlanes& own_part) override;
    Digest digest(const std::filesystem::path& file, std::uint64_t offset, std::uint64_t length,
                  const std::filesystem::path& target) override;

    /// What the others return from follow_orders.
    void dismiss(int status);

private:
    std::unique_ptr<CrewPost> post_;
    Ranks ranks_;
    bool dismissed_ = false;
};

/// Does what the rank that leads orders until it dismisses the crew; returns the exit status it names.
int follow_orders(const Ranks& ranks);

} // namespace vesica
