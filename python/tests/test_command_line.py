"""The same bytes as the command line, and the same words."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import ROOT, Program

import shtaerman as st


def is_contact(path: Path) -> bool:
    return "[equation]" not in path.read_text(encoding="utf-8")


FILES = sorted((ROOT / "examples").glob("*.toml"))
CONTACTS = [path for path in FILES if is_contact(path)]
EQUATIONS = [path for path in FILES if not is_contact(path)]


def test_there_are_examples() -> None:
    assert len(CONTACTS) >= 8 and len(EQUATIONS) >= 3


@pytest.mark.parametrize("path", CONTACTS, ids=lambda path: path.stem)
def test_a_file_gives_the_bytes_of_the_command_line(path: Path, program: Program) -> None:
    told = program.json("solve", path)
    contact = st.solve(path)
    assert contact.to_json() + "\n" == told
    assert contact.to_dict() == json.loads(told)
    again = st.solve(path.read_text(encoding="utf-8")) if "csv" not in path.read_text(encoding="utf-8") else contact
    assert again.to_json() == contact.to_json()
    bare = contact.to_dict()["physical"] or contact.to_dict()["dimensionless"]
    for name in ("settlement", "tilt", "force", "moment", "mean_pressure", "pressure_middle", "contact_width", "peak_pressure_at"):
        assert getattr(contact, name) == bare[name], name
    assert contact.zones.tolist() == bare["zones"]


def test_overrides_and_places_are_those_of_the_command_line(program: Program, root: Path) -> None:
    path = root / "examples/crowned_punch.toml"
    told = program.json("solve", path, "--no-audit", "--set", "load.settlement=2 um", "--set", "load.tilt=1e-5", "--at", "-2 mm,0,1 mm")
    contact = st.solve(path, audit=False, settlement="2 um", tilt=1e-5)
    assert contact.to_json(at=[-2e-3, 0.0, 1e-3]) + "\n" == told


@pytest.mark.parametrize("path", EQUATIONS, ids=lambda path: path.stem)
def test_equations_give_what_the_command_line_gives(path: Path, program: Program) -> None:
    assert st.equation(path).answer == json.loads(program.json("equation", path))


def test_spectra_and_roughness_are_those_of_the_command_line(program: Program) -> None:
    told = json.loads(program.json("spectrum", "power", "--a", "1", "--mu", "0.3", "--count", "5"))
    assert st.spectrum("power", a=1.0, mu=0.3, count=5).answer == told
    words = {"deviation": "0.5 um", "density": "1e4 1/mm^2", "radius": "10 um", "modulus": "110 GPa", "pressure": "80 MPa"}
    options = [word for name, value in words.items() for word in (f"--{name}", value)]
    assert st.roughness("gw", **words) == json.loads(program.json("roughness", "gw", *options))


def test_find_is_that_of_the_command_line(program: Program, root: Path) -> None:
    path = root / "examples/crowned_punch.toml"
    told = json.loads(program.json("find", "force", path, "--peak-pressure", "350 MPa"))
    found = st.find("force", path, peak_pressure="350 MPa")
    assert (found.value, found.reached, found.evaluations) == (told["value"], told["goal"]["reached"], told["evaluations"])
    assert found.contact.settlement == told["contact"]["settlement"]
    assert found.contact.problem.solve().to_json() == found.contact.to_json()
    told = json.loads(program.json("find", "crown", path))
    crown = st.find("crown", path)
    assert crown.best.radius == told["best"]["radius"] and crown.best.profile == told["best"]["profile"]
    assert crown.best.contact.problem.solve().peak_pressure == crown.best.contact.peak_pressure
    told = json.loads(program.json("find", "roughness", path, "--settlement", "4 um"))
    assert st.find("roughness", path, settlement="4 um").value == told["value"]
    told = json.loads(program.json("find", "profile", path, "--pressure", "1 - xi^2/2", "--points", "21"))
    shaped = st.find("profile", path, pressure="1 - xi^2/2", points=21)
    assert [shaped.x.tolist(), shaped.profile.tolist(), shaped.pressure.tolist()] == [told["profile"][name] for name in "xfp"]
    assert (shaped.settlement, shaped.factor, shaped.error) == (told["settlement"], told["factor"], told["error"])


FAULTS = [
    "",
    "[foundation]\nyoung_modulus = 1\n",
    "[dimensionless]\ntheta0 = -1\nprofile = '0'\nforce = 1\nmoment = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofile = 'xi^'\nforce = 1\nmoment = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofile = '1/xi'\nforce = 1\nmoment = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofile = '0'\nforce = 1\nmoment = 7\n",
    "[dimensionless]\ntheta0 = 1\nprofile = '0'\nforce = -1\nmoment = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofile = '0'\nsettlement = -1\ntilt = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofil = '0'\nforce = 1\nmoment = 0\n",
    "[dimensionless]\ntheta0 = 1\nprofile = 'xi^4'\nforce = 1\nmoment = 0\n[solver]\ntolerance = 1e-30\n",
    "[dimensionless]\ntheta0 = 1\nprofile = 'cos(9*xi)'\nforce = 1\nmoment = 0\n[solver]\ntime_limit = 1e-9\n",
    "[equation]\nkind = 'first'\n",
]


#: Its modulus has no unit, and its tolerance cannot be met.
DOUBTFUL = """
[foundation]
young_modulus = 200
poisson_ratio = 0.3
roughness = "1e-14 m/Pa"
[punch]
half_width = "5 mm"
profile = "x^2/0.04"
[load]
force = 1e-4
moment = 0
[solver]
tolerance = 1e-30
"""


@pytest.mark.parametrize("text", FAULTS)
def test_faults_are_told_as_on_the_command_line(text: str, program: Program, tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(text, encoding="utf-8")
    done = program.run("solve", path)
    kind = {2: ValueError, 3: st.ConvergenceError}[done.returncode]
    with pytest.raises(kind) as caught:
        st.solve(path)
    # On the command line a table of the best so far may stand before it.
    assert done.stderr.endswith(f"error: {caught.value}\n") or "time limit" in str(caught.value)
    assert issubclass(st.ConvergenceError, ArithmeticError) and not issubclass(st.ConvergenceError, ValueError)


def test_doubts_about_a_file_are_told_beside_its_fault(program: Program, tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(DOUBTFUL, encoding="utf-8")
    done = program.run("solve", path)
    with pytest.raises(st.ConvergenceError) as caught:
        st.solve(path)
    notes = caught.value.__notes__
    assert len(notes) == 1 and "is softer than rubber" in notes[0]
    assert done.returncode == 3 and done.stderr == f"{notes[0]}\nerror: {caught.value}\n"


def test_a_file_that_is_not_there(program: Program) -> None:
    done = program.run("solve", "no such file.toml")
    with pytest.raises(ValueError) as caught:
        st.solve("no such file.toml")
    assert done.returncode == 2 and done.stderr == f"error: {caught.value}\n"
