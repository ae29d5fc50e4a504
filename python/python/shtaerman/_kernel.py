"""Kernels of one's own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np

from ._profile import _floats


class Kernel:
    """A symmetric kernel ``K(x, s) = K(s, x)`` from a callable, for equations of the second kind.

    Parameters
    ----------
    function:
        Of a smooth kernel ``K(x, s)``: a function of two floats that gives one finite number. Of a singular one its split, ``split(x, s, distance)``: a function of three floats that gives the
        pair ``(A, B)`` of smooth functions; ``distance`` is ``|x - s|``, with digits that the difference has lost near the ends of the interval, and 0 for ``x = s``.
    interval:
        The ends of the interval of the integral.
    singularity:
        What the kernel does at ``x = s``:

        - ``None``: nothing, it is smooth;
        - ``"logarithm"``: ``K = A ln|x - s| + B``;
        - an exponent ``mu`` between -1 and 1, not 0: ``K = A |x - s|^-mu + B``.
    even:
        Whether reflection about the middle of the interval changes nothing: ``K(2c - x, 2c - s) = K(x, s)``. The work is then less.

    The callable is asked some thousand times before the equation is solved, and some ten thousand to some million times then, once for each pair of nodes; meanwhile the interpreter is not free but for
    what the callable does. What it raises is raised. Before anything is solved it is looked at in some places whether the kernel is symmetric, as even as is said, and tends to its split.

    Raises
    ------
    ValueError
        For what is no interval or no singularity.

    Examples
    --------
    Love's equation, two disks at the distance of their radius:

    >>> import math
    >>> import shtaerman as st
    >>> love = st.Kernel(lambda x, s: 1 / (math.pi * (1 + (x - s) ** 2)), even=True)
    >>> found = st.equation(kind="second", kernel=love, lambda_=-1.0, rhs=1, at=[0.0, 1.0])
    >>> found.phi.round(10).tolist()
    [1.9190319931, 1.6396952218]

    A logarithm with a smooth rest:

    >>> layered = st.Kernel(lambda x, s, distance: (-1.0, math.exp(-distance**2)), singularity="logarithm")
    >>> round(st.equation(kind="second", kernel=layered, lambda_=0.5, rhs="exp(x)", at=0.3).phi.item(), 12)
    0.456015642589
    """

    __slots__ = ("_even", "_function", "_interval", "_singularity")

    def __init__(
        self,
        function: Callable[[float, float], Any] | Callable[[float, float, float], Any],
        *,
        interval: Sequence[float] = (-1.0, 1.0),
        singularity: Literal["logarithm"] | float | None = None,
        even: bool = False,
    ) -> None:
        if not callable(function):
            raise ValueError(f"kernel: must be a function of x and s, got {type(function).__name__}")
        if not isinstance(even, (bool, np.bool_)):
            raise ValueError(f"kernel: even must be True or False, got {even!r}")
        self._function = function
        self._interval = _ends(interval)
        self._singularity = _singularity(singularity)
        self._even = bool(even)

    @property
    def function(self) -> Callable[[float, float], Any] | Callable[[float, float, float], Any]:
        """The callable."""
        return self._function

    @property
    def interval(self) -> tuple[float, float]:
        """The ends of the interval."""
        return self._interval

    @property
    def singularity(self) -> str | float | None:
        """``None``, ``"logarithm"`` or the exponent."""
        return self._singularity

    @property
    def even(self) -> bool:
        """Whether reflection changes nothing."""
        return self._even

    def __repr__(self) -> str:
        known = self._singularity
        kind = f"as |x - s|^{-known:g}" if isinstance(known, float) else known or "smooth"
        return f"<Kernel: {kind} on {self._interval}>"


def _ends(interval: Sequence[float]) -> tuple[float, float]:
    ends = _floats("kernel: interval", interval)
    if ends.shape != (2,):
        raise ValueError(f"kernel: interval must be a pair of numbers, got the shape {ends.shape}")
    left, right = ends.tolist()
    if not (np.isfinite(ends).all() and left < right):
        raise ValueError(f"kernel: interval must have finite ends, the left one first, got {left} and {right}")
    return left, right


def _singularity(given: Any) -> str | float | None:
    if given is None or (isinstance(given, str) and given == "logarithm"):
        return given
    if isinstance(given, (int, float, np.integer, np.floating)) and not isinstance(given, bool):
        exponent = float(given)
        if -1.0 < exponent < 1.0 and exponent != 0.0:
            return exponent
    raise ValueError(f"kernel: singularity must be None, 'logarithm' or an exponent between -1 and 1 that is not 0, got {given!r}")
