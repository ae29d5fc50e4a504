"""Studies: the same rows on threads, processes and workers, whatever befalls them."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT, Program

import shtaerman as st
from shtaerman import _sweep

PROBLEM = """
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
half_width = "5 mm"
profile = "x^2 / 40"

[load]
force = "0.8 MN/m"
moment = 0
"""
STUDY = (
    PROBLEM
    + """
[study]
vary."load.force" = { from = "0.1 MN/m", to = "2 MN/m", count = 9 }
vary."foundation.roughness" = ["1e-15 m/Pa", "1e-14 m/Pa", "1e-13 m/Pa"]
outputs = ["settlement", "peak_pressure"]
part_size = 4
audited_sample = 3
"""
)


def contents(folder: Path) -> dict[str, bytes]:
    return {entry.name: entry.read_bytes() for entry in sorted(folder.iterdir()) if not entry.name.startswith(".")}


def test_the_chapter_of_the_book_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs/src/studies.md").read_text(encoding="utf-8")
    names: dict[str, Any] = {}
    for block in re.findall(r"```python\n(.*?)```", text, re.DOTALL):
        exec(compile(block, "studies.md", "exec"), names)
    assert names["run"]().cases == 64


def test_rows_are_single_solves(tmp_path: Path) -> None:
    found = st.sweep(STUDY, tmp_path / "out")
    arrays = found.arrays()
    assert found.cases == 27 and arrays["case"].tolist() == list(range(27))
    for case in (0, 13, 26):
        force, roughness = arrays["load.force"][case], arrays["foundation.roughness"][case]
        alone = st.solve(PROBLEM, force=force, roughness=roughness, audit=False)
        assert arrays["settlement"][case] == alone.settlement
        assert arrays["peak_pressure"][case] == alone.peak_pressure
        assert arrays["settlement_error"][case] == alone.error.settlement
    data = found.to_xarray()
    # Keys in alphabetical order, the last changes fastest.
    assert data.settlement.dims == ("foundation.roughness", "load.force") and data.settlement.shape == (3, 9)
    assert float(data.settlement[2, 0]) == arrays["settlement"][18]
    assert found.to_pandas().shape == (27, 10)
    assert not any(arrays["warnings"])
    told = found.summary()["settlement"]
    assert told["largest"] == arrays["settlement"].max() and arrays["settlement"][int(told["least_case"])] == told["least"]
    sample = found.audited_sample
    assert sample is not None and len(sample[0]["case"]) == 3
    assert (np.abs(sample[0]["settlement"] - sample[1]["settlement"]) <= sample[1]["settlement_error"]).all()


def test_the_command_line_writes_the_same_bytes(tmp_path: Path, program: Program) -> None:
    (tmp_path / "study.toml").write_text(STUDY)
    subprocess.run([program.path, "sweep", "study.toml", "-o", "theirs"], cwd=tmp_path, check=True, capture_output=True)
    st.sweep(tmp_path / "study.toml", tmp_path / "ours")
    assert contents(tmp_path / "ours") == contents(tmp_path / "theirs")
    # Either goes on with what the other has begun.
    (tmp_path / "theirs" / "part-00000003.csv").unlink()
    st.sweep(tmp_path / "study.toml", tmp_path / "theirs")
    assert contents(tmp_path / "ours") == contents(tmp_path / "theirs")


@pytest.mark.parametrize("format", ["csv", "npz", "parquet"])
def test_formats_agree_and_parts_that_are_cut_are_done_again(tmp_path: Path, format: str) -> None:
    found = st.sweep(STUDY, tmp_path / "out", format=format)
    first = contents(tmp_path / "out")
    rows = st.sweep(STUDY, tmp_path / "text").arrays()
    arrays = found.arrays()
    assert list(arrays) == list(rows)
    assert all(np.array_equal(arrays[name], rows[name]) for name in rows)
    part = tmp_path / "out" / f"part-00000002.{format}"
    whole = part.read_bytes()
    flipped = bytearray(whole)
    if format != "csv":
        # One bit of a number, which checksums tell; text has none.
        flipped[whole.index(arrays["settlement"][9].tobytes())] ^= 1
    for broken in (whole[:-60], whole[:3], b"", bytes(flipped)):
        part.write_bytes(broken)
        assert len(st.sweep(STUDY, tmp_path / "out", format=format).arrays()["case"]) == 27
        assert contents(tmp_path / "out") == first


def test_files_are_read_by_their_own_tools(tmp_path: Path) -> None:
    import pyarrow.parquet

    st.sweep(STUDY, tmp_path / "npz", format="npz")
    with np.load(tmp_path / "npz" / "part-00000001.npz") as part:
        assert part["case"].tolist() == [4, 5, 6, 7] and part["error_kind"].tolist() == ["estimate"] * 4
        assert part["load.force"].dtype == np.float64
    st.sweep(STUDY, tmp_path / "parquet", format="parquet")
    # The folder is one table: what begins with an underscore is no part of it.
    assert len(pyarrow.parquet.read_table(tmp_path / "parquet")) == 27


def test_shares_and_other_processes_give_the_same_bytes(tmp_path: Path) -> None:
    st.sweep(STUDY, tmp_path / "whole", threads=1)
    whole = contents(tmp_path / "whole")
    for index in (2, 1, 3):
        st.sweep(STUDY, tmp_path / "shares", shard=(index, 3))
    assert contents(tmp_path / "shares") == whole
    told: list[tuple[int, int]] = []
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        st.sweep(STUDY, tmp_path / "pool", map=pool.map, progress=lambda done, all_: told.append((done, all_)))
    assert contents(tmp_path / "pool") == whole
    assert told[-1] == (7, 7)


def test_a_worker_that_is_killed_loses_nothing(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    study = STUDY.replace("count = 9", "count = 40").replace("part_size = 4", "part_size = 1")
    st.sweep(study, tmp_path / "here")
    import dask

    # A worker that dies is started again, and its tasks are done by the others meanwhile.
    settings = {"distributed.scheduler.allowed-failures": 5, "distributed.admin.log-format": "%(message)s"}
    with (
        dask.config.set(settings),
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50) as cluster,
        distributed.Client(cluster) as client,
    ):
        victim = next(iter(client.scheduler_info()["workers"].values()))
        pid = client.run(os.getpid, workers=[victim["address"]] if "address" in victim else None)
        killed = threading.Event()

        def kill(done: int, _: int) -> None:
            # Half-way.
            if done >= 30 and not killed.is_set():
                killed.set()
                os.kill(next(iter(pid.values())), signal.SIGKILL)

        found = st.sweep(study, tmp_path / "there", client=client, progress=kill)
    assert killed.is_set()
    assert found.arrays()["case"].tolist() == list(range(120))
    assert contents(tmp_path / "there") == contents(tmp_path / "here")


def test_a_run_that_is_killed_goes_on_to_the_same_bytes(tmp_path: Path) -> None:
    study = STUDY.replace("count = 9", "count = 60").replace("part_size = 4", "part_size = 2")
    (tmp_path / "study.toml").write_text(study)
    st.sweep(study, tmp_path / "whole")
    script = f"import shtaerman as st; st.sweep({os.fspath(tmp_path / 'study.toml')!r}, {os.fspath(tmp_path / 'out')!r})"
    generator = np.random.default_rng(411)
    for _ in range(6):
        with subprocess.Popen([sys.executable, "-c", script]) as run:
            deadline = time.monotonic() + 20
            while not (tmp_path / "out" / "_study.json").exists() and time.monotonic() < deadline:
                time.sleep(0.01)
            time.sleep(generator.uniform(0.0, 0.1))
            run.kill()
    found = st.sweep(tmp_path / "study.toml", tmp_path / "out")
    assert found.arrays()["case"].tolist() == list(range(180))
    ours, whole = contents(tmp_path / "out"), contents(tmp_path / "whole")
    # The manifest has the name of the file.
    assert {name: text for name, text in ours.items() if name != "_study.json"} == {
        name: text for name, text in whole.items() if name != "_study.json"
    }


def test_a_dictionary_is_a_study(tmp_path: Path) -> None:
    tables: dict[str, Any] = {
        "dimensionless": {"theta0": 1.0, "profile": "xi^2", "force": 1.0, "moment": 0},
        "solver": {"contact": "bilateral"},
        "study": {
            "design": "latin-hypercube",
            "count": 50,
            "seed": 3,
            "vary": {"dimensionless.theta0": {"from": 0.1, "to": 100.0, "scale": "log"}, "dimensionless.force": np.array([1.0, 2.0])},
            "outputs": ["settlement", "force"],
        },
    }
    found = st.sweep(tables, tmp_path / "out", overrides=["study.seed=4"])
    arrays = found.arrays()
    assert set(arrays["force"]) == {1.0, 2.0} and (arrays["error_kind"] == "estimate").all()
    problem = {key: tables[key] for key in ("dimensionless", "solver")}
    alone = st.solve(problem, theta0=arrays["dimensionless.theta0"][7], force=arrays["force"][7])
    assert abs(alone.settlement - arrays["settlement"][7]) <= alone.error.settlement + arrays["settlement_error"][7]


def test_a_worker_of_another_version_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def elsewhere(work: Any, tasks: Any) -> Any:
        for task in tasks:
            yield work(_sweep._Task(task.source, "0.0.9", task.folder, task.format, task.parts, task.threads))

    with pytest.raises(ValueError, match=r"worker has version .* begun by 0\.0\.9"):
        st.sweep(STUDY, tmp_path / "out", map=elsewhere)


@pytest.mark.parametrize(
    ("study", "keywords", "said"),
    [
        ("\n", {}, "the file is empty"),
        (PROBLEM, {}, "study: is missing"),
        (STUDY.replace('vary."load.force" = { from = "0.1 MN/m"', 'vary."load.force" = { from = "0.1 mm"'), {}, "load.force"),
        (STUDY, {"format": "xlsx"}, "format: must be one of csv, npz, parquet"),
        (STUDY, {"shard": (4, 3)}, "shard: must be"),
        (STUDY, {"shard": "1/3"}, "shard: must be"),
        (STUDY, {"threads": 0}, "threads: must be"),
        (STUDY, {"overrides": "study.seed=1"}, "overrides: must be a list"),
        (STUDY, {"map": map, "client": object()}, "not both"),
        (STUDY, {"client": 3}, "client: must be a distributed.Client, got int"),
        (STUDY, {"map": 3}, "map: must be a function"),
        (STUDY, {"map": lambda *_: None}, "map: must give an iterable"),
        (STUDY.replace("count = 9", "count = 900000"), {}, "has 2700000 cases"),
        (3, {}, "takes a path"),
        ({"study": 3}, {}, "study: is missing"),
        ("nowhere.toml", {}, "nowhere.toml"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, study: Any, keywords: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        st.sweep(study, tmp_path / "out", **keywords)


def test_a_folder_of_something_else_is_left_alone(tmp_path: Path) -> None:
    st.sweep(STUDY, tmp_path / "out")
    before = contents(tmp_path / "out")
    with pytest.raises(ValueError, match="has results of another study"):
        st.sweep(STUDY.replace("count = 9", "count = 8"), tmp_path / "out")
    with pytest.raises(ValueError, match="has results of this study as csv, not npz"):
        st.sweep(STUDY, tmp_path / "out", format="npz")
    manifest = json.loads(before["_study.json"])
    (tmp_path / "out" / "_study.json").write_text(json.dumps({**manifest, "version": "0.0.1"}))
    with pytest.raises(ValueError, match=r"version 0\.0\.1 of the program"):
        st.sweep(STUDY, tmp_path / "out")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").write_text("mine")
    with pytest.raises(ValueError, match="is no folder of results"):
        st.sweep(STUDY, tmp_path / "mine")
    (tmp_path / "file").write_text("mine")
    with pytest.raises(ValueError, match="is a file"):
        st.sweep(STUDY, tmp_path / "file")


@pytest.mark.skipif(sys.platform == "win32", reason="has no limits of a process")
@pytest.mark.parametrize("format", ["csv", "npz", "parquet"])
def test_what_cannot_be_written_is_an_os_error(tmp_path: Path, format: str) -> None:
    out = tmp_path / "out"
    st.sweep(STUDY, out, format=format)
    whole = contents(out)
    part = next(name for name in whole if name.startswith("part-00000001"))
    (out / part).unlink()
    # As on a full disk: files may be no longer than 64 bytes.
    script = f"""if True:
        import resource
        import shtaerman as st
        resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64))
        try:
            st.sweep({STUDY!r}, {str(out)!r}, format={format!r})
        except OSError as error:
            print(error)
    """
    told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    assert part in told, told
    assert {name: kept for name, kept in whole.items() if name != part} == contents(out)
    assert not [entry.name for entry in out.iterdir() if entry.name.startswith(".")]
    st.sweep(STUDY, out, format=format)
    assert contents(out) == whole


def test_indices_are_those_of_a_sum(tmp_path: Path) -> None:
    # A bilateral contact is linear in settlement and tilt, which vary with the variances 4/12 and 0.16.
    flat = {"theta0": 1.0, "profile": "0", "settlement": 1.0, "tilt": 0.0}
    varied = {
        "dimensionless.settlement": {"distribution": "uniform", "from": 1, "to": 3},
        "dimensionless.tilt": {"distribution": "normal", "mean": 0, "standard_deviation": 0.4},
    }
    design = {"design": "sobol-indices", "count": 2048, "seed": 11, "audited_sample": 0, "vary": varied, "outputs": ["pressure_right", "force"]}
    found = st.sweep({"dimensionless": flat, "solver": {"contact": "bilateral"}, "study": design}, tmp_path / "out")
    [lifted, turned] = [
        st.solve(theta0=1.0, profile="0", contact="bilateral", settlement=settlement, tilt=tilt).pressure_right for settlement, tilt in [(1.0, 0.0), (0.0, 1.0)]
    ]
    variances = [lifted**2 * 4 / 12, turned**2 * 0.16]
    indices = found.indices()
    for key, variance in zip(varied, variances):
        told = indices["pressure_right"][key]
        for name in ("first", "total"):
            assert abs(told[name] - variance / sum(variances)) < 3 * told[f"{name}_error"] < 0.1, (key, told)
    assert abs(indices["force"]["dimensionless.tilt"]["total"]) < 1e-12
    with pytest.raises(ValueError, match="sobol-indices"):
        st.sweep(STUDY, tmp_path / "other").indices()


@pytest.mark.skipif(sys.platform == "win32", reason="has no SIGINT for a child alone")
def test_an_interrupted_study_stops(tmp_path: Path) -> None:
    study = STUDY.replace("count = 9", "count = 6000").replace("part_size = 4", "part_size = 6000")
    script = f"""if True:
        import os, time
        import shtaerman as st
        print("go", flush=True)
        try:
            st.sweep({study!r}, {str(tmp_path / "out")!r})
        except KeyboardInterrupt:
            # A case on its way is left to itself; no other is begun.
            time.sleep(0.2)
            before = os.times()
            time.sleep(0.5)
            print(os.times().user - before.user)
        """
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout is not None and run.stdout.readline() == "go\n"
        time.sleep(0.3)
        run.send_signal(signal.SIGINT)
        told = run.stdout.readline()
    assert told and float(told) < 0.05, told
    assert list(contents(tmp_path / "out")) == ["_study.json"]
