#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "parallel/ranks.hpp"
#include "simulation/run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace vesica {

namespace {

struct RunArguments {
    std::string case_file;
    std::optional<std::string> directory;
    std::vector<std::string> overrides;
    int threads = 0;
    std::int64_t steps = 0;
    bool overwrite = false;
    bool profile = false;
    bool accept_soft_membranes = false;
    Sharing sharing;
    Watching watching;
};

/// Processes of another MPI's launcher would each run the whole case.
void refuse_strangers(const Crew* crew) {
    if (crew == nullptr && MpiSession::promised() > 1)
        throw InputError(fmt::format(
            "this is one of {} processes that a launcher has started, but they do not find each other; "
            "expected the launcher of the MPI library that vesica is built with; try its mpirun, or srun "
            "--mpi=pmix, or --threads N without a launcher",
            MpiSession::promised()));
}

RunOptions options_of(const std::filesystem::path& directory, int threads, bool profile,
                      const Sharing& sharing, Crew* crew) {
    RunOptions options;
    refuse_strangers(crew);
    options.crew = crew;
    options.blocks = sharing.blocks;
    options.balance = sharing.balance;
    if (options.crew == nullptr && sharing.blocks)
        layout_for({}, 1, sharing.blocks); // one rank has one block
    options.profile = profile;
    options.directory = directory;
    options.threads = threads;
    options.out = &std::cout;
    options.terminal = crew == nullptr && isatty(STDOUT_FILENO) == 1; // mpirun's terminals may lead anywhere
    return options;
}

int tell(const RunOutcome& outcome) {
    if (!outcome.message.empty())
        std::cerr << "vesica: " << outcome.message << '\n';
    std::cout.clear(); // the results are in their files, whoever listened
    return static_cast<int>(outcome.status);
}

/// DIR, or out/<case file's stem>. An empty DIR is a shell's variable that was never set.
std::filesystem::path directory_of(const RunArguments& arguments) {
    if (!arguments.directory)
        return std::filesystem::path("out") / std::filesystem::path(arguments.case_file).stem();
    if (arguments.directory->empty())
        throw InputError("-o is empty; expected a directory; try -o out/NAME");
    return *arguments.directory;
}

void declare_profile(CLI::App& command, bool& profile) {
    command.add_flag("--profile", profile, "Say at the end where the steps' time went");
}

int run(const RunArguments& arguments, Crew* crew) {
    Case what = read_case(arguments.case_file, arguments.overrides);
    if (arguments.steps > 0)
        what.run.steps = arguments.steps;
    RunOptions options =
        options_of(directory_of(arguments), arguments.threads, arguments.profile, arguments.sharing, crew);
    options.overwrite = arguments.overwrite;
    options.plan.accept_soft_membranes = arguments.accept_soft_membranes;
    const auto server = serve(arguments.watching, options, what);
    return tell(run_case(what, options));
}

} // namespace

void declare_run(CLI::App& app, Action& action, Crew* crew) {
    CLI::App* const command = app.add_subcommand("run", "Run a case");
    const auto arguments = std::make_shared<RunArguments>();
    command->add_option("case", arguments->case_file, "The case file")->type_name("CASE.toml")->required();
    command->add_option("-o,--output", arguments->directory, "Where to write; by default out/CASE")
        ->type_name("DIR");
    declare_overrides(*command, arguments->overrides);
    declare_threads(*command, arguments->threads);
    declare_steps(*command, arguments->steps, "Steps to do instead of those of the case");
    command->add_flag("--overwrite", arguments->overwrite, "Replace what an earlier run left in DIR");
    declare_soft_membranes(*command, arguments->accept_soft_membranes);
    declare_profile(*command, arguments->profile);
    declare_sharing(*command, arguments->sharing);
    declare_watching(*command, arguments->watching);
    command->footer("SIGINT, SIGTERM or SIGUSR1 end the run after the step, with a checkpoint (exit status "
                    "3). Under mpirun send\n"
                    "SIGUSR1: it does not leave time after the others.");
    command->callback([&action, arguments, crew] {
        action = [arguments, crew] {
            return run(*arguments, crew);
        };
    });
}

void declare_resume(CLI::App& app, Action& action, Crew* crew) {
    struct Arguments {
        std::string directory;
        int threads = 0;
        std::int64_t steps = 0;
        bool profile = false;
        Sharing sharing;
    };
    CLI::App* const command =
        app.add_subcommand("resume", "Continue a run from its newest intact checkpoint, bit for bit");
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("directory", arguments->directory, "The directory of the run")
        ->type_name("DIR")
        ->required();
    declare_threads(*command, arguments->threads);
    declare_steps(*command, arguments->steps, "Steps in total, instead of those planned");
    declare_profile(*command, arguments->profile);
    declare_sharing(*command, arguments->sharing);
    command->callback([&action, arguments, crew] {
        action = [arguments, crew] {
            std::optional<std::int64_t> steps;
            if (arguments->steps > 0)
                steps = arguments->steps;
            return tell(resume_run(steps, options_of(arguments->directory, arguments->threads,
                                                     arguments->profile, arguments->sharing, crew)));
        };
    });
}

} // namespace vesica
