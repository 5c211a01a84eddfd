"""Write the page of the derivation from its lines, as the report has them: python docs/derivation.py."""

from __future__ import annotations

import re
from pathlib import Path

from paper_checks.report.content import derivation
from paper_checks.report.content.blocks import Block, Heading, Line, Paragraph, Picture

HERE = Path(__file__).resolve().parent
NOTE = (
    "This page is written by `python docs/derivation.py`. Each check named here passed when it was written. Theorems "
    "of the kernel are named for reference; the report says whether the kernel accepted them, and links every claim."
)


def page() -> str:
    """Return the page in Markdown with mathematics between dollars."""
    blocks = (Paragraph(derivation.OPENING), Paragraph(NOTE), *derivation.checked_anew())
    return "\n\n".join([f"# {derivation.TITLE}", *filter(None, map(markdown, blocks))]) + "\n"


def markdown(block: Block) -> str:
    """Return a block; a picture only if these pages have it. A check that did not pass raises ValueError."""
    match block:
        case Heading(text):
            return f"## {text}"
        case Paragraph(text, label):
            return displayed(f"**{label}.** {text}" if label else text)
        case Picture(name, caption, title):
            return f"![{title}]({name}.svg)\n\n*{title}.* {caption}" if (HERE / f"{name}.svg").exists() else ""
        case Line(number, text, remark, True):
            return f"**({number})** {displayed(text)}\n\n{remark}"
    raise ValueError(f"{block} is no block of a derivation whose checks pass")


def displayed(text: str) -> str:
    """Return a text with its displayed formulas in paragraphs of their own."""
    return re.sub(r"\$\$(.+?)\$\$", r"\n\n$$\n\1\n$$\n\n", " ".join(text.split())).replace("\n\n\n\n", "\n\n").strip()


if __name__ == "__main__":
    (HERE / "derivation.md").write_text(page(), encoding="utf-8")
