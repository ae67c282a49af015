#include "cli/commands.hpp"
#include "core/input_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vesica {

namespace {

/// Throws InputError for anything but a whole number from `lowest` to `highest`. The parser's own conversion
/// takes a number that is too large for the largest there is.
std::int64_t whole_number(const std::string& option, const std::string& text, std::int64_t highest,
                          std::int64_t example, std::int64_t lowest = 1) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || value < lowest || value > highest)
        throw InputError(fmt::format("{0} is {1}; expected a whole number from {4} to {2}; try {0} {3}",
                                     option, text.empty() ? "empty" : text, highest, example, lowest));
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

void declare_count(CLI::App& command, const std::string& option, std::size_t& count, std::int64_t lowest,
                   std::int64_t highest, const std::string& description) {
    const auto usual = static_cast<std::int64_t>(count);
    command
        .add_option_function<std::string>(
            option,
            [&count, option, lowest, highest, usual](const std::string& text) {
                count = static_cast<std::size_t>(whole_number(option, text, highest, usual, lowest));
            },
            description)
        ->type_name("N");
}

void declare_soft_membranes(CLI::App& command, bool& accepted) {
    command.add_flag(
        "--accept-soft-membranes", accepted,
        "Run membranes so soft that the recolouring's own resistance is more than a tenth of theirs");
}

void declare_sharing(CLI::App& command, Sharing& sharing) {
    command
        .add_option_function<std::string>(
            "--blocks",
            [&sharing](const std::string& text) {
                constexpr int most_blocks = 100'000;
                Vec3<int> blocks{};
                std::size_t begin = 0;
                for (int a = 0; a < 3; ++a) {
                    const std::size_t end = a < 2 ? text.find(',', begin) : text.size();
                    const char* const last = text.data() + std::min(end, text.size());
                    const auto [stopped, code] = std::from_chars(text.data() + begin, last, blocks[a]);
                    if (end == std::string::npos || code != std::errc{} || stopped != last || blocks[a] < 1 ||
                        blocks[a] > most_blocks)
                        throw InputError(fmt::format("--blocks is {}; expected three whole numbers of blocks "
                                                     "along x, y and z; try --blocks 1,2,2",
                                                     text.empty() ? "empty" : text));
                    begin = end + 1;
                }
                sharing.blocks = blocks;
            },
            "Blocks along x, y and z, one for each rank of mpirun; by default those with the smallest faces")
        ->type_name("X,Y,Z");
    command
        .add_option_function<std::string>(
            "--balance",
            [&sharing](const std::string& text) {
                if (text != "cells" && text != "interface")
                    throw InputError(fmt::format("--balance is {}; expected cells or interface; try "
                                                 "--balance interface",
                                                 text.empty() ? "empty" : text));
                sharing.balance = text == "cells" ? Balance::cells : Balance::interface;
            },
            "Cut blocks of equally many cells, or of equal work with the interfaces where they are at the "
            "start (interface, the default)")
        ->type_name("WHAT");
}

} // namespace vesica
