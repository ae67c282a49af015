#include "simulation/run_metrics.hpp"

#include "core/input_error.hpp"
#include "measure/diameter.hpp"
#include "parallel/for_each_task.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vesica {

namespace {

std::int64_t end_of_ramps(const Parameters& parameters) {
    std::int64_t end = 0;
    for (const VesicleType& type : parameters.types)
        if (type.area.deflation)
            end = std::max(end, type.area.ramp);
    return end;
}

const std::vector<double>& note(const RunMetrics::Notes& notes, const std::string& name) {
    const auto found = notes.find(name);
    if (found == notes.end())
        throw RunError("the checkpoint does not remember " + name);
    return found->second;
}

/// The times of all that moves or pushes the fluid.
std::vector<FlowTimes> times_of_flows(const Parameters& parameters) {
    std::vector<FlowTimes> times;
    const auto add = [&](const auto& driven) {
        if (driven)
            times.push_back(driven->times);
    };
    add(parameters.flow.shear);
    add(parameters.flow.poiseuille);
    add(parameters.flow.body_force);
    add(parameters.flow.extension);
    for (const AxisEnds& ends : parameters.ends) {
        if (const auto* open = std::get_if<OpenEnds>(&ends))
            times.push_back(open->times);
        const auto* walls = std::get_if<WallEnds>(&ends);
        if (walls != nullptr && walls->lower_velocity != Vec3<double>{})
            times.push_back(walls->lower_times);
        if (walls != nullptr && walls->upper_velocity != Vec3<double>{})
            times.push_back(walls->upper_times);
    }
    return times;
}

/// When the first flow begins; 0 without one.
std::int64_t flow_start(const Parameters& parameters) {
    std::int64_t start = FlowTimes::never;
    for (const FlowTimes& times : times_of_flows(parameters))
        start = std::min(start, times.start);
    return start == FlowTimes::never ? 0 : start;
}

/// When areas have come to their targets and flows to their full strength.
std::int64_t end_of_all_ramps(const Parameters& parameters) {
    std::int64_t end = end_of_ramps(parameters);
    for (const FlowTimes& times : times_of_flows(parameters))
        end = std::max(end, times.start + times.ramp);
    return end;
}

} // namespace

std::optional<ShearPlane> shear_plane(const Parameters& parameters) {
    const auto along = [](int axis, double length) {
        Vec3<double> unit{};
        unit[axis] = length;
        return unit;
    };
    const FlowParameters& flow = parameters.flow;
    if (flow.shear)
        return ShearPlane{along(flow.shear->velocity, flow.shear->rate < 0.0 ? -1.0 : 1.0),
                          along(flow.shear->gradient, 1.0)};
    if (!flow.poiseuille)
        return std::nullopt;
    const int next = (flow.poiseuille->velocity + 1) % 3;
    const int last = (flow.poiseuille->velocity + 2) % 3;
    return ShearPlane{along(flow.poiseuille->velocity, flow.poiseuille->pressure_gradient < 0.0 ? -1.0 : 1.0),
                      along(parameters.has_walls(last) ? last : next, 1.0)};
}

RunMetrics::RunMetrics(const Parameters& parameters, const RunParameters& run, std::int64_t every,
                       const Snapshot& initial)
    : every_(every),
      ramp_end_(end_of_all_ramps(parameters)),
      flow_start_(flow_start(parameters)),
      criterion_(run.stop_when_steady) {
    Vec3<double> period{};
    for (int a = 0; a < 3; ++a)
        period[a] = parameters.is_bounded(a) ? 0.0 : parameters.size[a];
    for (const VesicleSnapshot& vesicle : initial.vesicles) {
        baselines_.push_back(
            baseline_of(vesicle, static_cast<int>(baselines_.size()), shear_plane(parameters)));
        trackers_.emplace_back(period);
    }
}

const std::vector<MetricsRow>& RunMetrics::sample(const Snapshot& snapshot, int threads) {
    last_.assign(snapshot.vesicles.size(), {});
    for_each_task(static_cast<std::int64_t>(last_.size()), threads, [&](std::int64_t k) {
        const auto vesicle = static_cast<std::size_t>(k);
        const bool on_schedule =
            every_ == 0 || snapshot.step % every_ == 0;  // a run cut short must not count twice
        if (snapshot.step <= flow_start_ && on_schedule) // elongation is against the shape the flow finds
            baselines_[vesicle].diameter = largest_diameter(snapshot.vesicles[vesicle]);
        MetricsRow& row = last_[vesicle];
        row = measure(snapshot.vesicles[vesicle], snapshot, baselines_[vesicle]);
        CentreTracker& tracker = trackers_[vesicle];
        const Vec3<double> centre = tracker.follow({row.x, row.y, row.z}, snapshot.sliding);
        if (snapshot.sliding) {
            const double gained = tracker.boxes_slid() * snapshot.sliding->speed;
            (snapshot.sliding->velocity == 0   ? row.vx
             : snapshot.sliding->velocity == 1 ? row.vy
                                               : row.vz) += gained;
        }
        row.x = centre.x;
        row.y = centre.y;
        row.z = centre.z;
    });
    // The box has one viscosity, to which all of them add.
    if (last_.size() > 1) {
        double viscosity = 1.0;
        for (const MetricsRow& row : last_)
            viscosity += row.effective_viscosity - 1.0;
        for (MetricsRow& row : last_)
            row.effective_viscosity = viscosity;
    }
    remember(snapshot.step);
    return last_;
}

void RunMetrics::remember(std::int64_t step) {
    // The sample after the last step may be off the schedule; a longer run would not have taken it.
    if (!criterion_ || every_ == 0 || step % every_ != 0)
        return;
    if (!history_.empty() && history_.back().step == step) // a checkpoint remembered it
        return;
    Moment moment{step, {}};
    for (const MetricsRow& row : last_)
        moment.values.push_back(metrics_value(row, criterion_->quantity));
    history_.push_back(std::move(moment));
    // One sample at or before the beginning of the window is enough.
    while (history_.size() > 1 && history_[1].step <= step - criterion_->over)
        history_.pop_front();
}

bool RunMetrics::is_steady() const {
    if (!criterion_ || history_.empty())
        return false;
    const Moment& now = history_.back();
    const std::int64_t begin = now.step - criterion_->over;
    if (history_.front().step > begin || history_.front().step < ramp_end_)
        return false;
    for (std::size_t vesicle = 0; vesicle < now.values.size(); ++vesicle) {
        double low = now.values[vesicle];
        double high = low;
        for (const Moment& moment : history_) {
            if (std::isnan(moment.values[vesicle]))
                return false;
            low = std::min(low, moment.values[vesicle]);
            high = std::max(high, moment.values[vesicle]);
        }
        if (high - low > criterion_->relative_change * std::abs(now.values[vesicle]))
            return false;
    }
    return true;
}

RunMetrics::Notes RunMetrics::notes() const {
    Notes notes;
    for (const MetricsBaseline& baseline : baselines_) {
        notes["colour_mass"].push_back(baseline.colour_mass);
        notes["diameter"].push_back(baseline.diameter);
    }
    for (const CentreTracker& tracker : trackers_)
        if (const auto& centre = tracker.last())
            notes["centres"].insert(notes["centres"].end(), {centre->x, centre->y, centre->z});
    for (const Moment& moment : history_) {
        notes["steady_steps"].push_back(static_cast<double>(moment.step));
        auto& values = notes["steady_values"];
        values.insert(values.end(), moment.values.begin(), moment.values.end());
    }
    return notes;
}

void RunMetrics::restore(const Notes& notes) {
    const std::size_t vesicles = baselines_.size();
    if (vesicles > 0) {
        const auto& masses = note(notes, "colour_mass");
        const auto& diameters = note(notes, "diameter");
        if (masses.size() != vesicles || diameters.size() != vesicles)
            throw RunError("the checkpoint is of another number of vesicles");
        for (std::size_t vesicle = 0; vesicle < vesicles; ++vesicle) {
            baselines_[vesicle].colour_mass = masses[vesicle];
            baselines_[vesicle].diameter = diameters[vesicle];
        }
    }
    for (CentreTracker& tracker : trackers_)
        tracker.restore(std::nullopt);
    if (const auto found = notes.find("centres");
        found != notes.end() && found->second.size() == 3 * vesicles)
        for (std::size_t vesicle = 0; vesicle < vesicles; ++vesicle) {
            const double* centre = found->second.data() + 3 * vesicle;
            trackers_[vesicle].restore(Vec3<double>{centre[0], centre[1], centre[2]});
        }
    history_.clear();
    const auto steps = notes.find("steady_steps");
    const auto values = notes.find("steady_values");
    if (!criterion_ || steps == notes.end() || values == notes.end())
        return;
    for (std::size_t moment = 0; moment < steps->second.size(); ++moment) {
        const auto begin = values->second.begin() + static_cast<std::ptrdiff_t>(moment * vesicles);
        history_.push_back({static_cast<std::int64_t>(steps->second[moment]),
                            {begin, begin + static_cast<std::ptrdiff_t>(vesicles)}});
    }
}

} // namespace vesica
