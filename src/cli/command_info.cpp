#include "cli/commands.hpp"
#include "io/describe_file.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace vesica {

void declare_info(CLI::App& app, Action& action) {
    CLI::App* const command = app.add_subcommand("info", "Say what a checkpoint or output file holds");
    const auto file = std::make_shared<std::string>();
    command->add_option("file", *file, "The file")->type_name("FILE")->required();
    command->callback([&action, file] {
        action = [file] {
            FileDescription found = describe_file(*file);
            if (!found.text.ends_with('\n'))
                found.text += '\n';
            std::cout << found.text << std::flush;
            if (found.intact)
                return 0;
            std::cerr << "vesica: " << *file << " is not intact: the lines above say why\n";
            return 1;
        };
    });
}

} // namespace vesica
