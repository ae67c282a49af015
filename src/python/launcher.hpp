#pragma once

#include <memory>

namespace vesica {

class Crew;

/// The ranks that a launcher (mpirun, srun) has started; null without one. They work on one thing at a time:
/// RunError while an earlier caller still holds what it was given. The first call parts them: on the first
/// rank it returns, on the others it serves the first until that lets them go, and then raises SystemExit.
/// MPI is begun unless mpi4py has done so. Throws InputError where the processes do not find each other. Call
/// it with the interpreter's lock.
std::shared_ptr<Crew> crew_of_launcher();

/// Lets the other ranks go. Afterwards this process is alone.
void leave_crew();

} // namespace vesica
