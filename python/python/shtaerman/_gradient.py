"""Derivatives for optimisers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ._contact import Contact
from ._problem import ProblemLike, problem_of
from ._profile import FloatArray

_OUTPUTS = ("settlement", "force", "tilt", "peak_pressure", "contact_width")
_PARAMETERS = ("roughness", "young_modulus", "theta0", "force", "settlement", "profile")


def value_and_gradient(
    problem: ProblemLike | Contact | None,
    output: str,
    with_respect_to: Sequence[str],
    **keywords: Any,
) -> tuple[float, FloatArray]:
    """The value of an output and its derivatives, from the linearised equation: exact up to their errors, for little more than one solve.

    Parameters
    ----------
    problem:
        As in :func:`solve`, with its keywords; or a contact that was solved already.
    output:
        ``"settlement"`` (where the force is prescribed), ``"force"`` (where the settlement is), ``"tilt"``, ``"peak_pressure"`` or ``"contact_width"``.
    with_respect_to:
        Names of parameters: ``"roughness"`` (``chi`` or ``B``), ``"young_modulus"`` (of graded ground the derivative by its ``grading_modulus``), ``"theta0"`` of a dimensionless problem, the prescribed ``"force"`` or ``"settlement"``, and
        ``"profile"``: the logarithm of the scale of the profile, ``d/ds`` at ``s = 1`` for the base ``s f(x)``. For the crown ``x^2/(2 R)`` that is ``-R d/dR``.

    Returns
    -------
    tuple
        The value, and an array of derivatives in the order of ``with_respect_to``. What they may be off is in :attr:`Contact.sensitivities`.

    Raises
    ------
    ValueError
        For an output or a parameter that the problem has not.

    Examples
    --------
    >>> import shtaerman as st
    >>> problem = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="10*xi^2"), st.Load(force=2.0))
    >>> peak, gradient = st.value_and_gradient(problem, "peak_pressure", ["profile", "force"])
    >>> gradient.shape
    (2,)
    """
    if output not in _OUTPUTS:
        raise ValueError(f"value_and_gradient(): the output must be one of {', '.join(_OUTPUTS)}, got {output!r}")
    if isinstance(with_respect_to, str):
        raise ValueError(f"value_and_gradient(): with_respect_to must be a list of names, got {with_respect_to!r}")
    if isinstance(problem, Contact):
        if keywords:
            raise ValueError("value_and_gradient(): keywords do not go with a contact that is solved")
        contact = problem
    else:
        contact = problem_of(problem, keywords, "value_and_gradient").solve(audit=False)
    found = contact.sensitivities
    derivatives = getattr(found, output)
    if derivatives is None:
        raise ValueError(f"value_and_gradient(): the {output.replace('_', ' ')} has no derivatives here: it is prescribed, or infinite")
    gradient = []
    for name in with_respect_to:
        if name not in _PARAMETERS:
            raise ValueError(f"value_and_gradient(): a parameter must be one of {', '.join(_PARAMETERS)}, got {name!r}")
        derivative = getattr(derivatives, name)
        if derivative is None:
            raise ValueError(f"value_and_gradient(): there is no derivative by {name!r}: {_absent(name)}")
        gradient.append(derivative)
    return float(getattr(contact, output)), np.array(gradient, dtype=np.float64)


def _absent(name: str) -> str:
    if name == "profile":
        return "the linearised equation gives none here (panels, coatings)"
    if name == "theta0":
        return "it belongs to dimensionless problems"
    if name in ("force", "settlement"):
        return "the problem does not prescribe it"
    return "the problem has none"
