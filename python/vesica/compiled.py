"""The compiled part of the package, or words on how to come by it."""

import atexit

try:
    from vesica import _vesica as part
except ImportError as problem:
    raise ImportError(
        f"the compiled part of vesica cannot be loaded ({problem}); try `make python` in the sources, then "
        "`source build/python-venv/bin/activate`"
    ) from problem

atexit.register(part.leave_crew)  # before mpi4py ends MPI
