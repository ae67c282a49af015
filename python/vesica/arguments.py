"""What callers give, as the compiled part wants it."""

from __future__ import annotations

import numpy

from vesica.errors import InputError


def count(name: str, value: int, lowest: int) -> int:
    """The value, if it is a whole number that is large enough; else InputError."""
    if isinstance(value, bool) or not isinstance(value, (int, numpy.integer)) or value < lowest:
        raise InputError(f"{name} is {value!r}; expected a whole number of at least {lowest}")
    return int(value)


def count_or_none(name: str, value: int | None, lowest: int) -> int | None:
    """The same, or None."""
    return None if value is None else count(name, value, lowest)


def thread_count(threads: int | None) -> int:
    """0 for the default."""
    return 0 if threads is None else count("threads", threads, 1)
