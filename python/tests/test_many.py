"""Many cases of one problem."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import shtaerman as st

NAMES = (
    "settlement tilt force moment pressure_left pressure_middle pressure_right mean_pressure peak_pressure peak_pressure_at contact_width theta0 relative_error"
).split()
BARE = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="4*xi^2 + xi"), st.Load(force=2.0))


@pytest.mark.parametrize("audit", [False, True])
def test_each_case_has_the_bits_of_a_single_solve(audit: bool) -> None:
    theta0, force = np.array([[0.5], [30.0]]), np.array([0.2, 2.0, 5.0])
    found = st.solve_many(BARE, theta0=theta0, force=force, audit=audit)
    assert found.shape == (2, 3) and found.solved.all() and len(found) == 2
    for index in np.ndindex(2, 3):
        one = st.solve(BARE, theta0=theta0[index[0], 0], force=force[index[1]], audit=audit)
        assert found.problem(index).solve(audit=audit).to_json() == one.to_json()
        for name in NAMES:
            assert getattr(found, name)[index] == getattr(one, name), name
        assert (found.stiffness[index] == one.stiffness).all() and one.error is not None
        assert found.error.kind[index] == one.error.kind == ("bound" if audit else "estimate")
        for name in ("pressure", "settlement", "tilt", "force", "moment"):
            assert getattr(found.error, name)[index] == getattr(one.error, name), name
        stated = np.asarray(found.error.peak_pressure)[index]
        assert stated == one.error.peak_pressure if audit else np.isnan(stated) and one.error.peak_pressure is None


@pytest.mark.parametrize(
    "varied",
    [
        {"roughness": [1e-14, 3e-14], "young_modulus": [1e11, 2e11]},
        {"half_width": [4e-3, 6e-3]},
        {"force": ["0.5 MN/m", "700 N/mm"]},
        {"poisson_ratio": [0.2, 0.4], "tilt": [0.0, 1e-5]},
        {"settlement": [1e-6, 2e-6], "moment": [0.0, 10.0]},
        {"contact": ["unilateral", "bilateral"], "eccentricity": [0.0, 1e-4]},
    ],
)
def test_any_key_can_be_varied(steel: dict[str, Any], varied: dict[str, Any]) -> None:
    found = st.solve_many(**{**steel, "profile": "x^2/40", **varied} if "settlement" not in varied else {**{k: v for k, v in steel.items() if k != "force"}, **varied})
    for case in range(2):
        stated = {**steel, "profile": "x^2/40", **{name: values[case] for name, values in varied.items()}}
        if "settlement" in varied:
            del stated["force"], stated["profile"]
        one = st.solve(**stated, audit=False)
        assert found.settlement[case] == one.settlement and found.peak_pressure[case] == one.peak_pressure


def test_the_number_of_threads_changes_nothing() -> None:
    theta0 = np.geomspace(0.01, 300, 41)
    one, many = (st.solve_many(BARE, theta0=theta0, threads=threads).to_pandas() for threads in (1, 5))
    assert one.equals(many)


def test_cases_without_an_answer_say_why() -> None:
    force = np.array([1.0, -1.0, np.nan, np.inf, 2.0])
    found = st.solve_many(BARE, force=force)
    assert found.solved.tolist() == [True, False, False, False, True]
    assert np.isnan(found.settlement[1:4]).all() and np.isnan(found.stiffness[1:4]).all()
    assert found.reason[0] == "" and found.error.kind[1] == ""
    for case in (1, 2, 3):
        with pytest.raises(ValueError) as caught:
            st.solve(theta0=5.0, profile="4*xi^2 + xi", force=force[case])
        assert found.reason[case].startswith("force") and "force" in str(caught.value)
    late = st.solve_many(BARE, tolerance=np.array([1e-9, 1e-30]))
    assert late.solved.tolist() == [True, False] and "tolerance 1e-30 was not met" in late.reason[1]
    text = st.solve_many(BARE, profile="xi^2", force=["1", "one"])
    assert text.solved.tolist() == [True, False] and "one" in text.reason[1]
    # The first case need not be the one that is a problem.
    assert st.solve_many(theta0=np.array([-1.0, 1.0]), force=1.0).solved.tolist() == [False, True]


@pytest.mark.parametrize(
    ("keywords", "said"),
    [
        ({"theta0": np.ones(3), "force": np.ones(2)}, r"do not go together: force \(2,\), theta0 \(3,\)"),
        ({"theta0": np.ones(0)}, "no cases"),
        ({"theta0": np.ones(2, dtype=complex)}, "complex"),
        ({"theta0": [[1.0], [1.0, 2.0]]}, "different lengths"),
        ({"theta0": np.array([True, False])}, "bool"),
        ({"theta0": np.ones(2), "threads": 0}, "threads"),
        ({"theta0": -np.ones(2000)}, "theta0"),
        ({"theta0": np.ones(2), "profile": "xi^"}, "profile"),
    ],
)
def test_arrays_that_are_none(keywords: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.solve_many(**{"force": 1.0, **keywords})


def test_one_case_and_scalars() -> None:
    found = st.solve_many(BARE)
    assert found.shape == () and float(found.settlement) == BARE.solve(audit=False).settlement
    with pytest.raises(TypeError):
        len(found)


def test_tables_and_data_sets() -> None:
    theta0, force = np.array([1.0, 2.0, 3.0]), np.array([1.0, 2.0])
    found = st.solve_many(BARE, theta0=theta0[:, None], force=force)
    table = found.to_pandas()
    assert table.shape[0] == 6 and table["theta0"].tolist() == [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]
    assert table["settlement"].tolist() == found.settlement.ravel().tolist()
    data = found.to_xarray()
    assert data.settlement.dims == ("theta0", "force")
    assert float(data.settlement.sel(theta0=2.0, force=1.0)) == found.settlement[1, 0]
    together = st.solve_many(BARE, theta0=theta0, force=theta0).to_xarray()
    assert together.settlement.dims == ("dim_0",) and together.coords["theta0"].dims == ("dim_0",)


def test_warnings_of_cases() -> None:
    found = st.solve_many(BARE, contact=["unilateral", "bilateral"], profile="9*xi^2", force=1.0)
    assert found.warnings.tolist() == ["", "negative_pressure"]


SWEPT = ["settlement", "tilt", "force", "moment", "pressure_left", "pressure_right", "mean_pressure", "stiffness", "theta0"]


@pytest.mark.parametrize(
    "load",
    [{"force": 2.0, "moment": 0.3}, {"force": 2.0, "eccentricity": 0.1}, {"settlement": 1.0, "tilt": 0.2}, {"settlement": 1.0, "moment": 0.1}],
)
def test_a_sweep_over_theta0_tells_what_single_solves_tell(load: dict[str, float]) -> None:
    problem = st.Problem(st.Foundation(theta0=1.0), st.Punch(profile="xi^2 + exp(xi)"), st.Load(**load), st.Solver(contact="bilateral"))
    theta0 = np.concatenate([[0.0], np.geomspace(0.01, 500, 23)]).reshape(4, 6)
    swept, single = st.solve_many(problem, theta0=theta0, outputs=SWEPT), st.solve_many(problem, theta0=theta0)
    assert swept.shape == (4, 6) and swept.solved.all() and (swept.error.kind == "estimate").all()
    # One decomposition tells nothing of what lies between the edges.
    with pytest.raises(AttributeError, match="outputs"):
        swept.peak_pressure
    for name in SWEPT:
        if name == "stiffness":
            assert swept.stiffness == pytest.approx(single.stiffness, rel=1e-10, abs=1e-10)
            continue
        error = "pressure" if "pressure" in name else name
        allowed = sum(getattr(found.error, error, 0.0) for found in (swept, single))
        assert (np.abs(getattr(swept, name) - getattr(single, name)) <= allowed + 1e-300).all(), name
    assert swept.relative_error.max() < 1e-10
    one, many = (st.solve_many(problem, theta0=np.geomspace(0.1, 9, 50_000), outputs=SWEPT, threads=k) for k in (1, 3))
    assert one.settlement.tobytes() == many.settlement.tobytes() and one.pressure_left.tobytes() == many.pressure_left.tobytes()


def test_cases_of_a_sweep_that_are_none_say_why() -> None:
    problem = st.Problem(st.Foundation(theta0=1.0), st.Punch(), st.Load(force=2.0), st.Solver(contact="bilateral"))
    found = st.solve_many(problem, theta0=[1.0, -1.0, np.nan, np.inf], outputs=["settlement", "pressure_left"])
    assert found.solved.tolist() == [True, False, False, False] and np.isnan(found.settlement[1:]).all()
    assert "theta0 = -1: must be finite and not negative" in found.reason[1]
    assert found.to_pandas().columns.tolist()[:2] == ["theta0", "settlement"]


def test_outputs_alone_change_no_bit() -> None:
    every, some = st.solve_many(BARE, theta0=[1.0, 2.0]), st.solve_many(BARE, theta0=[1.0, 2.0], outputs=["tilt"])
    assert some.tilt.tobytes() == every.tilt.tobytes() and some.error.tilt.tobytes() == every.error.tilt.tobytes()
    assert np.isnan(some.error.pressure).all()
    for outputs, said in [(["tild"], "is none"), ("tilt", "a list of names")]:
        with pytest.raises(ValueError, match=said):
            st.solve_many(BARE, theta0=[1.0], outputs=outputs)


def test_arrays_of_every_make_are_the_same_numbers(steel: dict[str, Any]) -> None:
    import array

    import pandas as pd

    forces = np.linspace(1e5, 8e5, 4)
    usual = st.solve_many(**{**steel, "force": forces}).settlement

    def solved(values: Any) -> Any:
        return st.solve_many(**{**steel, "force": values}).settlement

    for values in (
        forces.astype(">f8"),
        forces.astype(object),
        np.array([str(force) for force in forces], dtype=object),
        np.array([forces[0], f"{float(forces[1])!r} N/m", *forces[2:]], dtype=object),
        np.repeat(forces, 2)[::2],
        pd.Series(forces, index=list("abcd")),
        pd.Series(list(forces), dtype=object),
        memoryview(array.array("d", forces)),
        list(forces),
    ):
        assert (solved(values) == usual).all(), values
    assert (solved(forces[::-1]) == usual[::-1]).all()
    assert (solved(np.asfortranarray(forces.reshape(2, 2))) == usual.reshape(2, 2)).all()
    assert (solved(range(100_000, 300_000, 100_000)) == solved([1e5, 2e5])).all()
    assert solved(forces.astype(np.float32)).shape == (4,) and solved(np.array(8e5)).shape == ()
    contact = st.solve(**steel)
    places = np.array([0.0, 1e-3])
    assert (contact.pressure(places.astype(object)) == contact.pressure(places)).all()
    for bad, said in ((np.array([1e5, None], dtype=object), "object"), (np.array([1e5, True], dtype=object), "object"), ({1e5}, "set")):
        with pytest.raises(ValueError, match=said):
            solved(bad)
    with pytest.raises(ValueError, match="None"):
        contact.pressure(np.array([0.0, None], dtype=object))
