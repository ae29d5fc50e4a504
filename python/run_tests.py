#!/usr/bin/env python3
"""Builds the package and runs all that tests it: pytest, the examples, mypy and stubtest; then the tests of the page in a browser.

    python3 python/run_tests.py

Needs Python 3.10 or newer and a Rust toolchain. What Python needs is installed into a virtual environment of its own, `target/python-tests`; the compiled half is built as the tests of the workspace are,
in the same folder, so that after `cargo test --workspace` little is left to be compiled. Arguments go to pytest. `--wheel` tests what `pip install ./python` installs instead: an optimised
build from nothing, which takes some minutes. `--parquet` builds the command line with its feature `parquet`, and tests that, too.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PAGE = ROOT / "crates" / "explore" / "tests" / "browser" / "run.py"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
if not TARGET.is_absolute():
    TARGET = ROOT / TARGET
NEEDED = [
    "distributed>=2024.1",
    "matplotlib>=3.6",
    "mypy>=1.11",
    "numpy>=1.23",
    "pandas>=1.5",
    "pandas-stubs",
    "pyarrow>=14",
    "pytest>=7.4",
    "scipy>=1.10",
    "xarray>=2023.1",
]


def run(*command: object, **variables: str) -> None:
    words = [str(word) for word in command]
    print("$", " ".join(words), flush=True)
    # A test of the package must not see another one that happens to be on the path.
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")}
    done = subprocess.run(words, cwd=ROOT, env={**environment, **variables}, check=False)
    if done.returncode:
        sys.exit(done.returncode)


def environment() -> Path:
    """The interpreter of a virtual environment with all that is needed."""
    folder = TARGET / "python-tests"
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    asked = hashlib.sha256(repr((sys.version, NEEDED)).encode()).hexdigest()
    mark = folder / "installed"
    if python.exists() and mark.exists() and mark.read_text() == asked:
        return python
    shutil.rmtree(folder, ignore_errors=True)
    run(sys.executable, "-m", "venv", folder)
    # Most of what is installed is never imported: what is, the interpreter compiles then.
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", *NEEDED)
    mark.write_text(asked)
    return python


def build() -> None:
    """The compiled half of the package, and the command line."""
    # As `cargo test --workspace` builds, so that no dependency is compiled twice; for no interpreter in particular, as the module is for all of them.
    run("cargo", "build", "--quiet", "--workspace", "--lib", "--bins", "--tests", PYO3_NO_PYTHON="1")


def install(python: Path) -> None:
    """Puts the package into the environment: its Python files, and the compiled half beside them."""
    packages = subprocess.run(
        [str(python), "-c", "import sysconfig; print(sysconfig.get_path('platlib'))"], capture_output=True, text=True, check=True
    )
    place = Path(packages.stdout.strip()) / "shtaerman"
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(HERE / "python" / "shtaerman", place, ignore=shutil.ignore_patterns("__pycache__", "*.so", "*.pyd"))
    built, name = {
        "nt": ("_shtaerman.dll", "_shtaerman.pyd"),
        "darwin": ("lib_shtaerman.dylib", "_shtaerman.abi3.so"),
    }.get(os.name if os.name == "nt" else sys.platform, ("lib_shtaerman.so", "_shtaerman.abi3.so"))
    shutil.copyfile(TARGET / "debug" / built, place / name)


def told(*command: object, **variables: str) -> tuple[str, int]:
    """What a command says, and its code of exit."""
    words = [str(word) for word in command]
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")}
    done = subprocess.run(
        words, cwd=ROOT, env={**environment, **variables}, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    return f"$ {' '.join(words)}\n{done.stdout.rstrip()}", done.returncode


def checked_types(python: Path) -> list[tuple[str, int]]:
    """mypy and stubtest."""
    return [
        told(python, "-m", "mypy", "--config-file", HERE / "pyproject.toml", "--cache-dir", TARGET / "mypy", "-p", "shtaerman"),
        told(python, "-m", "mypy.stubtest", "--mypy-config-file", HERE / "pyproject.toml", "shtaerman"),
    ]


def prepared_page() -> list[tuple[str, int]]:
    """What the tests of the page need: Chromium, and an environment of their own."""
    return [told(sys.executable, PAGE, "--prepare")]


def checked_page(program: Path) -> list[tuple[str, int]]:
    """The tests of the page in a browser; its snippets of Python run in the environment of the package."""
    return [told(sys.executable, PAGE, SHTAERMAN=str(program))]


def main(arguments: list[str]) -> None:
    if sys.version_info < (3, 10):
        sys.exit(f"Python 3.10 or newer is needed, this is {sysconfig.get_python_version()}")
    is_wheel = "--wheel" in arguments
    rest = [argument for argument in arguments if argument not in ("--wheel", "--parquet")]
    with ThreadPoolExecutor(max_workers=2) as beside:
        # What is fetched comes while the compiler works.
        fetched = beside.submit(environment)
        prepared = None if rest else beside.submit(prepared_page)
        if is_wheel:
            run("cargo", "build", "--quiet", "--release", "-p", "shtaerman-cli")
        else:
            build()
        python = fetched.result()
        if is_wheel:
            run(python, "-m", "pip", "install", "--disable-pip-version-check", "--force-reinstall", "--no-deps", HERE)
        else:
            install(python)
        if "--parquet" in arguments:
            features = ("-p", "shtaerman-cli", "--features", "parquet")
            run("cargo", "test", "--quiet", *features, *(["--release"] if is_wheel else []), "--test", "all", "--", "parquet")
            run("cargo", "build", "--quiet", *features, *(["--release"] if is_wheel else []))
        program = TARGET / ("release" if is_wheel else "debug") / ("shtaerman.exe" if os.name == "nt" else "shtaerman")
        # Options alone choose among all tests.
        is_place = any((ROOT / argument.split("::")[0]).exists() for argument in rest)
        chosen = rest if is_place else [*rest, str(HERE / "tests")]
        # The types and the page, which mostly waits, are checked meanwhile; pytest speaks first.
        others = [] if prepared is None else [prepared, beside.submit(checked_page, program)]
        others.append(beside.submit(checked_types, python))
        tests = [python, "-m", "pytest", "-q", "-c", HERE / "pyproject.toml", "--rootdir", HERE, *chosen]
        try:
            run(*tests, SHTAERMAN=str(program))
        finally:
            found = [one for other in others for one in other.result()]
            print(*(text for text, _ in found), sep="\n", flush=True)
    sys.exit(next((code for _, code in found if code), 0))


if __name__ == "__main__":
    main(sys.argv[1:])
