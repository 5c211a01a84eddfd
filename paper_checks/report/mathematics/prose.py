"""Prose with LaTeX in it, for each kind of reader: MathML, plain text, LaTeX.

Mathematics stands between `$` (inline) or `$$` (displayed); a backslash before it makes a dollar literal.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum
from html import escape

from paper_checks.report.mathematics.mathml import UnreadableMathematicsError, mathml, spoken

_PIECES = re.compile(r"(?<!\\)\$\$(?P<display>.+?)(?<!\\)\$\$|(?<!\\)\$(?P<inline>[^$]+?)(?<!\\)\$", re.DOTALL)
_MINUS = re.compile(r"(?<![\w.,)\]-])-(?=\d)")
_BALL = re.compile(r"\[(?:([-+.\de]+) )?\+/- ([-+.\de]+)\]")
"""A ball as python-flint writes it: midpoint, which may be left out, and radius."""
_IN_PLACE = re.compile(r'([(\[]*)(<span class="long">.*?</span>|<math.*?</math>)([.,:;!?)\]]*)', re.DOTALL)
"""An inline formula with the brackets and the punctuation about it."""
_LONG_NUMBER = re.compile(r"\d{24,}")
_TEX = str.maketrans({
    "&": r"\&", "%": r"\%", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}", "$": r"\$", "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}",
})  # fmt: skip
"""What stands for a character that means something else to TeX."""
_DECLARED = "–—‘’“”…≤≥≠≈∓→∞−√∈πτΩΦΔθζ"
"""Characters beyond Latin that TeX knows, or that the template declares to it."""
LONG = 36
"""Characters from which on an inline formula may be wider than its column, so that it has to be scrolled."""


class Span(Enum):
    """What a stretch of a text is."""

    PROSE = "prose"
    INLINE = "inline"
    DISPLAY = "display"


def pieces(text: str) -> Iterator[tuple[Span, str]]:
    """Split a text into prose and mathematics; dollars without a partner stay in the prose."""
    end = 0
    for match in _PIECES.finditer(text):
        if match.start() > end:
            yield Span.PROSE, _prose(text[end : match.start()])
        kind = Span.DISPLAY if match["display"] else Span.INLINE
        yield kind, (match["display"] or match["inline"]).strip()
        end = match.end()
    if end < len(text):
        yield Span.PROSE, _prose(text[end:])


def _prose(text: str) -> str:
    """Return a stretch of prose with literal dollars, balls as midpoint ± radius, and a minus where a hyphen was typed."""
    shown = _BALL.sub(lambda ball: f"{ball[1] or 0} ± {ball[2]}", text.replace(r"\$", "$"))
    return _MINUS.sub("\N{MINUS SIGN}", shown)


def html(text: str) -> str:
    """Return the text as HTML phrasing content; mathematics that cannot be read stays visible, as code.

    A formula keeps the brackets and the punctuation about it, so that no line begins with a comma.
    """
    written = "".join(_html_piece(kind, content) for kind, content in pieces(text))
    return _IN_PLACE.sub(lambda one: f'<span class="glued">{one[0]}</span>' if one[1] or one[3] else one[0], written)


def _html_piece(kind: Span, content: str) -> str:
    if kind is Span.PROSE:
        return escape(content)
    try:
        element = mathml(content, display=kind is Span.DISPLAY)
    except UnreadableMathematicsError:
        return f"<code>{escape(content)}</code>"
    if kind is Span.DISPLAY:
        return f'<span class="display">{element}</span>'
    return f'<span class="long">{element}</span>' if len(spoken(content)) > LONG or "<mtable" in element else element


def plain(text: str) -> str:
    """Return the text for a terminal, mathematics in Unicode."""
    return "".join(content if kind is Span.PROSE else spoken(content) for kind, content in pieces(text))


def latex(text: str) -> str:
    """Return the text as LaTeX source; what is special to TeX in the prose is escaped."""
    return "".join(_latex_piece(kind, content) for kind, content in pieces(text))


def _latex_piece(kind: Span, content: str) -> str:
    if kind is not Span.PROSE:
        return f"${content}$" if kind is Span.INLINE else f"\\[{content}\\]"
    known = "".join(
        one if ord(one) in _TEX or one < "\u0180" or one in _DECLARED else f"[U+{ord(one):04X}]" for one in content
    )
    breakable = _LONG_NUMBER.sub(lambda number: "\0".join(re.findall(".{1,8}", number[0])), known)
    return breakable.translate(_TEX).replace("\0", r"\allowbreak{}")
