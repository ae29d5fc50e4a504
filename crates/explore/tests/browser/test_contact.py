"""The contact: what is moved and typed, and the numbers of the command line."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, Download
from conftest import PROGRAM, ROOT, Watched, serve

Solve = Callable[..., dict[str, Any]]


def same(watched: Watched, answer: dict[str, Any], *keys: str) -> None:
    """The page has the numbers of the command line to the last bit."""
    for key in keys:
        shown, value = watched.card(key)
        assert value == answer["physical"][key], key
        assert shown


def test_the_page_shows_the_file_that_it_was_opened_with(watched: Watched, solve: Solve) -> None:
    answer = solve((ROOT / "examples/crowned_punch.toml").read_text())
    same(watched, answer, "settlement", "tilt", "peak_pressure", "contact_width")
    assert watched.card("settlement")[0] == "2.97858 µm"
    assert "The punch sinks in by 2.97858 µm and stays level." in watched.page.inner_text("#words")
    assert watched.page.title() == "crowned_punch.toml: Shtaerman"


def test_a_slider_moves_the_answer_and_the_number_is_that_of_the_command_line(watched: Watched, solve: Solve) -> None:
    before = watched.card("settlement")[1]
    slider = watched.slider("punch.half_width")
    slider.focus()
    for _ in range(40):
        watched.page.keyboard.press("ArrowRight")
    watched.settle()
    text = watched.field("punch.half_width").input_value()
    assert text.endswith(" mm") and 5.5 < float(text.split()[0]) < 6.5
    assert slider.get_attribute("aria-valuetext") == text
    assert f'half_width = "{text}"' in watched.toml()
    answer = solve(watched.toml())
    assert answer["physical"]["settlement"] != before
    same(watched, answer, "settlement", "peak_pressure", "contact_width")
    # What the table shows is what the terminal shows.
    path = Path(os.environ["SCREENSHOTS"]).parent / "slider.toml"
    path.write_text(watched.toml())
    table = subprocess.run([PROGRAM, "solve", str(path)], capture_output=True, text=True, check=True).stdout
    for row in watched.page.locator("#table tbody tr").all():
        name, value = row.locator("th").inner_text(), row.locator("strong").inner_text()
        assert f" {name} ".strip() in table and value in table, (name, value)


def test_every_kind_of_input_has_its_slider(watched: Watched, solve: Solve) -> None:
    watched.page.select_option('[data-key="ground"]', "layer")
    watched.page.select_option('[data-key="roughness"]', "power")
    watched.settle()
    paths = ["load.force", "load.moment", "punch.half_width", "foundation.young_modulus", "foundation.thickness", "foundation.roughness.coefficient", "foundation.roughness.exponent"]
    for path in paths:
        slider = watched.slider(path)
        slider.focus()
        before = watched.field(path).input_value()
        for _ in range(12):
            watched.page.keyboard.press("ArrowLeft")
        assert watched.field(path).input_value() != before, path
    watched.settle()
    same(watched, solve(watched.toml()), "settlement", "tilt", "peak_pressure")


def test_a_broken_profile_is_told_where_it_stands(watched: Watched) -> None:
    profile = watched.field("punch.profile")
    profile.fill("x^^2")
    fault = watched.page.locator('.field[data-path="punch.profile"] .fault')
    fault.wait_for(state="visible")
    assert fault.inner_text() == "a value is missing after `^`"
    assert profile.get_attribute("aria-invalid") == "true"
    assert watched.page.get_by_role("alert").filter(has_text="a value is missing").first.is_visible()
    profile.fill("x^2 / (2*2)")
    fault.wait_for(state="hidden")
    watched.settle()
    assert not watched.page.locator("#trouble").is_visible()
    force = watched.field("load.force")
    force.fill("5 kg")
    watched.page.get_by_text("is a force per length (like \"1 MN/m\"), got kg, a mass").first.wait_for()
    force.fill("0.8 MN/m")
    watched.settle()


def test_unilateral_contact_lifts_off_and_its_edge_moves(watched: Watched, solve: Solve) -> None:
    watched.page.get_by_text("Held together").click()
    watched.field("load.moment").fill("2.5 kN")
    watched.settle()
    assert watched.card("contact_width")[0] == "10 mm"
    assert "the pressure is negative" in watched.page.inner_text("#warnings")
    watched.page.get_by_text("May lift off").click()
    watched.settle()
    shown, first = watched.card("contact_width")
    assert first < 0.0099, shown
    assert "the rest has lifted off" in watched.page.inner_text("#words")
    watched.slider("load.moment").focus()
    for _ in range(30):
        watched.page.keyboard.press("ArrowRight")
    watched.settle()
    assert watched.card("contact_width")[1] < first, "the edge moves"
    same(watched, solve(watched.toml()), "contact_width", "tilt")


def test_a_trace_is_dropped(watched: Watched, solve: Solve) -> None:
    rows = [f"{x / 10},{0.02 * (x / 10) ** 2}" for x in range(-52, 53)]
    trace = "x_mm,f_um\n" + "\n".join(rows) + "\n"
    watched.page.get_by_text("Trace (CSV)").click()
    drop = """([text]) => {
        const data = new DataTransfer();
        data.items.add(new File([text], 'pad.csv', { type: 'text/csv' }));
        const place = document.querySelector('.drop');
        for (const kind of ['dragover', 'drop']) place.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }"""
    watched.page.evaluate(drop, [trace])
    watched.page.get_by_text("pad.csv: 106 lines").wait_for()
    watched.settle()
    assert 'profile = { csv = "pad.csv", x_unit = "mm", f_unit = "um" }' in watched.toml()
    same(watched, solve(watched.toml(), pad_csv=trace), "settlement", "peak_pressure")
    # A trace that does not cover the punch is refused as the command line does.
    watched.field("punch.half_width").fill("9 mm")
    watched.page.locator('.field[data-path="punch.profile"] .fault').wait_for(state="visible")
    assert "pad.csv" in watched.page.inner_text('.field[data-path="punch.profile"] .fault')


def test_a_base_is_drawn_by_hand_and_by_keys(watched: Watched, solve: Solve) -> None:
    watched.page.get_by_text("Drawn", exact=True).click()
    watched.settle()
    pad = watched.page.locator("svg.pad")
    box = pad.bounding_box()
    assert box is not None
    watched.page.mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 0.5 * box["height"])
    watched.page.mouse.down()
    watched.page.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + 0.6 * box["height"], steps=3)
    watched.page.mouse.up()
    handle = watched.page.locator("svg.pad .handle").nth(10)
    handle.focus()
    before = handle.get_attribute("aria-valuetext")
    watched.page.keyboard.press("ArrowUp")
    assert handle.get_attribute("aria-valuetext") != before
    watched.settle()
    with watched.page.expect_download() as told:
        watched.page.click("#save-profile")
    trace = Path(told.value.path()).read_text()
    assert told.value.suggested_filename == "drawn.csv" and len(trace.splitlines()) == 22
    same(watched, solve(watched.toml(), drawn_csv=trace), "settlement", "peak_pressure")


def saved(watched: Watched, button: str) -> tuple[str, str]:
    with watched.page.expect_download() as told:
        watched.page.click(button)
    download: Download = told.value
    return download.suggested_filename, Path(download.path()).read_text()


def test_what_is_downloaded_is_what_the_command_line_writes(watched: Watched, solve: Solve, tmp_path: Path) -> None:
    watched.field("punch.half_width").fill("0.25 in")
    watched.settle()
    name, toml = saved(watched, "#save-toml")
    assert name == "crowned_punch.toml"
    same(watched, solve(toml), "settlement", "tilt", "peak_pressure", "contact_width")
    path = tmp_path / name
    path.write_text(toml)

    def run(*arguments: str) -> str:
        return subprocess.run([PROGRAM, *arguments], cwd=tmp_path, capture_output=True, text=True, check=True).stdout

    assert saved(watched, "#save-csv") == ("crowned_punch.csv", run("solve", name, "--format", "csv"))
    run("solve", name, "--plot", "a.svg")
    assert saved(watched, "#save-svg") == ("crowned_punch.svg", (tmp_path / "a.svg").read_text())
    run("stress", name, "--plot", "b.svg")
    assert saved(watched, "#save-map") == ("crowned_punch-stress.svg", (tmp_path / "b.svg").read_text())
    report_name, report = saved(watched, "#save-report")
    run("solve", name, "--report", report_name)
    assert report == (tmp_path / report_name).read_text()


def test_the_same_in_python_is_a_program(watched: Watched) -> None:
    watched.page.get_by_role("tab", name="Python").click()
    text = watched.page.inner_text("#python")
    compile(text, "snippet", "exec")
    python = ROOT / "target/python-tests/bin/python"
    if python.exists():
        done = subprocess.run([python, "-c", text], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert float(done.stdout.split()[0]) == watched.card("settlement")[1]
    watched.page.get_by_role("tab", name="Command line").click()
    assert "shtaerman solve crowned_punch.toml" in watched.page.inner_text("#shell")


def test_the_file_is_edited_as_text(watched: Watched) -> None:
    editor = watched.page.locator("#editor")
    editor.fill(watched.toml().replace('"5 mm"', '"4 mm"'))
    watched.page.wait_for_timeout(500)
    watched.settle()
    assert watched.field("punch.half_width").input_value() == "4 mm"
    editor.fill("[punch\nhalf_width = 1\n")
    watched.page.locator("#editor-fault").wait_for(state="visible")
    assert "is not valid TOML" in watched.page.inner_text("#editor-fault")


def test_steps_are_undone_and_a_link_holds_the_state(watched: Watched, context: BrowserContext) -> None:
    watched.page.wait_for_timeout(700)
    for value in ("6 mm", "7 mm"):
        watched.field("punch.half_width").fill(value)
        watched.page.wait_for_timeout(700)
    watched.page.locator("h2").first.click()
    watched.page.keyboard.press("Control+z")
    watched.settle()
    assert watched.field("punch.half_width").input_value() == "6 mm"
    watched.page.keyboard.press("Control+Shift+z")
    watched.settle()
    assert watched.field("punch.half_width").input_value() == "7 mm"
    watched.page.wait_for_timeout(700)
    other = Watched(context, watched.page.url)
    assert other.field("punch.half_width").input_value() == "7 mm"
    assert other.card("settlement") == watched.card("settlement")
    assert other.said == []


def test_units_of_ones_own(watched: Watched) -> None:
    watched.page.select_option("#units", "inch")
    watched.settle()
    assert watched.card("peak_pressure")[0] == "18.2087 ksi"
    assert 'units = "inch"' in watched.toml()
    # The study has them, too; its CSV stays in SI units.
    watched.page.click("#tab-study")
    watched.page.locator("#cases tbody tr").first.wait_for()
    names = watched.page.locator("#cases thead th").all_inner_texts()
    cells = watched.page.locator("#cases tbody tr").first.locator("th, td").all_inner_texts()
    row = dict(zip(names, cells, strict=True))
    with watched.page.expect_download() as told:
        watched.page.click("#save-cases")
    lines = Path(told.value.path()).read_text().splitlines()
    si = dict(zip(lines[0].split(","), lines[1].split(","), strict=True))
    for name, key, unit in (("peak pressure [psi]", "peak_pressure", 6894.757293168), ("force [lbf/in]", "load.force", 175.1268352)):
        assert abs(float(row[name]) * unit / float(si[key]) - 1) < 1e-5, name
    assert "peak pressure [psi]" in watched.page.inner_html("#study-chart")


def test_a_hostile_profile_is_ended_in_time(context: BrowserContext, tmp_path: Path) -> None:
    process, address = serve("examples/crowned_punch.toml", "--time-limit", "1 s")
    try:
        watched = Watched(context, address)
        steps = " + ".join(f"abs(x - {k}e-6)" for k in range(-900, 900))
        watched.field("punch.profile").fill(f"1e-6*sin(1e7*x) + 1e-7*({steps})")
        watched.page.wait_for_timeout(3500)
        watched.field("punch.profile").fill("x^2 / (2*20)")
        watched.settle()
        watched.page.wait_for_function("() => document.querySelector('#trouble').hidden", timeout=10000)
        assert watched.card("settlement")[0] == "2.97858 µm"
    finally:
        process.kill()
        process.wait()
