#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/report_file.hpp"
#include "simulation/plan.hpp"
#include "simulation/plan_text.hpp"
#include "simulation/run.hpp"
#include "simulation/run_start.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <iostream>

namespace vesica {

void declare_watching(CLI::App& command, Watching& watching) {
    command
        .add_option_function<std::string>(
            "--watch",
            [&watching](const std::string& text) {
                int port = -1;
                const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), port);
                if (code != std::errc{} || end != text.data() + text.size() || port < 0 || port > 65535)
                    throw InputError(fmt::format("--watch is {}; expected a port from 1 to 65535, or 0 for "
                                                 "one that is free; try --watch 8080",
                                                 text.empty() ? "empty" : text));
                watching.port = port;
            },
            "Serve the run's report to browsers on this machine while it goes on; 0 takes a free port")
        ->type_name("PORT");
    command
        .add_option("--watch-address", watching.address,
                    "Serve it on this address instead of 127.0.0.1: whoever reaches it can read the run")
        ->type_name("ADDRESS");
}

std::unique_ptr<ReportServer> serve(const Watching& watching, RunOptions& options, const Case& what) {
    if (!watching.port) {
        if (watching.address)
            throw InputError(
                fmt::format("--watch-address is {}, but nothing is to be served; expected a port "
                            "too; try --watch 8080",
                            *watching.address));
        return nullptr;
    }
    if (watching.address && watching.address->empty())
        throw InputError("--watch-address is empty; expected an address of this machine; try 127.0.0.1");
    // Packing a suspension once more would take too long for a page.
    const auto plan = [what]() -> std::string {
        try {
            return what.suspension ? std::string{} : plan_text(what, make_plan(what), std::nullopt, 1);
        } catch (const std::exception&) {
            return {};
        }
    };
    const auto report =
        std::make_shared<LiveReport>(options.directory, read_report_page(), settled(what), plan);
    auto server =
        std::make_unique<ReportServer>(report, watching.address.value_or("127.0.0.1"), *watching.port);
    options.begun = [report] {
        report->begin();
    };
    std::cout << "watch it at " << server->url() << std::endl;
    return server;
}

} // namespace vesica
