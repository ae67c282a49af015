#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/launcher.hpp"
#include "python/without_gil.hpp"
#include "simulation/live_run.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace py = pybind11;

namespace vesica {

namespace {

/// How long Ctrl-C may wait, unless a single step takes longer.
constexpr std::chrono::milliseconds between_looks{20};

/// Holds a simulation for one call.
class Turn {
public:
    explicit Turn(std::atomic_flag& busy) : busy_(busy) {
        if (busy_.test_and_set())
            throw RunError("the simulation is at work in another thread, or was interrupted by a signal's "
                           "handler; expected one call at a time; try again when that is done");
    }
    ~Turn() { busy_.clear(); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    std::atomic_flag& busy_;
};

/// A run at Python's pace. It is in one place at a time: a call that comes while another thread's is under
/// way, or out of a signal's handler, is refused.
class PythonSimulation {
    template <class Body>
    auto alone_with(const Body& body) {
        const Turn turn(busy_);
        return without_gil(body);
    }

public:
    PythonSimulation(const Case& what, int threads, bool alone, bool accept_soft_membranes)
        : crew_(alone ? nullptr : crew_of_launcher()), run_(without_gil([&] {
              return LiveRun::begin(what, options(threads), PlanOptions{accept_soft_membranes});
          })) {}

    PythonSimulation(const std::filesystem::path& from, int threads, bool alone)
        : crew_(alone ? nullptr : crew_of_launcher()),
          run_(without_gil([&] { return LiveRun::resume(from, options(threads)); })) {}

    /// Does at most so many steps; Ctrl-C and other signals are heeded between two of them.
    void advance(std::int64_t steps) {
        const Turn turn(busy_);
        const py::gil_scoped_release released;
        auto looked = std::chrono::steady_clock::now();
        for (std::int64_t step = 0; step < steps; ++step) {
            run_->advance();
            const auto now = std::chrono::steady_clock::now();
            if (now - looked < between_looks)
                continue;
            looked = now;
            const py::gil_scoped_acquire acquired;
            if (PyErr_CheckSignals() != 0)
                throw py::error_already_set();
        }
    }

    py::list sample() {
        py::list rows;
        for (const MetricsRow& row : alone_with([&] { return run_->sample(); }))
            rows.append(py::tuple(py::cast(metrics_values(row))));
        return rows;
    }

    py::array_t<double> field(const std::string& name) {
        return handed_over(alone_with([&] { return run_->engine().field(name); }));
    }

    py::array_t<double>
    velocities(const py::array_t<double, py::array::c_style | py::array::forcecast>& places) {
        if (places.ndim() != 2 || places.shape(1) != 3)
            throw InputError("points are not of shape (n, 3); expected x, y and z of each, in cells");
        const auto at = places.unchecked<2>();
        std::vector<Vec3<double>> points;
        for (py::ssize_t k = 0; k < at.shape(0); ++k) {
            points.push_back({at(k, 0), at(k, 1), at(k, 2)});
            if (!std::isfinite(at(k, 0)) || !std::isfinite(at(k, 1)) || !std::isfinite(at(k, 2)))
                throw InputError(fmt::format("points[{}] is not finite; expected cells", k));
        }
        return handed_over_rows<double, 3>(alone_with([&] { return run_->engine().velocities(points); }));
    }

    /// (points, triangles, {name: values on the points})
    py::tuple surface(int vesicle) {
        SurfaceArrays arrays = alone_with([&] { return run_->surface(vesicle); });
        const auto points = static_cast<py::ssize_t>(arrays.points.size());
        py::dict quantities;
        for (SurfaceQuantity& quantity : arrays.quantities) {
            std::vector<py::ssize_t> shape = {points};
            if (quantity.components > 1)
                shape.push_back(quantity.components);
            quantities[py::str(quantity.name)] = handed_over(std::move(quantity.values), std::move(shape));
        }
        return py::make_tuple(handed_over_rows<double, 3>(std::move(arrays.points)),
                              handed_over_rows<std::int32_t, 3>(std::move(arrays.triangles)), quantities);
    }

    void save(const std::filesystem::path& path) {
        alone_with([&] {
            run_->save(path);
            return 0;
        });
    }

    bool is_steady() {
        return alone_with([&] { return run_->is_steady(); });
    }
    auto bytes() {
        return alone_with([&] { return run_->engine().bytes_allocated(); });
    }

    const LiveRun& run() const { return *run_; }
    int ranks() const { return crew_ ? crew_->ranks().count() : 1; }

private:
    EngineOptions options(int threads) const {
        EngineOptions options;
        options.threads = threads;
        options.crew = crew_.get();
        return options;
    }

    std::atomic_flag busy_ = ATOMIC_FLAG_INIT;
    std::shared_ptr<Crew> crew_;
    std::unique_ptr<LiveRun> run_;
};

} // namespace

void bind_simulation(py::module_& module) {
    using Self = PythonSimulation;
    py::class_<Self>(module, "Simulation", "A run in memory.")
        .def(py::init<const Case&, int, bool, bool>(), py::arg("case"), py::arg("threads"), py::arg("alone"),
             py::arg("accept_soft_membranes"))
        .def_static(
            "resume",
            [](const std::filesystem::path& from, int threads, bool alone) {
                return std::make_unique<Self>(from, threads, alone);
            },
            py::arg("path"), py::arg("threads"), py::arg("alone"))
        .def("advance", &Self::advance, py::arg("steps"), "Does so many steps; heeds signals between them.")
        .def("sample", &Self::sample, "A tuple of metrics per vesicle, in the order of metrics_columns().")
        .def("field", &Self::field, py::arg("name"), "(nz, ny, nx[, 3]) in lattice units.")
        .def("velocities", &Self::velocities, py::arg("points"), "(n, 3) at points (n, 3).")
        .def("surface", &Self::surface, py::arg("vesicle"), "(points, triangles, quantities by name)")
        .def("save", &Self::save, py::arg("path"), "Writes a checkpoint.")
        .def_property_readonly("case", [](const Self& self) { return self.run().what(); })
        .def_property_readonly("step", [](const Self& self) { return self.run().step(); })
        .def_property_readonly("is_steady", &Self::is_steady)
        .def_property_readonly("threads", [](const Self& self) { return self.run().threads(); })
        .def_property_readonly("ranks", &Self::ranks)
        .def_property_readonly("bytes", &Self::bytes)
        .def_property_readonly("instruction_set", [](const Self& self) {
            return std::string(self.run().engine().instruction_set());
        });
}

} // namespace vesica
