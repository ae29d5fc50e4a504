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
