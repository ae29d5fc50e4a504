"""Tables for finite elements: the bytes of the command line, and what it refuses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, Program

import shtaerman as st

POWER = {"coefficient": 1e-9, "exponent": 0.4}


@pytest.mark.parametrize("path", ["examples/power_layer.toml", "examples/crowned_punch.toml", "examples/rough_ball.toml"])
@pytest.mark.parametrize("program_name", ["abaqus", "calculix"])
def test_a_file_gives_the_bytes_of_the_command_line(path: str, program_name: str, program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    told = program.run("export", program_name, path, "--units", "mm", "--share", "0.01")
    assert told.returncode == 0, told.stderr
    assert st.export(program_name, path, units="mm", share=0.01) == told.stdout


def test_options_are_those_of_the_command_line(program: Program, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(ROOT)
    path = "examples/crowned_punch.toml"
    options = ["--content", "surface,force,moment", "--reach", "5", "--load-factor", "1.5", "--moment-share", "0.25", "--length", "40 mm", "--datum-depth", "0.5 m"]
    told = program.run("export", "abaqus", path, *options, "--set", "load.moment=0", "-o", tmp_path / "told.inp")
    assert told.returncode == 0, told.stderr
    text = st.export(
        "abaqus",
        path,
        content=["moment", "surface", "force"],
        reach=np.float64(5),
        load_factor=1.5,
        moment_share=0.25,
        length="40 mm",
        datum_depth=0.5,
        moment=0,
    )
    assert text.encode() == (tmp_path / "told.inp").read_bytes()


def test_what_no_file_has_is_exported_too(tmp_path: Path) -> None:
    problem = st.Problem(
        st.Foundation(young_modulus=200e9, poisson_ratio=0.3, roughness=POWER),
        st.Punch(half_width=5e-3, profile=lambda x: x**2 / 40),
        st.Load(force=8e5),
    )
    text = st.export("calculix", problem, units="mm")
    # The largest pressure is that of the callable, not of the flat base that stands for it in the text.
    peak = float(text.split("largest pressure of this contact, ")[1].split(" MPa")[0])
    assert abs(peak * 1e6 / problem.solve().peak_pressure - 1) < 1e-5
    (tmp_path / "rough.inp").write_text(text)
    law = st.roughness("table", tmp_path / "rough.inp")["roughness"]
    assert abs(law["exponent"] / 0.4 - 1) < 1e-10
    for pressure in (1e6, 8e7, 1e9):
        assert abs(law["coefficient"] * pressure ** law["exponent"] / (1e-9 * pressure**0.4) - 1) < 1e-10


@pytest.mark.parametrize(
    ("program_name", "keywords", "said"),
    [
        ("nastran", {}, "program must be one of abaqus, calculix"),
        ("abaqus", {"content": "spring"}, "content must be one of"),
        ("abaqus", {"content": []}, "content must name"),
        ("abaqus", {"units": "inch"}, "units must be one of"),
        ("abaqus", {"share": 0}, "--share 0: must be from 1e-8 to 0.5"),
        ("abaqus", {"share": True}, "share must be a number or text"),
        ("abaqus", {"reach": 1e300}, "--reach"),
        ("abaqus", {"reach": float("nan")}, "--reach"),
        ("abaqus", {"length": "40 MPa"}, "--length"),
        ("abaqus", {"datum_depth": 1, "datum_distance": 1}, "not both"),
        ("abaqus", {"roughness": 0}, "a smooth surface has no pressure-overclosure law"),
        ("abaqus", {"contact": "bilateral"}, "unilateral"),
        ("calculix", {"roughness": POWER, "share": 1e-5}, "CalculiX keeps 200"),
    ],
)
def test_what_is_wrong_is_told(program_name: str, keywords: dict[str, Any], said: str, steel: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=said) as told:
        st.export(program_name, **{**steel, **keywords})
    assert "Usage" not in str(told.value)
    with pytest.raises(ValueError, match="dimensionless"):
        st.export("abaqus", theta0=1.0, force=1.0)
