#!/usr/bin/env python3
"""Tests the page in a real, headless Chromium.

    python3 crates/explore/tests/browser/run.py

Chromium is that of `SHTAERMAN_CHROMIUM`, one that is on the path, or Debian's, which is installed by apt-get where this may be done; where there is none the tests are left out, and it is said.
What Python needs goes into a virtual environment of its own, `target/browser-tests`; pictures of every tab in both themes are left in `target/browser-tests/screenshots`. Arguments go to pytest.
`--prepare` installs what is needed, and tests nothing. `test_redraw.py` measures times where `REDRAW=measure` is set.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[3]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
if not TARGET.is_absolute():
    TARGET = ROOT / TARGET
FOLDER = TARGET / "browser-tests"
NEEDED = ["axe-playwright-python>=0.1.4", "playwright>=1.45", "pytest>=7.4", "pytest-xdist>=3.3"]
NAMES = ["chromium", "chromium-browser", "google-chrome-stable", "google-chrome"]
PATIENCE = 300


def installed() -> str | None:
    named = os.environ.get("SHTAERMAN_CHROMIUM")
    return named or next((found for found in map(shutil.which, NAMES) if found), None)


def install() -> str | None:
    """Why Chromium cannot be installed; nothing where it was."""
    if not shutil.which("apt-get"):
        return "there is no apt-get"
    first = [] if os.geteuid() == 0 else ["sudo", "-n"]
    if first and not shutil.which("sudo"):
        return "this is not root, and there is no sudo"
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    said = ""
    for words in (["update"], ["install", "-y", "--no-install-recommends", "chromium"]):
        print("$ apt-get", *words, flush=True)
        try:
            done = subprocess.run([*first, "apt-get", "-q", *words], env=quiet, capture_output=True, text=True, timeout=PATIENCE, check=False)
        except subprocess.TimeoutExpired:
            return f"apt-get {words[0]} took longer than {PATIENCE} s"
        if done.returncode:
            said = (done.stderr.strip().splitlines() or ["no reason told"])[-1]
            if words[0] == "install":
                return f"apt-get install chromium failed: {said}"
    return None


def environment() -> Path:
    python = FOLDER / "environment" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    asked = hashlib.sha256(repr((sys.version, NEEDED)).encode()).hexdigest()
    mark = FOLDER / "environment" / "installed"
    if python.exists() and mark.exists() and mark.read_text() == asked:
        return python
    shutil.rmtree(FOLDER / "environment", ignore_errors=True)
    subprocess.run([sys.executable, "-m", "venv", FOLDER / "environment"], check=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", *NEEDED], check=True)
    mark.write_text(asked)
    return python


def is_place(argument: str) -> bool:
    return Path(argument.split("::")[0]).exists()


def main(arguments: list[str]) -> int:
    browser = installed()
    if browser is None:
        why = "this is no Unix" if os.name == "nt" else install()
        browser = installed()
        if browser is None:
            print(f"SKIPPED: the tests of the page in a browser: there is no Chromium, and it cannot be installed: {why}", flush=True)
            return 0
    if arguments == ["--prepare"]:
        environment()
        return 0
    # As `cargo test --workspace` builds, so that nothing is compiled twice.
    program = os.environ.get("SHTAERMAN")
    if program is None:
        build = ["cargo", "build", "--quiet", "--workspace", "--lib", "--bins", "--tests"]
        subprocess.run(build, cwd=ROOT, env={**os.environ, "PYO3_NO_PYTHON": "1"}, check=True)
        program = str(TARGET / "debug" / ("shtaerman.exe" if os.name == "nt" else "shtaerman"))
    python = environment()
    variables = {"SHTAERMAN": program, "SHTAERMAN_CHROMIUM": browser, "SCREENSHOTS": str(FOLDER / "screenshots"), "PYTHONDONTWRITEBYTECODE": "1"}
    pytest = [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir", HERE]
    if arguments:
        return run([*pytest, *arguments, *([] if any(map(is_place, arguments)) else [HERE])], variables)
    return run([*pytest, "-n", "2", "--dist", "loadfile", HERE], variables)


def run(command: list[object], variables: dict[str, str]) -> int:
    words = list(map(str, command))
    print("$", *words, flush=True)
    return subprocess.run(words, cwd=ROOT, env={**os.environ, **variables}, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
