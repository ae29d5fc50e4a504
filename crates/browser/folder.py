#!/usr/bin/env python3
"""Writes the page without a server: one folder, opened by a double click or put on any web server.

    python3 crates/browser/folder.py FOLDER

The engine is compiled for WebAssembly (`rustup target add wasm32-unknown-unknown`). Browsers load no modules, workers or engines from a disk, so the modules become one script, and the engine text
within another. `--keep` takes the engine that was compiled before.
"""

from __future__ import annotations

import base64
import gzip
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ASSETS = ROOT / "crates" / "explore" / "assets"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
TRIPLE = "wasm32-unknown-unknown"
POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'"
)
IMPORT = re.compile(r'^import (?:\{([^}]*)\} from )?"\./([\w-]+)\.js";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:async )?function |class |const |let )", re.MULTILINE)
NAME = re.compile(r"^export (?:async )?(?:function|class|const|let) (\w+)", re.MULTILINE)


def sources() -> dict[str, str]:
    files = [*ASSETS.glob("*.js"), HERE / "offline.js"]
    return {file.stem: file.read_text() for file in files}


def bundle(texts: dict[str, str]) -> str:
    """All modules in one script, each in a scope of its own, after those that it imports."""
    parts: list[str] = []
    done: set[str] = set()

    def add(name: str) -> None:
        if name in done:
            return
        done.add(name)
        text = texts[name]
        for _, other in IMPORT.findall(text):
            add(other)
        names = ", ".join(NAME.findall(text))

        def taken(found: re.Match[str]) -> str:
            if found.group(1) is None:
                return ""
            wanted = found.group(1).strip().rstrip(",").replace(" as ", ": ")
            return f"const {{ {wanted} }} = module_{found.group(2)};\n"

        body = EXPORT.sub("", IMPORT.sub(taken, text))
        if re.search(r"^(import|export) ", body, re.MULTILINE):
            sys.exit(f"{name}.js has an import or an export that cannot be put into one script")
        parts.append(f"const module_{name} = (() => {{\n{body}\nreturn {{ {names} }};\n}})();\n")

    # What answers is there before the page asks.
    add("offline")
    add("main")
    return '"use strict";\n' + "".join(parts)


def engine(is_kept: bool) -> bytes:
    if not is_kept:
        command = ["cargo", "build", "--profile", "browser", "--target", TRIPLE, "-p", "shtaerman-browser"]
        if subprocess.run(command, cwd=ROOT, check=False).returncode:
            sys.exit(f"the engine was not compiled; is the target there? rustup target add {TRIPLE}")
    return (TARGET / TRIPLE / "browser" / "shtaerman_browser.wasm").read_bytes()


def main(arguments: list[str]) -> None:
    places = [argument for argument in arguments if argument != "--keep"]
    if len(places) != 1:
        sys.exit(__doc__)
    folder = Path(places[0])
    compiled = engine("--keep" in arguments)
    packed = base64.b64encode(gzip.compress(compiled, 9, mtime=0)).decode()
    page = (ASSETS / "index.html").read_text()
    head = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n<meta charset="utf-8">'
    page = page.replace('<meta charset="utf-8">', head, 1)
    page = page.replace('<script type="module" src="main.js"></script>', '<script defer src="engine.js"></script>\n<script defer src="page.js"></script>', 1)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(page)
    (folder / "page.js").write_text(bundle(sources()))
    (folder / "engine.js").write_text(f'globalThis.SHTAERMAN_ENGINE = "{packed}";\n')
    for name in ("style.css", "icon.svg"):
        shutil.copyfile(ASSETS / name, folder / name)
    size = sum(file.stat().st_size for file in folder.iterdir())
    print(f"{folder / 'index.html'}: engine {len(compiled)} bytes, all files {size} bytes")


if __name__ == "__main__":
    main(sys.argv[1:])
