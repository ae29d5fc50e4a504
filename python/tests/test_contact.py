"""Contacts as objects of Python."""

from __future__ import annotations

import copy
import os
import pickle
import signal
import subprocess
import sys
import textwrap
import threading
import time
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import shtaerman as st


@pytest.fixture(scope="module")
def contact() -> st.Contact:
    return st.solve(theta0=5.0, profile="3*xi^2 + xi^3", force=1.0, moment=0.05)


def test_arrays_of_any_shape(contact: st.Contact) -> None:
    x = np.linspace(-1.0, 1.0, 24)
    for function in (contact.pressure, contact.displacement, contact.gap):
        flat = function(x)
        assert function(x.reshape(2, 3, 4)).tolist() == flat.reshape(2, 3, 4).tolist()
        assert function(np.asfortranarray(x.reshape(4, 6))).tolist() == flat.reshape(4, 6).tolist()
        assert function(x[::-2]).tolist() == flat[::-2].tolist()
        assert [function(float(place)) for place in x] == flat.tolist()
        assert isinstance(function(0.0), float) and function(np.zeros(0)).shape == (0,)
        assert function([0, 0.5]).dtype == np.float64
        assert function(x.astype(np.float32)).shape == (24,)
    assert contact.pressure(-1.0) == contact.pressure_left and contact.pressure(0.0) == contact.pressure_middle


@pytest.mark.parametrize("places", [[1.5], [np.nan], ["a"], [1j], [[0.0], [0.0, 1.0]], None])
def test_places_that_are_none(contact: st.Contact, places: Any) -> None:
    with pytest.raises(ValueError):
        contact.pressure(places)


def test_stresses_meet_the_pressure_at_the_surface(contact: st.Contact) -> None:
    x = np.linspace(-0.6, 0.4, 7)
    stress = contact.stress(x[:, None], np.array([0.0, 0.5]), poisson_ratio=0.25)
    assert stress.sigma_y.shape == (7, 2)
    assert stress.sigma_y[:, 0] == pytest.approx(-contact.pressure(x), abs=1e-10)
    assert stress.tau_xy[:, 0] == pytest.approx(0.0, abs=1e-10)
    single = contact.stress(0.1, 0.5, poisson_ratio=0.25)
    parts = (single.sigma_x, single.sigma_y, single.sigma_z)
    deviator = sum((a - b) ** 2 for a, b in zip(parts, parts[1:] + parts[:1])) / 2
    assert single.von_mises == pytest.approx((deviator + 3 * single.tau_xy**2) ** 0.5)
    with pytest.raises(ValueError, match="Poisson"):
        contact.stress(0.0, 0.5)
    with pytest.raises(ValueError):
        contact.stress(0.0, -0.5, poisson_ratio=0.25)
    with pytest.raises(ValueError):
        contact.stress(np.zeros(3), np.zeros(2), poisson_ratio=0.25)


def test_errors_and_audit() -> None:
    problem = st.Problem(st.Foundation(theta0=5.0), st.Punch(profile="3*xi^2"), st.Load(force=1.0))
    audited, plain = problem.solve(), problem.solve(audit=False)
    assert audited.is_audited and not plain.is_audited
    assert audited.error is not None and plain.error is not None
    assert (audited.error.kind, plain.error.kind) == ("bound", "estimate")
    assert plain.audit() == audited.audit() and audited.audit().error == audited.error
    assert audited.audit().residual is not None
    # The bound holds against a much finer answer to the same problem.
    fine = problem.replace(tolerance=1e-13).solve(audit=False)
    x = np.linspace(-1, 1, 201)
    assert np.abs(fine.pressure(x) - audited.pressure(x)).max() <= audited.error.pressure + 1e-12
    assert audited.error.force == 0.0 and audited.error.settlement > 0.0


def test_warnings_are_told() -> None:
    contact = st.solve(theta0=5.0, profile="9*xi^2", force=1.0, contact="bilateral")
    assert [warning.code for warning in contact.warnings] == ["negative_pressure"]
    assert contact.tension.shape == (2, 2) and contact.pressure(contact.tension.mean(axis=1)).max() < 0.0


@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_pickles(contact: st.Contact, protocol: int) -> None:
    for one in (contact, st.solve(theta0=2.0, profile=lambda x: np.cosh(x), force=1.0, audit=False)):
        two = pickle.loads(pickle.dumps(one, protocol))
        assert two.to_json() == one.to_json() and two.is_audited == one.is_audited
    assert copy.copy(contact) is contact and copy.deepcopy(contact) is contact
    problem = pickle.loads(pickle.dumps(contact.problem, protocol))
    assert problem.solve().to_json() == contact.to_json()
    part = st.Load(force="1 MN/m")
    assert pickle.loads(pickle.dumps(part, protocol)) == part
    with pytest.raises(st.ConvergenceError) as caught:
        contact.problem.replace(tolerance=1e-30).solve()
    assert str(pickle.loads(pickle.dumps(caught.value, protocol))) == str(caught.value)


def test_a_trace_goes_with_a_pickle(root: Any) -> None:
    one = st.solve(root / "examples/measured_profile.toml")
    state = pickle.dumps(one)
    away = subprocess.run(
        [sys.executable, "-c", "import pickle, sys; print(pickle.load(sys.stdin.buffer).to_json())"],
        input=state,
        capture_output=True,
        cwd=os.path.dirname(sys.executable),
        check=True,
    )
    assert away.stdout.decode().strip() == one.to_json()


def test_a_pickle_of_another_version_says_so(contact: st.Contact) -> None:
    function, (problem, _, *rest) = contact.__reduce__()
    with pytest.warns(UserWarning, match="version 0.0.0"):
        assert function(problem, "0.0.0", *rest).settlement == contact.settlement


def test_dimensionless_twins_pickle_and_show(root: Any) -> None:
    physical = st.solve(root / "examples/crowned_punch.toml")
    bare = physical.dimensionless
    assert bare.mean_pressure == pytest.approx(physical.mean_pressure / 200e9)
    assert pickle.loads(pickle.dumps(bare)).settlement == bare.settlement
    assert bare.to_dict() == physical.to_dict()
    assert " Pa" in repr(physical) and " Pa" not in repr(bare)


def test_cards_and_pictures(contact: st.Contact) -> None:
    card = contact._repr_html_()
    picture = ElementTree.fromstring(card[card.index("<svg") : card.index("</svg>") + 6])
    assert picture.tag.endswith("svg") and "settlement" in card and "(bound)" in card
    assert ElementTree.fromstring(contact.to_svg()).tag.endswith("svg")
    figure = contact.plot(points=51)
    line = figure.axes[0].lines[0].get_xydata()
    assert line.shape == (51, 2) and np.nanmax(line[:, 1]) <= contact.peak_pressure
    with pytest.raises(ValueError):
        contact.plot(points=1)
    with pytest.raises(ValueError):
        contact.to_json(points=1)


def test_a_problem_with_many_zones_lets_others_run_and_can_be_interrupted() -> None:
    # Some seconds of work.
    program = textwrap.dedent(
        """
        import threading, time, _thread, sys
        import shtaerman as st
        problem = st.Problem(st.Foundation(theta0=2e3), st.Punch(profile="abs(sin(40*xi))+0.3*cos(97*xi)+xi^2"), st.Load(force=50.0))
        ticks = []
        def tick():
            while True:
                ticks.append(time.perf_counter())
                time.sleep(0.01)
        threading.Thread(target=tick, daemon=True).start()
        threading.Timer(0.3, lambda: print("go", flush=True)).start()
        begun = time.perf_counter()
        try:
            problem.solve()
            print("solved", time.perf_counter() - begun, len(ticks))
        except KeyboardInterrupt:
            print("interrupted", time.perf_counter() - begun, len(ticks))
        """
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stdout.readline() == "go\n"
        begun = time.perf_counter()
        process.send_signal(signal.SIGINT)
        word, _, ticks = process.stdout.readline().split()
        waited = time.perf_counter() - begun
    assert word == "interrupted", "the problem took too little time: make it harder"
    # Looked for every twentieth of a second; the rest is for a machine that is busy.
    assert waited < 5.0 and int(ticks) >= 5, (waited, ticks)


def test_the_time_limit_is_kept() -> None:
    problem = st.Problem(st.Foundation(theta0=2e3), st.Punch(profile="abs(sin(40*xi))+0.3*cos(97*xi)+xi^2"), st.Load(force=50.0))
    begun = time.perf_counter()
    with pytest.raises(st.ConvergenceError, match="time limit of 0.2 s"):
        problem.replace(time_limit="0.2 s").solve()
    assert time.perf_counter() - begun < 5.0


def test_threads_of_python_solve_at_the_same_time(contact: st.Contact) -> None:
    found: list[str] = []
    threads = [threading.Thread(target=lambda: found.append(contact.problem.solve().to_json())) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [contact.to_json()] * 4


def test_slips_are_doubted() -> None:
    steel = dict(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa", half_width="5 mm", profile="x^2 / (2*20)")
    assert st.solve(**steel, force="0.8 MN/m", audit=False).warnings == []
    heavy = st.solve(**steel, force="0.8 GN/m", audit=False)
    assert "high_pressure" in [warning.code for warning in heavy.warnings]
    soft = st.solve(**{**steel, "young_modulus": 200.0}, force="0.8 N/m", audit=False)
    assert any('is "200 GPa" meant?' in warning.message for warning in soft.warnings)


def test_a_pressure_that_is_wanted_without_a_unit_is_doubted() -> None:
    crowned = dict(young_modulus=2e11, poisson_ratio=0.3, roughness=1e-14, half_width=5e-3, profile="x^2/40")
    bare = st.find("force", **crowned, force=8e5, peak_pressure=350, audit=False).contact
    assert any('is "350 MPa" meant?' in warning.message for warning in bare.warnings)
    for wanted in ("350 MPa", 350e6):
        found = st.find("force", **crowned, force=8e5, peak_pressure=wanted, audit=False).contact
        assert not any("meant?" in warning.message for warning in found.warnings)
