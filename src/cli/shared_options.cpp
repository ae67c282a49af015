#include "cli/commands.hpp"
#include "core/input_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>

namespace vesica {

namespace {

/// Throws InputError for anything but a whole number from 1 to `highest`. The parser's own conversion takes a
/// number that is too large for the largest there is.
std::int64_t whole_number(const std::string& option, const std::string& text, std::int64_t highest,
                          std::int64_t example) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || value < 1 || value > highest)
        throw InputError(fmt::format("{0} is {1}; expected a whole number from 1 to {2}; try {0} {3}", option,
                                     text.empty() ? "empty" : text, highest, example));
    return value;
}

} // namespace

void declare_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    command
        .add_option("--set", overrides,
                    "Change a value of the case, such as fluid.kinematic_viscosity=0.2 or "
                    "vesicle[0].radius=12; may be repeated")
        ->type_name("PATH.KEY=VALUE")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false); // or it would swallow the case file behind it
}

void declare_steps(CLI::App& command, std::int64_t& steps, const std::string& description) {
    constexpr std::int64_t most = 1'000'000'000'000'000; // as in a case file
    command
        .add_option_function<std::string>(
            "--steps",
            [&steps](const std::string& text) { steps = whole_number("--steps", text, most, 1000); },
            description)
        ->type_name("N");
}

void declare_threads(CLI::App& command, int& threads) {
    command
        .add_option_function<std::string>(
            "--threads",
            [&threads](const std::string& text) {
                threads = static_cast<int>(whole_number("--threads", text, 4096, 2));
            },
            "Threads to use; by default OMP_NUM_THREADS or all processors")
        ->type_name("N");
}

void declare_soft_membranes(CLI::App& command, bool& accepted) {
    command.add_flag(
        "--accept-soft-membranes", accepted,
        "Run membranes so soft that the recolouring's own resistance is more than a tenth of theirs");
}

void refuse_ranks() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
        const char* const ranks = std::getenv(name);
        if (ranks != nullptr && std::atoi(ranks) > 1)
            throw InputError(
                std::string("this is one of ") + ranks +
                " processes started by mpirun; expected one, as several ranks are not available yet; try "
                "--threads N without mpirun");
    }
}

} // namespace vesica
