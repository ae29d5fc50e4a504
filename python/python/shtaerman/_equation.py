"""Integral equations without mechanics, spectra, and the roughness of measured surfaces."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _document as document
from . import _shtaerman as engine
from ._arrays import counted, places
from ._contact import Method, Warned
from ._kernel import Kernel
from ._parts import Quantity
from ._profile import FloatArray


@dataclass(frozen=True)
class EquationErrors:
    """The errors of the solution of an equation."""

    kind: str
    """``"bound"`` or ``"estimate"``."""
    of: str
    """What the error is of: ``"phi"``, of the first kind ``"phi/w"`` with the weight ``w``."""
    solution_sup: float | None
    """Largest error of that on the closed interval."""
    integral: float | None
    """Error of the integral."""


@dataclass(frozen=True, eq=False)
class EquationAnswer:
    """The solution of an equation at places."""

    x: FloatArray
    """Places."""
    phi: FloatArray
    """The solution there; infinite at the ends where a solution of the first kind is."""
    integral: float | None
    """The integral of what ``integral_of`` names; ``None`` where it does not exist."""
    integral_of: str
    """What the integral is taken of."""
    error: EquationErrors
    """How sure the answer is."""
    method: Method
    """How it was solved."""
    warnings: list[Warned]
    """What a user should know."""
    answer: dict[str, Any]
    """The answer of ``shtaerman equation --format json``; on a kernel of one's own what of it there is."""


def equation(
    problem: str | os.PathLike[str] | Mapping[str, Any] | None = None,
    /,
    *,
    kind: str | None = None,
    lambda_: float | None = None,
    rhs: str | float | Callable[[float], Any] | None = None,
    kernel: str | Kernel | None = None,
    points: int = 201,
    at: npt.ArrayLike | None = None,
    audit: bool = True,
    cross_check: bool = False,
    solver: Mapping[str, Any] | None = None,
    **parameters: Any,
) -> EquationAnswer:
    """Solves ``phi + lambda int K phi ds = f`` or ``int K phi ds = f`` on one of the seven kernels, as ``shtaerman equation`` does, or on a kernel of one's own.

    Parameters
    ----------
    problem:
        The path of an equation file, its text, or a dictionary with its tables; the keywords then replace its values.
    kind, lambda_, rhs:
        ``"second"`` (with ``lambda_``) or ``"first"``, and the right-hand side as an expression in ``x``. On a kernel of one's own it may also be a function of one float, which should
        be smooth; an expression has its kinks and jumps found.
    kernel:
        ``"log"``, ``"log-ratio"``, ``"log-sine"``, ``"power"``, ``"macdonald"``, ``"weber-sonine"``, ``"yukawa"`` or ``"log-square"``, with its parameters as further keywords; or a
        :class:`Kernel`, for the second kind, by collocation: errors are estimates then, without audit and cross-check.
    points, at:
        At how many places, or at which, the solution is told.
    audit:
        Whether the solution is audited.
    cross_check:
        Whether it is compared with the other method.
    solver:
        ``method``, ``n`` and ``tolerance``; on a kernel of one's own ``tolerance`` alone.

    Raises
    ------
    ValueError
        For bad input, with the text of the command line.
    ConvergenceError
        For a numerical promise that is not kept.

    Examples
    --------
    >>> import shtaerman as st
    >>> found = st.equation(kind="second", lambda_=1.0, rhs="1 + x", kernel="power", a=1.0, mu=0.3, at=[-0.5, 0.5])
    >>> found.phi.shape
    (2,)
    """
    points = counted(points)
    if solver is not None and not isinstance(solver, Mapping):
        raise ValueError(f"solver: must be a dictionary with method, n and tolerance, got {type(solver).__name__}")
    if callable(kernel):
        raise ValueError("kernel: is a function: a kernel of one's own is st.Kernel(function, ...)")
    asked = None if at is None else places(at, "at")
    listed = None if asked is None else asked.ravel()
    if isinstance(kernel, Kernel):
        if problem is not None or parameters or cross_check:
            what = "the other problem" if problem is not None else ", ".join(parameters) or "cross_check"
            raise ValueError(f"equation(): {what}: does not go with a kernel of one's own, which is stated by kind, lambda_ and rhs")
        told = _own(kernel, kind, lambda_, rhs, solver or {}, points, listed)
    else:
        if callable(rhs):
            raise ValueError("rhs: is a function, which goes with a kernel of one's own; with a kernel by name it must be an expression in x or a number")
        stated: dict[str, Any] = {"equation.kind": kind, "equation.lambda": lambda_, "equation.rhs": rhs, "kernel.name": kernel}
        stated.update({f"kernel.{name}": value for name, value in parameters.items()})
        stated.update({f"solver.{name}": value for name, value in (solver or {}).items()})
        given = {name: value for name, value in stated.items() if value is not None}
        content, name, overrides = _content(problem, given)
        told = engine.solve_equation(content, name, overrides, points, listed, audit, cross_check)
    answer: dict[str, Any] = json.loads(told)
    samples = answer["solution"]
    shape = (len(samples["x"]),) if asked is None else asked.shape
    phi = np.array([np.inf if value is None else value for value in samples["phi"]], dtype=np.float64)
    return EquationAnswer(
        np.array(samples["x"], dtype=np.float64).reshape(shape),
        phi.reshape(shape),
        answer["integral"],
        answer["integral_of"],
        EquationErrors(**answer["error"]),
        Method(**answer["method"]),
        [Warned(**warning) for warning in answer["warnings"]],
        answer,
    )


def _own(
    kernel: Kernel,
    kind: str | None,
    lambda_: float | None,
    rhs: str | float | Callable[[float], Any] | None,
    solver: Mapping[str, Any],
    points: int,
    at: FloatArray | None,
) -> str:
    """The JSON of the answer on a kernel of one's own."""
    if kind != "second":
        raise ValueError(f"kind: must be 'second' on a kernel of one's own, whose spectral relation is not known, got {kind!r}")
    if rhs is None:
        raise ValueError("rhs: is missing: must be an expression in x, a number or a function")
    given = rhs if callable(rhs) or isinstance(rhs, str) else repr(_number("rhs", rhs))
    for name, value in solver.items():
        if name == "tolerance" or value is None or (name, value) in _COLLOCATION:
            continue
        raise ValueError(f"solver.{name}: is {value!r}: a kernel of one's own is solved by collocation, and only tolerance can be chosen")
    tolerance = solver.get("tolerance")
    return engine.solve_own(
        kernel.function,
        0.0 if isinstance(kernel.singularity, str) else kernel.singularity,
        kernel.interval,
        kernel.even,
        _number("lambda_", lambda_),
        given,
        None if tolerance is None else _number("solver.tolerance", tolerance),
        points,
        at,
    )


#: What may be said of the solver beside the tolerance, as it says nothing new.
_COLLOCATION = (("method", "auto"), ("method", "sinc"))


def _number(name: str, value: Any) -> float:
    array = np.asarray(value)
    if array.shape != () or array.dtype.kind not in "iuf" or not np.isfinite(array):
        raise ValueError(f"{name}: is {value!r}: must be a finite number")
    return float(array)


def _content(problem: str | os.PathLike[str] | Mapping[str, Any] | None, given: Mapping[str, Any]) -> tuple[bytes, str, list[str]]:
    overrides = [f"{key}={document.toml_value(value, key)}" for key, value in given.items()]
    if problem is None or isinstance(problem, Mapping):
        tables: dict[str, Any] = {} if problem is None else {key: value for key, value in problem.items()}
        if problem is None:
            for key, value in given.items():
                table, name = key.split(".", 1)
                tables.setdefault(table, {})[name] = value
            overrides = []
        return document.toml(tables).encode(), "equation", overrides
    if isinstance(problem, str) and "\n" in problem:
        return problem.encode("utf-8", "surrogateescape"), "equation", overrides
    if isinstance(problem, (str, os.PathLike)):
        name = os.fspath(problem)
        return engine.load(name), name, overrides
    raise ValueError(f"equation() takes a path, the text of an equation file, a dictionary or keywords, got {type(problem).__name__}")


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Eigenvalues and norms of a kernel."""

    index: npt.NDArray[np.int64]
    """``n``."""
    eigenvalue: FloatArray
    """The eigenvalues."""
    norm: FloatArray
    """Norms of the eigenfunctions."""
    expansion_factor: FloatArray
    """Factors of the bilinear expansion."""
    answer: dict[str, Any]
    """The answer of ``shtaerman spectrum --format json``."""


def spectrum(kernel: str, /, *, count: int = 10, verify: bool = False, **parameters: Any) -> Spectrum:
    """Eigenvalues and norms of a kernel with its parameters, as ``shtaerman spectrum`` gives them.

    Parameters
    ----------
    kernel:
        As in :func:`equation`.
    count:
        How many.
    verify:
        Whether they are verified by independent quadrature.

    Raises
    ------
    ValueError
        For parameters out of range.
    ConvergenceError
        Where the verification fails.

    Examples
    --------
    >>> import shtaerman as st
    >>> st.spectrum("power", a=1.0, mu=0.3, count=3, verify=True).eigenvalue.shape
    (3,)
    """
    options = {"count": count, **parameters}
    answer = _command("spectrum", [kernel], options, ["--verify"] if verify else [])
    names = ("eigenvalue", "norm", "expansion_factor")
    arrays = {name: np.array(answer[name], dtype=np.float64) for name in names}
    return Spectrum(index=np.array(answer["index"], dtype=np.int64), answer=answer, **arrays)


def roughness(source: str, file: str | os.PathLike[str] | None = None, /, **options: Quantity | os.PathLike[str]) -> dict[str, Any]:
    """The law of the rough layer from asperities, a bearing curve or a table, as ``shtaerman roughness`` finds it.

    Parameters
    ----------
    source:
        ``"gw"`` (Greenwood and Williamson), ``"bearing"`` or ``"table"``.
    file:
        The table, for ``"table"``.
    **options:
        Those of the command line with ``_`` in place of ``-``: numbers in SI units or text with a unit.

    Returns
    -------
    dict
        The answer of the command line; ``["roughness"]`` is what :func:`solve` takes as ``roughness``.

    Raises
    ------
    ValueError
        For bad input, with the text of the command line.

    Examples
    --------
    >>> import shtaerman as st
    >>> found = st.roughness("gw", deviation="0.5 um", density="1e4 1/mm^2", radius="20 um", modulus="110 GPa", pressure="50 MPa")
    >>> 1e-15 < found["roughness"] < 1e-14
    True
    """
    return _command("roughness", [source, *([] if file is None else [os.fspath(file)])], options, [])


def _command(command: str, words: list[str], options: Mapping[str, Any], flags: list[str]) -> dict[str, Any]:
    for word in words:
        if not isinstance(word, str) or word.startswith("-"):
            raise ValueError(f"{command}(): {word!r} is no name")
    arguments = [command, *words, *flags, *document.options(options, command)]
    try:
        found: dict[str, Any] = json.loads(engine.command_json(arguments))
    except ValueError as error:
        raise ValueError(document.without_usage(str(error))) from None
    return found
