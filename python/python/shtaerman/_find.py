"""The inverse way round: which force, roughness, crown or profile gives what is wanted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, overload

from . import _shtaerman as engine
from ._arrays import counted, finite
from ._contact import Contact
from ._parts import Quantity
from ._problem import Problem, ProblemLike, problem_of
from ._profile import FloatArray


@dataclass(frozen=True)
class Found:
    """A force or a roughness that was looked for, with its contact; in the units of the problem."""

    value: float
    """The force (N/m), ``chi`` (m/Pa), or the coefficient ``B`` of the layer's law."""
    wanted: float
    """What was to be reached."""
    reached: float
    """What was reached."""
    relative_error: float
    """The difference of both over the larger of them."""
    evaluations: int
    """Number of solves that it took."""
    contact: Contact
    """The contact at this value; its ``problem`` is the one found."""


@dataclass(frozen=True)
class Crowned:
    """A crown with its contact."""

    radius: float | None
    """``R`` of ``x^2/(2 R)``; ``None`` for the flat base."""
    profile: str
    """The base as an expression."""
    contact: Contact
    """The contact with this base."""


@dataclass(frozen=True)
class Crown:
    """The crown of the lowest peak pressure and, with a limit, all that keep it."""

    best: Crowned
    """The crown of the lowest peak pressure."""
    least: Crowned | None
    """The sharpest crown within the limit."""
    largest: Crowned | None
    """The flattest crown within the limit, perhaps the flat base."""
    evaluations: int
    """Number of solves that it took."""


@dataclass(frozen=True, eq=False)
class Shaped:
    """The profile under which the pressure is what was prescribed."""

    x: FloatArray
    """Places (m)."""
    profile: FloatArray
    """Heights of the base there (m); ``(x, profile)`` is a profile for a :class:`Punch`."""
    pressure: FloatArray
    """Pressures there (Pa)."""
    settlement: float
    """Settlement of the punch with this profile (m)."""
    tilt: float
    """Its tilt (rad)."""
    force: float
    """Force (N/m)."""
    moment: float
    """Moment of the pressure (N m/m)."""
    factor: float
    """What the pressure as written was multiplied with to balance the force."""
    error: float
    """Estimated error of the heights (m)."""


@overload
def find(
    unknown: Literal["force", "roughness"],
    problem: ProblemLike | None = None,
    /,
    *,
    peak_pressure: Quantity | None = None,
    contact_width: Quantity | None = None,
    settlement: Quantity | None = None,
    audit: bool = True,
    **keywords: Any,
) -> Found: ...


@overload
def find(
    unknown: Literal["crown"],
    problem: ProblemLike | None = None,
    /,
    *,
    peak_pressure: Quantity | None = None,
    audit: bool = True,
    **keywords: Any,
) -> Crown: ...


@overload
def find(
    unknown: Literal["profile"],
    problem: ProblemLike | None = None,
    /,
    *,
    pressure: str | None = None,
    zero: Literal["centre", "lowest"] = "centre",
    points: int = 201,
    **keywords: Any,
) -> Shaped: ...


def find(
    unknown: Literal["force", "roughness", "crown", "profile"],
    problem: ProblemLike | None = None,
    /,
    *,
    peak_pressure: Quantity | None = None,
    contact_width: Quantity | None = None,
    settlement: Quantity | None = None,
    pressure: str | None = None,
    zero: Literal["centre", "lowest"] = "centre",
    points: int = 201,
    audit: bool = True,
    **keywords: Any,
) -> Found | Crown | Shaped:
    """Finds what gives a wanted answer, as ``shtaerman find`` does.

    Parameters
    ----------
    unknown:
        ``"force"`` or ``"roughness"`` for one of ``peak_pressure``, ``contact_width`` and (of the roughness) ``settlement``; ``"crown"``, of the lowest peak pressure, with
        ``peak_pressure`` as its limit; ``"profile"`` for a ``pressure`` prescribed as an expression.
    problem:
        As in :func:`solve`, with its keywords, but that ``settlement`` is what is wanted, not a load.
    peak_pressure, contact_width, settlement:
        What is wanted: a number in the units of the problem, or text with a unit.
    pressure, zero, points:
        The pressure as an expression in ``x``, scaled to the force; where the heights count from; and at how many places they are told.
    audit:
        Whether the contacts found are audited.

    Raises
    ------
    ValueError
        For what cannot be reached, with what can, and for bad input.

    Examples
    --------
    >>> import shtaerman as st
    >>> flat = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="10*xi^2"), st.Load(force=1.0))
    >>> found = st.find("force", flat, contact_width=1.5)
    >>> round(found.contact.contact_width, 12)
    1.5
    """
    asked = problem_of(problem, keywords, "find")
    goals = {"peak_pressure": peak_pressure, "contact_width": contact_width, "settlement": settlement}
    given = {name: value for name, value in goals.items() if value is not None}
    if unknown in ("force", "roughness"):
        _only(unknown, {"pressure": pressure})
        return _value(unknown, asked, given, audit)
    if unknown == "crown":
        _only(unknown, {"pressure": pressure, "contact_width": contact_width, "settlement": settlement})
        best, least, largest, evaluations = engine.find_crown(asked._engine, peak_pressure, audit)
        rows = [None if row is None else _crowned(asked, row) for row in (best, least, largest)]
        assert rows[0] is not None
        return Crown(rows[0], rows[1], rows[2], evaluations)
    if unknown == "profile":
        _only(unknown, goals)
        return _shaped(asked, pressure, zero, points)
    raise ValueError(f"find(): must be 'force', 'roughness', 'crown' or 'profile', got {unknown!r}")


def _only(unknown: str, others: dict[str, Any]) -> None:
    for name, value in others.items():
        if value is not None:
            raise ValueError(f"find({unknown!r}): {name} does not belong here")


def _value(unknown: str, asked: Problem, given: dict[str, Quantity], audit: bool) -> Found:
    if len(given) != 1:
        raise ValueError(f"find({unknown!r}): needs one of peak_pressure, contact_width and settlement, got {len(given)}")
    ((goal, wanted),) = given.items()
    if not isinstance(wanted, str):
        wanted = finite(wanted, goal).item()
    value, goal_value, reached, error, solves, changes, contact = engine.find_value(asked._engine, unknown, goal, wanted, audit)
    known: dict[str, Any] = dict(changes)
    if "coefficient" in known:
        known = {"roughness": known}
    return Found(value, goal_value, reached, error, solves, Contact._of(asked.replace(**known), contact))


def _crowned(asked: Problem, row: tuple[float | None, str, engine.Contact]) -> Crowned:
    radius, profile, contact = row
    return Crowned(radius, profile, Contact._of(asked.replace(profile=profile), contact))


def _shaped(asked: Problem, pressure: str | None, zero: str, points: int) -> Shaped:
    if not isinstance(pressure, str):
        raise ValueError(f"find('profile'): pressure must be an expression in x, got {type(pressure).__name__}")
    if zero not in ("centre", "lowest"):
        raise ValueError(f"find('profile'): zero must be 'centre' or 'lowest', got {zero!r}")
    points = counted(points, "find('profile'): points")
    (x, heights, pressures), numbers = engine.find_profile(asked._engine, pressure, zero == "lowest", max(points, 3))
    return Shaped(x, heights, pressures, *numbers)
