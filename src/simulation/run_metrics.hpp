#pragma once

#include "case/parameters.hpp"
#include "measure/centre_tracker.hpp"
#include "measure/metrics.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// The plane whose deformation, inclination and stress are measured. A shear whose velocity falls along the
/// gradient flows the other way.
std::optional<ShearPlane> shear_plane(const Parameters& parameters);

/// The metrics of a run from sample to sample: what they are compared with, where the centres were, whether
/// they still change. All of it goes into checkpoints, so that a resumed run measures what an unbroken one
/// does.
class RunMetrics {
public:
    using Notes = std::map<std::string, std::vector<double>>;

    /// `initial` is the state at step 0; after it, `restore` puts a checkpoint's memory in place of it.
    RunMetrics(const Parameters& parameters, const RunParameters& run, std::int64_t every,
               const Snapshot& initial);

    /// Measures every vesicle.
    const std::vector<MetricsRow>& sample(const Snapshot& snapshot, int threads = 1);

    /// The rows of the newest sample; none before the first.
    const std::vector<MetricsRow>& last() const { return last_; }

    /// Whether the quantity has changed by no more than asked for, for as long as asked for, for every
    /// vesicle, and the targets have stood still meanwhile.
    bool is_steady() const;

    Notes notes() const;
    /// Throws RunError if the notes are not of this case.
    void restore(const Notes& notes);

private:
    struct Moment {
        std::int64_t step = 0;
        std::vector<double> values; ///< of the steady criterion's quantity, vesicle by vesicle
    };
    void remember(std::int64_t step);

    std::int64_t every_;
    std::int64_t ramp_end_ = 0;
    std::int64_t flow_start_ = 0; ///< 0 without a flow
    std::optional<SteadyCriterion> criterion_;
    std::vector<MetricsBaseline> baselines_;
    std::vector<CentreTracker> trackers_;
    std::deque<Moment> history_;
    std::vector<MetricsRow> last_;
};

} // namespace vesica
