"""The book, built and opened from the disk: every formula is set, nothing is loaded from elsewhere."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from conftest import PROGRAM, ROOT

# Of a page without its programs: formulas as they are shown, code within a line as well.
TEXT = """() => {
    const main = document.querySelector("main").cloneNode(true);
    main.querySelectorAll("pre").forEach((block) => block.remove());
    return main.textContent;
}"""
# What TeX looks like; `\\u{1b}` is a sign of a terminal.
TEX = re.compile(r"\\(?!u\{)[A-Za-z,;!|{}]+|\$\S")


@pytest.fixture(scope="module")
def book(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("book") / "book"
    # What was built with the program; built alone its dependencies would be compiled again.
    built = Path(PROGRAM).with_name("shtaerman-book")
    command = [str(built)] if built.exists() else ["cargo", "run", "--quiet", "-p", "shtaerman-book", "--"]
    subprocess.run([*command, folder], cwd=ROOT, check=True)
    return folder


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    page = browser.new_page(viewport={"width": 1440, "height": 1000})
    foreign: list[str] = []
    page.on("request", lambda request: foreign.append(request.url) if not request.url.startswith(("file:", "data:")) else None)
    # What is under way when a page is left is given up.
    page.on("requestfailed", lambda request: None if request.failure == "net::ERR_ABORTED" else foreign.append(f"failed: {request.url}"))
    page.on("console", lambda message: foreign.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: foreign.append(str(error)))
    yield page
    page.close()
    assert foreign == []


def chapters(book: Path) -> list[Path]:
    names = re.findall(r"\]\((.+?)\.md\)", (ROOT / "docs/src/SUMMARY.md").read_text(encoding="utf-8"))
    return [book / f"{name}.html" for name in names]


def test_no_formula_is_left_as_it_was_written(book: Path, page: Page) -> None:
    formulas = displayed = 0
    raw: list[str] = []
    for path in chapters(book):
        page.goto(path.as_uri())
        text = page.evaluate(TEXT)
        raw += [f"{path.stem}: {text[max(0, found.start() - 30) : found.end() + 30]!r}" for found in TEX.finditer(text)]
        formulas += page.locator("main .katex").count()
        displayed += page.locator("main .katex-display").count()
        assert page.locator(".katex-error, mjx-container, script[src*=athJax]").count() == 0
    assert raw == []
    written = sum(len(re.findall(r"\$\$.+?\$\$", (ROOT / "docs/src" / f"{path.stem}.md").read_text(encoding="utf-8"), re.DOTALL)) for path in chapters(book))
    assert displayed == written > 100 and formulas > displayed


def test_formulas_have_their_own_letters(book: Path, page: Page) -> None:
    page.goto((book / "model.html").as_uri())
    page.evaluate("() => document.fonts.ready")
    loaded = page.evaluate("() => [...document.fonts].filter((font) => font.status === 'loaded').map((font) => font.family)")
    assert {"KaTeX_Main", "KaTeX_Math", "KaTeX_Size2"} <= {family.strip('"') for family in loaded}
    # The letters of the screen reader are not shown beside those of the page.
    box = page.locator("main .katex-mathml").first.bounding_box()
    assert box is not None and box["width"] <= 1.5
    wide = page.locator("main .katex-display .katex-html").first.bounding_box()
    assert wide is not None and wide["width"] > 100 and wide["height"] > 25


def test_links_of_the_book_lead_somewhere(book: Path, page: Page) -> None:
    dead: list[str] = []
    places: dict[Path, set[str]] = {}
    wanted: list[tuple[Path, Path, str]] = []
    for path in chapters(book):
        page.goto(path.as_uri())
        places[path] = set(page.evaluate("() => [...document.querySelectorAll('[id]')].map((element) => element.id)"))
        for link in page.evaluate("() => [...document.querySelectorAll('main a[href]')].map((element) => element.getAttribute('href'))"):
            if not re.match(r"[a-z]+:", link):
                name, _, anchor = link.partition("#")
                wanted.append((path, (path.parent / name).resolve() if name else path, anchor))
    for path, target, anchor in wanted:
        if not target.is_file():
            dead.append(f"{path.stem}: {target.name}")
        elif anchor and target in places and anchor not in places[target]:
            dead.append(f"{path.stem}: {target.name}#{anchor}")
    assert len(wanted) > 100 and dead == []


def test_the_search_finds_a_chapter(book: Path, page: Page) -> None:
    page.goto((book / "introduction.html").as_uri())
    page.keyboard.press("s")
    page.locator("#mdbook-searchbar").press_sequentially("regularity")
    page.locator("#mdbook-searchresults a").first.wait_for(timeout=10000)
