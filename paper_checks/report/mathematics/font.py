"""The font of the page's mathematics: a subset of STIX Math under a name of its own, as its licence asks (fonts/OFL.txt).

It is embedded in the page, so that every browser shows the same.

`python -m paper_checks.report.mathematics.font STIXMath-Regular.otf` cuts the subset anew from the whole font (STIX fonts 1.1.1,
https://www.stixfonts.org), for instance after `CHARACTERS` has grown; it needs fontTools, which matplotlib brings along.
"""

from __future__ import annotations

import base64
import sys
from io import BytesIO
from pathlib import Path

FILE = Path(__file__).with_name("fonts") / "report-math.woff"
FAMILY = "Report Math"


def _between(first: int, last: int) -> str:
    return "".join(map(chr, range(first, last + 1)))


CHARACTERS = (
    _between(0x20, 0x7E)
    + _between(0x391, 0x3C9).replace("\u03a2", "")  # Greek; one place is empty
    + "ϕϵϑ"
    + _between(0x1D434, 0x1D467).replace("\U0001d455", "")  # italic letters; h is the Planck constant
    + "\u210e\U0001d6a4\U0001d6a5"
    + _between(0x1D6E2, 0x1D71B)  # italic Greek
    + "−±∓×·⋅∘∕⁄√∞∂∇∫∑∏∈∉∋∩∪⊂⊃⊆∅∀∃∧∨¬"
    + "≤≥⩽⩾≪≫≠≈≃≅∼≡≔→←↦⇒⇔⟶↔∝∣∥‖⌈⌉⌊⌋⟨⟩…⋯⋮⋱′″ℓℝℕℤ"
    + "˙¨¯ˉ˜ˆˇ\u0302\u0303\u0304\u0305\u0307\u0308\u20d7\u00a0"
)
"""What formulas are written with; a test compares it with all of them."""


def face() -> str:
    """Return the CSS rule that embeds the font."""
    data = base64.b64encode(FILE.read_bytes()).decode("ascii")
    return f'@font-face {{ font-family: "{FAMILY}"; src: url(data:font/woff;base64,{data}) format("woff"); }}\n'


def subset(source: Path) -> bytes:
    """Return the font with `CHARACTERS` and all that their formulas need, as WOFF without time stamps."""
    from fontTools import subset as cutter
    from fontTools.ttLib import TTFont

    options = cutter.Options(
        flavor="woff",
        hinting=False,
        recalc_timestamp=False,
        layout_features=["*"],
        drop_tables=["FFTM"],
        name_IDs=["*"],
    )
    with TTFont(source, recalcTimestamp=False) as font:
        chosen = cutter.Subsetter(options)
        chosen.populate(text=CHARACTERS)
        chosen.subset(font)
        for record in list(font["name"].names):
            if record.nameID in (1, 4, 6, 16):
                record.string = FAMILY.replace(" ", "") if record.nameID == 6 else FAMILY
            elif record.nameID != 0:  # the copyright stays
                font["name"].names.remove(record)
        font.flavor = "woff"
        stream = BytesIO()
        font.save(stream)
    return stream.getvalue()


if __name__ == "__main__":
    FILE.write_bytes(subset(Path(sys.argv[1])))
