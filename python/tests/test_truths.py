"""Closed forms and invariants that hold whatever the program does."""

from __future__ import annotations

import math

import numpy as np
import pytest

import shtaerman as st

E, NU = 200e9, 0.3
E_STAR = E / (1 - NU**2)


def test_hertz_of_a_cylinder_on_a_smooth_plane() -> None:
    radius, force = 0.4, 2e5
    contact = st.solve(young_modulus=E, poisson_ratio=NU, roughness=0, half_width=5e-3, profile=f"x^2/(2*{radius})", force=force)
    half = math.sqrt(4 * force * radius / (math.pi * E_STAR))
    peak = 2 * force / (math.pi * half)
    assert half < 5e-3
    assert contact.zones == pytest.approx(np.array([[-half, half]]), rel=1e-11)
    assert contact.peak_pressure == pytest.approx(peak, rel=1e-11)
    x = np.linspace(-0.99, 0.99, 41) * half
    assert contact.pressure(x) == pytest.approx(peak * np.sqrt(1 - (x / half) ** 2), rel=1e-9)
    # Below the middle: sigma_x = -p0 [(1 + 2 t^2)/sqrt(1 + t^2) - 2 t], sigma_y = -p0/sqrt(1 + t^2), t = z/b.
    t = np.array([0.1, 0.5, 0.786, 1.0, 2.0])
    stress = contact.stress(0.0, t * half)
    root = np.sqrt(1 + t**2)
    assert stress.sigma_y == pytest.approx(-peak / root, rel=1e-8)
    assert stress.sigma_x == pytest.approx(-peak * ((1 + 2 * t**2) / root - 2 * t), rel=1e-7)
    assert stress.sigma_z == pytest.approx(NU * (stress.sigma_x + stress.sigma_y), rel=1e-12)


def test_a_smooth_flat_punch() -> None:
    contact = st.solve(young_modulus=E, poisson_ratio=NU, roughness=0, half_width=5e-3, force=1e6)
    x = np.linspace(-4.9e-3, 4.9e-3, 31)
    assert contact.pressure(x) == pytest.approx(1e6 / (math.pi * np.sqrt(25e-6 - x**2)), rel=1e-11)
    assert contact.peak_pressure == math.inf
    # In the gauge ln(a/|x-s|): int ln(a/|x-s|)/(pi sqrt(a^2-s^2)) ds = ln 2.
    assert contact.settlement == pytest.approx(2 * 1e6 * math.log(2) / (math.pi * E_STAR), rel=1e-12)


def test_the_layer_alone() -> None:
    """theta0 = 0: p0 = delta0 - f0 where that is positive."""
    contact = st.solve(theta0=0.0, profile="xi^2", settlement=0.25)
    xi = np.linspace(-1, 1, 41)
    assert contact.pressure(xi) == pytest.approx(np.maximum(0.25 - xi**2, 0.0), abs=1e-14)
    assert contact.force == pytest.approx(4 / 3 * 0.5**3, rel=1e-13)


@pytest.mark.parametrize(
    "stated",
    [
        {"theta0": 3.0, "profile": "2*xi^2 + 0.3*xi^3", "force": 1.5, "moment": 0.2},
        {"theta0": 20.0, "profile": "cos(3*xi)", "force": 4.0, "tilt": 0.1},
        {"theta0": 1.0, "profile": "abs(xi)", "force": 0.5, "eccentricity": 0.1, "exponent": 0.5},
    ],
)
def test_the_pressure_carries_the_load_and_solves_the_equation(stated: dict[str, object]) -> None:
    contact = st.solve(**stated)
    # Between the ends of zones and kinks: x = c + h sin(pi t/2) takes the roots at free ends away.
    nodes, weights = np.polynomial.legendre.leggauss(200)
    force = moment = 0.0
    for left, right in contact.zones:
        cuts = [left, *(at for at in contact.problem._engine.breakpoints() if left < at < right), right]
        for one, two in zip(cuts[:-1], cuts[1:]):
            x = 0.5 * (one + two) + 0.5 * (two - one) * np.sin(0.5 * np.pi * nodes)
            w = 0.25 * np.pi * (two - one) * np.cos(0.5 * np.pi * nodes) * weights
            p = contact.pressure(np.clip(x, one, two))
            force, moment = force + w @ p, moment + w @ (x * p)
    assert force == pytest.approx(contact.force, rel=1e-9)
    assert moment == pytest.approx(contact.moment, rel=1e-8, abs=1e-9)
    # Inside the zones: p^kappa + u = delta - alpha x - f.
    left, right = contact.zones[0]
    x = np.linspace(left, right, 23)[1:-1]
    kappa = stated.get("exponent", 1.0)
    layer = contact.pressure(x) ** kappa
    base = contact.settlement - contact.tilt * x - contact.problem.height(x)
    assert layer + contact.displacement(x) == pytest.approx(base, abs=1e-8)
    assert (contact.gap(np.linspace(-1, 1, 50)) >= -1e-9).all()


def test_the_mirror_image() -> None:
    one = st.solve(theta0=4.0, profile=lambda x: x**2 + 0.2 * x**3, force=1.0, moment=0.1)
    two = st.solve(theta0=4.0, profile=lambda x: x**2 - 0.2 * x**3, force=1.0, moment=-0.1)
    x = np.linspace(-1, 1, 33)
    assert one.pressure(x) == pytest.approx(two.pressure(-x), abs=1e-11)
    assert one.tilt == pytest.approx(-two.tilt, rel=1e-10)


def test_units_are_only_units() -> None:
    a, chi = 5e-3, 1.2e-13
    physical = st.solve(young_modulus=E, poisson_ratio=NU, roughness=chi, half_width=a, profile="x^2/1.6", force=8e5, eccentricity=1e-4)
    theta0 = 2 * a / (math.pi * E_STAR * chi)
    scale = chi * E
    bare = st.solve(theta0=theta0, profile=f"{a**2 / 1.6 / scale}*xi^2", force=8e5 / (a * E), eccentricity=1e-4 / a)
    assert physical.problem.theta0 == pytest.approx(theta0, rel=1e-14)
    told = physical.dimensionless
    for name in ("settlement", "tilt", "force", "moment", "peak_pressure", "contact_width"):
        assert getattr(told, name) == pytest.approx(getattr(bare, name), rel=1e-10), name
    assert told.pressure(0.3) * E == pytest.approx(physical.pressure(0.3 * a), rel=1e-14)
    assert bare.dimensionless is bare and told.dimensionless is told
