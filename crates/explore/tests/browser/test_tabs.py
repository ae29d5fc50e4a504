"""Every tab: its numbers, its looks in both themes, and whether everyone can use it."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page
from conftest import PROGRAM, ROOT, Watched, serve

PICTURES = Path(os.environ["SCREENSHOTS"])
TABS = ["contact", "study", "kernels", "paper"]
READY = {
    "contact": "#map-legend span",
    "study": "#cases tbody tr",
    "kernels": "#spectrum tbody tr",
    "paper": "#paper-tables tbody tr",
}


def run(*arguments: str) -> str:
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True, cwd=ROOT).stdout


def faults(page: Page, *rules: str) -> list[str]:
    """What axe-core finds that is serious or worse, by all of its rules or by these."""
    options = {"runOnly": {"type": "rule", "values": list(rules)}} if rules else None
    found = Axe().run(page, options=options).response["violations"]
    grave = [one for one in found if one["impact"] in ("serious", "critical")]
    return [f"{one['id']}: {node['html'][:200]}" for one in grave for node in one["nodes"]]


def opened(page: Page, tab: str) -> None:
    page.click(f"#tab-{tab}")
    page.locator(READY[tab]).first.wait_for()
    page.wait_for_timeout(200)


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_every_tab_is_seen_in_both_themes_and_usable_by_everyone(browser: Browser, address: str, theme: str) -> None:
    context = browser.new_context(viewport={"width": 1440, "height": 1000}, color_scheme=theme)
    watched = Watched(context, address)
    PICTURES.mkdir(parents=True, exist_ok=True)
    for tab in TABS:
        opened(watched.page, tab)
        watched.page.screenshot(path=PICTURES / f"{tab}-{theme}.png", full_page=True)
        # The themes differ in colours alone.
        rules = ["color-contrast"] if theme == "dark" else []
        assert faults(watched.page, *rules) == [], (tab, theme)
    assert watched.said == []
    context.close()


def test_on_a_phone_nothing_is_wider_than_the_screen(browser: Browser, address: str) -> None:
    context = browser.new_context(viewport={"width": 375, "height": 812}, has_touch=True, is_mobile=True)
    watched = Watched(context, address)
    for tab in TABS:
        opened(watched.page, tab)
        width = watched.page.evaluate("() => document.documentElement.scrollWidth")
        assert width <= 375, (tab, width)
        watched.page.screenshot(path=PICTURES / f"{tab}-phone.png", full_page=True)
    assert faults(watched.page) == []
    assert watched.said == []
    context.close()


def test_tabs_and_charts_are_reached_by_keys(watched: Watched) -> None:
    page = watched.page
    page.locator("#tab-contact").focus()
    page.keyboard.press("ArrowRight")
    assert page.locator("#panel-study").is_visible() and page.locator("#tab-study").evaluate("one => one === document.activeElement")
    page.keyboard.press("Home")
    assert page.locator("#panel-contact").is_visible()
    keys = page.locator("#pressure .keys")
    keys.focus()
    assert "p = " in page.inner_text("#pressure-reading")
    first = keys.get_attribute("aria-valuetext")
    page.keyboard.press("ArrowRight")
    assert keys.get_attribute("aria-valuetext") != first


def test_the_theme_is_chosen_and_kept(watched: Watched) -> None:
    page = watched.page
    page.click("#theme")
    page.click("#theme")
    assert page.get_attribute("html", "data-theme") == "dark"
    page.reload()
    watched.settle()
    assert page.get_attribute("html", "data-theme") == "dark"


def test_a_study_has_the_numbers_of_solve(watched: Watched) -> None:
    opened(watched.page, "study")
    watched.page.locator('[data-key="Points count"]').first.fill("5")
    watched.page.locator('[data-key="From from"]').first.fill("0.4 MN/m")
    watched.page.wait_for_function("() => document.querySelectorAll('#cases tbody tr').length === 5")
    with watched.page.expect_download() as told:
        watched.page.click("#save-cases")
    lines = Path(told.value.path()).read_text().splitlines()
    names, first = lines[0].split(","), lines[1].split(",")
    row = dict(zip(names, first, strict=True))
    assert float(row["load.force"]) == 4e5
    answer = json.loads(run("solve", "examples/crowned_punch.toml", "--set", "load.force=4e5", "--format", "json"))["physical"]
    for name in ("settlement", "peak_pressure", "contact_width"):
        assert float(row[name]) == answer[name], name
    assert watched.page.locator("#study-warnings").is_hidden()
    # A slip is told with its case.
    watched.page.locator('[data-key="To to"]').first.fill("900 MN/m")
    watched.page.wait_for_selector("#study-warnings li[data-code=high_pressure]")
    assert "(load.force = " in watched.page.inner_text("#study-warnings")
    watched.page.locator('[data-key="To to"]').first.fill("4 MN/m")
    watched.page.wait_for_selector("#study-warnings", state="hidden")
    # Two inputs give a curve for each value of the second.
    watched.page.locator('[data-key="input 1"]').select_option(label="modulus")
    watched.page.wait_for_function("() => document.querySelectorAll('#study-legend > span').length === 3")


def test_kernels_have_the_eigenvalues_of_spectrum(watched: Watched) -> None:
    opened(watched.page, "kernels")
    watched.page.get_by_role("radio", name="power").check()
    watched.page.wait_for_function("() => document.querySelector('#kernel-command').textContent.includes('spectrum power')")
    spectrum = json.loads(run("spectrum", "power", "--a", "1", "--mu", "0.3", "--count", "16", "--format", "json"))
    cells = watched.page.locator("#spectrum tbody tr").nth(3).locator("td").all_inner_texts()
    assert float(cells[0]) == float(f"{spectrum['eigenvalue'][3]:.12g}")
    before = cells[0]
    slider = watched.page.get_by_role("slider", name="μ")
    slider.focus()
    for _ in range(20):
        watched.page.keyboard.press("ArrowRight")
    watched.page.wait_for_function("before => document.querySelectorAll('#spectrum tbody tr')[3].querySelector('td').textContent !== before", arg=before)
    assert "error (" in watched.page.inner_text("#equation-text")
    for radio in watched.page.get_by_role("radio").all():
        if radio.is_visible() and radio.get_attribute("name") == "kernel":
            radio.check()
            watched.page.wait_for_timeout(80)
    watched.page.wait_for_timeout(500)
    assert watched.page.locator("#kernel-trouble").is_hidden()


def test_the_paper_as_printed_computed_and_true(watched: Watched) -> None:
    opened(watched.page, "paper")
    assert watched.page.inner_text("#agreeing").startswith("143 of 144")
    assert watched.page.locator("#paper-tables tbody tr").count() == 144
    watched.page.check("#differing")
    assert watched.page.locator("#paper-tables tbody tr").count() < 100
    slider = watched.page.get_by_role("slider", name="λ₀")
    slider.focus()
    watched.page.keyboard.press("Home")
    watched.page.get_by_text("λ₀ = 0.001").first.wait_for()


def test_an_equation_file_opens_the_kernels(browser: Browser) -> None:
    process, address = serve("examples/equation_power.toml")
    try:
        page = browser.new_page()
        page.goto(address)
        page.get_by_text("power kernel, a = 1, mu = 0.3").wait_for()
        assert page.locator("#panel-kernels").is_visible()
        told = run("equation", "examples/equation_power.toml")
        integral = next(line.split()[-1] for line in told.splitlines() if "int phi dx" in line)
        assert integral in page.inner_text("#equation-text")
        page.close()
    finally:
        process.kill()
        process.wait()


@pytest.mark.parametrize(
    "command",
    [
        ["solve", "examples/two_punches.toml"],
        ["solve", "examples/measured_profile.toml"],
        ["stress", "examples/crowned_punch.toml", "--yield-stress", "350 MPa"],
        ["find", "force", "examples/crowned_punch.toml", "--peak-pressure", "350 MPa"],
        ["equation", "examples/equation_log.toml"],
        ["sweep", "examples/studies/force_and_roughness.toml"],
    ],
    ids=lambda command: command[0] if isinstance(command, list) else None,
)
def test_reports_print_to_two_pages(command: list[str], tmp_path: Path) -> None:
    folder = ["--output", str(tmp_path / "parts")] if command[0] == "sweep" else []
    pdf = tmp_path / "report.pdf"
    run(*command, *folder, "--report", str(pdf))
    content = pdf.read_bytes()
    assert content.startswith(b"%PDF-")
    pages = content.count(b"/Type /Page\n") + content.count(b"/Type /Page ") + content.count(b"/Type /Page/")
    assert 1 <= pages <= 2, pages
