"""The accessibility checker axe-core on pages in headless Chromium, light and dark, wide and narrow, folded and open.

`python tests/axe.py axe.min.js PAGE.html ...` exits with 1 if it finds something moderate or worse. The checker comes
from npm: the continuous integration runs it where npm can fetch it.
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
APPEARANCES = [("light", WIDTHS[0], True), *itertools.product(SCHEMES, WIDTHS, [False])]
"""Colours, width, and whether the page is folded: what is open shows all that a folded one does."""
QUESTION = """
if (document.readyState !== "complete") await new Promise((done) => addEventListener("load", done));
await document.fonts.ready;
if (open) document.querySelectorAll("details").forEach((one) => { one.open = true; });
await new Promise((done) => setTimeout(done, 500));
const found = await axe.run(document, { resultTypes: ["violations"] });
return found.violations.filter((one) => one.impact !== "minor").map((one) => (
  `${one.impact}: ${one.id}, ${one.help}; ${one.nodes.length} times, first ${one.nodes[0].html.slice(0, 160)}`));
"""


FORMULA = re.compile(r"<math\b.*?</math>", re.DOTALL)
DRAWING = re.compile(r'(<svg\b[^>]*\brole="img"[^>]*>).*?</svg>', re.DOTALL)


def lighter(page: str) -> str:
    """Return a page with a letter for each formula and nothing inside its pictures: a quarter of the elements is left.

    The checker visits each; it has no rule about those of a formula, and a picture is one thing to a screen reader.
    """
    return DRAWING.sub(r"\1</svg>", FORMULA.sub("<i>x</i>", page))


def complaints(axe: str, page: Path) -> list[str]:
    """Return what the checker finds on a page, moderate or worse, in each of its appearances."""
    text = lighter(page.read_text(encoding="utf-8")).replace("</body>", f"<script>{axe}</script></body>")
    found = []
    with tempfile.TemporaryDirectory() as folder:
        question = Path(folder) / "question.js"
        question.write_text(QUESTION, encoding="utf-8")
        for scheme, width, folded in APPEARANCES:
            flags = (SCHEMES[scheme], f"--window-size={width},900")
            answer = asked(text, question, Path(folder), *flags, seconds=900, open=not folded)
            if not isinstance(answer, list):
                raise RuntimeError(f"{page.name}: {answer}")
            found += [f"{page.name}, {scheme}, {width} px, {'folded' if folded else 'open'}: {one}" for one in answer]
    return found


if __name__ == "__main__":
    source = Path(sys.argv[1]).read_text(encoding="utf-8").replace("</script", "<\\/script")
    every = [one for page in sys.argv[2:] for one in complaints(source, Path(page))]
    print("\n".join(every) or f"{len(sys.argv) - 2} pages: nothing moderate or worse")
    sys.exit(bool(every))
