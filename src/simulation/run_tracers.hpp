#pragma once

#include "case/case.hpp"
#include "io/metrics_file.hpp"
#include "io/output_directory.hpp"
#include "simulation/engine.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vesica {

/// Points that the fluid carries along, and tracers.csv: a row for each of them at each time.
class RunTracers {
public:
    using Notes = std::map<std::string, std::vector<double>>;

    /// `resumed`: the step of the checkpoint from which the run continues.
    RunTracers(const Case& what, const OutputDirectory& directory, std::optional<std::int64_t> resumed);

    /// At every multiple of TracerOutput::every.
    void write(const Engine& engine);
    /// At every step that is TracerOutput::carried_at, after write(): on to the next.
    void carry(const Engine& engine);

    void flush() { file_.flush(); }
    Notes notes() const;
    void restore(const Notes& notes);

private:
    struct Tracer {
        double number = 0.0;
        double seed = 0.0;
        double released = 0.0; ///< step
        Vec3<double> place{};
        Vec3<double> velocity{};
    };

    void release_due(const Engine& engine);
    void release(const Vec3<double>& place, double seed, std::int64_t step);
    void arrive(const Engine& engine);
    void look_around(const Engine& engine);
    void drop_lost(const std::vector<Vec3<double>>& velocities);

    const Parameters& parameters_;
    TracerOutput output_;
    MetricsFile file_;
    std::vector<Tracer> tracers_;
    std::int64_t released_at_ = -1; ///< the last step at which some were
    std::int64_t departed_at_ = -1; ///< the step their places and velocities are of; -1: now
    std::int64_t written_at_ = -1;  ///< they have been moved and looked after at that step
    double count_ = 0.0;            ///< of all that were ever released
};

/// Points where a vesicle's surface meets rays from its middle, evenly turned about the normal of the plane
/// that `first` and `second` span. Each ray ends at its outermost crossing.
std::vector<Vec3<double>> contour_points(const VesicleSnapshot& vesicle, const Vec3<double>& first,
                                         const Vec3<double>& second, int count);

} // namespace vesica
