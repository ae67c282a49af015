#include "case/case.hpp"

#include "io/case_file.hpp"
#include "python/bindings.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace vesica {

namespace {

py::object scales_of(const Case& what) {
    if (!what.scales)
        return py::none();
    return py::make_tuple(what.scales->cell, what.scales->step, what.scales->density);
}

} // namespace

void bind_case(py::module_& module) {
    py::class_<Case>(module, "Case", "A case as it was read, checked and put into lattice units; read-only.")
        .def_static(
            "from_file",
            [](const std::filesystem::path& file, const std::vector<std::string>& overrides) {
                return read_case(file, overrides);
            },
            py::arg("file"), py::arg("overrides"), "Reads a case file and applies overrides `path=value`.")
        .def_static(
            "from_text",
            [](std::string text, std::string name, const std::vector<std::string>& overrides) {
                return read_case_text(std::move(text), std::move(name), overrides);
            },
            py::arg("text"), py::arg("name"), py::arg("overrides"),
            "The same for a text that stands for the file `name`.")
        .def_readonly("title", &Case::title)
        .def_readonly("source_file", &Case::source_file)
        .def_readonly("source_text", &Case::source_text)
        .def_readonly("overrides", &Case::overrides)
        .def_property_readonly("resolved", &resolved_toml,
                               "The case with every default filled in, as TOML in lattice units.")
        .def_property_readonly("scales", &scales_of, "(cell in m, step in s, density in kg/m^3), or None.")
        .def_property_readonly("steps", [](const Case& what) { return what.run.steps; })
        .def_property_readonly("metrics_every", [](const Case& what) { return what.output.metrics_every; })
        .def_property_readonly("stops_when_steady",
                               [](const Case& what) { return what.run.stop_when_steady.has_value(); });
}

} // namespace vesica
