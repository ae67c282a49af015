#include "cli/commands.hpp"
#include "core/input_error.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace vesica {

namespace {

/// A command that the interface promises and this version does not have.
void declare_planned(CLI::App& app, Action& action, const std::string& name, const std::string& summary) {
    CLI::App* const command = app.add_subcommand(name, summary + " (not available yet)");
    command->allow_extras();
    command->callback([&action, name] {
        action = [name]() -> int {
            throw InputError("`vesica " + name + "` is not available yet");
        };
    });
}

} // namespace

void declare_report(CLI::App& app, Action& action) {
    declare_planned(app, action, "report", "Make one self-contained HTML file of a run");
}

} // namespace vesica
