"""Prose with LaTeX in it, for each kind of reader: MathML, plain text, LaTeX.

Mathematics stands between `$` (inline) or `$$` (displayed); a backslash before it makes a dollar literal.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from enum import Enum
from html import escape, unescape
from xml.etree import ElementTree

from latex2mathml.converter import convert

from paper_checks.report.unicode_mathematics import spoken

_PIECES = re.compile(r"(?<!\\)\$\$(?P<display>.+?)(?<!\\)\$\$|(?<!\\)\$(?P<inline>[^$]+?)(?<!\\)\$", re.DOTALL)
_COMMAND = re.compile(r"\s*\\[A-Za-z]+")
_NAMESPACE = "{http://www.w3.org/1998/Math/MathML}"
_ARITY = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munder": 2, "munderover": 3, "mroot": 2}
_ELEMENTS = {
    *("math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "msqrt", "mtable", "mtr", "mtd", "mstyle", "mpadded"),
    *("mphantom", "menclose", *_ARITY),
}
_LETTER = re.compile(r"<mi>(&#x[0-9A-F]+;|\W)</mi>")
_BAR = '<mo stretchy="false">&#x0007C;</mo>'
_FENCE = re.compile(r'<mo ([^>]*fence="true"[^>]*)>\\?([^<]*)</mo>')
_SIGN_AFTER_OPERATOR = re.compile(
    r"(?P<before><mo[^>]*>(?!&#x00029;|&#x0005D;|&#x0007D;|&#x02016;|[|)\]}])[^<]*</mo>)"
    r"(?P<space>(?:<mspace[^>]*/>)?)<mo>(?P<sign>&#x02212;|&#x0002B;|&#x000B1;|&#x02213;)</mo>"
)
_NAMED_FUNCTION = re.compile(r"(<m[io]>(?:sin|cos|tan|exp|log|ln|max|min)</m[io]>)(?=<m(?!o))")
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


class UnreadableMathematicsError(ValueError):
    """LaTeX that cannot be turned into MathML."""


class Piece(Enum):
    """What a stretch of a text is."""

    PROSE = "prose"
    INLINE = "inline"
    DISPLAY = "display"


def pieces(text: str) -> Iterator[tuple[Piece, str]]:
    """Split a text into prose and mathematics; dollars without a partner stay in the prose."""
    end = 0
    for match in _PIECES.finditer(text):
        if match.start() > end:
            yield Piece.PROSE, text[end : match.start()].replace(r"\$", "$")
        kind = Piece.DISPLAY if match["display"] else Piece.INLINE
        yield kind, (match["display"] or match["inline"]).strip()
        end = match.end()
    if end < len(text):
        yield Piece.PROSE, text[end:].replace(r"\$", "$")


def mathml(latex: str, *, display: bool = False) -> str:
    """Return the MathML element; raises UnreadableMathematicsError."""
    try:
        element = convert(latex, display="block" if display else "inline")
    except Exception as error:
        raise UnreadableMathematicsError(f"{latex!r}: {type(error).__name__}: {error}") from error
    if objection := _objection_to(element):
        raise UnreadableMathematicsError(f"{latex!r}: {objection}")
    return _spaced(element)


def _objection_to(element: str) -> str | None:
    """Say why what the converter gave is no MathML: it lets unknown commands, lost arguments and tags through."""
    try:
        nodes = list(ElementTree.fromstring(element).iter())
    except ElementTree.ParseError as error:
        return f"not well-formed, {error}"
    for node in nodes:
        name = node.tag.removeprefix(_NAMESPACE)
        if name not in _ELEMENTS:
            return f"{name} is no element of mathematics"
        if len(node) != _ARITY.get(name, len(node)):
            return f"{name} has {len(node)} arguments"
        if command := _COMMAND.match(node.text or ""):
            return f"the command {command[0]} is not known"
    return None


def _spaced(element: str) -> str:
    """Mend what the converter leaves to chance: relations set as letters, bars and signs spaced as infixes."""
    element = _LETTER.sub(lambda match: f"<mo>{match[1]}</mo>" if _is_relation(match[1]) else match[0], element)
    element = _FENCE.sub(r'<mo lspace="0" rspace="0" \1>\2</mo>', element)
    element = element.replace(_BAR, '<mo stretchy="false" lspace="0" rspace="0">|</mo>')
    element = _NAMED_FUNCTION.sub(r'\1<mspace width="0.167em"/>', element)
    return _SIGN_AFTER_OPERATOR.sub(r'\g<before>\g<space><mo form="prefix">\g<sign></mo>', element)


def _is_relation(content: str) -> bool:
    character = unescape(content)
    return unicodedata.category(character) == "Sm" and character not in "∞∅∂∇"


def html(text: str) -> str:
    """Return the text as HTML phrasing content; mathematics that cannot be read stays visible, as code."""
    return "".join(_html_piece(kind, content) for kind, content in pieces(text))


def _html_piece(kind: Piece, content: str) -> str:
    if kind is Piece.PROSE:
        return escape(content)
    try:
        element = mathml(content, display=kind is Piece.DISPLAY)
    except UnreadableMathematicsError:
        return f"<code>{escape(content)}</code>"
    return f'<span class="display">{element}</span>' if kind is Piece.DISPLAY else element


def plain(text: str) -> str:
    """Return the text for a terminal, mathematics in Unicode."""
    return "".join(content if kind is Piece.PROSE else spoken(content) for kind, content in pieces(text))


def latex(text: str) -> str:
    """Return the text as LaTeX source; what is special to TeX in the prose is escaped."""
    return "".join(_latex_piece(kind, content) for kind, content in pieces(text))


def _latex_piece(kind: Piece, content: str) -> str:
    if kind is Piece.PROSE:
        escaped = _TEX_SPECIAL.sub(lambda match: _TEX_ESCAPES.get(match[0], "\\" + match[0]), content)
        return _LONG_NUMBER.sub(_breakable, "".join(map(_latex_character, escaped)))
    return f"${content}$" if kind is Piece.INLINE else f"\\[{content}\\]"


def _breakable(number: re.Match[str]) -> str:
    return r"\allowbreak{}".join(re.findall(".{1,8}", number[0]))


def _latex_character(character: str) -> str:
    """Return the character as pdfTeX can set it; one that it has no glyph for is named, not dropped."""
    if character in _TEX_CHARACTERS:
        return f"${_TEX_CHARACTERS[character]}$"
    if character < "\u0180" or character in "–—‘’“”…":
        return character
    return f"[U+{ord(character):04X}]"
