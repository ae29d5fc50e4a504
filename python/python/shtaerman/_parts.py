"""Foundation, punch, load and solver: the tables of a problem file as objects."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._profile import Profile

#: A number in SI units (in a dimensionless problem a number), or text with a unit such as ``"5 mm"``.
Quantity: TypeAlias = float | str
#: A base: an expression such as ``"x^2 / 40"``, a constant height, places with heights ``(x, f)``, a smooth callable, a :class:`Profile`, or the table of a CSV file.
ProfileLike: TypeAlias = (
    float | str | Profile | Callable[[npt.NDArray[np.float64]], npt.ArrayLike] | Sequence[npt.ArrayLike] | Mapping[str, Any]
)


class _Part:
    """What has the keys of a table as attributes."""

    def keywords(self) -> dict[str, Any]:
        """What was given, by the names of the problem file."""
        given = ((field.name, getattr(self, field.name)) for field in fields(self))  # type: ignore[arg-type]
        return {name: value for name, value in given if value is not None}


@dataclass(frozen=True, kw_only=True)
class Foundation(_Part):
    """The body under the punch: its elastic material and what its rough surface gives.

    The names are those of ``[foundation]`` in a problem file. ``theta0`` or ``lambda0`` makes the problem dimensionless: lengths are then in half-widths,
    pressures in Young's modulus. What does not go together is refused by :class:`Problem`.

    Examples
    --------
    >>> import shtaerman as st
    >>> steel = st.Foundation(young_modulus="200 GPa", poisson_ratio=0.3, roughness=1.2e-14)
    >>> bare = st.Foundation(theta0=5.0)
    """

    young_modulus: Quantity | None = None
    """``E`` (Pa)."""
    poisson_ratio: float | None = None
    """``nu``, greater than -1 and at most 0.5."""
    roughness: Quantity | Mapping[str, Any] | None = None
    """``chi`` (m/Pa), 0 for a smooth surface; or ``{"coefficient": B, "exponent": kappa}`` of the law ``B p^kappa``."""
    subgrade_modulus: Quantity | None = None
    """``1/chi`` (Pa/m), in place of the roughness."""
    yield_stress: Quantity | None = None
    """Yield stress (Pa), for stresses below the surface."""
    grading_exponent: float | None = None
    """``mu`` of ``E = E0 y^mu``."""
    grading_modulus: Quantity | None = None
    """``E0`` (Pa), the modulus at the depth of 1 m."""
    thickness: Quantity | None = None
    """Thickness of a layer on a rigid base (m)."""
    base: str | None = None
    """``"bonded"`` or ``"frictionless"``: how that layer lies on its base."""
    coating: Mapping[str, Any] | None = None
    """``thickness``, ``young_modulus`` and ``poisson_ratio`` of a coating."""
    theta0: float | None = None
    """``2 a/(pi E* chi)`` of a dimensionless problem."""
    lambda0: float | None = None
    """``a/(E chi)`` of a dimensionless problem, with ``poisson_ratio``."""
    exponent: float | None = None
    """``kappa`` of the law of the layer, in a dimensionless problem."""


@dataclass(frozen=True, kw_only=True)
class Punch(_Part):
    """The body that is pressed on the foundation: where it stands, its base, and what it is made of.

    The names are those of ``[punch]`` in a problem file, with the table ``body``. A base that is not given is flat.

    Examples
    --------
    >>> import shtaerman as st
    >>> crowned = st.Punch(half_width="5 mm", profile="x^2 / (2*0.8)")
    >>> the_same = st.Punch(half_width=5e-3, profile=lambda x: x**2 / 1.6)
    """

    half_width: Quantity | None = None
    """``a`` (m); left out in a dimensionless problem."""
    profile: ProfileLike | None = None
    """The base ``f(x)`` (m), positive away from the body."""
    geometry: str | None = None
    """``"plane"``, ``"pair"``, ``"periodic"`` or ``"circular"``."""
    outer_half_width: Quantity | None = None
    """Of a pair (m)."""
    inner_half_gap: Quantity | None = None
    """Of a pair (m)."""
    period: Quantity | None = None
    """Of a periodic row (m)."""
    radius: Quantity | None = None
    """Of a circular punch (m)."""
    body: Mapping[str, Any] | None = None
    """``young_modulus`` and ``poisson_ratio`` of an elastic punch; a rigid one has none."""


@dataclass(frozen=True, kw_only=True)
class Load(_Part):
    """What is prescribed: force or settlement, and moment, eccentricity or tilt; without one of these the load is central.

    Compression is positive, and a positive moment gives a negative tilt.

    Examples
    --------
    >>> import shtaerman as st
    >>> eccentric = st.Load(force="0.8 MN/m", eccentricity="0.1 mm")
    """

    force: Quantity | None = None
    """``P`` (N/m; N under a circular punch)."""
    settlement: Quantity | None = None
    """``delta`` (m), in the gauge of the problem."""
    moment: Quantity | None = None
    """``M = int x p dx`` (N m/m; N m under a circular punch)."""
    eccentricity: Quantity | None = None
    """``e`` (m), for ``M = P e``."""
    tilt: Quantity | None = None
    """``alpha`` (rad); 0 keeps the punch level."""


@dataclass(frozen=True, kw_only=True)
class Solver(_Part):
    """How the problem is to be solved, where that matters.

    Examples
    --------
    >>> import shtaerman as st
    >>> kept_in_contact = st.Solver(contact="bilateral", tolerance=1e-9)
    """

    contact: str | None = None
    """``"unilateral"`` (the punch may lift off) or ``"bilateral"``."""
    method: str | None = None
    """``"auto"``, ``"spectral"`` or ``"sinc"``."""
    n: int | None = None
    """Highest Chebyshev degree kept in the degenerate kernel."""
    tolerance: float | None = None
    """Relative error to be met, or :class:`ConvergenceError` is raised."""
    time_limit: Quantity | None = None
    """How long a solve may take (s), or :class:`ConvergenceError` is raised."""
