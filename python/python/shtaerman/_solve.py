"""Solving in one call."""

from __future__ import annotations

from typing import Any

from ._contact import Contact
from ._problem import ProblemLike, problem_of


def solve(problem: ProblemLike | None = None, /, *, audit: bool = True, **keywords: Any) -> Contact:
    """Solves a contact problem.

    Parameters
    ----------
    problem:
        A :class:`Problem`, the path of a problem file, its text (of more than one line), or a dictionary with its tables and keys. Keywords then replace single values, as
        ``--set`` of the command line does. It may be left out: then the keywords are the problem.
    audit:
        Whether the answer is audited, as the command line does: its errors are then bounds from its own residual wherever there is an audit.
    **keywords:
        By the names of the problem file, each a number in SI units or text with a unit:

        - the foundation: ``young_modulus``, ``poisson_ratio``, ``roughness`` or ``subgrade_modulus``, ``grading_exponent``, ``grading_modulus``, ``thickness``,
          ``base``, ``coating``, ``yield_stress``;
        - the punch: ``half_width``, ``profile`` (flat where left out), ``geometry``, ``outer_half_width``, ``inner_half_gap``, ``period``, ``radius``, ``body``;
        - the load: ``force`` or ``settlement``, and ``moment``, ``eccentricity`` or ``tilt`` (central where left out);
        - the solver: ``contact``, ``method``, ``n``, ``tolerance``, ``time_limit``;
        - ``theta0`` or ``lambda0``, and ``exponent``, make the problem dimensionless.

        The profile is an expression in ``x``, an array of places with one of heights ``(x, f)``, a callable of an array of places, or a :class:`Profile`.

    Raises
    ------
    ValueError
        For bad input, with the text of the command line.
    ConvergenceError
        For a numerical promise that is not kept.

    Examples
    --------
    >>> import shtaerman as st
    >>> steel = dict(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa")
    >>> contact = st.solve(**steel, half_width="5 mm", profile="x^2 / (2*20)", force="0.8 MN/m")
    >>> round(contact.settlement, 11)
    2.97858e-06
    >>> st.solve(theta0=5.0, force=2.0).mean_pressure
    1.0
    """
    return problem_of(problem, keywords, "solve").solve(audit=audit)
