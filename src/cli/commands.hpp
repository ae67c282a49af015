#pragma once

#include "case/case.hpp"
#include "core/vec3.hpp"
#include "io/report_server.hpp"
#include "simulation/crew.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vesica {

/// What a command does once its options are read; returns the exit status.
using Action = std::function<int()>;

/// Each declares a command's options on `app` and leaves what to do in `action` when it is the one named.
/// `crew`: the ranks a launcher has started; null where this process is alone.
void declare_run(CLI::App& app, Action& action, Crew* crew);
void declare_resume(CLI::App& app, Action& action, Crew* crew);
void declare_check(CLI::App& app, Action& action);
void declare_new(CLI::App& app, Action& action);
void declare_info(CLI::App& app, Action& action);
void declare_bench(CLI::App& app, Action& action);
void declare_reproduce(CLI::App& app, Action& action);
void declare_report(CLI::App& app, Action& action);

/// Repeatable `--set path.key=value`.
void declare_overrides(CLI::App& command, std::vector<std::string>& overrides);
/// A whole number of at least 1; `value` is left alone where the option is not given.
void declare_steps(CLI::App& command, std::int64_t& steps, const std::string& description);
void declare_threads(CLI::App& command, int& threads);
/// A whole number from `lowest` to `highest` for any other option.
void declare_count(CLI::App& command, const std::string& option, std::size_t& count, std::int64_t lowest,
                   std::int64_t highest, const std::string& description);
void declare_soft_membranes(CLI::App& command, bool& accepted);

/// How several ranks share a box: `--blocks X,Y,Z` and `--balance cells|interface`.
struct Sharing {
    std::optional<Vec3<int>> blocks;
    Balance balance = Balance::interface;
};
void declare_sharing(CLI::App& command, Sharing& sharing);

struct RunOptions;

/// Whether browsers may watch a run: `--watch PORT` and `--watch-address ADDRESS`.
struct Watching {
    std::optional<int> port;
    std::optional<std::string> address;
};
void declare_watching(CLI::App& command, Watching& watching);
/// Serves the report of the run in options.directory from its beginning (options.begun) for as long as the
/// answer lives, and says where; null where nobody wants to watch. Throws InputError or RunError before the
/// run has begun.
std::unique_ptr<ReportServer> serve(const Watching& watching, RunOptions& options, const Case& what);

} // namespace vesica
