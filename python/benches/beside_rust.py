#!/usr/bin/env python3
"""What Python costs beside Rust, both measured in the same run, in turns.

    pip install ./python && python3 python/benches/beside_rust.py [COUNT]

Ten million bilateral cases in which theta0 alone varies, and one solve with its audit, from keywords to numbers; the least of some rounds, of single solves the least of their medians. The machine
should be idle, the package built by pip, since that optimises.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import shtaerman as st

ROOT = Path(__file__).resolve().parents[2]
ROUNDS = 5
SOLVES = 300
THREADS = 2


def rust(*words: object) -> list[float]:
    """Seconds that the Rust of `crates/shtaerman/examples/beside_python.rs` takes."""
    command = ["cargo", "run", "--quiet", "--release", "-p", "shtaerman", "--example", "beside_python", "--", *map(str, words)]
    told = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [float(line) for line in told.split()]


def sweeps(count: int) -> None:
    problem = st.Problem(st.Foundation(theta0=1.0), st.Punch(profile="xi^2"), st.Load(force=2.0), st.Solver(contact="bilateral"))
    theta0 = np.geomspace(0.01, 100.0, count)
    ours: list[float] = []
    theirs: dict[str, list[float]] = {"sweep": [], "errors": []}
    for _ in range(ROUNDS):
        begun = time.perf_counter()
        found = st.solve_many(problem, theta0=theta0, outputs=["settlement", "pressure_right"], threads=THREADS)
        ours.append(time.perf_counter() - begun)
        assert np.isfinite(found.settlement).all()
        del found
        for name, times in theirs.items():
            times.extend(rust(name, count, THREADS, 1))
    print(f"{count} theta0 on {THREADS} threads, million a second: solve_many {count / min(ours) / 1e6:.2f}", end="")
    for name, said in (("errors", "Rust with the same errors"), ("sweep", "Rust without errors")):
        least = min(theirs[name])
        print(f", {said} {count / least / 1e6:.2f} ({100 * least / min(ours):.0f} %)", end="")
    print()


def solves() -> None:
    path = ROOT / "examples/crowned_punch.toml"
    text = path.read_text(encoding="utf-8")
    keywords = dict(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa", half_width="5 mm", profile="x^2 / (2*20)", force="0.8 MN/m")
    calls = {"text": lambda: st.solve(text), "keywords": lambda: st.solve(**keywords)}
    times: dict[str, list[float]] = {"text": [], "keywords": [], "Rust": []}
    for _ in range(ROUNDS):
        for name, call in calls.items():
            round_: list[float] = []
            for _ in range(SOLVES):
                begun = time.perf_counter()
                contact = call()
                contact.settlement, contact.peak_pressure, contact.error
                round_.append(time.perf_counter() - begun)
            times[name].append(statistics.median(round_))
        times["Rust"].append(statistics.median(rust("solve", path, SOLVES)))
    least = {name: 1e3 * min(medians) for name, medians in times.items()}
    print("one solve with its audit, ms: " + ", ".join(f"{name} {value:.3f}" for name, value in least.items()), end="")
    print(f"; Python over Rust {max(least['text'], least['keywords']) - least['Rust']:.3f}")


if __name__ == "__main__":
    rust("solve", ROOT / "examples/crowned_punch.toml", 1)
    sweeps(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000_000)
    solves()
