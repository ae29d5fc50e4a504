"""Many cases of one problem."""

from __future__ import annotations

import numbers
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _shtaerman as engine
from ._arrays import processors
from ._contact import Errors
from ._problem import Problem, ProblemLike, problem_of
from ._profile import FloatArray, as_numbers

if TYPE_CHECKING:
    import pandas
    import xarray

#: Cases that are tried to find one that is a problem at all.
_TRIED = 1000
_STIFFNESS = ("stiffness_00", "stiffness_01", "stiffness_10", "stiffness_11")
_OUTPUTS = (
    "settlement",
    "tilt",
    "force",
    "moment",
    "pressure_left",
    "pressure_middle",
    "pressure_right",
    "mean_pressure",
    "peak_pressure",
    "peak_pressure_at",
    "contact_width",
    "theta0",
    "stiffness",
)
_ERRORS = ("pressure", "peak_pressure", "settlement", "tilt", "force", "moment")


def solve_many(
    problem: ProblemLike | None = None,
    /,
    *,
    outputs: Sequence[str] | None = None,
    audit: bool = False,
    threads: int | None = None,
    **keywords: Any,
) -> Contacts:
    """Solves a problem for arrays of values.

    Keywords are those of :func:`solve`, and any of them but the profile and tables may be an array: all arrays are broadcast against each other as NumPy does. Each case
    is solved by itself, with the same bits as :func:`solve` and whatever the number of threads, without the interpreter being held.

    Parameters
    ----------
    problem:
        As in :func:`solve`.
    outputs:
        Names of the arrays that are wanted, with their errors; all of them where left out. Where ``theta0`` alone varies in bilateral contact, and none but ``settlement``, ``tilt``, ``force``,
        ``moment``, ``pressure_left``, ``pressure_right``, ``mean_pressure``, ``stiffness`` and ``theta0`` are wanted, one decomposition serves all cases: millions in a second, equal
        to single solves within the errors of both, though not to the last bit, and without warnings.
    audit:
        Whether every answer is audited; without, the errors are those that the method states.
    threads:
        How many threads solve; as many as there are processors where left out.
    **keywords:
        Numbers, text with units, and arrays of either.

    Returns
    -------
    Contacts
        Arrays under the names of :class:`Contact`. A case without an answer is NaN, and ``reason`` says why; no exception is raised for it.

    Raises
    ------
    ValueError
        For arrays that do not go together, and where no case is a problem at all.

    Examples
    --------
    >>> import numpy as np
    >>> import shtaerman as st
    >>> found = st.solve_many(profile="10*xi^2", theta0=np.array([[1.0], [10.0]]), force=np.array([1.0, 2.0, -1.0]))
    >>> found.settlement.shape
    (2, 3)
    >>> found.solved.tolist()
    [[True, True, False], [True, True, False]]
    >>> found.reason[0, 2].split(":")[0]
    'force = -1'
    """
    if threads is None:
        threads = processors()
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or threads < 1:
        raise ValueError(f"threads: must be a whole number of at least 1, got {threads!r}")
    columns = {name: _column(name, value) for name, value in keywords.items() if _is_varied(name, value)}
    fixed = {name: value for name, value in keywords.items() if name not in columns}
    try:
        shape = np.broadcast_shapes(*(column.shape for column in columns.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {column.shape}" for name, column in columns.items())
        raise ValueError(f"solve_many(): the shapes of the arrays do not go together: {shapes}") from None
    inputs = {name: np.broadcast_to(column, shape) for name, column in columns.items()}
    if 0 in shape:
        raise ValueError(f"solve_many(): there are no cases: the arrays have the shape {shape}")
    wanted = _wanted(outputs)
    base = _base(problem, fixed, inputs)
    if wanted is not None and not audit:
        swept = _swept(base, inputs, wanted, threads)
        if swept is not None:
            return Contacts._of(base, inputs, shape, swept, wanted)
    found = _solved(base, inputs, audit, threads)
    return Contacts._of(base, inputs, shape, found, wanted)


def _wanted(outputs: Sequence[str] | None) -> list[str] | None:
    """Names of the numbers behind the outputs and their errors."""
    if outputs is None:
        return None
    if isinstance(outputs, str) or not all(isinstance(name, str) for name in outputs):
        raise ValueError(f"outputs: must be a list of names, got {outputs!r}")
    wanted: list[str] = []
    for name in outputs:
        if name not in _OUTPUTS:
            raise ValueError(f"outputs: {name!r} is none: there are {', '.join(_OUTPUTS)}")
        wanted.extend(_STIFFNESS if name == "stiffness" else [name])
        error = "pressure" if "pressure" in name else name
        if error in _ERRORS and name != "peak_pressure_at":
            wanted.append(f"error_{error}")
        if name == "peak_pressure":
            wanted.append("error_peak_pressure")
    return list(dict.fromkeys([*wanted, "relative_error"]))


def _swept(base: Problem, inputs: Mapping[str, npt.NDArray[Any]], wanted: list[str], threads: int) -> Any:
    """What a sweep over theta0 tells, in the form of :func:`_solved`; none where single solves have to."""
    if set(inputs) != {"theta0"} or inputs["theta0"].dtype.kind != "f" or not all(engine.is_swept(name) for name in wanted if name != "relative_error"):
        return None
    theta0 = np.ascontiguousarray(inputs["theta0"], dtype=np.float64).ravel()
    names = [name for name in wanted if name != "relative_error"]
    found = engine.sweep_theta0(base._engine, theta0, names, threads)
    if found is None:
        return None
    numbers, relative_error, faults = found
    # What is the same for all cases takes the room of one.
    relative_errors = np.broadcast_to(np.array(relative_error), theta0.shape)
    kinds, warnings, reasons = (np.broadcast_to(np.array(text, dtype=object), theta0.shape) for text in ("estimate", "", ""))
    if faults:
        relative_errors, kinds, reasons = relative_errors.copy(), kinds.copy(), reasons.copy()
    for case, reason in faults:
        relative_errors[case], kinds[case], reasons[case] = np.nan, "", reason
    return [*names, "relative_error"], [*numbers.T, relative_errors], kinds, warnings, reasons


def _is_varied(name: str, value: Any) -> bool:
    if name == "profile" or value is None or isinstance(value, (str, bytes, Mapping)):
        return False
    return isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) > 0


def _column(name: str, value: Any) -> npt.NDArray[Any]:
    """An array of numbers or of text."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: must be an array of numbers, got rows of different lengths") from None
    if np.ma.is_masked(value):
        raise ValueError(f"{name}: has masked values: leave them out, x.compressed(), or fill them")
    array = as_numbers(array)
    if array.dtype.kind in "iuf":
        return array.astype(np.float64)
    if array.dtype.kind in "UT" or (array.dtype.kind == "O" and all(isinstance(item, (str, numbers.Real)) and not isinstance(item, bool) for item in array.flat)):
        return array.astype(object)
    raise ValueError(f"{name}: must be an array of real numbers or of text, got the type {array.dtype}")


def _base(problem: ProblemLike | None, fixed: dict[str, Any], inputs: Mapping[str, npt.NDArray[Any]]) -> Problem:
    """The problem that is varied."""
    if problem is not None or not inputs:
        return problem_of(problem, fixed, "solve_many")
    first: ValueError | None = None
    for case in range(min(_TRIED, next(iter(inputs.values())).size)):
        try:
            return problem_of(None, {**fixed, **_values(inputs, case)}, "solve_many")
        except ValueError as error:
            first = first or error
    assert first is not None
    raise first


def _values(inputs: Mapping[str, npt.NDArray[Any]], case: int) -> dict[str, Any]:
    return {name: values.flat[case] for name, values in inputs.items()}


def _solved(base: Problem, inputs: Mapping[str, npt.NDArray[Any]], audit: bool, threads: int) -> Any:
    """Names, a column of numbers for each, and the kinds of errors, warnings and reasons."""
    def is_direct(name: str, values: npt.NDArray[Any]) -> bool:
        return values.dtype.kind == "f" and engine.is_varied_directly(name)

    if inputs and all(is_direct(name, values) for name, values in inputs.items()):
        columns = [(name, np.ascontiguousarray(values, dtype=np.float64).ravel()) for name, values in inputs.items()]
        found = engine.solve_varied(base._engine, columns, audit, threads)
    else:
        count = next(iter(inputs.values())).size if inputs else 1
        found = engine.solve_single(base._engine, [_single(base, inputs, case) for case in range(count)], audit, threads)
    names, numbers, *texts = found
    return names, numbers.T, *texts


def _single(base: Problem, inputs: Mapping[str, npt.NDArray[Any]], case: int) -> tuple[engine.Problem | None, str]:
    try:
        return base.replace(**_values(inputs, case))._engine, ""
    except ValueError as error:
        return None, str(error)


class Contacts:
    """The answers of :func:`solve_many`: arrays under the names of :class:`Contact`, in the shape that the arrays of values have together.

    Cases without an answer are NaN; ``solved`` says which have one, ``reason`` why the others have none.
    """

    __slots__ = ("_found", "_inputs", "_kinds", "_problem", "_reasons", "_shape", "_warnings")

    _problem: Problem
    _inputs: dict[str, npt.NDArray[Any]]
    _shape: tuple[int, ...]
    _found: dict[str, FloatArray]
    _kinds: npt.NDArray[Any]
    _warnings: npt.NDArray[Any]
    _reasons: npt.NDArray[Any]

    def __init__(self) -> None:
        raise TypeError("Contacts are made by solve_many()")

    @classmethod
    def _of(
        cls,
        problem: Problem,
        inputs: dict[str, npt.NDArray[Any]],
        shape: tuple[int, ...],
        found: Any,
        wanted: list[str] | None,
    ) -> Contacts:
        names, columns, kinds, warnings, reasons = found
        made = cls.__new__(cls)
        made._problem, made._inputs, made._shape = problem, inputs, shape
        kept = [(name, column) for name, column in zip(names, columns, strict=True) if wanted is None or name in wanted]
        # Columns are views where all of them are kept: copies of millions of cases take as long as the cases.
        made._found = {name: (column if len(kept) == len(names) else column.copy()).reshape(shape) for name, column in kept}
        made._kinds, made._warnings, made._reasons = (
            np.asarray(texts, dtype=object).reshape(shape) for texts in (kinds, warnings, reasons)
        )
        return made

    def _array(self, name: str) -> FloatArray:
        if name not in self._found:
            raise AttributeError(f"{name.partition('_0')[0].partition('_1')[0]} was not asked for: name it in outputs")
        return self._found[name]

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of all arrays."""
        return self._shape

    @property
    def inputs(self) -> dict[str, npt.NDArray[Any]]:
        """What was varied, in that shape."""
        return dict(self._inputs)

    @property
    def settlement(self) -> FloatArray:
        """Settlement ``delta`` (m)."""
        return self._array("settlement")

    @property
    def tilt(self) -> FloatArray:
        """Tilt ``alpha`` (rad)."""
        return self._array("tilt")

    @property
    def force(self) -> FloatArray:
        """Force ``P`` (N/m; N under a circular punch)."""
        return self._array("force")

    @property
    def moment(self) -> FloatArray:
        """Moment ``M`` (N m/m; N m under a circular punch)."""
        return self._array("moment")

    @property
    def pressure_left(self) -> FloatArray:
        """Pressure at the left edge (Pa)."""
        return self._array("pressure_left")

    @property
    def pressure_middle(self) -> FloatArray:
        """Pressure in the middle (Pa)."""
        return self._array("pressure_middle")

    @property
    def pressure_right(self) -> FloatArray:
        """Pressure at the right edge (Pa)."""
        return self._array("pressure_right")

    @property
    def mean_pressure(self) -> FloatArray:
        """Mean pressure over the base (Pa)."""
        return self._array("mean_pressure")

    @property
    def peak_pressure(self) -> FloatArray:
        """The largest pressure (Pa)."""
        return self._array("peak_pressure")

    @property
    def peak_pressure_at(self) -> FloatArray:
        """Its place (m)."""
        return self._array("peak_pressure_at")

    @property
    def contact_width(self) -> FloatArray:
        """Width of all zones together (m)."""
        return self._array("contact_width")

    @property
    def theta0(self) -> FloatArray:
        """``2 a/(pi E* chi)``."""
        return self._array("theta0")

    @property
    def stiffness(self) -> FloatArray:
        """Tangent stiffness, two more axes of length 2."""
        parts = [self._array(name) for name in _STIFFNESS]
        return np.stack(parts, axis=-1).reshape(*self._shape, 2, 2)

    @property
    def relative_error(self) -> FloatArray:
        """The largest error relative to its size; infinite where nothing is stated."""
        return self._array("relative_error")

    @property
    def error(self) -> Errors:
        """The errors as arrays; ``kind`` is ``"bound"``, ``"estimate"``, or empty where nothing is stated and the errors are NaN, as that of the largest pressure is without an audit."""
        # Of what was not asked for nothing is stated.
        nothing = np.full(self._shape, np.nan)
        parts: dict[str, Any] = {name: self._found.get(f"error_{name}", nothing) for name in _ERRORS}
        kinds: Any = self._kinds
        return Errors(kind=kinds, **parts)

    @property
    def solved(self) -> npt.NDArray[np.bool_]:
        """Which cases have an answer."""
        found: npt.NDArray[np.bool_] = self._reasons == ""
        return found

    @property
    def reason(self) -> npt.NDArray[Any]:
        """Why a case has none, with the text of the command line; empty where it has one."""
        return self._reasons

    @property
    def warnings(self) -> npt.NDArray[Any]:
        """Codes of the warnings of each case, with blanks between them."""
        return self._warnings

    def problem(self, index: int | tuple[int, ...]) -> Problem:
        """The problem of one case.

        Raises
        ------
        ValueError
            Where the case is none.
        """
        return self._problem.replace(**{name: values[index] for name, values in self._inputs.items()})

    def _columns(self) -> dict[str, npt.NDArray[Any]]:
        """All arrays by name; what is varied comes first."""
        columns: dict[str, npt.NDArray[Any]] = dict(self._inputs)
        columns.update({name: values for name, values in self._found.items() if name not in columns})
        return {**columns, "error_kind": self._kinds, "warnings": self._warnings, "reason": self._reasons}

    def to_pandas(self) -> pandas.DataFrame:
        """A table with a row for each case, in C order; pandas must be installed."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_pandas() needs pandas: pip install 'shtaerman[pandas]'") from error
        return pandas.DataFrame({name: np.asarray(values).ravel() for name, values in self._columns().items()})

    def to_xarray(self) -> xarray.Dataset:
        """A data set over the axes of the arrays; xarray must be installed.

        An axis along which a single array of values varies, and no other, has its name and its values.
        """
        try:
            import xarray
        except ImportError as error:
            raise ImportError("to_xarray() needs xarray: pip install 'shtaerman[xarray]'") from error
        names = self._axes()
        coordinates: dict[str, Any] = {}
        for name, values in self._inputs.items():
            if name in names:
                axis = names.index(name)
                along = tuple(slice(None) if at == axis else 0 for at in range(len(names)))
                coordinates[name] = (name, values[along])
            else:
                coordinates[name] = (names, values)
        variables = {name: (names, values) for name, values in self._columns().items() if name not in coordinates}
        return xarray.Dataset(variables, coords=coordinates)

    def _axes(self) -> list[str]:
        # What is broadcast along an axis has no stride there.
        moving = {
            name: [at for at, stride in enumerate(values.strides) if stride and values.shape[at] > 1]
            for name, values in self._inputs.items()
        }
        names = []
        for axis in range(len(self._shape)):
            along = [name for name, axes in moving.items() if axis in axes]
            is_own = len(along) == 1 and moving[along[0]] == [axis]
            names.append(along[0] if is_own else f"dim_{axis}")
        return names

    def __len__(self) -> int:
        if not self._shape:
            raise TypeError("a single case has no length")
        return self._shape[0]

    def __repr__(self) -> str:
        varied = ", ".join(self._inputs) or "nothing"
        return f"<Contacts: shape {self._shape}, {int(self.solved.sum())} of {self.solved.size} solved, varied: {varied}>"
