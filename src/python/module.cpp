#include "core/version.hpp"
#include "measure/metrics.hpp"
#include "python/bindings.hpp"
#include "simulation/engine.hpp"
#include "simulation/plan_cost.hpp"

#include <pybind11/stl.h>

#include <string>

PYBIND11_MODULE(_vesica, module) {
    module.doc() = "What the package vesica is built on. Use the package.";
    vesica::bind_errors(module);
    vesica::bind_case(module);
    vesica::bind_plan(module);
    vesica::bind_run(module);
    vesica::bind_simulation(module);
    module.attr("version") = std::string(vesica::version);
    module.attr("commit") = std::string(vesica::commit);
    module.def("metrics_columns", &vesica::metrics_columns, "The columns of metrics.csv, in order.");
    module.def("field_names", &vesica::field_names, "The fields that Simulation.field knows.");
    module.def(
        "default_threads", [] { return vesica::default_threads(); },
        "The threads a run takes if nobody says otherwise.");
}
