#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "simulation/paper_formulas.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace vesica {

namespace {

namespace fs = std::filesystem;

struct ReproduceArguments {
    std::vector<std::string> items;
    bool all = false;
    bool list = false;
    bool quick = false;
    std::string output = "reproduction-out";
    int threads = 0;
};

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

fs::path own_executable() {
    std::error_code unknown;
    const fs::path path = fs::read_symlink("/proc/self/exe", unknown);
    if (unknown)
        throw RunError("/proc/self/exe cannot be read, so that the program does not know where it lies");
    return path;
}

/// Beside an installed program in share/vesica, beside one that was just built in the sources it was built
/// from.
fs::path script_near(const fs::path& executable) {
    const fs::path script = fs::path("reproduction") / "reproduce.py";
    const std::string named = environment("VESICA_REPRODUCTION");
    if (!named.empty()) {
        if (fs::exists(fs::path(named) / "reproduce.py"))
            return fs::path(named) / "reproduce.py";
        throw InputError(
            fmt::format("VESICA_REPRODUCTION is {}; expected a directory that holds reproduce.py; "
                        "try share/vesica/reproduction of the installation",
                        named));
    }
    constexpr int levels = 5;
    fs::path folder = executable.parent_path();
    for (int level = 0; level < levels && folder != folder.root_path(); ++level) {
        for (const fs::path& candidate : {folder / "share" / "vesica" / script, folder / script})
            if (fs::exists(candidate))
                return candidate;
        folder = folder.parent_path();
    }
    throw RunError(fmt::format("{} is in no directory above {}; it is installed with the program; set "
                               "VESICA_REPRODUCTION to the directory that holds reproduce.py",
                               script.string(), executable.string()));
}

std::string python() {
    const std::string named = environment("VESICA_PYTHON");
    if (!named.empty())
        return named;
    // Debian's own sees Debian's packages, whatever else comes first on the path.
    const std::string debian = "/usr/bin/python3";
    return fs::exists(debian) ? debian : "python3";
}

/// Hands the process over: signals and the exit status are then the script's own.
int reproduce(const ReproduceArguments& arguments) {
    const fs::path executable = own_executable();
    std::vector<std::string> words = {
        python(),        "-B", script_near(executable).string(), "--program", executable.string(), "--output",
        arguments.output};
    if (arguments.threads > 0)
        words.insert(words.end(), {"--threads", std::to_string(arguments.threads)});
    for (const auto& [given, word] :
         {std::pair{arguments.all, "--all"}, {arguments.list, "--list"}, {arguments.quick, "--quick"}})
        if (given)
            words.emplace_back(word);
    words.emplace_back("--");
    words.insert(words.end(), arguments.items.begin(), arguments.items.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::cout << std::flush;
    execvp(pointers.front(), pointers.data());
    throw RunError(fmt::format("{} cannot be started: {}; expected Python 3.11 or newer with NumPy, SciPy, "
                               "Matplotlib, h5py and VTK; try apt-get install python3, or set VESICA_PYTHON",
                               words.front(), std::strerror(errno)));
}

} // namespace

void declare_reproduce(CLI::App& app, Action& action) {
    CLI::App* const command =
        app.add_subcommand("reproduce", "Reproduce figures and tables of the reference paper");
    const auto arguments = std::make_shared<ReproduceArguments>();
    command->add_option("item", arguments->items, "Which figures and tables; see --list")->type_name("ITEM");
    command->add_flag("--all", arguments->all, "All of them");
    command->add_flag("--list", arguments->list, "Name the items, and what each takes");
    command->add_flag("--quick", arguments->quick,
                      "Small vesicles and short runs, in minutes: shows that it works, not what is right");
    command
        ->add_option("-o,--output", arguments->output,
                     "Where runs and results are kept; what is done there already is not done again")
        ->type_name("DIR")
        ->capture_default_str();
    declare_threads(*command, arguments->threads);
    command->callback([&action, arguments] {
        action = [arguments] {
            return reproduce(*arguments);
        };
    });

    // For `reproduce` itself, which checks the program's own tables; without a group it is in no list.
    CLI::App* const formulas = app.add_subcommand("paper-formulas", "The reference paper's tables, as JSON");
    formulas->group("");
    formulas->callback([&action] {
        action = [] {
            std::cout << paper_formulas_json() << std::flush;
            return 0;
        };
    });
}

} // namespace vesica
