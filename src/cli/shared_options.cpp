#include "cli/commands.hpp"
#include "core/input_error.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace vesica {

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

void declare_threads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Threads to use; by default OMP_NUM_THREADS or all processors")
        ->type_name("N")
        ->check(CLI::Range(1, 4096).description(""));
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
