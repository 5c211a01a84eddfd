"""The derivation as Markdown with mathematics between dollars: for the documentation and for notebooks."""

from __future__ import annotations

import re
from collections.abc import Iterable

from paper_checks.report.content import derivation
from paper_checks.report.content.blocks import Block, Heading, Line, Paragraph, Picture


def stages(*names: str) -> str:
    """Return stages of the derivation by their anchors, the lines checked anew. Raises KeyError, and ValueError as `written`."""
    return written(block for name in names for block in derivation.checked_anew(name))


def written(some: Iterable[Block], pictures: Iterable[str] = ()) -> str:
    """Return blocks one below the other, of the pictures those of these names.

    Raises ValueError for a line whose check did not pass, and for a block that no derivation has.
    """
    known = frozenset(pictures)
    return "\n\n".join(filter(None, (_block(one, known) for one in some)))


def _block(block: Block, pictures: frozenset[str]) -> str:
    match block:
        case Heading(text):
            return f"## {text}"
        case Paragraph(text, label):
            return _displayed(f"**{label}.** {text}" if label else text)
        case Picture(name, caption, title):
            return f"![{title}]({name}.svg)\n\n*{title}.* {caption}" if name in pictures else ""
        case Line(number, text, remark, True):
            return f"**D{number}.** {_displayed(text)}\n\n{remark}"
    raise ValueError(f"{block} is no block of a derivation whose checks pass")


def _displayed(text: str) -> str:
    """Return a text with its displayed formulas in paragraphs of their own."""
    return re.sub(r"\$\$(.+?)\$\$", r"\n\n$$\n\1\n$$\n\n", " ".join(text.split())).replace("\n\n\n\n", "\n\n").strip()
