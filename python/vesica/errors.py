"""What can go wrong: your input, or the run."""


class InputError(ValueError):
    """The input is wrong. The text is the program's own: ``FILE:LINE:COLUMN: path.key is VALUE; expected ...; try ...``."""


class RunError(RuntimeError):
    """A run failed although its input was right: instability, a full disk, a damaged file."""


class Unavailable(RunError):
    """Something cannot be had from this run, for a reason that is no fault of the run; the text says which."""
