"""Parquet parts of the command line: `python3 python/run_tests.py --parquet` builds it with its feature, which takes a minute more."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import Program
from test_sweep import STUDY

import shtaerman as st


def test_parquet_of_the_command_line_is_read_by_pyarrow_and_gone_on_with(tmp_path: Path, program: Program) -> None:
    import pyarrow.parquet

    (tmp_path / "study.toml").write_text(STUDY)
    done = subprocess.run(
        [program.path, "sweep", "study.toml", "-o", "theirs", "--format", "parquet"], cwd=tmp_path, check=False, capture_output=True, text=True
    )
    if "was built without it" in done.stderr:
        assert done.returncode == 2
        pytest.skip("the program was built without Parquet: run_tests.py --parquet")
    assert done.returncode == 0, done.stderr
    ours = st.sweep(tmp_path / "study.toml", tmp_path / "ours", format="parquet").arrays()
    theirs = pyarrow.parquet.read_table(tmp_path / "theirs")
    assert theirs.column_names == list(ours)
    for name, values in ours.items():
        told = theirs[name].to_numpy()
        assert told.dtype == values.dtype and (told == values).all(), name
    # Python goes on with what the command line began, and the other way round.
    for left, there in (("part-00000002.parquet", "theirs"), ("part-00000003.parquet", "ours")):
        (tmp_path / there / left).unlink()
    again = st.sweep(tmp_path / "study.toml", tmp_path / "theirs", format="parquet").arrays()
    assert all(np.array_equal(again[name], ours[name]) for name in ours)
    told = subprocess.run(
        [program.path, "sweep", "study.toml", "-o", "ours", "--format", "parquet", "--summary"], cwd=tmp_path, check=True, capture_output=True, text=True
    ).stdout
    assert "6 kept, 1 missing" in told, told
