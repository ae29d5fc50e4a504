"""Problems, from whatever a user has."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from . import _document as document
from . import _shtaerman as engine
from ._parts import Foundation, Load, Punch, Solver
from ._profile import FloatArray, Profile, points

if TYPE_CHECKING:
    from ._contact import Contact

#: Points, or the pieces of a callable, that take the place of the profile in the text.
_Sampled: TypeAlias = tuple[FloatArray, FloatArray] | list[tuple[float, float, FloatArray]]

_NAME = "problem"


class Problem:
    """A punch on a foundation under a load.

    Everything is checked when the problem is made. A problem does not change: :meth:`replace` gives another one.

    Parameters
    ----------
    foundation, punch, load, solver:
        Its parts; the solver may be left out.

    Raises
    ------
    ValueError
        For what is wrong or does not go together, with the text of the command line.

    Examples
    --------
    >>> import shtaerman as st
    >>> steel = st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa")
    >>> problem = st.Problem(steel, st.Punch(half_width="5 mm"), st.Load(force="0.8 MN/m"))
    >>> round(problem.theta0, 4)
    1.2069
    >>> problem.replace(force="1 MN/m").solve().mean_pressure
    100000000.0
    """

    __slots__ = ("_content", "_engine", "_folder", "_name", "_overrides", "_sampled")

    _content: bytes
    _name: str
    _folder: str
    _overrides: list[str]
    _sampled: _Sampled | None
    _engine: engine.Problem

    def __init__(self, foundation: Foundation, punch: Punch, load: Load, solver: Solver | None = None) -> None:
        parts: list[tuple[Foundation | Punch | Load | Solver, type]] = [(foundation, Foundation), (punch, Punch), (load, Load)]
        if solver is not None:
            parts.append((solver, Solver))
        given: dict[str, Any] = {}
        for part, kind in parts:
            if not isinstance(part, kind):
                raise TypeError(f"Problem() takes a {kind.__name__} here, got {type(part).__name__}")
            given.update(part.keywords())
        self._take_tables(document.nested(given, "Problem"), "")

    @classmethod
    def open(cls, path: str | os.PathLike[str], **keywords: Any) -> Problem:
        """The problem of a file, with :meth:`replace` for the keywords.

        Raises
        ------
        ValueError
            With file, line and field.
        """
        name = os.fspath(path)
        made = cls.__new__(cls)
        made._take(engine.load(name), name, os.path.dirname(name), [], None)
        return made.replace(**keywords)

    @classmethod
    def parse(cls, text: str, **keywords: Any) -> Problem:
        """The problem of the text of a problem file; a measured profile is looked for in the current folder.

        Raises
        ------
        ValueError
            With line and field.
        """
        if not isinstance(text, str):
            raise TypeError(f"Problem.parse() takes the text of a problem file, got {type(text).__name__}")
        made = cls.__new__(cls)
        made._take(text.encode("utf-8", "surrogateescape"), _NAME, "", [], None)
        return made.replace(**keywords)

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any], **keywords: Any) -> Problem:
        """The problem of a dictionary with the tables and keys of a problem file; the profile may be an array or a callable, too.

        Raises
        ------
        ValueError
            With the field.
        """
        if not isinstance(tables, Mapping):
            raise TypeError(f"Problem.from_dict() takes a dictionary with the tables of a problem file, got {type(tables).__name__}")
        made = cls.__new__(cls)
        made._take_tables({key: dict(value) if isinstance(value, Mapping) else value for key, value in tables.items()}, "")
        return made.replace(**keywords)

    def replace(self, **keywords: Any) -> Problem:
        """The same problem with other values, by the names of the problem file; one of a pair takes the place of the other.

        Examples
        --------
        >>> import shtaerman as st
        >>> problem = st.Problem(st.Foundation(theta0=5.0), st.Punch(), st.Load(force=2.0))
        >>> problem.replace(settlement=1.0).solve().settlement
        1.0
        """
        given = {name: value for name, value in keywords.items() if value is not None}
        if not given:
            return self
        later, sampled, profile = [], self._sampled, None
        for name, value in given.items():
            table = document.table_of(name, self.is_dimensionless, "replace")
            key = f"{table}.{name}" if table else name
            if name == "profile":
                profile, value = _separated(value)
                sampled = None
            later.append(f"{key}={document.toml_value(value, key)}")
        made = type(self).__new__(type(self))
        overrides = engine.superseded(self._overrides, later)
        made._take(self._content, self._name, self._folder, overrides, sampled)
        made._take_profile(profile)
        return made

    def solve(self, *, audit: bool = True) -> Contact:
        """Solves the problem.

        Parameters
        ----------
        audit:
            Whether the answer is audited, as the command line does: its errors are then bounds from its own residual where there is an audit. Without, they are those
            that the method states, and a solve takes less time.

        Raises
        ------
        ValueError
            For what is found to be wrong with the problem.
        ConvergenceError
            For a tolerance that is not met, a time limit that is over, an answer that was not found.
        KeyboardInterrupt
            Within some hundredths of a second.
        """
        from ._contact import Contact

        return Contact._of(self, self._engine.solve(audit))

    @property
    def is_dimensionless(self) -> bool:
        """Whether it is stated in numbers without dimensions."""
        return self._engine.is_dimensionless

    @property
    def is_circular(self) -> bool:
        """Whether force and moment are those of a disk (N, N m), not per unit length."""
        return self._engine.is_circular

    @property
    def theta0(self) -> float:
        """``2 a/(pi E* chi)``; of a smooth surface, where its scale is undefined, a number of internal use."""
        return self._engine.theta0

    @property
    def half_width(self) -> float:
        """``a`` (m): half-width, outer half-width of a pair, radius of a circular punch."""
        return self._engine.half_width

    @property
    def gauge(self) -> str:
        """What the settlement is measured against."""
        return self._engine.gauge

    def height(self, x: Any) -> Any:
        """The base ``f(x)`` (m) at places from edge to edge, as an array of their shape.

        Raises
        ------
        ValueError
            For a place beyond the base, also for NaN.
        """
        from ._arrays import each, finite

        beyond = np.abs(finite(x)).max(initial=0.0)
        if beyond > self.half_width:
            raise ValueError(f"x: reaches to {beyond} from the middle, beyond the punch, whose base is known to {self.half_width}")
        return each(self._engine.heights, x)

    def to_toml(self) -> str:
        """The problem as the text of a problem file, without later replacements: those are in :attr:`overrides`."""
        return self._content.decode("utf-8", "replace")

    @property
    def overrides(self) -> tuple[str, ...]:
        """What replaces values of the text, as after ``--set`` of the command line."""
        return tuple(self._overrides)

    def __repr__(self) -> str:
        kind = "dimensionless" if self.is_dimensionless else "physical"
        return f"<Problem {self._name!r}: {kind}, theta0 = {self.theta0:.6g}>"

    def __reduce__(self) -> tuple[Any, ...]:
        overrides, sampled = self._overrides, self._sampled
        found = self._engine.points() if sampled is None else None
        if found is not None:
            # The trace goes with the problem: its file may not be where it is restored.
            key = "dimensionless.profile" if self.is_dimensionless else "punch.profile"
            overrides, sampled = engine.superseded(overrides, [f"{key}=0"]), found
        return _restored, (self._content, self._name, self._folder, overrides, sampled)

    def __copy__(self) -> Problem:
        return self

    def __deepcopy__(self, memo: object) -> Problem:
        return self

    def _take_tables(self, tables: dict[str, Any], folder: str) -> None:
        profile = None
        for table in ("punch", "dimensionless"):
            home = tables.get(table)
            if isinstance(home, Mapping) and "profile" in home:
                profile, plain = _separated(home["profile"])
                tables[table] = {**home, "profile": plain}
                break
        self._take(document.toml(tables).encode("utf-8"), _NAME, folder, [], None)
        self._take_profile(profile)

    def _take_profile(self, profile: Profile | tuple[FloatArray, FloatArray] | None) -> None:
        if profile is None:
            return
        sampled: _Sampled = profile.pieces(self.half_width) if isinstance(profile, Profile) else profile
        self._take(self._content, self._name, self._folder, self._overrides, sampled)

    def _take(self, content: bytes, name: str, folder: str, overrides: list[str], sampled: _Sampled | None) -> None:
        self._content, self._name, self._folder = content, name, folder
        self._overrides, self._sampled = overrides, sampled
        self._engine = engine.Problem(content, name, folder, overrides, sampled)


#: What :func:`solve` takes: a problem, the path of a problem file, its text, or its tables as a dictionary.
ProblemLike: TypeAlias = Problem | str | os.PathLike[str] | Mapping[str, Any]


def problem_of(problem: ProblemLike | None, keywords: Mapping[str, Any], function: str) -> Problem:
    """The problem of whatever :func:`solve` takes."""
    if problem is None:
        made = Problem.__new__(Problem)
        made._take_tables(document.nested(keywords, function), "")
        return made
    if isinstance(problem, Problem):
        return problem.replace(**keywords)
    if isinstance(problem, Mapping):
        return Problem.from_dict(problem, **keywords)
    if isinstance(problem, os.PathLike):
        return Problem.open(problem, **keywords)
    if isinstance(problem, str):
        # A path has no line breaks, and a problem has some.
        is_text = "\n" in problem
        if not problem:
            raise ValueError(f"{function}(): empty text is neither a path nor a problem")
        return Problem.parse(problem, **keywords) if is_text else Problem.open(problem, **keywords)
    raise ValueError(f"{function}() takes a Problem, a path, the text of a problem file, a dictionary or keywords, got {type(problem).__name__}")


def _separated(value: Any) -> tuple[Profile | tuple[FloatArray, FloatArray] | None, Any]:
    """A profile that is no text, and what stands for it in the text."""
    if isinstance(value, Profile):
        return value, 0
    if callable(value):
        return Profile(value), 0
    if isinstance(value, (tuple, list)) or (isinstance(value, np.ndarray) and value.ndim > 0):
        if len(value) != 2:
            raise ValueError(f"profile: points are a pair (x, f) of places and heights, got {len(value)} parts")
        return points(value[0], value[1]), 0
    return None, value


def _restored(content: bytes, name: str, folder: str, overrides: list[str], sampled: _Sampled | None) -> Problem:
    made = Problem.__new__(Problem)
    made._take(content, name, folder, overrides, sampled)
    return made
