"""The examples run and say what is so; those in the documentation, too."""

from __future__ import annotations

import doctest
import importlib
import pkgutil
import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

import shtaerman as st

FOLDER = ROOT / "examples/python"
MODULES = [module.name for module in pkgutil.iter_modules(st.__path__) if module.name != "_shtaerman"]


def test_every_example_is_tested() -> None:
    assert {path.stem for path in FOLDER.glob("*.py")} == {"first_contact", "many_cases", "crown"}


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
