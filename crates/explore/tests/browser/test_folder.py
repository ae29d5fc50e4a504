"""The page without a server: `python3 crates/browser/folder.py FOLDER`, opened from the disk. `SHTAERMAN_FOLDER=FOLDER` has it tested; compiling it takes too long to be done here."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import Browser
from conftest import PROGRAM, ROOT

FOLDER = os.environ.get("SHTAERMAN_FOLDER")


@pytest.mark.skipif(FOLDER is None, reason="SHTAERMAN_FOLDER names no folder that crates/browser/folder.py wrote")
def test_the_folder_computes_in_the_browser(browser: Browser) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 1000})
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto((Path(str(FOLDER)).resolve() / "index.html").as_uri())
    page.locator("#cards .figure").first.wait_for(timeout=30000)
    for name in ("two punches", "rough ball", "crowned punch"):
        page.select_option("#examples", label=name)
        page.wait_for_timeout(300)
        page.wait_for_function("() => !document.querySelector('#panel-contact[aria-busy]')", timeout=30000)
        path = ROOT / "examples" / f"{name.replace(' ', '_')}.toml"
        answer = json.loads(subprocess.run([PROGRAM, "solve", path, "--format", "json", "-q"], capture_output=True, text=True, check=True).stdout)
        for key in ("settlement", "peak_pressure", "contact_width"):
            shown = float(page.locator(f'#cards [data-key="{key}"]').get_attribute("data-si") or "nan")
            assert shown == pytest.approx(answer["physical"][key], rel=1e-10), (name, key)
    for tab, ready in (("study", "#cases tbody tr"), ("kernels", "#spectrum tbody tr"), ("paper", "#paper-tables tbody tr")):
        page.click(f"#tab-{tab}")
        page.locator(ready).first.wait_for(timeout=30000)
    assert said == []
    page.close()
