"""Equations against closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import shtaerman as st


def test_the_first_kind_of_the_logarithm() -> None:
    """int ln(1/|x-s|) phi ds = T_2(x) on [-1, 1]: phi = 2 T_2/(pi sqrt(1 - x^2))."""
    x = np.linspace(-0.9, 0.9, 19)
    found = st.equation(kind="first", kernel="log", a=1.0, rhs="2*x^2 - 1", at=x)
    assert found.phi == pytest.approx(2 * (2 * x**2 - 1) / (math.pi * np.sqrt(1 - x**2)), rel=1e-9, abs=1e-10)
    ends = st.equation(kind="first", kernel="log", a=1.0, rhs="2*x^2 - 1", at=[[-1.0], [1.0]])
    assert ends.phi.shape == (2, 1) and np.isinf(ends.phi).all()


def test_the_second_kind_contains_the_rough_flat_punch() -> None:
    """phi + theta0 int ln(1/|x-s|) phi = delta0 is the dimensionless contact of a flat punch."""
    contact = st.solve(theta0=4.0, settlement=1.0, tilt=0.0)
    found = st.equation(kind="second", lambda_=4.0, kernel="log", a=1.0, rhs=1.0, points=21)
    assert found.phi == pytest.approx(contact.pressure(found.x), rel=1e-9)
    assert found.integral == pytest.approx(contact.force, rel=1e-10)
    assert found.error.kind in ("bound", "estimate") and found.error.solution_sup is not None


def test_eigenvalues_of_the_logarithm() -> None:
    """Of ln(1/|x-s|) with the weight 1/sqrt(1-x^2): pi ln 2, pi/n."""
    found = st.spectrum("log", a=1.0, count=6, verify=True)
    assert found.eigenvalue == pytest.approx([math.pi * math.log(2), *(math.pi / n for n in range(1, 6))], rel=1e-13)


@pytest.mark.parametrize(
    ("keywords", "said"),
    [
        ({}, "equation"),
        ({"kind": "third", "rhs": "1", "kernel": "log", "a": 1.0}, "kind"),
        ({"kind": "second", "rhs": "1", "kernel": "log", "a": 1.0}, "lambda"),
        ({"kind": "first", "rhs": "1", "kernel": "lag", "a": 1.0}, "log"),
        ({"kind": "first", "rhs": "1", "kernel": "log", "b": 1.0}, "kernel"),
        ({"kind": "first", "rhs": "y", "kernel": "log", "a": 1.0}, "rhs"),
        ({"kind": "first", "rhs": "1", "kernel": "log", "a": 1.0, "at": [2.0]}, "beyond"),
        ({"kind": "first", "rhs": "1", "kernel": "log", "a": 1.0, "points": 1}, "points"),
    ],
)
def test_what_is_no_equation(keywords: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.equation(**keywords)


def test_options_of_spectra_and_roughness_are_checked() -> None:
    for call in (
        lambda: st.spectrum("lag", a=1.0),
        lambda: st.spectrum("log"),
        lambda: st.spectrum("--help"),
        lambda: st.spectrum("log", a=1.0, what=1.0),
        lambda: st.spectrum("log", a=-1.0),
        lambda: st.roughness("gw", deviation="0.5 kg", density=1e10, radius=1e-5, modulus=1e11, pressure=1e8),
        lambda: st.roughness("gw", deviation=None, density=1e10),  # type: ignore[arg-type]
        lambda: st.roughness("gw", deviation=[1.0]),  # type: ignore[arg-type]
        lambda: st.roughness("table", "no such file.csv"),
    ):
        with pytest.raises(ValueError) as caught:
            call()
        assert str(caught.value) and not str(caught.value).startswith("error:")


def test_numbers_serve_for_text() -> None:
    text = st.roughness("gw", deviation="0.5 um", density="1e4 1/mm^2", radius="10 um", modulus="110 GPa", pressure="80 MPa")
    numbers = st.roughness("gw", deviation=0.5e-6, density=np.float64(1e10), radius=1e-5, modulus=110e9, pressure=80e6)
    assert numbers["roughness"] == pytest.approx(text["roughness"], rel=1e-14)
