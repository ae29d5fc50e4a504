"""Problem files from dictionaries and keywords.

What a user states becomes the text of a problem file, so that all of it is read, checked and solved as the command line does.
"""

from __future__ import annotations

import difflib
import json
import numbers
import os
import re
from collections.abc import Mapping
from typing import Any

import numpy as np

FOUNDATION = (
    "young_modulus",
    "poisson_ratio",
    "roughness",
    "subgrade_modulus",
    "yield_stress",
    "grading_exponent",
    "grading_modulus",
    "thickness",
    "base",
    "coating",
)
PUNCH = (
    "half_width",
    "profile",
    "geometry",
    "outer_half_width",
    "inner_half_gap",
    "period",
    "radius",
)
LOAD = ("force", "settlement", "moment", "eccentricity", "tilt")
SOLVER = ("contact", "method", "n", "tolerance", "time_limit")
#: What only a dimensionless problem has.
BARE = ("theta0", "lambda0", "exponent")
VERTICAL = ("force", "settlement")
ROTATIONAL = ("moment", "eccentricity", "tilt")

#: Whole numbers of TOML have 64 bits; larger ones of Python are written as floats.
_BEYOND_INTEGERS = 2**63

_TABLES = {"foundation": FOUNDATION, "punch": PUNCH, "load": LOAD, "solver": SOLVER}
_KEYWORDS = (*FOUNDATION, *PUNCH, *LOAD, *SOLVER, *BARE, "body")


def table_of(keyword: str, is_dimensionless: bool, function: str) -> str:
    """The table of a problem file that a keyword belongs to; empty for the tables themselves."""
    if keyword == "body":
        return ""
    for table, keys in _TABLES.items():
        if keyword in keys:
            return "dimensionless" if is_dimensionless and table != "solver" else table
    if keyword in BARE:
        return "dimensionless"
    near = difflib.get_close_matches(keyword, _KEYWORDS, 1)
    hint = f": did you mean {near[0]!r}?" if near else f": it takes {', '.join(_KEYWORDS)}"
    raise TypeError(f"{function}() got an unexpected keyword argument {keyword!r}{hint}")


def nested(keywords: Mapping[str, Any], function: str) -> dict[str, Any]:
    """Keywords as the tables of a problem file; a base that is not given is flat, and a load without moment, eccentricity or tilt is central."""
    given = {name: value for name, value in keywords.items() if value is not None}
    is_dimensionless = any(name in given for name in BARE)
    tables: dict[str, Any] = {}
    for name, value in given.items():
        table = table_of(name, is_dimensionless, function)
        home = tables.setdefault(table, {}) if table else tables
        home[name] = value
    punch = tables.setdefault("dimensionless" if is_dimensionless else "punch", {})
    load = tables.setdefault("dimensionless" if is_dimensionless else "load", {})
    punch.setdefault("profile", 0)
    if not any(name in load for name in ROTATIONAL):
        load["moment"] = 0
    return tables


def toml(tables: Mapping[str, Any]) -> str:
    """A dictionary as TOML, tables first level by level.

    Raises
    ------
    ValueError
        For what is no value of a problem file, with its key.
    """
    try:
        return _toml(tables)
    except RecursionError:
        raise ValueError("the tables are nested too deeply, or contain themselves") from None


def _toml(tables: Mapping[str, Any]) -> str:
    lines: list[str] = []
    plain = {name: value for name, value in tables.items() if not isinstance(value, Mapping)}
    lines.extend(f"{key_text(name)} = {toml_value(value, str(name))}" for name, value in plain.items())
    for name, table in tables.items():
        if isinstance(table, Mapping):
            lines.extend(["", f"[{key_text(name)}]"] if lines else [f"[{key_text(name)}]"])
            lines.extend(
                f"{key_text(key)} = {toml_value(value, f'{name}.{key}')}"
                for key, value in table.items()
                if value is not None
            )
    return "\n".join(lines) + "\n"


def toml_value(value: Any, where: str) -> str:
    """One value as TOML; ``where`` is its key, for messages."""
    if type(value) is float:
        # Most values are; the classes below are slow to ask for.
        return repr(value)
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, numbers.Integral) and abs(int(value)) < _BEYOND_INTEGERS:
        return str(int(value))
    if isinstance(value, numbers.Real):
        try:
            return repr(float(value))
        except OverflowError:
            raise ValueError(f"{where}: is beyond the range of double precision") from None
    if isinstance(value, Mapping):
        entries = (
            f"{key_text(name)} = {toml_value(inner, f'{where}.{name}')}"
            for name, inner in value.items()
            if inner is not None
        )
        return "{ " + ", ".join(entries) + " }"
    if isinstance(value, np.ndarray):
        raise ValueError(
            f"{where}: is an array of shape {value.shape}, where one value is wanted; solve_many takes arrays"
        )
    raise ValueError(
        f"{where}: is of type {type(value).__name__}: must be a number in SI units or text such as '5 mm'"
    )


def options(given: Mapping[str, Any], function: str) -> list[str]:
    """Keywords as options of the command line."""
    arguments = []
    for name, value in given.items():
        if value is None:
            continue
        if isinstance(value, (np.generic, np.ndarray)) and np.ndim(value) == 0:
            value = value.item()
        if isinstance(value, bool) or not isinstance(value, (int, float, str, os.PathLike)):
            raise ValueError(f"{function}(): {name} must be a number or text, got {type(value).__name__}")
        text = repr(value) if isinstance(value, (int, float)) else os.fspath(value)
        arguments.append(f"--{name.replace('_', '-')}={text}")
    return arguments


def without_usage(text: str) -> str:
    """What the command line says of its options, without how it is called, which helps nobody in Python."""
    return re.split(r"\n\n(?:Usage:|For more information)", text)[0].rstrip()


_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+").fullmatch


def key_text(name: object) -> str:
    """A key as TOML."""
    if not isinstance(name, str):
        raise ValueError(f"{name!r}: is no key of a problem file, whose keys are text")
    return name if _BARE_KEY(name) else _string(name)


_ESCAPED = json.JSONEncoder(ensure_ascii=False).encode


def _string(text: str) -> str:
    # JSON escapes what TOML does, but for DEL; lone surrogates are no text.
    try:
        text.encode("utf-8")
    except UnicodeEncodeError as error:
        raise ValueError(f"{text!r}: is no text: {error.reason}") from None
    return _ESCAPED(text).replace("\x7f", "\\u007f")
