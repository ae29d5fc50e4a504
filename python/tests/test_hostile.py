"""What a careless or hostile user asks for, and is told."""

from __future__ import annotations

import copy
import math
import os
import pickle
import select
import signal
import struct
import subprocess
import sys
import textwrap
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import shtaerman as st


@pytest.fixture(scope="module")
def contact() -> st.Contact:
    steel = {"young_modulus": "200 GPa", "poisson_ratio": 0.3, "roughness": "1.2e-14 m/Pa"}
    return st.solve(**steel, half_width="5 mm", profile="x^2/40", force="0.8 MN/m")


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda c: c.pressure([[0.0, 1e-3], [np.nan, 0.0]]), "NaN is beyond the punch"),
        (lambda c: c.pressure(np.ma.array([0.0, 1e-3], mask=[0, 1])), "masked"),
        (lambda c: c.pressure(True), "bool"),
        (lambda c: c.pressure(np.array(["2020"], dtype="datetime64[Y]")), "datetime64"),
        (lambda c: c.displacement([[0.0], [np.nan]]), r"x\[1, 0\]: is nan: must be finite"),
        (lambda c: c.displacement(np.inf), "x: is inf: must be finite"),
        (lambda c: c.gap(1.0), "beyond the punch"),
        (lambda c: c.problem.height(0.006), "beyond the punch, whose base is known to 0.005"),
        (lambda c: c.problem.height([0.0, np.nan]), r"x\[1\]: is nan"),
        (lambda c: c.stress(np.zeros(3), np.zeros(4)), r"do not go together: \(3,\) and \(4,\)"),
        (lambda c: c.stress(np.nan, 1e-3), "NaN"),
        (lambda c: c.stress(0.0, [1e-3, np.inf]), "depth = inf"),
        (lambda c: c.stress(0.0, 1e-3, poisson_ratio="0.3"), "poisson_ratio: must be"),
        (lambda c: c.stress(0.0, 1e-3, poisson_ratio=math.nan), "poisson_ratio: is nan"),
        (lambda c: c.stress(0.0, 1e-3, poisson_ratio=0.7), "at most 0.5"),
        (lambda c: c.to_json(points=11.0), "a whole number from 2 to 1000000, got 11.0"),
        (lambda c: c.to_json(points=True), "got True"),
        (lambda c: c.to_json(at=["1 mm"]), "real numbers"),
        (lambda c: c.plot(points="many"), "got 'many'"),
        (lambda c: st.find("force", c.problem, peak_pressure=math.nan), "peak_pressure: is nan"),
        (lambda c: st.find("force", c.problem, peak_pressure=[1.0, 2.0]), "size 1"),
        (lambda c: c.problem.replace(force=10**400), "load.force: is beyond the range"),
        (lambda c: st.solve(""), "neither a path nor a problem"),
        (lambda c: st.solve("a\0b"), "cannot be read"),
        (lambda c: st.solve({}), "empty"),
        (lambda c: st.solve({"foundation": 1}), "is a table"),
        (lambda c: st.solve({1: 2}), "no key"),
        (lambda c: st.equation(kind="second", lambda_=1.0, rhs=lambda x: 1.0, kernel="log", a=1.0), "rhs: is a function, which goes with"),
        (lambda c: st.equation(kind="second", lambda_=1.0, rhs="1", kernel=lambda x, s: 1.0), r"st\.Kernel\(function"),
        (lambda c: st.equation(kind="second", lambda_=1.0, rhs="1", kernel="log", a=1.0, solver=[1]), "solver: must be a dictionary"),
        (lambda c: st.spectrum("log", a=1.0, count=2.5), "invalid value '2.5' for '--count <N>': invalid digit found in string$"),
        (lambda c: st.roughness("bearing", "file.csv"), "unexpected argument 'file.csv' found$"),
        (lambda c: st.solve_many(c.problem, force=np.array([1e5, None], dtype=object)), "object"),
        (lambda c: st.solve_many(c.problem, force=np.ma.array([1e5, 2e5], mask=[0, 1])), "masked"),
    ],
)
def test_what_is_refused(contact: st.Contact, call: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        call(contact)


def test_a_dictionary_that_contains_itself() -> None:
    tables: dict[str, Any] = {}
    tables["punch"] = tables
    with pytest.raises(ValueError, match="contain themselves"):
        st.solve(tables)


def test_types_that_are_no_problem() -> None:
    for call in (lambda: st.Problem.parse(3), lambda: st.Problem.from_dict(3), lambda: st.Problem.open(None)):  # type: ignore[arg-type]
        with pytest.raises(TypeError, match="Problem|PathLike"):
            call()


def test_numbers_of_many_kinds_are_the_same_number(contact: st.Contact) -> None:
    for force in (800_000, np.float64(8e5), np.array(8e5), np.int64(800_000), np.uint32(800_000), Fraction(800_000), "0.8 MN/m", "800 N/mm"):
        assert contact.problem.replace(force=force).solve().to_json() == contact.to_json()
    # Whole numbers beyond 64 bits are floats.
    assert contact.problem.replace(young_modulus=2**64, roughness=1e-25).theta0 == contact.problem.replace(young_modulus=float(2**64), roughness=1e-25).theta0
    assert contact.to_json(points=np.int64(11)) == contact.to_json(points=11)
    x = np.array([1e-3])
    for kind in (">f8", np.longdouble):
        assert contact.pressure(x.astype(kind)).tolist() == contact.pressure(x).tolist()
    x.setflags(write=False)
    assert contact.pressure(x).flags.writeable and contact.pressure(np.ma.array(x)).tolist() == contact.pressure(x).tolist()


def test_many_cases_of_a_problem_in_any_form(contact: st.Contact, root: Any) -> None:
    path = root / "examples/crowned_punch.toml"
    text = path.read_text(encoding="utf-8")
    tables = {
        "foundation": {"young_modulus": "200 GPa", "poisson_ratio": 0.3, "roughness": 1.2e-14},
        "punch": {"half_width": 5e-3, "profile": "x^2 / (2*20)"},
        "load": {"force": 8e5, "moment": 0},
    }
    expected = [contact.problem.replace(force=force).solve(audit=False).settlement for force in (1e5, 8e5)]
    for form in (path, str(path), text, tables, contact.problem):
        assert st.solve_many(form, force=[1e5, 8e5], threads=np.int64(2)).settlement.tolist() == expected


def test_heights_at_the_end_of_the_range() -> None:
    tall = st.Problem(st.Foundation(theta0=1.0), st.Punch(profile=lambda x: 1.5e308 * x), st.Load(force=1.0))
    assert tall.height([-0.5, 1.0]).tolist() == pytest.approx([-0.75e308, 1.5e308], rel=1e-14)
    tiny = st.Problem(st.Foundation(theta0=1.0), st.Punch(profile=lambda x: 1e-300 * x), st.Load(force=1.0))
    assert tiny.height(0.5) == pytest.approx(0.5e-300, rel=1e-14)


def test_a_contact_does_not_change(contact: st.Contact) -> None:
    for name in ("force", "anything"):
        with pytest.raises(AttributeError):
            setattr(contact, name, 1.0)
    before = contact.to_json()
    contact.zones[0, 0] = 1.0
    contact.stiffness[:] = 0.0
    contact.to_dict()["pressure"]["x"].clear()
    assert contact.to_json() == before and contact.zones[0, 0] < 0.0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are never forked there")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*:DeprecationWarning")
@pytest.mark.parametrize("profile", ["x^2/40", "x^2/40 + 2e-8*cos(5e4*x)"])
def test_a_fork_solves_without_the_threads_of_its_parent(contact: st.Contact, profile: str) -> None:
    # Waves enough for panels, on which all processors work.
    problem = contact.problem.replace(profile=profile)

    def solved() -> float:
        return st.solve(problem).settlement

    here = solved()
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        # Nothing of pytest runs twice.
        try:
            os.write(write, struct.pack("2d", solved(), solved()))
        finally:
            os._exit(0)
    os.close(write)
    told, _, _ = select.select([read], [], [], 60.0)
    if not told:
        os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    assert told and struct.unpack("2d", os.read(read, 16)) == (here, here)
    assert solved() == here


def test_threads_of_python_solve_side_by_side(contact: st.Contact) -> None:
    problems = [contact.problem.replace(force=4e5 + 1e4 * case) for case in range(40)]
    alone = [st.solve(problem).settlement for problem in problems]
    with ThreadPoolExecutor(12) as threads:
        assert list(threads.map(lambda problem: st.solve(problem).settlement, problems)) == alone


def test_what_else_is_copied_and_pickled() -> None:
    many = st.solve_many(theta0=[1.0, -1.0], force=2.0)
    # A callable goes where pickle takes it: one that has a name.
    for one in (many, st.Profile(np.cosh, breaks=[0.0]), st.Kernel(math.hypot, singularity="logarithm")):
        for two in (copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
            assert repr(two) == repr(one) or isinstance(one, st.Profile)
    again = pickle.loads(pickle.dumps(many))
    assert again.settlement.tobytes() == many.settlement.tobytes() and again.reason.tolist() == many.reason.tolist()


def test_the_card_has_units() -> None:
    plane = st.solve(young_modulus=2e11, poisson_ratio=0.3, roughness=1e-14, half_width=5e-3, force=8e5)
    assert "<td>800000 N/m</td>" in plane._repr_html_() and " Pa</td>" in plane._repr_html_()
    disk = st.solve(young_modulus=2e11, poisson_ratio=0.3, roughness=1e-14, geometry="circular", radius=5e-3, force=8e3)
    assert "<td>8000 N</td>" in disk._repr_html_()
    assert " Pa</td>" not in plane.dimensionless._repr_html_()
    assert "<td>2</td>" in st.solve(theta0=1.0, force=2.0)._repr_html_()


@pytest.mark.parametrize(
    "call",
    [
        'st.solve_many(problem, force=np.linspace(40.0, 60.0, 400))',
        'st.find("force", problem, contact_width=0.4)',
    ],
)
def test_long_calls_let_others_run_and_can_be_interrupted(call: str) -> None:
    program = textwrap.dedent(
        f"""
        import threading, time
        import numpy as np
        import shtaerman as st
        problem = st.Problem(st.Foundation(theta0=2e3), st.Punch(profile="abs(sin(40*xi))+0.3*cos(97*xi)+xi^2"), st.Load(force=50.0))
        def others():
            for _ in range(40):
                time.sleep(0.01)
            print("go", flush=True)
        threading.Thread(target=others, daemon=True).start()
        try:
            {call}
            print("solved")
        except KeyboardInterrupt:
            print("interrupted")
        """
    )
    # A call that holds the interpreter is over before the others have had their turns, however busy the machine is.
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stdout.readline() == "go\n"
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
