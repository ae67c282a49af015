#include "cli/commands.hpp"
#include "core/input_error.hpp"

#include <CLI/CLI.hpp>

namespace vesica {

void declare_new(CLI::App& app, Action& action)
{
    CLI::App* const command = app.add_subcommand("new", "Write a commented starter case");
    command->callback([&action] { action = []() -> int { throw InputError("`vesica new` is not available yet"); }; });
}

} // namespace vesica
