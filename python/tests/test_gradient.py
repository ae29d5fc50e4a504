"""Derivatives against differences, and solves that they lead to."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import shtaerman as st

PHYSICAL: dict[str, Any] = {
    "young_modulus": 200e9,
    "poisson_ratio": 0.3,
    "roughness": 1.2e-13,
    "half_width": 5e-3,
    "profile": "x^2/1.6",
    "force": 4e5,
    "eccentricity": 1e-4,
}


@pytest.mark.parametrize("output", ["settlement", "tilt", "peak_pressure", "contact_width"])
def test_derivatives_are_those_of_the_answer(output: str) -> None:
    names = ["roughness", "young_modulus", "force", "profile"]
    value, gradient = st.value_and_gradient(None, output, names, **PHYSICAL)
    assert value == getattr(st.solve(**PHYSICAL, audit=False), output)

    def at(name: str, factor: float) -> float:
        changed = {"profile": f"{factor!r}*x^2/1.6"} if name == "profile" else {name: PHYSICAL[name] * factor}
        return float(getattr(st.solve(**{**PHYSICAL, **changed}, audit=False), output))

    h = 1e-3
    for name, derivative in zip(names, gradient):
        central = [(at(name, 1 + k * h) - at(name, 1 - k * h)) / (2 * k * h) for k in (1, 2)]
        expected = (4 * central[0] - central[1]) / 3
        size = 1.0 if name == "profile" else PHYSICAL[name]
        # What the differences leave, h^4 and the rounding of a solve over h.
        assert derivative * size == pytest.approx(expected, abs=1e-8 * max(abs(value), abs(expected))), name


def test_a_contact_serves_as_well_and_tells_what_it_has_not() -> None:
    contact = st.solve(theta0=5.0, profile="10*xi^2", settlement=3.0)
    value, gradient = st.value_and_gradient(contact, "force", ["settlement", "theta0"])
    assert value == contact.force
    assert gradient[0] == pytest.approx(contact.stiffness[0, 0], rel=1e-9)
    assert st.value_and_gradient(contact, "force", [])[1].shape == (0,)
    for output, names, said in [
        ("settlement", ["theta0"], "no derivatives"),
        ("force", ["roughness"], "roughness"),
        ("force", ["force"], "does not prescribe"),
        ("force", ["weight"], "must be one of"),
        ("area", ["theta0"], "must be one of"),
        ("force", "theta0", "a list of names"),
    ]:
        with pytest.raises(ValueError, match=said):
            st.value_and_gradient(contact, output, names)
    with pytest.raises(ValueError, match="keywords"):
        st.value_and_gradient(contact, "force", ["theta0"], force=1.0)


def test_a_force_is_found_as_by_newton() -> None:
    problem = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="10*xi^2"), st.Load(force=1.0))
    wanted, force = 1.5, 1.0
    for _ in range(8):
        width, slope = st.value_and_gradient(problem.replace(force=force), "contact_width", ["force"])
        force += (wanted - width) / slope[0]
    assert st.find("force", problem, contact_width=wanted).value == pytest.approx(force, rel=1e-9)


@pytest.mark.parametrize(
    ("unknown", "keywords", "said"),
    [
        ("force", {}, "needs one of"),
        ("force", {"peak_pressure": 1.0, "contact_width": 1.0}, "got 2"),
        ("force", {"peak_pressure": -1.0}, "peak pressure|greater"),
        ("force", {"contact_width": 5.0}, "contact width"),
        ("force", {"contact_width": "5 mm"}, "contact_width `5 mm`"),
        ("crown", {"contact_width": 1.0}, "does not belong"),
        ("profile", {}, "expression"),
        ("profile", {"pressure": "1", "points": 1}, "points"),
        ("profile", {"pressure": "xi^", "points": 5}, "pressure"),
        ("weight", {}, "must be"),
    ],
)
def test_find_refuses(unknown: Any, keywords: dict[str, Any], said: str) -> None:
    problem = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="10*xi^2"), st.Load(force=1.0))
    with pytest.raises(ValueError, match=said):
        st.find(unknown, problem, **keywords)


def test_a_prescribed_pressure_comes_out() -> None:
    problem = st.Problem(st.Foundation(theta0=3.0), st.Punch(), st.Load(force=2.0))
    shaped = st.find("profile", problem, pressure="2 - xi^2", points=401)
    contact = st.solve(theta0=3.0, profile=(shaped.x, shaped.profile), force=2.0)
    x = np.linspace(-0.95, 0.95, 21)
    assert contact.pressure(x) == pytest.approx(shaped.factor * (2 - x**2), rel=1e-6)
