"""A server of the page, a browser that looks at it, and the command line to compare with."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright

ROOT = Path(__file__).resolve().parents[4]
PROGRAM = os.environ["SHTAERMAN"]
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def serve(*arguments: str) -> tuple[subprocess.Popen[str], str]:
    """A server on a port of its own, and its address."""
    command = [PROGRAM, "explore", "--no-browser", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT)
    assert process.stdout is not None
    address = process.stdout.readline().split()[0]
    assert address.startswith("http://127.0.0.1:")
    return process, address


@pytest.fixture(scope="session")
def address() -> Iterator[str]:
    process, address = serve("examples/crowned_punch.toml")
    yield address
    process.kill()
    process.wait()


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=os.environ["SHTAERMAN_CHROMIUM"], args=FLAGS)
        yield browser
        browser.close()


class Watched:
    """A page, what its console says, and what it loads."""

    def __init__(self, context: BrowserContext, address: str) -> None:
        self.page: Page = context.new_page()
        self.said: list[str] = []
        self.loaded: list[str] = []
        self.page.on("console", lambda message: self.said.append(f"{message.type}: {message.text}"))
        self.page.on("pageerror", lambda error: self.said.append(f"error: {error}"))
        self.page.on("request", lambda request: self.loaded.append(request.url))
        self.address = address
        self.page.goto(address)
        self.settle()

    def settle(self) -> None:
        """Waits until the answer with its audit is shown, and nothing is under way."""
        self.page.wait_for_function(
            "() => document.querySelector('#cards .figure') && !document.querySelector('#panel-contact[aria-busy], #map-card[aria-busy]:not([hidden])')",
            timeout=20000,
        )
        # What a screen reader is told follows.
        self.page.wait_for_timeout(150)

    def card(self, key: str) -> tuple[str, float]:
        """What a card shows, and its value in SI units."""
        card = self.page.locator(f'#cards [data-key="{key}"]')
        return card.locator(".value").inner_text(), float(card.get_attribute("data-si") or "nan")

    def field(self, path: str) -> Any:
        return self.page.locator(f'.field[data-path="{path}"] input[type="text"]')

    def slider(self, path: str) -> Any:
        return self.page.locator(f'.field[data-path="{path}"] input[type="range"]')

    def example(self, name: str) -> None:
        self.page.select_option("#examples", label=name)
        self.page.wait_for_timeout(150)
        self.settle()

    def toml(self) -> str:
        return self.page.input_value("#editor")


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    context = browser.new_context(viewport={"width": 1440, "height": 1000}, color_scheme="light", accept_downloads=True)
    yield context
    context.close()


@pytest.fixture
def watched(context: BrowserContext, address: str) -> Iterator[Watched]:
    watched = Watched(context, address)
    yield watched
    assert watched.said == [], "the console is silent"
    own = (watched.address, "blob:", "data:")
    assert all(url.startswith(own) for url in watched.loaded), watched.loaded


@pytest.fixture
def solve(tmp_path: Path) -> Callable[..., dict[str, Any]]:
    """The answer of the command line to a file."""

    def solve(toml: str, **files: str) -> dict[str, Any]:
        for name, content in files.items():
            (tmp_path / name.replace("_csv", ".csv")).write_text(content)
        path = tmp_path / "problem.toml"
        path.write_text(toml)
        done = subprocess.run([PROGRAM, "solve", str(path), "--format", "json", "-q"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        answer: dict[str, Any] = json.loads(done.stdout)
        return answer

    return solve
