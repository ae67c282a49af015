#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/case_file.hpp"
#include "simulation/engine.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/start_state.hpp"
#include "simulation/suspension.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <optional>

namespace vesica {

namespace {

struct CheckArguments {
    std::string case_file;
    std::vector<std::string> overrides;
    int threads = 0;
    bool model = false;
    bool accept_soft_membranes = false;
};

int check(const CheckArguments& arguments) {
    if (arguments.model)
        std::cout << model_text();
    if (arguments.case_file.empty()) {
        if (arguments.model)
            return 0;
        throw InputError(
            "the case file is missing; expected `vesica check CASE.toml`; try `vesica new` for a first one");
    }
    if (arguments.model)
        std::cout << '\n';
    Case what = read_case(arguments.case_file, arguments.overrides);
    pack_suspension(what);
    const Plan plan = make_plan(what, PlanOptions{arguments.accept_soft_membranes});
    const int threads = arguments.threads > 0 ? arguments.threads : default_threads();
    std::optional<std::string> start;
    if (what.initial) {
        Colleagues nobody;
        const StartState found = find_start_state(what, nobody);
        start = fmt::format("step {} of {}", found.step, found.path.string());
    }
    std::optional<RunCost> cost;
    if (!has_errors(plan.remarks))
        cost = measure_cost(what.parameters, what.run, what.output, threads,
                            [](const Parameters& parameters, int n) { return make_engine(parameters, n); });
    if (start)
        std::cout << "starts from " << *start << '\n';
    std::cout << plan_text(what, plan, cost, threads) << std::flush;
    refuse_errors(plan);
    return 0;
}

} // namespace

void declare_check(CLI::App& app, Action& action) {
    CLI::App* const command =
        app.add_subcommand("check", "Say what a case means, costs and risks, without running it");
    const auto arguments = std::make_shared<CheckArguments>();
    command->add_option("case", arguments->case_file, "The case file")->type_name("CASE.toml");
    declare_overrides(*command, arguments->overrides);
    declare_threads(*command, arguments->threads);
    command->add_flag("--model", arguments->model, "Say what is in the model and what is not");
    declare_soft_membranes(*command, arguments->accept_soft_membranes);
    command->callback([&action, arguments] {
        action = [arguments] {
            return check(*arguments);
        };
    });
}

} // namespace vesica
