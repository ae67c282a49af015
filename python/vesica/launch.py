"""Runs into a directory, as the program does them."""

from __future__ import annotations

import os
import signal

from vesica.arguments import count_or_none, thread_count
from vesica.case import Case
from vesica.compiled import part
from vesica.directory import Run
from vesica.errors import RunError

_FAILED, _STOPPED = 1, 3


def run(case: Case, directory: str | os.PathLike[str], *, steps: int | None = None, threads: int | None = None,
        overwrite: bool = False, progress: bool = False, accept_soft_membranes: bool = False) -> Run:
    """``vesica run``: leaves metrics, fields, surfaces and checkpoints in the directory, and returns it as a Run.

    steps: instead of the case's. overwrite: replaces what an earlier run left there. progress: the program's own line on standard output.
    Ctrl-C writes a checkpoint and raises KeyboardInterrupt. InputError if the case cannot serve, RunError if the run
    fails; what was written before stays."""
    outcome = part.run_case(case._found, os.fspath(directory), count_or_none("steps", steps, 1), thread_count(threads),
                            overwrite, progress, accept_soft_membranes)
    return _finished(outcome, directory)


def resume(directory: str | os.PathLike[str], *, steps: int | None = None, threads: int | None = None,
           progress: bool = False) -> Run:
    """``vesica resume``: continues the run in a directory from its newest intact checkpoint, up to ``steps`` in total."""
    outcome = part.resume_run(os.fspath(directory), count_or_none("steps", steps, 1), thread_count(threads), progress)
    return _finished(outcome, directory)


def _finished(outcome: dict, directory: str | os.PathLike[str]) -> Run:
    if outcome["status"] == _STOPPED and signal.Signals.SIGINT.name in outcome["message"]:
        raise KeyboardInterrupt(outcome["message"])
    if outcome["status"] in (_FAILED, _STOPPED):
        raise RunError(outcome["message"])
    return Run(directory)
