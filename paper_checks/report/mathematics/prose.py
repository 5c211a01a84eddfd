"""Prose with LaTeX in it, for each kind of reader: MathML, plain text, LaTeX.

Mathematics stands between `$` (inline) or `$$` (displayed); a backslash before it makes a dollar literal.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum
from html import escape

from paper_checks.report.mathematics.mathml import UnreadableMathematicsError, mathml
from paper_checks.report.mathematics.unicode import spoken

_PIECES = re.compile(r"(?<!\\)\$\$(?P<display>.+?)(?<!\\)\$\$|(?<!\\)\$(?P<inline>[^$]+?)(?<!\\)\$", re.DOTALL)
_MINUS = re.compile(r"(?<![\w.,)\]-])-(?=\d)")
_BALL = re.compile(r"\[(?:([-+.\de]+) )?\+/- ([-+.\de]+)\]")
"""A ball as python-flint writes it: midpoint, which may be left out, and radius."""
_OPENING, _CLOSING = re.compile(r"[(\[]+$"), re.compile(r"^[.,:;!?)\]]+")
_LONG_NUMBER = re.compile(r"\d{24,}")
_TEX_SPECIAL = re.compile(r"[&%#_{}~^\\$<>|]")
_TEX_ESCAPES = {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
}
_TEX_CHARACTERS = {
    "≤": r"\leq", "≥": r"\geq", "≠": r"\neq", "≈": r"\approx", "±": r"\pm", "∓": r"\mp", "×": r"\times",
    "·": r"\cdot", "→": r"\to", "∞": r"\infty", "−": "-", "²": "^2", "³": "^3", "√": r"\surd",
    "∈": r"\in", "π": r"\pi", "τ": r"\tau", "Ω": r"\Omega", "Φ": r"\Phi", "Δ": r"\Delta", "θ": r"\theta", "ζ": r"\zeta",
}  # fmt: skip


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
    split = list(pieces(text))
    written = [_html_piece(kind, content) for kind, content in split]
    for index, (kind, _) in enumerate(split):
        if kind is not Span.INLINE:
            continue
        opening, closing = "", ""
        if index and split[index - 1][0] is Span.PROSE:
            opening, written[index - 1] = _cut(_OPENING, written[index - 1])
        if index + 1 < len(split) and split[index + 1][0] is Span.PROSE:
            closing, written[index + 1] = _cut(_CLOSING, written[index + 1])
        if opening or closing:
            written[index] = f'<span class="glued">{opening}{written[index]}{closing}</span>'
    return "".join(written)


def _cut(mark: re.Pattern[str], text: str) -> tuple[str, str]:
    """Return the marks at an end of a text, and the text without them."""
    found = mark.search(text)
    return (found[0], text[: found.start()] + text[found.end() :]) if found else ("", text)


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
    if kind is Span.PROSE:
        escaped = _TEX_SPECIAL.sub(lambda match: _TEX_ESCAPES.get(match[0], "\\" + match[0]), content)
        return _LONG_NUMBER.sub(_breakable, "".join(map(_latex_character, escaped)))
    return f"${content}$" if kind is Span.INLINE else f"\\[{content}\\]"


def _breakable(number: re.Match[str]) -> str:
    return r"\allowbreak{}".join(re.findall(".{1,8}", number[0]))


def _latex_character(character: str) -> str:
    """Return the character as pdfTeX can set it; one that it has no glyph for is named, not dropped."""
    if character in _TEX_CHARACTERS:
        return f"${_TEX_CHARACTERS[character]}$"
    if character < "\u0180" or character in "–—‘’“”…":
        return character
    return f"[U+{ord(character):04X}]"
