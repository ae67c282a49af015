#include "python/launcher.hpp"

#include "core/input_error.hpp"
#include "parallel/ranks.hpp"
#include "python/without_gil.hpp"
#include "simulation/crew.hpp"
#include "simulation/stop.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace py = pybind11;

namespace vesica {

namespace {

/// MPI and the ranks, for as long as the interpreter lives.
struct Launched {
    MpiSession session;
    std::unique_ptr<Crew> crew;
    std::weak_ptr<int> lease; ///< alive while somebody holds the crew
};

std::unique_ptr<Launched>& launched() {
    static std::unique_ptr<Launched> one;
    return one;
}

[[noreturn]] void serve(const Ranks& ranks) {
    const int status = without_gil([&] {
        const StopSignals ignored; // the rank that leads heeds them
        return follow_orders(ranks);
    });
    PyErr_SetObject(PyExc_SystemExit, py::int_(status).ptr());
    throw py::error_already_set();
}

} // namespace

std::shared_ptr<Crew> crew_of_launcher() {
    if (MpiSession::promised() == 1)
        return nullptr;
    if (!launched()) {
        launched() = std::make_unique<Launched>();
        const Ranks ranks = Ranks::all();
        if (ranks.count() == 1)
            throw InputError(fmt::format(
                "this is one of {} processes that a launcher has started, but they do not find each other; "
                "expected the launcher of the MPI library that vesica is built with; try its mpirun, or "
                "ranks = 1, with which each works alone",
                MpiSession::promised()));
        if (!ranks.leads())
            serve(ranks);
        launched()->crew = std::make_unique<Crew>(ranks);
    }
    if (!launched()->crew)
        throw RunError("the other ranks have been let go; expected a call before the interpreter's end");
    if (launched()->lease.lock())
        throw RunError(
            "the ranks carry out one simulation at a time, and have one already; expected that to be "
            "gone; try `del` on it first, or ranks = 1, with which each process works alone");
    const auto lease = std::make_shared<int>(0);
    launched()->lease = lease;
    return {lease, launched()->crew.get()};
}

void leave_crew() {
    if (!launched())
        return;
    if (launched()->crew)
        launched()->crew->dismiss(0);
    launched().reset();
}

} // namespace vesica
