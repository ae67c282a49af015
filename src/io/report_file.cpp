#include "io/report_file.hpp"

#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/base64.hpp"
#include "io/report_manifest.hpp"
#include "io/report_run.hpp"
#include "io/step_name.hpp"
#include "io/surface_decimation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vesica {
namespace {

using Path = std::filesystem::path;

/// Coarser than this a surface is no picture of itself.
constexpr std::size_t fewest_triangles = 300;
/// What a number of the metrics takes in base64.
constexpr std::uint64_t number_bytes = 11;

/// At most `count` of the steps, as evenly as can be, the last among them.
std::vector<std::int64_t> evenly(const std::vector<std::int64_t>& steps, std::size_t count) {
    if (steps.size() <= count)
        return steps;
    std::vector<std::int64_t> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(steps[count == 1 ? steps.size() - 1 : i * (steps.size() - 1) / (count - 1)]);
    return chosen;
}

/// The surfaces of a run as they go into the page.
class Frames {
public:
    Frames(const Path& directory, std::vector<std::int64_t> steps)
        : directory_(directory), steps_(std::move(steps)) {}

    std::size_t count() const { return steps_.size(); }
    const std::vector<PackedStep>& packed() const { return packed_; }
    const std::vector<std::string>& notes() const { return notes_; }

    /// Packs all steps so that they take at most `bytes` in the page.
    void fit(std::size_t triangles, std::uint64_t bytes) {
        // A look at the last, the most developed, spares most attempts at the whole.
        if (const auto probe = pack(steps_.back(), triangles, false))
            triangles = lowered(triangles, *probe, page_bytes(*probe) * steps_.size(), bytes);
        while (true) {
            pack_all(triangles);
            const std::uint64_t total = sum_of_bytes();
            if (total <= bytes || packed_.empty())
                return;
            const std::size_t fewer = lowered(triangles, packed_.back(), total, bytes);
            if (fewer < triangles) {
                triangles = fewer;
                continue;
            }
            if (steps_.size() == 1)
                throw InputError(fmt::format("a single frame takes {} bytes; expected at most {} for all; "
                                             "try a larger --max-size",
                                             total, bytes));
            const double share = 0.95 * static_cast<double>(bytes) / static_cast<double>(total);
            const auto fitting = static_cast<std::size_t>(share * static_cast<double>(steps_.size()));
            steps_ = evenly(steps_, std::clamp<std::size_t>(fitting, 1, steps_.size() - 1));
        }
    }

private:
    static std::uint64_t page_bytes(const PackedStep& step) { return (step.bytes.size() + 2) / 3 * 4 + 80; }

    /// Triangles of a surface with which `total` bytes would come down to `bytes`.
    static std::size_t lowered(std::size_t triangles, const PackedStep& sample, std::uint64_t total,
                               std::uint64_t bytes) {
        if (total <= bytes)
            return triangles;
        const double share = 0.95 * static_cast<double>(bytes) / static_cast<double>(total);
        const std::size_t now = std::min(triangles, sample.largest_surface);
        return std::min(triangles, std::max(fewest_triangles,
                                            static_cast<std::size_t>(share * static_cast<double>(now))));
    }

    std::optional<PackedStep> pack(std::int64_t step, std::size_t triangles, bool tell) {
        try {
            SurfaceStep surfaces =
                read_surface_file(directory_ / "surfaces" / step_name("surface_", step, ".vtp"));
            for (SurfaceArrays& surface : surfaces.surfaces)
                surface = decimate(surface, triangles);
            return pack_surfaces(surfaces);
        } catch (const InputError& error) {
            if (tell)
                notes_.emplace_back(error.what());
        } catch (const RunError& error) { // a run that is being resumed removes some
            if (tell)
                notes_.emplace_back(error.what());
        }
        return std::nullopt;
    }

    void pack_all(std::size_t triangles) {
        packed_.clear();
        notes_.clear();
        for (const std::int64_t step : steps_)
            if (auto one = pack(step, triangles, true))
                packed_.push_back(std::move(*one));
    }

    std::uint64_t sum_of_bytes() const {
        std::uint64_t sum = 0;
        for (const PackedStep& step : packed_)
            sum += page_bytes(step);
        return sum;
    }

    Path directory_;
    std::vector<std::int64_t> steps_;
    std::vector<PackedStep> packed_;
    std::vector<std::string> notes_;
};

std::vector<ReportFrame> outlines_of(const std::vector<PackedStep>& steps) {
    std::vector<ReportFrame> frames;
    for (const PackedStep& step : steps)
        frames.push_back({step.step, step.time, step.triangles, step.spreads});
    return frames;
}

} // namespace

std::string read_report_page() {
    std::error_code none;
    const Path program = std::filesystem::read_symlink("/proc/self/exe", none);
    const Path page = program.parent_path().parent_path() / "share" / "vesica" / "report.html";
    if (!std::filesystem::exists(page, none))
        throw RunError(
            fmt::format("{}: the report's page is missing; it is made when vesica is built where npm is; "
                        "install nodejs and npm (Debian's packages of these names), then configure and "
                        "build again",
                        page.lexically_normal().string()));
    return read_whole_file(page);
}

ReportOutcome write_report(const Path& directory, const Path& file, const std::string& page,
                           const ReportOptions& options) {
    const std::size_t place = page.find(report_data_place);
    if (place == std::string::npos)
        throw RunError("the report's page has no place for data; build vesica again");
    ReportRun run = read_report_run(directory);
    ReportMaking making;
    making.plan_text = options.plan_text;
    const std::size_t columns = std::max<std::size_t>(run.metrics.columns.size(), 1);
    making.metrics_every =
        thin_metrics(run.metrics, static_cast<std::size_t>(options.max_bytes / 4 / (columns * number_bytes)));
    if (making.metrics_every > 1)
        making.notes.push_back(fmt::format("of the samples in metrics.csv every {}th is shown, to keep the "
                                           "page small",
                                           making.metrics_every));

    const auto all = list_steps(directory / "surfaces", "surface_", ".vtp");
    Frames frames(directory, evenly(all, options.frames));
    // What the frames' own outlines in the manifest take is known only when there are some.
    const std::uint64_t fixed =
        page.size() + report_manifest(run, {}, making).size() + 400 * std::min(all.size(), options.frames);
    if (fixed >= options.max_bytes)
        throw InputError(fmt::format("--max-size is {:.3g} MB; expected more than the {:.3g} MB that the "
                                     "page takes without surfaces; try --max-size 20",
                                     1e-6 * static_cast<double>(options.max_bytes),
                                     1e-6 * static_cast<double>(fixed)));
    if (frames.count() > 0)
        frames.fit(options.triangles, options.max_bytes - fixed);
    making.notes.insert(making.notes.end(), frames.notes().begin(), frames.notes().end());
    const std::size_t shown = frames.packed().size();
    if (shown + frames.notes().size() < all.size())
        making.notes.push_back(fmt::format("{} of {} frames are shown, evenly chosen", shown, all.size()));

    ReportOutcome outcome{0, shown, all.size(), 0, making.notes};
    outcome.notes.insert(outcome.notes.begin(), run.notes.begin(), run.notes.end());
    AtomicFile output(file);
    const auto write = [&](std::string_view text) {
        output.write(text);
        outcome.bytes += text.size();
    };
    write(std::string_view(page).substr(0, place));
    write(report_manifest_element(report_manifest(run, outlines_of(frames.packed()), making)));
    for (const PackedStep& step : frames.packed()) {
        outcome.triangles += step.triangles;
        write(fmt::format("<script type=\"text/plain\" id=\"vesica-frame-{}\">", step.step));
        write(encode_base64(step.bytes));
        write("</script>\n");
    }
    write(std::string_view(page).substr(place + report_data_place.size()));
    output.commit();
    return outcome;
}

} // namespace vesica
