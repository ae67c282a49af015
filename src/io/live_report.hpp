#pragma once

#include "case/case.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace vesica {

/// What the report's page asks for while a run goes on, read from the run's files when it is asked for, so
/// that a run that nobody looks at is charged nothing. May be asked by several threads.
class LiveReport {
public:
    /// `page`: without data. `what`: the run's case; files it names are not read again, since HDF5 serves one
    /// thread. `plan_text`: as `vesica check` prints it; asked for once, when the run has begun.
    LiveReport(std::filesystem::path directory, std::string page, Case what,
               std::function<std::string()> plan_text);

    /// The directory is the run's from now on; what lay there before is not shown.
    void begin() { has_begun_ = true; }
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
    Case case_;
    std::function<std::string()> plan_text_;
    std::atomic<bool> has_begun_{false};
    std::mutex manifest_guard_, frame_guard_; ///< one answer of a kind at a time, which bounds their memory
    std::optional<std::string> plan_;
    std::map<std::int64_t, std::string> packed_; ///< the latest of those that were asked for
};

} // namespace vesica
