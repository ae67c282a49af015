"""Runs of the program `vesica` that a validation needs: each in its own directory, done once, resumed if cut short."""

import json
import os
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy

from vesica.plotting.run_directory import RunDirectory
from vesica.plotting.surface import read_surface


@dataclass(frozen=True)
class Simulation:
    """One run: a case file, what is changed in it (key path -> TOML value as Python number, string, list), and where
    it goes. `options` are further ones of `vesica run`."""

    name: str
    case: Path
    settings: dict = field(default_factory=dict)
    options: tuple = ()

    def arguments(self):
        changes = []
        for key, value in self.settings.items():
            changes += ["--set", f"{key}={json.dumps(value)}"]
        return [str(self.case), *changes, *self.options]

    def stamp(self):
        """What must not have changed if an earlier result is to stand for this run."""
        options = {"options": list(self.options)} if self.options else {}
        return {"case": tomllib.loads(Path(self.case).read_text("utf-8")), "settings": self.settings, **options}


class Finished:
    """A run that has ended; its numbers are read when asked for."""

    def __init__(self, directory, seconds, failure, versions=()):
        self.directory = Path(directory)
        self.seconds = seconds  # of one core's time, over all its parts
        self.failure = failure  # None, or the program's last words
        self.versions = list(versions)  # of the program, over all its parts; empty: not noted then

    @cached_property
    def run(self):
        return RunDirectory(self.directory)

    @cached_property
    def metrics(self):
        """Column -> array over the samples of vesicle 0."""
        return self.run.metrics(0)

    def last(self, column):
        return float(self.metrics[column][-1])

    def at(self, step, column):
        """The sample at this step exactly."""
        rows = numpy.flatnonzero(self.metrics["step"] == step)
        if len(rows) != 1:
            raise KeyError(f"{self.directory}: no sample at step {step}")
        return float(self.metrics[column][rows[0]])

    def surface(self):
        path, _ = self.run.last_surface()
        return read_surface(path, 0).in_cells(self.run.cell_length())

    def steps(self):
        return int(self.metrics["step"][-1])


def run_all(simulations, folder, program, processes, threads=1):
    """Runs what is not done yet, `processes` at a time with as many threads each, the first in the list first.
    Returns name -> Finished."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = [s.name for s in simulations]
    if len(set(names)) != len(names):
        raise ValueError(f"two runs of one name among {names}")
    with ThreadPoolExecutor(max_workers=max(1, processes)) as pool:
        finished = list(pool.map(lambda s: run_one(s, folder, program, threads), simulations))
    return dict(zip(names, finished))


def run_one(simulation, folder, program, threads=1):
    directory = folder / simulation.name
    stamp_file = folder / f"{simulation.name}.stamp.json"
    stamp = simulation.stamp()
    earlier = json.loads(stamp_file.read_text("utf-8")) if stamp_file.is_file() else {}
    same = earlier.get("stamp") == stamp
    if same and earlier.get("ended") and is_result(earlier["failure"]) and (directory / "metrics.csv").is_file():
        return Finished(directory, earlier["seconds"], earlier["failure"], earlier.get("versions", ()))

    spent, versions = 0.0, []
    if same and any((directory / "checkpoints").glob("*.h5")):
        spent, versions = earlier.get("seconds", 0.0), earlier.get("versions", [])
        command = [program, "resume", str(directory), "--threads", str(threads)]
    else:
        command = [program, "run", *simulation.arguments(), "-o", str(directory), "--overwrite", "--threads", str(threads)]
    versions = list(dict.fromkeys([*versions, version_of(program)]))
    kept = {"stamp": stamp, "versions": versions}
    _write(stamp_file, {**kept, "ended": False, "seconds": spent})
    print(f"   {simulation.name}: starts", flush=True)
    status, _, words, seconds = run_timed(command)
    seconds += spent
    if status not in (0, 1):  # wrong input, stopped or killed from outside: no result
        print(words, file=sys.stderr)
        raise SystemExit(f"{simulation.name}: vesica ended with status {status}")
    failure = None if status == 0 else (words.strip().splitlines() or ["no reason given"])[-1]
    _write(stamp_file, {**kept, "ended": is_result(failure), "seconds": seconds, "failure": failure})
    print(f"   {simulation.name}: {seconds:.0f} s{'' if failure is None else ': ' + failure}", flush=True)
    return Finished(directory, seconds, failure, versions)


def is_result(failure):
    """Whether the end is one that the case has: a run that went wrong by its own physics goes wrong so again, while one
    that lacked a disk's or a machine's room is to be done again."""
    return failure is None or "the run failed at step " in failure


def version_of(program):
    """For information: a stamp is not compared by it, or every commit would throw hours of runs away."""
    done = subprocess.run([program, "--version"], capture_output=True, text=True, check=False)
    return (done.stdout.strip().splitlines() or ["unknown"])[0]


def run_timed(command, **environment):
    """Runs a command on one thread. Returns its status (negative: the signal that ended it), what it wrote to its
    output and to its error stream, and the processor time it took in seconds: unlike wall time it counts no pauses."""
    everything = dict(os.environ, OMP_NUM_THREADS="1", **environment)
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(command, stdout=output, stderr=errors, env=everything)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        errors.seek(0)
        return process.returncode, output.read(), errors.read(), usage.ru_utime + usage.ru_stime


def _write(path, content):
    temporary = path.with_suffix(".tmp")
    temporary.write_text(json.dumps(content, indent=1), encoding="utf-8")
    temporary.replace(path)
