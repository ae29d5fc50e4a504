"""The rough layer, or the whole contact, for finite-element programs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from . import _document as document
from . import _shtaerman as engine
from ._parts import Quantity
from ._problem import ProblemLike, problem_of

_PROGRAMS = ("abaqus", "calculix")
_CONTENTS = ("surface", "force", "moment")
_UNITS = ("si", "mm")


def export(
    program: str,
    problem: ProblemLike | None = None,
    /,
    *,
    content: str | Sequence[str] = "surface",
    units: str = "si",
    share: float | None = None,
    reach: float | None = None,
    load_factor: float | None = None,
    moment_share: float | None = None,
    length: Quantity | None = None,
    datum_distance: Quantity | None = None,
    datum_depth: Quantity | None = None,
    **keywords: Any,
) -> str:
    """Tables that a finite-element program reads, as ``shtaerman export`` writes them: the same text to the last byte.

    Parameters
    ----------
    program:
        ``"abaqus"`` or ``"calculix"``.
    problem, **keywords:
        As in :func:`solve`.
    content:
        ``"surface"``, the rough layer as pressure against overclosure; ``"force"`` and ``"moment"``, the whole contact as springs; or a list of them.
    units:
        Of the model: ``"si"`` (N, m, Pa) or ``"mm"`` (N, mm, MPa).
    share:
        What straight lines between the points may be off by, and what the penalty may take of the settlement; 0.001 where left out.
    reach:
        Largest pressure of the table over that of the contact; 10 where left out.
    load_factor, moment_share:
        Largest force of the force curve over that of the problem (1), and largest moment over ``P a`` (0.5).
    length:
        Of a plane punch out of the plane, for forces and moments; the unit of length where left out.
    datum_distance, datum_depth:
        Where the settlement is counted from: the surface at this ``x``, or the point at this depth under the middle.

    Returns
    -------
    str
        The text of an input file, to be written as it is: ``Path("rough.inp").write_text(text)``.

    Raises
    ------
    ValueError
        For what has no table, with the text of the command line.
    ConvergenceError
        Where a contact is not found.

    Examples
    --------
    >>> import shtaerman as st
    >>> text = st.export("calculix", young_modulus="200 GPa", poisson_ratio=0.3, roughness=1.2e-14, half_width="5 mm", force="0.8 MN/m", units="mm")
    >>> "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR" in text.splitlines()
    True
    """
    contents = [content] if isinstance(content, str) else list(content)
    for name, given, known in (("program", [program], _PROGRAMS), ("content", contents, _CONTENTS), ("units", [units], _UNITS)):
        for word in given:
            if word not in known:
                raise ValueError(f"export(): {name} must be one of {', '.join(known)}, got {word!r}")
    if not contents:
        raise ValueError(f"export(): content must name at least one of {', '.join(_CONTENTS)}")
    if datum_distance is not None and datum_depth is not None:
        raise ValueError("export(): give datum_distance or datum_depth, not both")
    asked = problem_of(problem, keywords, "export")
    options = {
        "content": ",".join(contents),
        "units": units,
        "share": share,
        "reach": reach,
        "load_factor": load_factor,
        "moment_share": moment_share,
        "length": length,
        "datum_distance": datum_distance,
        "datum_depth": datum_depth,
    }
    # The name, which the text has, may look like an option.
    arguments = ["export", *document.options(options, "export"), "--", program, asked._name]
    try:
        return engine.export_text(asked._engine, arguments)
    except ValueError as error:
        raise ValueError(document.without_usage(str(error))) from None
