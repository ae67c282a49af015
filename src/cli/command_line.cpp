#include "cli/command_line.hpp"

#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "core/version.hpp"
#include "io/case_keys.hpp"
#include "parallel/ranks.hpp"
#include "simulation/crew.hpp"
#include "simulation/stop.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <exception>
#include <iostream>
#include <string_view>

namespace vesica {

namespace {

constexpr int run_failed = 1;
constexpr int input_wrong = 2;

bool is_command(const CLI::App& app, const std::string& word) {
    const auto commands =
        app.get_subcommands([&](const CLI::App* command) { return command->get_name() == word; });
    return !commands.empty();
}

/// Those that are in the help; commands for the program's own use are in no group.
std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        if (!command->get_group().empty())
            names.push_back(command->get_name());
    return names;
}

/// A word in the place of a command that is none deserves a better answer than "unexpected argument".
void refuse_unknown_command(const CLI::App& app, int argument_count, const char* const* arguments) {
    if (argument_count < 2 || arguments[1][0] == '-')
        return;
    const std::string word = arguments[1];
    if (is_command(app, word))
        return;
    const std::vector<std::string> names = command_names(app);
    throw InputError(fmt::format("{} is not a command; expected one of {}; try `vesica {}`", word,
                                 fmt::join(names, ", "), nearest_word(word, names)));
}

int parse_and_act(CLI::App& app, Action& action, int argument_count, const char* const* arguments) {
    refuse_unknown_command(app, argument_count, arguments);
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::Success& request) { // --help, --version
        return app.exit(request, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        const auto chosen = app.get_subcommands();
        const std::string command = chosen.empty() ? "vesica" : "vesica " + chosen.front()->get_name();
        throw InputError(fmt::format("{}; try `{} --help`", error.what(), command));
    }
    if (!action) {
        std::cerr << app.help();
        return input_wrong;
    }
    return action();
}

} // namespace

namespace {

int lead(int argument_count, const char* const* arguments, Crew* crew) {
    CLI::App app{
        "Deformable vesicles in viscous flow, with one lattice Boltzmann framework and no surface mesh",
        "vesica"};
    app.set_version_flag("--version",
                         fmt::format("vesica {} ({}, {}, {})", version, commit, compiler, build_type));
    app.set_help_flag("-h,--help", "Print this and exit");
    app.require_subcommand(0, 1);
    app.footer("Exit status: 0 done; 1 the run failed; 2 the input is wrong; 3 stopped on request, with a "
               "checkpoint\n"
               "written. `vesica COMMAND --help` tells more of a command.");
    Action action;
    declare_run(app, action, crew);
    declare_check(app, action);
    declare_resume(app, action, crew);
    declare_new(app, action);
    declare_info(app, action);
    declare_bench(app, action);
    declare_reproduce(app, action);
    declare_report(app, action);

    try {
        const int status = parse_and_act(app, action, argument_count, arguments);
        if (std::cout.flush().fail())
            throw RunError("the standard output cannot be written: the answer is not complete");
        return status;
    } catch (const InputError& error) {
        std::cerr << error.what() << '\n'; // begins with FILE:LINE:COLUMN, which editors understand
        return input_wrong;
    } catch (const RunError& error) {
        std::cerr << "vesica: " << error.what() << '\n';
    } catch (const std::exception& error) {
        std::cerr << "vesica: " << words_of(error) << '\n';
    }
    return run_failed;
}

} // namespace

int command_line(int argument_count, const char* const* arguments) {
    // Only these share their work among ranks; of the others the first process does it alone.
    const std::string_view command = argument_count > 1 ? arguments[1] : "";
    if (command != "run" && command != "resume")
        return MpiSession::promised_rank() > 0 ? 0 : lead(argument_count, arguments, nullptr);
    try {
        const MpiSession session;
        const Ranks ranks = Ranks::all();
        if (ranks.count() == 1)
            return lead(argument_count, arguments, nullptr);
        if (!ranks.leads()) {
            const StopSignals ignored; // the rank that leads heeds them
            return follow_orders(ranks);
        }
        Crew crew(ranks);
        const int status = lead(argument_count, arguments, &crew);
        crew.dismiss(status);
        return status;
    } catch (const std::exception& error) {
        std::cerr << "vesica: " << words_of(error) << '\n';
        return run_failed;
    }
}

} // namespace vesica
