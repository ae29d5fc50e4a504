"""Problems in every form, and what is wrong with some."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import shtaerman as st

TABLES: dict[str, Any] = {
    "foundation": {"young_modulus": "200 GPa", "poisson_ratio": 0.3, "roughness": 1.2e-14},
    "punch": {"half_width": 5e-3, "profile": "x^2 / 40"},
    "load": {"force": "0.8 MN/m", "moment": 0},
}
TEXT = """
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = 1.2e-14
[punch]
half_width = 0.005
profile = "x^2 / 40"
[load]
force = "0.8 MN/m"
moment = 0
"""


def bits(contact: st.Contact) -> dict[str, Any]:
    return contact.to_dict()


def test_every_form_is_the_same_problem(tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(TEXT, encoding="utf-8")
    flat = {name: value for table in TABLES.values() for name, value in table.items()}
    parts = (st.Foundation(**TABLES["foundation"]), st.Punch(**TABLES["punch"]), st.Load(**TABLES["load"]))
    expected = bits(st.solve(TEXT))
    for form in (path, str(path), TABLES, st.Problem(*parts), st.Problem.parse(TEXT), st.Problem.from_dict(TABLES)):
        assert bits(st.solve(form)) == expected
    assert bits(st.solve(**flat)) == expected
    numbers = {**flat, "young_modulus": np.float64(200e9), "force": np.array(8e5), "half_width": 5e-3, "moment": np.int32(0)}
    assert bits(st.solve(**numbers)) == expected
    del flat["moment"]
    assert bits(st.solve(**flat)) == expected


def test_replacing_takes_the_place_of_what_it_excludes() -> None:
    problem = st.Problem.from_dict(TABLES).replace(settlement=3e-6, tilt=1e-5)
    contact = problem.replace(eccentricity=1e-4).replace(force=5e5).solve()
    assert contact.force == 5e5 and contact.moment == pytest.approx(50.0)
    assert problem.solve().settlement == 3e-6
    assert problem.replace() is problem
    power = problem.replace(roughness={"coefficient": 2e-10, "exponent": 0.6})
    assert power.replace(roughness=1.2e-14).solve().to_dict() == problem.solve().to_dict()
    table = st.Problem.from_dict(TABLES | {"foundation": {**TABLES["foundation"], "roughness": {"coefficient": 2e-10, "exponent": 0.6}}})
    plain = table.replace(roughness=1.2e-14)
    assert plain.solve().to_dict() == st.solve(TABLES).to_dict() != table.solve().to_dict()
    elastic = problem.replace(body={"young_modulus": "100 GPa", "poisson_ratio": 0.3})
    assert elastic.theta0 > problem.theta0
    bilateral = problem.replace(contact="bilateral", tolerance=1e-9)
    assert bilateral.solve().to_dict()["contact"] == "bilateral"


def test_points_are_the_trace_of_a_file(tmp_path: Path) -> None:
    x = np.linspace(-5e-3, 5e-3, 41)
    f = x**2 / 40 + 1e-8 * np.cos(900 * x)
    rows = "".join(f"{a!r},{b!r}\n" for a, b in zip(x.tolist(), f.tolist()))
    (tmp_path / "trace.csv").write_text(rows, encoding="utf-8")
    (tmp_path / "p.toml").write_text(TEXT.replace('"x^2 / 40"', '{ csv = "trace.csv" }'), encoding="utf-8")
    expected = bits(st.solve(tmp_path / "p.toml"))
    for profile in ((x, f), [x, f], np.array([x, f]), (x.tolist(), f.tolist()), (x[::-1], f[::-1])):
        assert bits(st.solve(TABLES, profile=profile)) == expected
    assert bits(st.solve(**{**TABLES["foundation"], "half_width": 5e-3, "profile": (x, f), "force": "0.8 MN/m"})) == expected


def test_a_callable_is_the_expression_it_computes() -> None:
    calls: list[np.ndarray[Any, Any]] = []

    def base(x: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        calls.append(x)
        return x**2 / 40 + 1e-6 * np.exp(200 * x)

    by_text = st.solve(TABLES, profile="x^2/40 + 1e-6*exp(200*x)")
    problem = st.Problem.from_dict(TABLES, profile=base)
    count = len(calls)
    assert 1 <= count <= 3 and all(np.abs(x).max() <= 5e-3 for x in calls)
    contact = problem.solve()
    assert len(calls) == count, "it is sampled once"
    x = np.linspace(-5e-3, 5e-3, 101)
    assert problem.height(x) == pytest.approx(x**2 / 40 + 1e-6 * np.exp(200 * x), abs=1e-19)
    assert contact.settlement == pytest.approx(by_text.settlement, rel=1e-11)
    assert contact.pressure(x) == pytest.approx(by_text.pressure(x), rel=1e-9, abs=1e-9 * by_text.peak_pressure)
    assert contact.error is not None and contact.error.kind == "estimate"


def test_kinks_and_jumps_of_a_callable_are_named() -> None:
    wedge = st.Profile(lambda x: 2.0 * abs(x), breaks=[0.0])
    by_text = st.solve(theta0=3.0, profile="2*abs(xi)", force=1.0)
    contact = st.solve(theta0=3.0, profile=wedge, force=1.0)
    assert contact.settlement == pytest.approx(by_text.settlement, rel=1e-9)
    step = st.Profile(lambda x: np.where(x < 0.25, 0.0, 0.1), breaks=[0.25, 7.0])
    by_text = st.solve(theta0=3.0, profile="where(xi < 0.25, 0, 0.1)", force=3.0, contact="bilateral")
    assert st.solve(theta0=3.0, profile=step, force=3.0, contact="bilateral").tilt == pytest.approx(by_text.tilt, rel=1e-8)
    with pytest.raises(ValueError, match="not smooth .* name its kinks"):
        st.solve(theta0=3.0, profile=abs, force=1.0)


def test_a_constant_callable_is_a_level() -> None:
    contact = st.solve(theta0=2.0, profile=lambda x: 0.5, force=1.0)
    assert contact.settlement == pytest.approx(st.solve(theta0=2.0, force=1.0).settlement + 0.5, rel=1e-12)


PROFILES: list[tuple[Any, str]] = [
    (lambda x: x * np.nan, "gives nan at x = .*: must be finite"),
    (lambda x: np.where(x > 0, np.inf, 0.0), "gives inf"),
    (lambda x: x[:3], r"shape \(3,\) for places of shape \(16,\)"),
    (lambda x: x.reshape(4, 4), "must be one height for each place"),
    (lambda x: x + 1j, "real numbers, got the type complex"),
    (lambda x: ["high"] * x.size, "real numbers"),
    (lambda x: None, "real numbers, got the type NoneType"),
    (lambda x: [[1.0], [1.0, 2.0]], "different lengths"),
    (([0.0, 1.0], [0.0]), "one height for each place, got 2 places and 1 heights"),
    (([0.0], [0.0]), "at least two points"),
    (([-1.0, 1.0, 0.5], [0.0, 0.0, 0.0]), r"x\[2\] = 0.5 after 1.0"),
    (([-1.0, math.nan, 1.0], [0.0, 0.0, 0.0]), r"x\[1\] is nan"),
    (([-1.0, 0.0, 1.0], [0.0, math.inf, 0.0]), r"f\[1\] is inf"),
    (([-1.0, 0.0, 0.5], [0.0, 0.0, 0.0]), "does not cover the punch"),
    (([[-1.0, 1.0]], [[0.0, 0.0]]), "lists of numbers"),
    ((["a", "b"], [0.0, 0.0]), "real numbers"),
    (([0.0, 1.0], [0.0, 1.0], [0.0, 1.0]), r"a pair \(x, f\)"),
    (np.zeros((3, 5)), "a pair"),
    ("xi^^2", "punch.profile|dimensionless.profile"),
    (b"xi", "type bytes"),
    (object(), "type object"),
]


@pytest.mark.parametrize(("profile", "said"), PROFILES)
def test_rubbish_for_a_profile_is_refused(profile: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.solve(theta0=1.0, force=1.0, profile=profile)


def test_what_a_callable_raises_is_raised() -> None:
    class Own(Exception):
        pass

    def broken(x: object) -> float:
        raise Own("here")

    with pytest.raises(Own, match="here"):
        st.solve(theta0=1.0, force=1.0, profile=broken)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"young_modulus": -1}, "foundation.young_modulus: is -1 Pa: must be finite and greater than zero"),
        ({"young_modulus": math.nan}, "foundation.young_modulus: is nan"),
        ({"half_width": "5 kg"}, "is a length"),
        ({"force": [1.0, 2.0]}, "type list"),
        ({"force": np.ones(3)}, r"array of shape \(3,\)"),
        ({"force": 1j}, "type complex"),
        ({"force": None, "settlement": None}, "force"),
        ({"force": 1.0, "settlement": 1.0}, "settlement"),
        ({"theta0": 1.0}, "theta0 alone is enough"),
        ({"theta0": 1.0, "poisson_ratio": None, "force": 1.0}, "dimensionless.young_modulus|dimensionless.half_width"),
        ({"contact": "sideways"}, "unilateral"),
        ({"n": 2.5}, "solver.n"),
        ({"geometry": "round"}, "circular"),
        ({"roughness": "\ud800"}, "is no text"),
        ({"body": {"young_modulus": 1e9}}, "poisson_ratio"),
        ({"body": {3: 1e9}}, "no key"),
    ],
)
def test_bad_values_name_their_key(steel: dict[str, Any], changes: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.solve(**{**steel, **changes})


def test_what_is_no_keyword() -> None:
    with pytest.raises(TypeError, match="did you mean 'force'"):
        st.solve(theta0=1.0, forse=1.0)
    with pytest.raises(TypeError, match="'anything'"):
        st.solve(TEXT, anything=1)
    with pytest.raises(ValueError, match="got int"):
        st.solve(7)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="Foundation"):
        st.Problem(st.Load(force=1.0), st.Punch(), st.Load(force=1.0))  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        st.Contact()
    with pytest.raises(TypeError):
        st.Foundation(yung_modulus=1.0)  # type: ignore[call-arg]


def test_strange_text_stays_within_its_quotes() -> None:
    for text in ('"\n[load]\nforce = 1', "\x7f\x00\\", 'a"b', "é\u2028", "'''"):
        with pytest.raises(ValueError, match="profile"):
            st.solve(theta0=1.0, force=1.0, profile=text)


def test_nothing_warns_on_the_way(steel: dict[str, Any]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        st.solve(**steel)
