#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "simulation/run.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>

namespace vesica {

namespace {

struct RunArguments {
    std::string case_file;
    std::string directory;
    std::vector<std::string> overrides;
    int threads = 0;
    std::int64_t steps = 0;
    bool overwrite = false;
    bool accept_soft_membranes = false;
};

RunOptions options_of(const std::filesystem::path& directory, int threads) {
    RunOptions options;
    options.directory = directory;
    options.threads = threads;
    options.out = &std::cout;
    options.terminal = isatty(STDOUT_FILENO) == 1;
    return options;
}

int tell(const RunOutcome& outcome) {
    if (!outcome.message.empty())
        std::cerr << "vesica: " << outcome.message << '\n';
    return static_cast<int>(outcome.status);
}

/// out/<case file's stem>; `out` is made, being nobody's choice.
std::filesystem::path default_directory(const std::string& case_file) {
    const std::filesystem::path parent = "out";
    std::error_code failure;
    std::filesystem::create_directory(parent, failure);
    if (failure)
        throw InputError("out: cannot be created: " + failure.message() + "; choose a directory with -o DIR");
    return parent / std::filesystem::path(case_file).stem();
}

int run(const RunArguments& arguments) {
    refuse_ranks();
    Case what = read_case(arguments.case_file, arguments.overrides);
    if (arguments.steps > 0)
        what.run.steps = arguments.steps;
    const std::filesystem::path directory = arguments.directory.empty()
                                                ? default_directory(arguments.case_file)
                                                : std::filesystem::path(arguments.directory);
    RunOptions options = options_of(directory, arguments.threads);
    options.overwrite = arguments.overwrite;
    options.plan.accept_soft_membranes = arguments.accept_soft_membranes;
    return tell(run_case(what, options));
}

} // namespace

void declare_run(CLI::App& app, Action& action) {
    CLI::App* const command = app.add_subcommand("run", "Run a case");
    const auto arguments = std::make_shared<RunArguments>();
    command->add_option("case", arguments->case_file, "The case file")->type_name("CASE.toml")->required();
    command->add_option("-o,--output", arguments->directory, "Where to write; by default out/CASE")
        ->type_name("DIR");
    declare_overrides(*command, arguments->overrides);
    declare_threads(*command, arguments->threads);
    command->add_option("--steps", arguments->steps, "Steps to do instead of those of the case")
        ->type_name("N")
        ->check(CLI::PositiveNumber.description(""));
    command->add_flag("--overwrite", arguments->overwrite, "Replace what an earlier run left in DIR");
    declare_soft_membranes(*command, arguments->accept_soft_membranes);
    command->footer(
        "SIGINT, SIGTERM or SIGUSR1 end the run after the step, with a checkpoint (exit status 3).");
    command->callback([&action, arguments] {
        action = [arguments] {
            return run(*arguments);
        };
    });
}

void declare_resume(CLI::App& app, Action& action) {
    struct Arguments {
        std::string directory;
        int threads = 0;
        std::int64_t steps = 0;
    };
    CLI::App* const command =
        app.add_subcommand("resume", "Continue a run from its newest intact checkpoint, bit for bit");
    const auto arguments = std::make_shared<Arguments>();
    command->add_option("directory", arguments->directory, "The directory of the run")
        ->type_name("DIR")
        ->required();
    declare_threads(*command, arguments->threads);
    command->add_option("--steps", arguments->steps, "Steps in total, instead of those planned")
        ->type_name("N")
        ->check(CLI::PositiveNumber.description(""));
    command->callback([&action, arguments] {
        action = [arguments] {
            refuse_ranks();
            std::optional<std::int64_t> steps;
            if (arguments->steps > 0)
                steps = arguments->steps;
            return tell(resume_run(steps, options_of(arguments->directory, arguments->threads)));
        };
    });
}

} // namespace vesica
