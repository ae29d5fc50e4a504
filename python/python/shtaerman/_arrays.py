"""Functions of arrays of any shape."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import numpy as np

from ._profile import FloatArray, _floats


def places(values: Any, name: str = "x") -> FloatArray:
    """Places as an array of floats."""
    return _floats(name, values)


def finite(values: Any, name: str = "x") -> FloatArray:
    """Places that are none of them NaN or infinite."""
    array = places(values, name)
    faulty = np.flatnonzero(~np.isfinite(array))
    if faulty.size:
        at = int(faulty[0])
        where = "" if array.ndim == 0 else f"[{', '.join(str(i) for i in np.unravel_index(at, array.shape))}]"
        raise ValueError(f"{name}{where}: is {array.flat[at]}: must be finite")
    return array


#: Places of a curve, at most.
_MOST_POINTS = 1_000_000


def counted(points: Any, name: str = "points") -> int:
    """How many places a curve has."""
    is_whole = isinstance(points, (int, np.integer)) and not isinstance(points, bool)
    if not is_whole or not 2 <= points <= _MOST_POINTS:
        raise ValueError(f"{name}: must be a whole number from 2 to {_MOST_POINTS}, got {points!r}")
    return int(points)


def each(function: Callable[[FloatArray], FloatArray], x: Any, name: str = "x") -> Any:
    """What a function of a list of places gives for an array of any shape; a float for a single place."""
    array = places(x, name)
    found = function(array.ravel()).reshape(array.shape)
    return float(found) if array.ndim == 0 and not isinstance(x, np.ndarray) else found


def processors() -> int:
    """How many processors this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1
