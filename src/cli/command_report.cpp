#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "io/report_file.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/suspension.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace vesica {

namespace {

struct ReportArguments {
    std::string directory;
    std::optional<std::string> file;
    ReportOptions options;
};

/// What `check` says of the run's own case. A page without it is better than none: the case's files may be
/// gone since.
std::string plan_of(const std::filesystem::path& directory) {
    try {
        Case what = read_case(directory / "resolved.toml");
        pack_suspension(what);
        std::string text = plan_text(what, make_plan(what), std::nullopt, 1);
        // The page may travel: places in the case are told without where it lay.
        const std::string folder = (directory / "").string();
        const std::string told = (directory / "resolved.toml").string();
        for (std::size_t at = text.find(told); at != std::string::npos; at = text.find(told, at + 1))
            text.erase(at, folder.size());
        return text;
    } catch (const std::exception&) {
        return {};
    }
}

int report(ReportArguments arguments) {
    if (arguments.directory.empty())
        throw InputError("the directory is empty; expected that of a run; try vesica report out/NAME");
    if (arguments.file && arguments.file->empty())
        throw InputError("-o is empty; expected a file; try -o report.html");
    const std::filesystem::path directory = arguments.directory;
    const std::filesystem::path file =
        arguments.file ? std::filesystem::path(*arguments.file) : directory / "report.html";
    const std::string page = read_report_page();
    arguments.options.plan_text = plan_of(directory);
    const ReportOutcome outcome = write_report(directory, file, page, arguments.options);
    for (const std::string& note : outcome.notes)
        std::cerr << "note: " << note << '\n';
    std::cout << fmt::format("{}: {} of {} frames, {} triangles, {:.1f} MB; open it in a browser\n",
                             file.string(), outcome.frames, outcome.frames_found, outcome.triangles,
                             1e-6 * static_cast<double>(outcome.bytes))
              << std::flush;
    return 0;
}

/// Megabytes, as in "20" or "7.5".
std::uint64_t bytes_of(const std::string& text) {
    double megabytes = 0.0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), megabytes);
    if (code != std::errc{} || end != text.data() + text.size() ||
        !(megabytes >= 0.1 && megabytes <= 2000.0)) // browsers stop at texts of about 2 GB
        throw InputError(fmt::format("--max-size is {}; expected megabytes from 0.1 to 2000; try --max-size "
                                     "20",
                                     text.empty() ? "empty" : text));
    return static_cast<std::uint64_t>(1e6 * megabytes);
}

} // namespace

void declare_report(CLI::App& app, Action& action) {
    CLI::App* const command =
        app.add_subcommand("report", "Make one self-contained HTML page of a run: surfaces, plots, verdicts");
    const auto arguments = std::make_shared<ReportArguments>();
    command->add_option("directory", arguments->directory, "The directory of the run")
        ->type_name("DIR")
        ->required();
    command->add_option("-o,--output", arguments->file, "The page to write; by default DIR/report.html")
        ->type_name("FILE");
    declare_count(*command, "--triangles", arguments->options.triangles, 100, 10'000'000,
                  "Triangles of a surface, at most (12000)");
    declare_count(*command, "--frames", arguments->options.frames, 1, 100'000,
                  "Frames, at most; evenly chosen (200)");
    command
        ->add_option_function<std::string>(
            "--max-size",
            [arguments](const std::string& text) { arguments->options.max_bytes = bytes_of(text); },
            "Size of the page in MB, at most (20): surfaces become coarser, then fewer, to keep it")
        ->type_name("MB");
    command->callback([&action, arguments] {
        action = [arguments] {
            return report(*arguments);
        };
    });
}

} // namespace vesica
