#include "cli/commands.hpp"
#include "simulation/bench.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <memory>

namespace vesica {

void declare_bench(CLI::App& app, Action& action) {
    struct Arguments {
        bool json = false;
        BenchOptions options;
    };
    CLI::App* const command =
        app.add_subcommand("bench", "Measure the standard cases beside what this machine can do at most");
    const auto arguments = std::make_shared<Arguments>();
    command->add_flag("--json", arguments->json, "Write JSON instead of tables");
    declare_threads(*command, arguments->options.threads);
    command->add_option("--size", arguments->options.edges, "Edge of the box in cells; may be repeated")
        ->type_name("N")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option(
            "--case", arguments->options.cases,
            fmt::format("Measure this case only ({}); may be repeated", fmt::join(bench_case_names(), ", ")))
        ->type_name("NAME")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option("--colours", arguments->options.colours,
                     "How many colours the spheres share; by default each has its own")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    command->add_option("--seconds", arguments->options.seconds, "Time to spend on each case")
        ->type_name("S")
        ->check(CLI::Range(1e-3, 3600.0).description(""))
        ->capture_default_str();
    command->callback([&action, arguments] {
        action = [arguments] {
            arguments->options.progress = &std::cerr;
            const BenchReport report = run_bench(arguments->options);
            std::cout << (arguments->json ? bench_json(report) : bench_text(report)) << std::flush;
            return 0;
        };
    });
}

} // namespace vesica
