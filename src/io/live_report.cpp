#include "io/live_report.hpp"

#include "core/input_error.hpp"
#include "io/report_file.hpp"
#include "io/report_manifest.hpp"
#include "io/report_run.hpp"
#include "io/step_name.hpp"
#include "io/surface_decimation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t most_frames = 400;
constexpr std::size_t most_numbers = 400'000; ///< of metrics.csv in one answer
constexpr std::size_t most_triangles = 300'000;
constexpr std::size_t largest_memory = 64'000'000;

/// Steps evenly apart whose choice does not change with every frame that is added, and the last.
std::vector<std::int64_t> steps_shown(const Path& directory) {
    const auto all = list_steps(directory / "surfaces", "surface_", ".vtp");
    std::size_t every = 1;
    while (all.size() / every > most_frames)
        every *= 2;
    std::vector<std::int64_t> shown;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i % every == 0 || i + 1 == all.size())
            shown.push_back(all[i]);
    return shown;
}

} // namespace

LiveReport::LiveReport(Path directory, std::string page, Case what, std::function<std::string()> plan_text)
    : directory_(std::move(directory)),
      page_(std::move(page)),
      case_(std::move(what)),
      plan_text_(std::move(plan_text)) {}

std::string LiveReport::page() {
    const std::size_t place = page_.find(report_data_place);
    if (place == std::string::npos)
        return page_;
    return page_.substr(0, place) + report_manifest_element(manifest()) +
           page_.substr(place + report_data_place.size());
}

std::string LiveReport::manifest() {
    const std::lock_guard lock(manifest_guard_);
    ReportRun run;
    run.state = "running";
    run.directory = directory_.filename().string();
    const bool begun = has_begun_;
    if (begun)
        try {
            run = read_report_run(directory_, {&case_, most_numbers});
        } catch (const InputError&) { // its first file is still to come
        }
    ReportMaking making;
    making.live = true;
    if (run.resolved) {
        if (!plan_)
            plan_ = plan_text_ ? plan_text_() : std::string{};
        making.plan_text = *plan_;
    }
    making.metrics_every = run.metrics_every;
    const double seconds = run.resolved && run.resolved->scales ? run.resolved->scales->step : 1.0;
    std::vector<ReportFrame> frames;
    for (const std::int64_t step : begun ? steps_shown(directory_) : std::vector<std::int64_t>{})
        frames.push_back({step, static_cast<double>(step) * seconds, 0, {}});
    return report_manifest(run, frames, making);
}

std::string LiveReport::tag() const {
    std::string text = has_begun_ ? "begun;" : "";
    for (const char* name :
         {"resolved.toml", "metrics.csv", "summary.json", "log.txt", "surfaces/surfaces.pvd"}) {
        std::error_code none;
        const auto time = std::filesystem::last_write_time(directory_ / name, none);
        if (!none)
            text += fmt::format("{}:{}:{};", name, time.time_since_epoch().count(),
                                std::filesystem::file_size(directory_ / name, none));
    }
    return fmt::format("\"{:x}\"", std::hash<std::string>{}(text));
}

std::optional<std::string> LiveReport::frame(std::int64_t step) {
    if (!has_begun_)
        return std::nullopt;
    const std::lock_guard lock(frame_guard_);
    if (const auto found = packed_.find(step); found != packed_.end())
        return found->second;
    try {
        SurfaceStep surfaces =
            read_surface_file(directory_ / "surfaces" / step_name("surface_", step, ".vtp"));
        const std::size_t count = std::max<std::size_t>(surfaces.surfaces.size(), 1);
        for (SurfaceArrays& surface : surfaces.surfaces)
            surface = decimate(surface, std::min(ReportOptions{}.triangles, most_triangles / count));
        std::string bytes = pack_surfaces(surfaces).bytes;
        if ((packed_.size() + 1) * bytes.size() > largest_memory)
            packed_.clear();
        packed_[step] = bytes;
        return bytes;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

} // namespace vesica
