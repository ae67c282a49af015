#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace spdlog {
class logger;
}

namespace vesica {

/// DIR/log.txt: one line per event, with its time. Appended to by a resumed run. Losing a line never stops a
/// run.
class RunLog {
public:
    /// Throws RunError when the file cannot be opened.
    explicit RunLog(const std::filesystem::path& path);
    ~RunLog();
    RunLog(const RunLog&) = delete;
    RunLog& operator=(const RunLog&) = delete;

    void information(std::string_view text);
    void warning(std::string_view text);
    void error(std::string_view text);

private:
    std::unique_ptr<spdlog::logger> logger_;
};

} // namespace vesica
