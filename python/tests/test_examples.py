"""The examples run and say what is so; those in the documentation, too."""

from __future__ import annotations

import collections
import doctest
import importlib
import json
import math
import pkgutil
import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, Program

import shtaerman as st

FOLDER = ROOT / "examples/python"
MODULES = [module.name for module in pkgutil.iter_modules(st.__path__) if module.name != "_shtaerman"]


SCRIPTS = sorted(FOLDER.glob("*.py"))
#: Those whose tests below look at what they found.
LOOKED_AT = {"first_contact", "many_cases", "crown", "design_study", "paper_tables", "own_kernel", "calibration", "dask_study"}


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_examples_are_notebooks_that_assert_what_they_claim(path: Path) -> None:
    """Percent format: text in markdown cells alone, each followed by code; so editors and jupytext open them."""
    text = path.read_text(encoding="utf-8")
    cells = re.split(r"^(?=# %%)", text, flags=re.MULTILINE)
    assert cells[0] == "" and cells[1].startswith("# %% [markdown]\n# # ")
    for cell in cells[1:]:
        mark, *lines = cell.strip("\n").split("\n")
        if mark == "# %% [markdown]":
            assert all(line.startswith("# ") or line in ("#", "") for line in lines), cell
        else:
            assert mark == "# %%" and lines, cell
            compile("\n".join(lines), path.name, "exec")
    assert f"python examples/python/{path.name}" in text and "assert " in text


def test_every_example_is_tested() -> None:
    assert LOOKED_AT == {name.removeprefix("test_") for name in globals() if name.startswith("test_")} & {path.stem for path in SCRIPTS}
    listed = (ROOT / "README.md").read_text(encoding="utf-8") + (ROOT / "docs/src/python.md").read_text(encoding="utf-8")
    assert all(path.stem in listed for path in SCRIPTS)


def test_first_contact(capsys: pytest.CaptureFixture[str]) -> None:
    said = runpy.run_path(str(FOLDER / "first_contact.py"))
    assert said["force"] == pytest.approx(0.8e6, rel=1e-9)
    for name in ("by_callable", "by_points"):
        assert said[name].settlement == pytest.approx(said["contact"].settlement, rel=1e-9)
    assert "error (bound)" in capsys.readouterr().out


def test_many_cases() -> None:
    said = runpy.run_path(str(FOLDER / "many_cases.py"))
    found = said["found"]
    assert found.solved.all() and found.shape == (30, 20)
    assert found.mean_pressure == pytest.approx(np.broadcast_to(said["force"] / 10e-3, (30, 20)), rel=1e-12)
    assert said["falls"] == 1.0 and said["odd"].solved.tolist() == [True, False, False]


def test_crown() -> None:
    """Two ways to the best crown that share nothing but the solver, and a system of two equations that is met."""
    said = runpy.run_path(str(FOLDER / "crown.py"))
    crown, lowest = said["crown"], said["lowest"]
    assert 20.0 / np.exp(said["best"]) == pytest.approx(crown.best.radius, rel=1e-8)
    assert lowest.peak_pressure == pytest.approx(crown.best.contact.peak_pressure, rel=1e-8)
    assert said["both"].peak_pressure == pytest.approx(150e6, rel=1e-9)
    assert said["both"].contact_width == pytest.approx(9e-3, rel=1e-9)


def test_design_study() -> None:
    """The robust crown against a search by brute force over radius, force and eccentricity."""
    said = runpy.run_path(str(FOLDER / "design_study.py"))
    radii = np.linspace(said["smallest"], said["largest"], 41).tolist()
    worst = [said["peaks"](radius).max() for radius in radii]
    assert min(worst) == pytest.approx(said["robust"].max(), rel=2e-3) and min(worst) >= said["robust"].max() * (1 - 1e-9)
    assert said["smallest"] < said["radius"] < said["largest"] and said["contact"].error.kind == "bound"


def test_paper_tables(program: Program) -> None:
    """What the script counts is what `shtaerman reproduce` says."""
    said = runpy.run_path(str(FOLDER / "paper_tables.py"))
    told = json.loads(program.json("reproduce"))
    reasons = collections.Counter(figure["reason"] for figure in told["figures"])
    named = {None: "true", "truncation": "truncated", "pressure_formula": "pressure formula", "sign": "sign", "misprint": "misprint"}
    assert {named[reason]: count for reason, count in reasons.items()} == said["count"]


def test_own_kernel() -> None:
    """Its kernel at places is the function in closed form."""
    said = runpy.run_path(str(FOLDER / "own_kernel.py"))
    for h in (0.05, 1.0, 10.0):
        split = said["layer"](h).function
        for distance in (1e-9, 1e-4, 3e-3 * h, 0.1, 2.0):
            a, b = split(0.0, distance, distance)
            exact = -math.log(math.tanh(0.25 * math.pi * distance / h))
            assert a * math.log(distance) + b == pytest.approx(exact, abs=1e-13 * abs(math.log(distance)) + 1e-14)
    assert said["force"][10.0] < said["force"][1.0] < said["force"][0.1]


def test_calibration() -> None:
    """The fit against a search without derivatives."""
    said = runpy.run_path(str(FOLDER / "calibration.py"))
    chi, zero = math.exp(said["fit"].x[0]), 1e-6 * said["fit"].x[1]

    def misfit(roughness: float, offset: float) -> float:
        found = st.solve_many(said["plate"].replace(roughness=roughness), force=said["force"], outputs=["settlement"])
        return float(((found.settlement + offset - said["measured"]) ** 2).sum())

    best = misfit(chi, zero)
    for share in (0.999, 1.001):
        assert misfit(share * chi, zero) > best and misfit(chi, share * zero) > best


def test_dask_study(capsys: pytest.CaptureFixture[str]) -> None:
    found = runpy.run_path(str(FOLDER / "dask_study.py"))["main"]()
    rows = found.arrays()
    assert rows["case"].tolist() == list(range(256)) and (rows["reason"] == "").all()
    # Of 256 points of a Sobol sequence the mean of the force is nearly that of its distribution.
    assert rows["load.force"].mean() == pytest.approx(0.6e6, rel=2e-3)
    assert rows["foundation.roughness"].mean() == pytest.approx(2e-14, rel=1e-2)
    assert "largest pressure" in capsys.readouterr().out


@pytest.mark.parametrize("name", MODULES)
def test_examples_in_the_documentation(name: str) -> None:
    module = importlib.import_module(f"shtaerman.{name}")
    assert doctest.testmod(module).failed == 0


def test_there_are_examples_in_the_documentation() -> None:
    finder = doctest.DocTestFinder(exclude_empty=True)
    count = sum(len(test.examples) for name in MODULES for test in finder.find(importlib.import_module(f"shtaerman.{name}")))
    assert count >= 30
    assert doctest.testmod(st).attempted >= 3 and doctest.testmod(st).failed == 0


@pytest.mark.parametrize("path", [ROOT / "python/README.md", ROOT / "docs/src/python.md"], ids=lambda path: path.name)
def test_code_in_the_texts_runs(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    blocks = re.findall(r"```python\n(.*?)```", path.read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 3
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {"output": str(tmp_path / "contact.png")}
    # One after the other, as a reader would.
    for block in blocks:
        exec(compile(block, str(path), "exec"), names)
