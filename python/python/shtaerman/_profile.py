"""Bases that are no text: points, and callables that are sampled once."""

from __future__ import annotations

import numbers
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

#: Coefficients below this share of the largest height count as none: some tens of roundings of a height.
_RESOLVED = 1e-14
#: Chebyshev degrees of the first and the last attempt on a piece. A smooth base takes some tens; what takes more than thousands has a kink.
_FIRST, _LAST = 16, 8192


class Profile:
    """The base of a punch from a callable, with the places where it has kinks or jumps.

    Parameters
    ----------
    height:
        A function of an array of places ``x`` (metres; half-widths in a dimensionless problem) that gives the array of heights there, positive away
        from the body. It is called with arrays of places between the edges, some thousands at most, before the problem is solved and never again.
    breaks:
        Where it has kinks or jumps. Between them it must be smooth: it is replaced by a Chebyshev series that agrees with it to
        1e-14 of its largest height, and refused where there is none.

    A callable that is smooth needs no ``Profile``: ``st.Punch(half_width=5e-3, profile=lambda x: x**2 / 40)`` is enough. No audit bounds
    the errors of an answer then, as nothing is known of the base between the samples; an expression in text is proved to be what it is.

    Examples
    --------
    >>> import shtaerman as st
    >>> wedge = st.Profile(lambda x: 1e-3 * abs(x), breaks=[0.0])
    >>> contact = st.solve(young_modulus=200e9, poisson_ratio=0.3, roughness=1.2e-14, half_width=5e-3, profile=wedge, force=4e5)
    >>> contact.peak_pressure_at
    0.0
    """

    __slots__ = ("_breaks", "_height")

    def __init__(self, height: Callable[[FloatArray], npt.ArrayLike], breaks: Sequence[float] = ()) -> None:
        if not callable(height):
            raise ValueError(f"profile: must be a function of an array of places, got {type(height).__name__}")
        self._height = height
        self._breaks = _floats("profile: breaks", breaks)
        if self._breaks.ndim != 1 or not np.isfinite(self._breaks).all():
            raise ValueError("profile: breaks must be a list of finite places")

    @property
    def height(self) -> Callable[[FloatArray], npt.ArrayLike]:
        """The callable."""
        return self._height

    @property
    def breaks(self) -> FloatArray:
        """Where it has kinks or jumps."""
        return self._breaks.copy()

    def pieces(self, half_width: float) -> list[tuple[float, float, FloatArray]]:
        """Left end, right end and Chebyshev coefficients of the pieces between the breaks, from left to right.

        Raises
        ------
        ValueError
            Where the callable gives something else than finite heights, or is not resolved.
        """
        inside = np.unique(self._breaks[np.abs(self._breaks) < half_width])
        ends = np.concatenate(([-half_width], inside, [half_width]))
        return [(left, right, self._series(left, right)) for left, right in zip(ends[:-1].tolist(), ends[1:].tolist())]

    def _series(self, left: float, right: float) -> FloatArray:
        degree = _FIRST
        while True:
            # Points inside only: at a jump the ends belong to both sides.
            angles = np.pi * (np.arange(degree) + 0.5) / degree
            y = np.cos(angles)
            x = np.where(y < 0.0, left + 0.5 * (1.0 + y) * (right - left), right - 0.5 * (1.0 - y) * (right - left))
            heights = self._heights(x)
            coefficients = _chebyshev(heights)
            size = float(np.abs(heights).max())
            rest = float(np.abs(coefficients[3 * degree // 4 :]).max())
            if rest <= _RESOLVED * size:
                return _shortened(coefficients, size)
            if degree >= _LAST:
                _not_resolved(left, right, degree, rest / size)
            degree *= 2

    def _heights(self, x: FloatArray) -> FloatArray:
        found = self._height(x.copy())
        heights = _floats("profile: what the callable gives", found)
        if heights.shape == ():
            heights = np.full(x.shape, float(heights))
        if heights.shape != x.shape:
            raise ValueError(
                f"profile: the callable gives an array of shape {heights.shape} for places of shape {x.shape}: must be one height for each place"
            )
        faulty = np.flatnonzero(~np.isfinite(heights))
        if faulty.size:
            at = int(faulty[0])
            raise ValueError(f"profile: the callable gives {heights[at]} at x = {x[at]}: must be finite on the whole punch")
        return heights


def _not_resolved(left: float, right: float, degree: int, rest: float) -> NoReturn:
    raise ValueError(
        f"profile: the callable is not smooth between x = {left} and {right}: {degree} samples leave {rest:.1e} of its size, where {_RESOLVED:.0e} is wanted; "
        "name its kinks and jumps, Profile(f, breaks=[..]), write differences of nearly equal numbers in another form, or give points (x, f)"
    )


def _chebyshev(heights: FloatArray) -> FloatArray:
    """Coefficients of the polynomial through heights at the roots of a Chebyshev polynomial, from right to left."""
    count = heights.size
    # By a power of two, which is exact: sums of the largest numbers must not overflow.
    scale = int(np.frexp(np.abs(heights).max())[1])
    doubled = np.ldexp(np.concatenate([heights, heights[::-1]]), -scale)
    phases = np.exp(-0.5j * np.pi * np.arange(count) / count)
    coefficients: FloatArray = np.real(np.fft.fft(doubled)[:count] * phases) / count
    coefficients[0] *= 0.5
    return np.ldexp(coefficients, scale)


def _shortened(coefficients: FloatArray, size: float) -> FloatArray:
    """Without what is rounding of the last coefficients."""
    kept = np.flatnonzero(np.abs(coefficients) > 1e-17 * size)
    last = int(kept[-1]) + 1 if kept.size else 1
    return np.ascontiguousarray(coefficients[:last])


def points(x: Any, f: Any) -> tuple[FloatArray, FloatArray]:
    """Positions and heights of a trace, checked for what only arrays can have wrong."""
    positions, heights = _floats("profile: x", x), _floats("profile: f", f)
    if positions.ndim != 1 or heights.ndim != 1:
        raise ValueError(f"profile: x and f must be lists of numbers, got shapes {positions.shape} and {heights.shape}")
    if positions.size != heights.size:
        raise ValueError(f"profile: must have one height for each place, got {positions.size} places and {heights.size} heights")
    if positions.size < 2:
        raise ValueError(f"profile: needs at least two points, got {positions.size}")
    for name, values in (("x", positions), ("f", heights)):
        faulty = np.flatnonzero(~np.isfinite(values))
        if faulty.size:
            at = int(faulty[0])
            raise ValueError(f"profile: {name}[{at}] is {values[at]}: must be finite at every point")
    if np.all(np.diff(positions) < 0.0):
        # From right to left, as files may be.
        positions, heights = positions[::-1], heights[::-1]
    back = np.flatnonzero(np.diff(positions) <= 0.0)
    if back.size:
        at = int(back[0]) + 1
        raise ValueError(f"profile: x[{at}] = {positions[at]} after {positions[at - 1]}: places must increase, or decrease all along")
    return positions.copy(), heights.copy()


def _floats(what: str, values: Any) -> FloatArray:
    """An array of real numbers; text and complex numbers are none, nor are values that are masked."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{what}: must be an array of numbers, got rows of different lengths") from None
    if np.ma.is_masked(values):
        raise ValueError(f"{what}: has masked values: leave them out, x.compressed(), or fill them")
    array = as_numbers(array)
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{what}: must be an array of real numbers, got {_kind(values, array)}")
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def as_numbers(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Numbers that are Python objects, as tables with mixed columns have them, as floats; any other array as it is."""
    if array.dtype.kind != "O" or not array.size:
        return array
    if not all(isinstance(value, numbers.Real) and not isinstance(value, bool) for value in array.flat):
        return array
    try:
        return array.astype(np.float64)
    except OverflowError:
        return array


def _kind(values: Any, array: npt.NDArray[Any]) -> str:
    if array.dtype.kind == "O" and array.ndim and array.size:
        odd = [value for value in array.flat if not isinstance(value, numbers.Real) or isinstance(value, bool)]
        return f"{odd[0]!r}" if odd else "integers beyond the range of double precision"
    return f"the type {type(values).__name__}" if array.dtype.kind == "O" else f"the type {array.dtype}"
