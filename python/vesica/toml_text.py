"""Python values as TOML, and the path of a key to its value."""

import json
import math
import re
from collections.abc import Mapping
from pathlib import PurePath

from vesica.errors import InputError


def toml_text(value: object, path: str = "the value") -> str:
    """The value as it would stand in a case file. Numbers, text, lists, tuples, numpy's arrays and numbers, mappings."""
    if hasattr(value, "tolist"):  # numpy's arrays and numbers
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)  # TOML knows inf and nan
    if isinstance(value, (str, PurePath)):
        return json.dumps(str(value), ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {toml_text(v, path)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml_text(item, path) for item in value) + "]"
    raise InputError(f"{path} is {value!r}; expected a number, text, a list or a table; try one that TOML knows")


def look_up(table: Mapping, path: str) -> object:
    """The value at `path`, such as ``vesicle[0].radius``, in nested tables and lists. KeyError."""
    found: object = table
    for word in re.findall(r"[^.\[\]]+|\[\d+\]", path):
        try:
            found = found[int(word[1:-1])] if word.startswith("[") else found[word]  # type: ignore[index]
        except (KeyError, IndexError, TypeError):
            known = f"; beside it there are {', '.join(found)}" if isinstance(found, Mapping) else ""
            raise KeyError(f"{path} is not in this case{known}") from None
    return found


def _key(key: object) -> str:
    return str(key) if re.fullmatch(r"[A-Za-z0-9_-]+", str(key)) else json.dumps(str(key))
