#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace vesica {

/// What the report's page asks for while a run goes on, read from the run's files when it is asked for, so
/// that nobody who looks costs a run anything. May be asked by several threads.
class LiveReport {
public:
    /// `page`: without data. `plan_text`: as `vesica check` prints it; asked for once, when the run has
    /// begun.
    LiveReport(std::filesystem::path directory, std::string page, std::function<std::string()> plan_text);

    /// The page with what there is.
    std::string page();
    /// As report_manifest; a run that has not begun to write is one that runs.
    std::string manifest();
    /// Changes whenever the manifest does, and is cheap to find.
    std::string tag() const;
    /// The bytes of pack_surfaces; nothing where the run has no such frame, or it cannot be read.
    std::optional<std::string> frame(std::int64_t step);

private:
    std::filesystem::path directory_;
    std::string page_;
    std::function<std::string()> plan_text_;
    std::mutex plan_guard_, frame_guard_;
    std::optional<std::string> plan_;
    std::map<std::int64_t, std::string> packed_; ///< the latest of those that were asked for
};

} // namespace vesica
