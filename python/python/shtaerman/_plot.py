"""Pictures with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._arrays import counted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ._contact import Contact

#: How far beside the punch the surface is drawn, in half-widths.
_BESIDE = 0.6


def contact_figure(contact: Contact, points: int) -> Figure:
    """Pressure above, base and deformed surface below."""
    try:
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError("plot() needs matplotlib: pip install 'shtaerman[plot]', or use to_svg()") from error
    points = counted(points)
    is_bare = contact._is_bare
    half_width = 1.0 if is_bare else contact.problem.half_width
    # Dense at the edges, where the pressure changes most; the edges themselves are exact.
    base = half_width * np.sin(0.5 * np.pi * np.linspace(-1.0, 1.0, points))
    base[0], base[-1] = -half_width, half_width
    pressure = np.asarray(contact.pressure(base))
    wide = np.linspace(-half_width * (1.0 + _BESIDE), half_width * (1.0 + _BESIDE), 2 * points)
    surface = np.asarray(contact.displacement(wide))
    stated = contact if is_bare is contact.problem.is_dimensionless else contact._stated
    x_label, p_label, d_label = ("x/a", "p/E", "depth/(chi E)") if is_bare else ("x [m]", "p [Pa]", "depth [m]")
    figure = Figure(figsize=(7.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    above.plot(base, np.where(np.isfinite(pressure), pressure, np.nan))
    for left, right in contact.zones:
        above.axvspan(left, right, alpha=0.08)
    above.set_ylabel(p_label)
    below.plot(wide, surface, label="surface, without the layer")
    if stated is contact:
        depth = contact.settlement - contact.tilt * base - np.asarray(contact.problem.height(base))
        below.plot(base, depth, label="base of the punch")
    below.invert_yaxis()
    below.set_xlabel(x_label)
    below.set_ylabel(d_label)
    below.legend()
    return figure
