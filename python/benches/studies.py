"""How long studies take, with the package that is installed (`pip install './python[dask,parquet]'`: an optimised build).

    python python/benches/studies.py [million | unilateral | dask | kills] [--count N]

million: bilateral cases in which theta0, force and moment vary, to Parquet, with the peak of memory for a tenth of the cases and for all.
unilateral: cases of one zone, as CSV, on all processors.
dask: the same on two local workers and on two threads, in turn.
kills: a run is killed at 50 random moments and goes on; the bytes are compared with those of a run in one piece.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import shtaerman as st

MILLION = """
[dimensionless]
theta0 = 3.0
profile = "xi^2"
force = 2.0
moment = 0.1

[solver]
contact = "bilateral"

[study]
design = "random"
count = 1000000
seed = 1
vary."dimensionless.theta0" = { from = 0.1, to = 100.0, scale = "log" }
vary."dimensionless.force" = { from = 1.0, to = 5.0 }
vary."dimensionless.moment" = { from = -0.3, to = 0.3 }
outputs = ["settlement", "tilt", "pressure_left", "pressure_right"]
"""
UNILATERAL = """
[dimensionless]
theta0 = 3.0
profile = "4*xi^2"
force = 0.5
moment = 0.02

[study]
design = "random"
count = 100000
seed = 1
vary."dimensionless.theta0" = { from = 0.5, to = 50.0, scale = "log" }
vary."dimensionless.force" = { from = 0.2, to = 0.9 }
vary."dimensionless.moment" = { from = -0.02, to = 0.02 }
outputs = ["settlement", "tilt", "peak_pressure", "contact_width"]
"""


def timed(study: str, count: int, **options: Any) -> float:
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        found = st.sweep(study, Path(folder) / "out", overrides=[f"study.count={count}"], **options)
        took = time.perf_counter() - start
        assert len(found.paths) > 0 and found.arrays()["reason"].tolist().count("") > 0.99 * count
    return took


def million(count: int) -> None:
    # Each in a process of its own: the peak of one would hide the other's.
    for part in (count // 10, count):
        script = f"import sys; sys.path.insert(0, {os.fspath(Path(__file__).parent)!r}); import studies; studies.one_million({part})"
        subprocess.run([sys.executable, "-c", script], check=True)


def one_million(count: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        st.sweep(MILLION, Path(folder) / "out", format="parquet", overrides=[f"study.count={count}"])
        took = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{count} bilateral cases to Parquet: {took:.2f} s, peak of memory {peak:.0f} MB")


def unilateral(count: int) -> None:
    print(f"{count} unilateral cases: {timed(UNILATERAL, count):.1f} s on {os.cpu_count()} processors")


def dask(count: int) -> None:
    from distributed import Client, LocalCluster

    here = there = 0.0
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        for _ in range(2):
            here += timed(UNILATERAL, count, threads=2)
            there += timed(UNILATERAL, count, client=client)
    print(f"{count} unilateral cases, mean of two in turn: {here / 2:.1f} s on two threads, {there / 2:.1f} s on two workers, ratio {there / here:.3f}")


def kills(count: int) -> None:
    generator = random.Random(2026)
    with tempfile.TemporaryDirectory() as folder:
        study = Path(folder) / "study.toml"
        # Small parts: a moment is within one or between two.
        study.write_text(UNILATERAL)
        given = ["study.count=40000", "study.part_size=40", "study.audited_sample=0"]
        st.sweep(study, Path(folder) / "whole", overrides=given)
        script = f"import shtaerman as st; print('begun', flush=True); st.sweep({os.fspath(study)!r}, {os.fspath(Path(folder) / 'out')!r}, overrides={given!r})"
        killed = 0
        for _ in range(count):
            with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE) as run:
                assert run.stdout is not None
                run.stdout.readline()
                time.sleep(generator.uniform(0.0, 0.6))
                killed += run.poll() is None
                run.kill()
        done = len(list((Path(folder) / "out").glob("part-*.csv")))
        st.sweep(study, Path(folder) / "out", overrides=given)
        names = sorted(path.name for path in (Path(folder) / "whole").iterdir())
        same = all((Path(folder) / "out" / name).read_bytes() == (Path(folder) / "whole" / name).read_bytes() for name in names)
        print(f"{killed} of {count} runs killed on the way, {done} of {len(names) - 1} parts done by then; every file the same bytes: {same}")


KINDS = {"million": (million, 1_000_000), "unilateral": (unilateral, 100_000), "dask": (dask, 100_000), "kills": (kills, 50)}

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=KINDS, nargs="?", help="one of them; all where left out")
    parser.add_argument("--count", type=int, help="cases, or kills")
    arguments = parser.parse_args()
    for name in [arguments.kind] if arguments.kind else list(KINDS):
        measure, usual = KINDS[name]
        measure(arguments.count or usual)
