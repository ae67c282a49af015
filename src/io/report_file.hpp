#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vesica {

/// How much of a run goes into its page.
struct ReportOptions {
    std::size_t triangles = 12'000;       ///< of each surface, at most
    std::size_t frames = 200;             ///< at most; chosen evenly, the last among them
    std::uint64_t max_bytes = 20'000'000; ///< of the page; surfaces become coarser, then fewer, to keep it
    std::string plan_text;                ///< as `vesica check` prints it; may be empty
};

/// What became of it.
struct ReportOutcome {
    std::uint64_t bytes = 0;
    std::size_t frames = 0;
    std::size_t frames_found = 0;
    std::size_t triangles = 0;      ///< of all frames
    std::vector<std::string> notes; ///< also on the page
};

/// Where in the page the data go.
inline constexpr std::string_view report_data_place = "<!--vesica:data-->";

/// The page without data, which is built from report/ and lies in ../share/vesica beside the program's
/// folder. Throws RunError with what to install when it is not there.
std::string read_report_page();

/// Writes `file`: `page` with the data of the run in `directory`, whole or not at all. Throws InputError when
/// there is no run, or the page cannot be made as small as asked; RunError when it cannot be written.
ReportOutcome write_report(const std::filesystem::path& directory, const std::filesystem::path& file,
                           const std::string& page, const ReportOptions& options);

} // namespace vesica
