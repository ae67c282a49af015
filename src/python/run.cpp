#include "simulation/run.hpp"

#include "python/bindings.hpp"
#include "python/launcher.hpp"
#include "python/without_gil.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace py = pybind11;

namespace vesica {

namespace {

py::dict told(const RunOutcome& outcome) {
    py::dict result;
    result["status"] = static_cast<int>(outcome.status);
    result["step"] = outcome.step;
    result["steady"] = outcome.end == RunEnd::steady;
    result["message"] = outcome.message;
    return result;
}

RunOptions options_for(const std::filesystem::path& directory, int threads, bool progress, Crew* crew) {
    RunOptions options;
    options.crew = crew;
    options.directory = directory;
    options.threads = threads;
    if (progress) {
        options.out = &std::cout;
        options.terminal = options.crew == nullptr && isatty(STDOUT_FILENO) == 1;
    }
    return options;
}

} // namespace

void bind_run(py::module_& module) {
    module.def(
        "run_case",
        [](Case what, const std::filesystem::path& directory, std::optional<std::int64_t> steps, int threads,
           bool overwrite, bool progress, bool accept_soft_membranes) {
            if (steps)
                what.run.steps = *steps;
            const std::shared_ptr<Crew> crew = crew_of_launcher();
            RunOptions options = options_for(directory, threads, progress, crew.get());
            options.overwrite = overwrite;
            options.plan.accept_soft_membranes = accept_soft_membranes;
            return told(without_gil([&] { return run_case(what, options); }));
        },
        py::arg("case"), py::arg("directory"), py::arg("steps"), py::arg("threads"), py::arg("overwrite"),
        py::arg("progress"), py::arg("accept_soft_membranes"),
        "`vesica run`: status (that of the program), step, steady, message.");
    module.def(
        "resume_run",
        [](const std::filesystem::path& directory, std::optional<std::int64_t> steps, int threads,
           bool progress) {
            const std::shared_ptr<Crew> crew = crew_of_launcher();
            const RunOptions options = options_for(directory, threads, progress, crew.get());
            return told(without_gil([&] { return resume_run(steps, options); }));
        },
        py::arg("directory"), py::arg("steps"), py::arg("threads"), py::arg("progress"),
        "`vesica resume`: the same.");
    module.def("leave_crew", &leave_crew, "Lets the other ranks go, before MPI ends.");
}

} // namespace vesica
