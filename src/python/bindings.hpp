#pragma once

#include <pybind11/pybind11.h>

namespace vesica {

/// Each binds one thing into the module `vesica._vesica`.
void bind_errors(const pybind11::module_& module);
void bind_case(pybind11::module_& module);
void bind_plan(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);

} // namespace vesica
