"""The chapter of the ten tasks: what its commands print, and what its Python asserts. Its Rust runs with `cargo test --doc -p shtaerman`."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, Program

import shtaerman as st

TEXT = (ROOT / "docs/src/ten-tasks.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", TEXT, re.DOTALL | re.MULTILINE)


def blocks(language: str) -> list[str]:
    return [block for name, block in BLOCKS if name == language]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, program: Program) -> Path:
    """A folder with the examples, and with the program on the path."""
    made = tmp_path_factory.mktemp("tasks")
    (made / "examples").symlink_to(ROOT / "examples")
    (made / "bin").mkdir()
    (made / "bin/shtaerman").symlink_to(program.path.resolve())
    return made


def test_every_task_is_there_three_times() -> None:
    tasks = re.split(r"^## ", TEXT, flags=re.MULTILINE)[1:11]
    assert [task.split(".")[0] for task in tasks] == [str(number) for number in range(1, 11)]
    for task in tasks:
        assert re.findall(r"^```(\w+)$", task, re.MULTILINE) == ["sh", "text", "python", "rust"], task
        assert "assert" in task.split("```python")[1].split("```")[0] and "assert" in task.split("```rust")[1]
    assert {name for name, _ in BLOCKS} == {"sh", "text", "python", "rust", "matlab"}


@pytest.mark.skipif(os.name == "nt", reason="the commands are those of a POSIX shell")
def test_commands_print_what_is_shown(folder: Path) -> None:
    environment = {**os.environ, "PATH": f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}"}
    shown = 0
    for (language, block), (following, expected) in zip(BLOCKS, [*BLOCKS[1:], ("", "")]):
        if language != "sh":
            continue
        done = subprocess.run(["sh", "-eu", "-c", block], cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8", check=False)
        assert done.returncode == 0, (block, done.stderr)
        assert following == "text", block
        said = " ".join(done.stdout.split())
        for line in expected.splitlines():
            assert " ".join(line.split()) in said, (line, done.stdout)
            shown += 1
    assert shown >= 14
    for name in ("pressure.csv", "stress.csv", "cell_3.csv"):
        table = np.genfromtxt(folder / name, delimiter=",", names=True)
        assert table.size > 10 and all(np.isfinite(table[column]).all() for column in table.dtype.names), name


def test_python_of_the_tasks_runs(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    names: dict[str, object] = {"folder": folder}
    for block in blocks("python"):
        exec(compile(block, "ten-tasks.md", "exec"), names)


def test_what_matlab_calls_is_there(folder: Path, program: Program) -> None:
    """The command with its fields, and the calls into Python with their values."""
    command, calls = blocks("matlab")
    words = re.search(r"system\('(.*)'\)", command)
    assert words is not None
    asked = shlex.split(words.group(1))
    output = folder / "answer.json"
    done = subprocess.run([str(program.path), *asked[1:-1], str(output)], cwd=folder, capture_output=True, text=True, check=False)
    assert asked[0] == "shtaerman" and asked[-2:] == ["--output", "answer.json"] and done.returncode == 0, done.stderr
    answer = json.loads(output.read_text(encoding="utf-8"))
    fields = re.findall(r"answer\.([a-z_.]+)", command.replace("answer.json", ""))
    assert len(fields) == 4
    for field in fields:
        found = answer
        for name in field.split("."):
            found = found[name]
        assert np.isfinite(found).all(), field
    stated = re.search(r"py\.shtaerman\.solve\('(.*?)', pyargs\('(\w+)', '(.*?)'\)\)", calls)
    assert stated is not None
    contact = st.solve(folder / stated.group(1), **{stated.group(2): stated.group(3)})
    assert contact.settlement == answer["physical"]["settlement"]
    assert contact.pressure(np.linspace(-5e-3, 5e-3, 201)).shape == (201,) and "int32(201)" in calls
