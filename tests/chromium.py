"""A page opened in headless Chromium, as a reader's browser would; the page answers with JSON."""

import json
import os
import re
import shutil
import subprocess
import tomllib
from pathlib import Path
from urllib.parse import unquote

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
ANSWER = re.compile(r'<script type="text/plain" id="test-answer">(.*?)</script>', re.DOTALL)


def faults(name: str) -> list[tuple[str, str]]:
    """Return the changes of a program that a comparison has to see."""
    path = Path(__file__).parent / "paper_checks" / "explore" / "faults.toml"
    return tomllib.loads(path.read_text("utf-8"))[name]


def planted(program: str, some: list[tuple[str, str]]) -> list[str]:
    """Return the program with each of some changes."""
    assert not [right for right, _ in some if program.count(right) != 1]
    return [program.replace(right, wrong) for right, wrong in some]


def browser() -> str:
    """Return Chromium's path; skip the test where there is none, unless INERTIAL_PAIR_BROWSER=required."""
    found = next(filter(None, map(shutil.which, NAMES)), None)
    if found is None and os.environ.get("INERTIAL_PAIR_BROWSER") != "required":
        pytest.skip("no Chromium here")
    assert found, "INERTIAL_PAIR_BROWSER=required, and there is no Chromium"
    return found


def asked(page: str, question: Path, folder: Path, *flags: str, seconds: float = 180, **given: object) -> object:
    """Return what `question`, a file with the body of an async function, returns on this page. It knows `given`."""
    known = "".join(f"const {name} = {json.dumps(value)};\n" for name, value in given.items()).replace("</", "<\\/")
    body = known + question.read_text("utf-8")
    program = (
        "<script>(async () => { let found; try { found = await (async () => {" + body + "\n"
        "})(); } catch (error) { found = {error: String(error.stack || error)}; }\n"
        'const answer = Object.assign(document.createElement("script"), {type: "text/plain", id: "test-answer"});\n'
        "answer.textContent = encodeURIComponent(JSON.stringify(found)); document.body.append(answer); })();</script>"
    )
    path = folder / "page.html"
    path.write_text(page.replace("</body>", program + "</body>"), encoding="utf-8")
    options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder / 'profile'}", *flags]
    done = subprocess.run(
        [browser(), *options, "--virtual-time-budget=20000", "--dump-dom", path.as_uri()],
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=seconds,
        check=False,
    )
    answer = ANSWER.search(done.stdout)
    assert answer, f"the page gave no answer: {done.stdout[-500:]} {done.stderr[-1500:]}"
    return json.loads(unquote(answer.group(1)))
