"""The accessibility checker axe-core on reports in headless Chromium, light and dark, wide and narrow, all unfolded.

`python tests/axe.py axe.min.js FILE.html ...` checks each file and the pages in the folder `pages` beside it; it exits
with 1 if it finds something moderate or worse. The checker comes from npm: the continuous integration runs it where npm
can fetch it.
"""

import itertools
import re
import shutil
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
  if (inside.querySelector("[data-row] a")) inside.querySelector("[data-row] a").click();
  await new Promise((done) => setTimeout(done, page.includes("/") ? 20 : 500));
  inside.head.append(Object.assign(inside.createElement("script"), { textContent: axe }));
  const tabs = [...inside.querySelectorAll("[role=tab]")];
  for (const tab of tabs.length ? tabs : [inside.body]) {
    if (tabs.length) tab.click();
    const { violations } = await frame.contentWindow.axe.run(inside, { resultTypes: ["violations"] });
    found.push(...violations.filter((one) => one.impact !== "minor").map((one) => (
      `${page}: ${one.impact}: ${one.id}, ${one.help}; ${one.nodes.length} times, `
      + `first ${one.nodes[0].html.slice(0, 160)}`)));
  }
  frame.remove();
}
return found;
"""


FORMULA = re.compile(r"<math\b.*?</math>", re.DOTALL)


def lighter(page: str) -> str:
    """Return a page with a letter for each formula: the checker visits each element, and has no rule about those."""
    return FORMULA.sub("<i>x</i>", page)


def complaints(axe: str, file: Path) -> list[str]:
    """Return what the checker finds, moderate or worse: on a file in each appearance, on each page beside it in one."""
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "report"
        folder.mkdir()
        shutil.copy(file, folder)
        if (file.parent / "pages").exists():
            shutil.copytree(file.parent / "pages", folder / "pages")
        for page in folder.rglob("*.html"):
            page.write_text(lighter(page.read_text(encoding="utf-8")), encoding="utf-8")
        pages = sorted(str(page.relative_to(folder)) for page in (folder / "pages").glob("*.html"))
        question = Path(name) / "question.js"
        question.write_text(QUESTION, encoding="utf-8")
        for turn, ((scheme, flag), width) in enumerate(itertools.product(SCHEMES.items(), WIDTHS)):
            some = [file.name, *pages[turn :: len(SCHEMES) * len(WIDTHS)]]
            flags = (flag, f"--window-size={width},900", "--allow-file-access-from-files")
            answer = asked("<body></body>", question, folder, *flags, seconds=900, pages=some, axe=axe)
            if not isinstance(answer, list):
                raise RuntimeError(f"{file.name}: {answer}")
            found += [f"{scheme}, {width} px: {one}" for one in answer]
    return found


if __name__ == "__main__":
    source = Path(sys.argv[1]).read_text(encoding="utf-8")
    every = [one for page in sys.argv[2:] for one in complaints(source, Path(page))]
    print("\n".join(every) or f"{len(sys.argv) - 2} files and the pages beside them: nothing moderate or worse")
    sys.exit(bool(every))
