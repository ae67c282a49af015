"""Starts the program on several ranks of one machine, however many processors it has."""

import os

ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",  # whoever waits lets the others work
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMP_WAIT_POLICY": "passive",
}
NO_LEAKS = {"ASAN_OPTIONS": ":".join([*filter(None, [os.environ.get("ASAN_OPTIONS")]), "detect_leaks=0"])}


def environment():
    # What Open MPI keeps to its end is checked by valgrind, which can tell whose it is (tools/check-valgrind).
    return {**os.environ, **ENVIRONMENT, **NO_LEAKS}


def mpirun(ranks):
    """The words before the program's; none for 0 ranks."""
    return ["mpirun", "-n", str(ranks)] if ranks else []
