"""Solved contacts."""

from __future__ import annotations

import html
import json
import warnings
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _shtaerman as engine
from ._arrays import counted, each, finite, places
from ._problem import Problem
from ._profile import FloatArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__version__ = engine.__version__

#: Points of the pressure curve in the JSON answer, as on the command line.
_POINTS = 201


@dataclass(frozen=True, eq=False)
class Errors:
    """The errors of a contact, in its units; zero for what the load prescribes."""

    kind: str
    """``"bound"`` (guaranteed) or ``"estimate"``."""
    pressure: float
    """Largest error of the pressure on the closed base."""
    settlement: float
    """Error of the settlement."""
    tilt: float
    """Error of the tilt."""
    force: float
    """Error of the force."""
    moment: float
    """Error of the moment."""
    peak_pressure: float | None = None
    """Error of the largest pressure, where an audit bounds it."""
    zones: float | None = None
    """Error of the free ends of the zones."""
    stiffness: FloatArray | None = None
    """Errors of the entries of the tangent stiffness, where the method tells them."""

    def _values(self) -> tuple[object, ...]:
        # Arrays have no truth value of their own.
        stiffness = None if self.stiffness is None else self.stiffness.tobytes()
        return (*(getattr(self, field.name) for field in fields(self) if field.name != "stiffness"), stiffness)

    def __eq__(self, other: object) -> bool:
        return self._values() == other._values() if isinstance(other, Errors) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._values())


@dataclass(frozen=True)
class Audit:
    """What an audit found: the errors of an answer from its own residual."""

    kind: str
    """``"bound"``, ``"estimate"`` or ``"none"``."""
    reason: str
    """What it rests on, or why there is none."""
    error: Errors | None
    """The errors of the answer; those of the method where there is no audit."""
    mean_square: float | None = None
    """Error of ``p/E`` in the mean square over the base, where it is finite."""
    residual: float | None = None
    """Norm of the residual."""
    panels: int | None = None
    """Panels of the resampled pressure."""
    windows: int | None = None
    """Windows on which the residual was bounded."""


@dataclass(frozen=True)
class Method:
    """How an answer was found."""

    name: str
    """``"spectral"`` or ``"sinc"``."""
    n: int
    """Highest Chebyshev degree kept, or number of nodes."""
    reason: str
    """Why this method."""


@dataclass(frozen=True)
class Warned:
    """What a user should know about an answer."""

    code: str
    """Stable across releases, such as ``"negative_pressure"``."""
    message: str
    """One sentence with figures."""


@dataclass(frozen=True)
class Derivatives:
    """Derivatives of one quantity by what a problem prescribes; ``None`` for what it does not."""

    error: float
    """Largest estimated error, relative to the largest elasticity of the quantity (or to 1, if that is larger)."""
    roughness: float | None = None
    """By ``chi`` (m/Pa) or the coefficient ``B``."""
    young_modulus: float | None = None
    """By Young's modulus of the foundation (Pa); of graded ground by ``grading_modulus``."""
    theta0: float | None = None
    """By ``theta0`` of a dimensionless problem."""
    force: float | None = None
    """By the force (N/m), where it is prescribed."""
    settlement: float | None = None
    """By the settlement (m), where it is prescribed."""
    profile: float | None = None
    """By the logarithm of the scale of the profile: ``d/ds`` at ``s = 1`` for the base ``s f(x)``; from the linearised equation alone."""


@dataclass(frozen=True)
class Sensitivities:
    """How an answer changes with roughness, modulus and load; what ``held`` names stays as it is, and so do profile and geometry."""

    kind: str
    """Always ``"estimate"``."""
    held: str
    """``"moment"``, ``"eccentricity"`` or ``"tilt"``."""
    contact_width: Derivatives
    """Of the width of contact."""
    settlement: Derivatives | None = None
    """Of the settlement, where the force is prescribed."""
    force: Derivatives | None = None
    """Of the force, where the settlement is prescribed."""
    tilt: Derivatives | None = None
    """Of the tilt, where it is not prescribed."""
    peak_pressure: Derivatives | None = None
    """Of the largest pressure, where that is finite."""


@dataclass(frozen=True, eq=False)
class Stress:
    """Stresses below the surface at places, arrays of their shape, in the units of the contact; tension is positive."""

    sigma_x: Any
    """Along the surface."""
    sigma_y: Any
    """Into the body."""
    sigma_z: Any
    """Out of the plane."""
    tau_xy: Any
    """Shear in the plane."""
    von_mises: Any
    """Equivalent stress of von Mises."""
    max_shear: Any
    """Largest shear stress on any plane."""
    error: float
    """What the stresses may be off, where that is known from the error of the pressure."""


class Contact:
    """The answer: settlement, tilt, force, moment, zones and pressure of a contact.

    Quantities are in the units of the problem: SI, or numbers for a dimensionless problem. They have the names of the JSON answer of the command line, and its values to the
    last bit. A contact does not change, can be pickled and copied, and is made by :func:`solve` and :meth:`Problem.solve`.

    Examples
    --------
    >>> import shtaerman as st
    >>> contact = st.solve(young_modulus="200 GPa", poisson_ratio=0.3, roughness=1.2e-14, half_width="5 mm", force="0.8 MN/m")
    >>> contact.mean_pressure
    80000000.0
    >>> contact.peak_pressure_at
    -0.005
    >>> contact.error.kind
    'bound'
    >>> bool(contact.pressure([-5e-3, 0.0]).argmin())
    True
    """

    __slots__ = ("_engine", "_problem", "_stated")

    _engine: engine.Contact
    _problem: Problem
    #: The contact in the units of its problem; itself, but for numbers without dimensions of a physical problem.
    _stated: Contact

    def __init__(self) -> None:
        raise TypeError("a Contact is made by solve() or Problem.solve()")

    @classmethod
    def _of(cls, problem: Problem, solved: engine.Contact, stated: Contact | None = None) -> Contact:
        made = cls.__new__(cls)
        made._problem, made._engine = problem, solved
        made._stated = made if stated is None else stated
        return made

    @property
    def problem(self) -> Problem:
        """The problem solved, as it was stated."""
        return self._problem

    @property
    def settlement(self) -> float:
        """Settlement ``delta`` (m), in the gauge of the problem."""
        return self._engine.settlement

    @property
    def tilt(self) -> float:
        """Tilt ``alpha`` (rad); a positive moment gives a negative one."""
        return self._engine.tilt

    @property
    def force(self) -> float:
        """Force ``P`` (N/m; N under a circular punch)."""
        return self._engine.force

    @property
    def moment(self) -> float:
        """Moment ``M = int x p dx`` (N m/m; N m under a circular punch)."""
        return self._engine.moment

    @property
    def pressure_left(self) -> float:
        """Pressure at the left edge of the punch (Pa), 0 where it lifted."""
        return self._engine.pressure_left

    @property
    def pressure_middle(self) -> float:
        """Pressure in the middle (Pa)."""
        return self._engine.pressure_middle

    @property
    def pressure_right(self) -> float:
        """Pressure at the right edge of the punch (Pa), 0 where it lifted."""
        return self._engine.pressure_right

    @property
    def mean_pressure(self) -> float:
        """Force over the length of the base, or the area of a circular one (Pa)."""
        return self._engine.mean_pressure

    @property
    def peak_pressure(self) -> float:
        """The largest pressure (Pa); infinite at the corners of a smooth surface."""
        return self._engine.peak_pressure

    @property
    def peak_pressure_at(self) -> float:
        """Its place (m); of equal ones the leftmost, of -r and r under a circular punch, which are one, either."""
        return self._engine.peak_pressure_at

    @property
    def contact_width(self) -> float:
        """Width of all zones together (m)."""
        return self._engine.contact_width

    @property
    def theta0(self) -> float:
        """``2 a/(pi E* chi)``."""
        return self._engine.theta0

    @property
    def stiffness(self) -> FloatArray:
        """Tangent stiffness ``d(P, M)/d(delta, -alpha)``, an array of shape (2, 2); of a wave infinite against tilt, and ``nan`` where a change of its moment is not found."""
        return np.array(self._engine.stiffness)

    @property
    def zones(self) -> FloatArray:
        """Zones of contact from left to right (m), an array of shape (zones, 2)."""
        return np.array(self._engine.zones).reshape(-1, 2)

    @property
    def tension(self) -> FloatArray:
        """Where the pressure of a bilateral contact is negative (m), an array of shape (intervals, 2)."""
        return np.array(self._engine.tension).reshape(-1, 2)

    @property
    def gauge(self) -> str:
        """What the settlement is measured against."""
        return self._problem.gauge

    @property
    def method(self) -> Method:
        """How it was solved."""
        return Method(*self._engine.method)

    @property
    def warnings(self) -> list[Warned]:
        """What a user should know."""
        return [Warned(**warning) for warning in json.loads(self._engine.warnings)]

    @property
    def error(self) -> Errors | None:
        """The errors of the answer: those of its audit where it was audited, or those that the method states; ``None`` where it states none."""
        return _errors(self._engine)

    @property
    def relative_error(self) -> float:
        """The largest error relative to its size; infinite where nothing is stated."""
        return self._engine.relative_error

    @property
    def is_audited(self) -> bool:
        """Whether an audit was made, with or without result."""
        return self._engine.audited_by is not None

    def audit(self) -> Audit:
        """The audit of the answer: that of the solve, or made now.

        Raises
        ------
        ConvergenceError
            Where the audit finds the answer wrong, or a prescribed tolerance not kept.
        """
        audited = self._engine if self.is_audited else self._engine.audited()
        found = audited.audited_by
        assert found is not None
        kind, reason, figures = found
        known = json.loads(figures) if figures else {}
        kept = {name: known.get(name) for name in ("mean_square", "residual", "panels", "windows")}
        return Audit(kind, reason, _errors(audited), **kept)

    @property
    def sensitivities(self) -> Sensitivities:
        """Derivatives of the answer, from its linearised equation, or where there is none from differences of some more solves."""
        found = self._engine.sensitivities(True)
        assert found is not None
        return _sensitivities(json.loads(found))

    @property
    def dimensionless(self) -> Contact:
        """The same contact in numbers without dimensions: lengths in half-widths, pressures in Young's modulus. Itself for a dimensionless problem."""
        if self._problem.is_dimensionless or self._stated is not self:
            return self
        return Contact._of(self._problem, self._engine.dimensionless(), self)

    def pressure(self, x: Any) -> Any:
        """Pressure ``p(x)`` (Pa) at places of the closed base, an array of their shape; 0 outside the zones.

        Raises
        ------
        ValueError
            For a place beyond the base, also for NaN.
        """
        return each(self._engine.pressure, x)

    def displacement(self, x: Any) -> Any:
        """Elastic displacement of the surface (m) at any places, an array of their shape; positive into the body, without the layer, in the gauge of the settlement.

        Raises
        ------
        ValueError
            For a place that is NaN or infinite.
        """
        finite(x)
        return each(self._engine.displacement, x)

    def gap(self, x: Any) -> Any:
        """Gap between base and body (m) at places of the closed base, an array of their shape; 0 in the zones of contact.

        Raises
        ------
        ValueError
            For a place beyond the base, also for NaN.
        """
        return each(self._engine.gap, x)

    def stress(self, x: Any, z: Any, *, poisson_ratio: float | None = None) -> Stress:
        """Stresses at places ``x`` and depths ``z`` (m), which are broadcast against each other; plane homogeneous bodies only.

        Parameters
        ----------
        poisson_ratio:
            That of the foundation where left out; a dimensionless problem needs it.

        Raises
        ------
        ValueError
            For a body whose stresses are not known, and a depth above the surface.
        """
        one, other = places(x), places(z, "z")
        try:
            across, down = np.broadcast_arrays(one, other)
        except ValueError:
            raise ValueError(f"stress(): the shapes of x and z do not go together: {one.shape} and {other.shape}") from None
        if poisson_ratio is not None:
            poisson_ratio = finite(poisson_ratio, "poisson_ratio").item()
        parts, error = self._engine.stress(across.ravel(), down.ravel(), poisson_ratio)
        is_single = across.ndim == 0
        shaped = [float(part[0]) if is_single else part.reshape(across.shape) for part in parts]
        return Stress(**dict(zip(_STRESSES, shaped, strict=True)), error=error)

    def to_json(self, points: int = _POINTS, at: Any = None) -> str:
        """The answer of ``shtaerman solve --format json``, byte for byte: with the pressure at ``points`` places, or ``at`` places of one's own."""
        return self._stated._engine.to_json(counted(points), None if at is None else places(at, "at").ravel())

    def to_dict(self, points: int = _POINTS, at: Any = None) -> dict[str, Any]:
        """The answer of ``shtaerman solve --format json`` as a dictionary."""
        found: dict[str, Any] = json.loads(self.to_json(points, at))
        return found

    def to_svg(self) -> str:
        """The picture of ``shtaerman solve --plot``."""
        return self._stated._engine.svg()

    def plot(self, *, points: int = 401) -> Figure:
        """Draws pressure and surfaces with matplotlib, which must be installed, and returns the figure."""
        from ._plot import contact_figure

        return contact_figure(self, points)

    def __repr__(self) -> str:
        units = ("", "", "") if self._is_bare else (" N/m", " m", " Pa")
        if units[0] and self._problem.is_circular:
            units = (" N", *units[1:])
        return (
            f"<Contact: force {self.force:.6g}{units[0]}, settlement {self.settlement:.6g}{units[1]}, "
            f"peak pressure {self.peak_pressure:.6g}{units[2]}>"
        )

    def _repr_html_(self) -> str:
        def shown(name: str, digits: str, value: float) -> str:
            units = _SHOWN[name]
            unit = "" if self._is_bare else units[1 if self._problem.is_circular else 0]
            return f"{value:{digits}} {unit}".rstrip()

        rows = [(name.replace("_", " "), shown(name, ".6g", getattr(self, name))) for name in _SHOWN]
        error = self.error
        if error is not None:
            rows.append((f"error of the pressure ({error.kind})", shown("mean_pressure", ".2g", error.pressure)))
            rows.append((f"error of the settlement ({error.kind})", shown("settlement", ".2g", error.settlement)))
        cells = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>" for name, value in rows)
        notes = "".join(f"<p>{html.escape(warning.message)}</p>" for warning in self.warnings)
        picture = self.to_svg()
        picture = picture[picture.index("<svg") :]
        return f"<div>{picture}<table>{cells}</table>{notes}</div>"

    @property
    def _is_bare(self) -> bool:
        return self._problem.is_dimensionless or self._stated is not self

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._problem, __version__, self.is_audited, self._stated is not self)

    def __copy__(self) -> Contact:
        return self

    def __deepcopy__(self, memo: object) -> Contact:
        return self


#: Parts of a stress as they are computed.
_STRESSES = ("sigma_x", "sigma_y", "sigma_z", "tau_xy", "von_mises", "max_shear")
#: What the card of a notebook shows, with the units of a plane and of a circular punch.
_SHOWN = {
    "settlement": ("m", "m"),
    "tilt": ("rad", "rad"),
    "force": ("N/m", "N"),
    "moment": ("N m/m", "N m"),
    "mean_pressure": ("Pa", "Pa"),
    "peak_pressure": ("Pa", "Pa"),
    "peak_pressure_at": ("m", "m"),
    "contact_width": ("m", "m"),
}


def _restored(problem: Problem, version: str, is_audited: bool, is_bare: bool) -> Contact:
    """A pickled contact: solved again, which gives the same bits in the same version."""
    if version != __version__:
        message = f"this contact was solved by version {version}, and is solved again by {__version__}: digits may differ within its errors"
        warnings.warn(message, stacklevel=2)
    contact = problem.solve(audit=is_audited)
    return contact.dimensionless if is_bare else contact


def _errors(solved: engine.Contact) -> Errors | None:
    found = solved.error
    if found is None:
        return None
    kind, text = found
    known = json.loads(text)
    if known.get("stiffness") is not None:
        known["stiffness"] = np.array(known["stiffness"], dtype=np.float64)
    return Errors(kind, **known)


def _sensitivities(known: dict[str, Any]) -> Sensitivities:
    parts: dict[str, Any] = {name: Derivatives(**part) if isinstance(part, dict) else part for name, part in known.items()}
    return Sensitivities(**parts)
