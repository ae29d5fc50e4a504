#!/usr/bin/env python3
"""What Python costs beside Rust, both measured in the same run, in turns.

    pip install ./python && python3 python/benches/beside_rust.py [COUNT]

Ten million bilateral cases in which theta0 alone varies, and one solve with its audit, from keywords to numbers. The machine should be idle, the package built by pip, since that optimises.
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
    ours, theirs = [], []
    for _ in range(ROUNDS):
        begun = time.perf_counter()
        found = st.solve_many(problem, theta0=theta0, outputs=["settlement", "pressure_right"], threads=THREADS)
        ours.append(time.perf_counter() - begun)
        assert found.solved.all()
        del found
        theirs.extend(rust("sweep", count, THREADS, 1))
    one, other = statistics.median(ours), statistics.median(theirs)
    print(f"solve_many, {count} theta0, {THREADS} threads: {one:.3f} s, Rust {other:.3f} s: {count / one / 1e6:.2f} and {count / other / 1e6:.2f} million a second, {100 * other / one:.0f} %")


def solves() -> None:
    path = ROOT / "examples/crowned_punch.toml"
    text = path.read_text(encoding="utf-8")
    keywords = dict(young_modulus="200 GPa", poisson_ratio=0.3, roughness="1.2e-14 m/Pa", half_width="5 mm", profile="x^2 / (2*20)", force="0.8 MN/m")
    from_text, from_keywords, theirs = [], [], []
    for _ in range(ROUNDS):
        for times, call in ((from_text, lambda: st.solve(text)), (from_keywords, lambda: st.solve(**keywords))):
            for _ in range(SOLVES):
                begun = time.perf_counter()
                contact = call()
                contact.settlement, contact.peak_pressure, contact.error
                times.append(time.perf_counter() - begun)
        theirs.extend(rust("solve", path, SOLVES))
    medians = [1e3 * statistics.median(times) for times in (from_text, from_keywords, theirs)]
    print("one solve with audit: from text {:.3f} ms, from keywords {:.3f} ms, Rust {:.3f} ms".format(*medians))


if __name__ == "__main__":
    rust("solve", ROOT / "examples/crowned_punch.toml", 1)
    sweeps(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000_000)
    solves()
