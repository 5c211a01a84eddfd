"""The accessibility checker axe-core on reports in headless Chromium, light and dark, wide and narrow, all unfolded.

`python tests/axe.py axe.min.js FILE.html ...` checks each file; it exits with 1 if something is moderate or worse.
The checker comes from npm: the continuous integration runs it where npm can fetch it.
"""

import itertools
import re
import sys
import tempfile
from pathlib import Path

from chromium import asked

SCHEMES = {"dark": "--blink-settings=preferredColorScheme=0", "light": "--blink-settings=preferredColorScheme=1"}
WIDTHS = (1400, 500)
"""Pixels; headless Chromium has no narrower window, and the page turns narrow below 736."""
QUESTION = """
const found = [];
for (const page of pages) {
  const size = { width: innerWidth, height: 900 };
  const frame = Object.assign(document.createElement("iframe"), { ...size, src: page, title: page });
  document.body.append(frame);
  await new Promise((done) => { frame.onload = done; });
  const inside = frame.contentDocument;
  await inside.fonts.ready;
  inside.querySelectorAll("details").forEach((one) => { one.open = true; });
  await new Promise((done) => setTimeout(done, 500));
  inside.head.append(Object.assign(inside.createElement("script"), { textContent: axe }));
  const { violations } = await frame.contentWindow.axe.run(inside, { resultTypes: ["violations"] });
  found.push(...violations.filter((one) => one.impact !== "minor").map((one) => (
    `${page}: ${one.impact}: ${one.id}, ${one.help}; ${one.nodes.length} times, `
    + `first ${one.nodes[0].html.slice(0, 160)}`)));
  frame.remove();
}
return found;
"""


FORMULA = re.compile(r"<math\b.*?</math>", re.DOTALL)


def lighter(page: str) -> str:
    """Return a page with a letter for each formula: the checker visits each element, and has no rule about those."""
    return FORMULA.sub("<i>x</i>", page)


def complaints(axe: str, file: Path) -> list[str]:
    """Return what the checker finds, moderate or worse, in each appearance."""
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "report"
        folder.mkdir()
        (folder / file.name).write_text(lighter(file.read_text(encoding="utf-8")), encoding="utf-8")
        question = Path(name) / "question.js"
        question.write_text(QUESTION, encoding="utf-8")
        for (scheme, flag), width in itertools.product(SCHEMES.items(), WIDTHS):
            flags = (flag, f"--window-size={width},900", "--allow-file-access-from-files")
            answer = asked("<body></body>", question, folder, *flags, seconds=900, pages=[file.name], axe=axe)
            if not isinstance(answer, list):
                raise RuntimeError(f"{file.name}: {answer}")
            found += [f"{scheme}, {width} px: {one}" for one in answer]
    return found


if __name__ == "__main__":
    source = Path(sys.argv[1]).read_text(encoding="utf-8")
    every = [one for page in sys.argv[2:] for one in complaints(source, Path(page))]
    print("\n".join(every) or f"{len(sys.argv) - 2} files: nothing moderate or worse")
    sys.exit(bool(every))
