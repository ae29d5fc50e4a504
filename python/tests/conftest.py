"""What the tests share."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

# A shell has what it runs in the background ignore SIGINT, and every child inherits that; the tests that interrupt one need it to listen.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


class Program:
    """The command line, of the same build."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def run(self, *words: object, text: str | None = None) -> subprocess.CompletedProcess[str]:
        command = [str(self.path), *map(str, words)]
        return subprocess.run(command, input=text, capture_output=True, text=True, encoding="utf-8", cwd=ROOT, check=False)

    def json(self, *words: object) -> str:
        done = self.run(*words, "--format", "json")
        assert done.returncode == 0, done.stderr
        return done.stdout


@pytest.fixture(scope="session")
def program() -> Program:
    path = Path(os.environ.get("SHTAERMAN", ROOT / "target/debug/shtaerman"))
    assert path.exists(), f"{path} is not there: run python/run_tests.py"
    return Program(path)


@pytest.fixture
def steel() -> dict[str, object]:
    """A flat steel punch on ground steel, as in examples/flat_punch.toml."""
    return {"young_modulus": "200 GPa", "poisson_ratio": 0.3, "roughness": "1.2e-14 m/Pa", "half_width": "5 mm", "force": "0.8 MN/m"}
