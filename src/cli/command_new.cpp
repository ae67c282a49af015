#include "cli/commands.hpp"
#include "core/input_error.hpp"
#include "io/atomic_file.hpp"
#include "io/case_keys.hpp"
#include "io/case_templates.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace vesica {

namespace {

struct NewArguments {
    std::string name;
    std::optional<std::string> file;
    bool list = false;
};

const CaseTemplate& template_named(const std::string& name) {
    const auto templates = case_templates();
    if (name.empty())
        return templates.front();
    std::vector<std::string> names;
    for (const CaseTemplate& one : templates) {
        if (one.name == name)
            return one;
        names.emplace_back(one.name);
    }
    throw InputError(fmt::format("{} is not a template; expected one of {}; try `vesica new {}`", name,
                                 fmt::join(names, ", "), nearest_word(name, names)));
}

void list_templates() {
    std::size_t width = 0;
    for (const CaseTemplate& one : case_templates())
        width = std::max(width, one.name.size());
    for (const CaseTemplate& one : case_templates())
        std::cout << fmt::format("{:<{}}  {}\n", one.name, width, one.description);
    std::cout << std::flush;
}

/// A case somebody has worked on is not replaced.
int write_template(const NewArguments& arguments) {
    if (arguments.list) {
        list_templates();
        return 0;
    }
    const CaseTemplate& chosen = template_named(arguments.name);
    if (arguments.file && arguments.file->empty())
        throw InputError("-o is empty; expected a new file; try -o case.toml");
    if (arguments.file == "-") {
        std::cout << chosen.text << std::flush;
        return 0;
    }
    const std::string file = arguments.file.value_or(std::string(chosen.name) + ".toml");
    std::error_code unknown;
    if (std::filesystem::exists(file, unknown))
        throw InputError(file + " exists already; expected a new file; try another with -o FILE");
    try {
        write_atomically(file, chosen.text);
    } catch (const RunError& failure) {
        throw InputError(std::string(failure.what()) + "; try another place with -o FILE");
    }
    std::cout << file << ": " << chosen.description << "; next: vesica check " << file << std::endl;
    return 0;
}

} // namespace

void declare_new(CLI::App& app, Action& action) {
    CLI::App* const command = app.add_subcommand("new", "Write a commented starter case");
    const auto arguments = std::make_shared<NewArguments>();
    command->add_option("template", arguments->name, "Which one; see --list")->type_name("TEMPLATE");
    command
        ->add_option("-o,--output", arguments->file,
                     "Where to write, - for the terminal; by default TEMPLATE.toml")
        ->type_name("FILE");
    command->add_flag("--list", arguments->list, "List the templates");
    command->callback([&action, arguments] {
        action = [arguments] {
            return write_template(*arguments);
        };
    });
}

} // namespace vesica
