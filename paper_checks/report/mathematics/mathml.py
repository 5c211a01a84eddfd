"""LaTeX mathematics as MathML, by the library math-core; and as a line of Unicode for terminals, read off the MathML."""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from xml.etree import ElementTree

from math_core import LatexError, LatexToMathML

_CONVERTER = LatexToMathML(fancy_error=False)
_SIGNS = dict(zip("⩽⩾≤≥≠≈", (f" {one} " for one in "≤≥≤≥≠≈"), strict=True)) | {
    "−": "-",
    "∗": "*",
    "⋅": "·",
    "\u2063": "",
}
"""What a terminal shows of some signs."""
_SUBSCRIPTS = str.maketrans("0123456789+-", "₀₁₂₃₄₅₆₇₈₉₊₋")
_SUPERSCRIPTS = str.maketrans("0123456789+-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻")
_ACCENTS = dict(zip("˙¨˜ˆ¯̲→", "\u0307\u0308\u0303\u0302\u0304\u0304\u20d7", strict=True))


class UnreadableMathematicsError(ValueError):
    """LaTeX that cannot be turned into MathML."""


@cache
def mathml(latex: str, *, display: bool = False) -> str:
    """Return LaTeX mathematics as the text of a MathML element; raises UnreadableMathematicsError."""
    try:
        return _CONVERTER.convert_with_local_state(latex, displaystyle=display)
    except LatexError as error:
        raise UnreadableMathematicsError(f"{latex!r}: {error}") from error


@cache
def spoken(latex: str) -> str:
    r"""Return LaTeX mathematics as Unicode text; what cannot be read stays LaTeX.

    >>> spoken(r"\ddot{x}_1 \leqslant \tfrac{b}{m_1+m_2}\sqrt{a}")
    'ẍ₁ ≤ b/(m₁+m₂) √a'
    """
    try:
        text = mathml(latex).replace("&ApplyFunction;", "\u2061")
    except UnreadableMathematicsError:
        return latex
    line = " ".join(_said(ElementTree.fromstring(text)).split())
    return re.sub(r"(?<=[-+(]) (?=\w)", "", line)  # before a function's name


def _said(node: ElementTree.Element) -> str:  # noqa: PLR0911  one return for each kind of element
    parts = [*map(_said, node)]
    match node.tag, parts:
        case "mi", _:
            letter = node.text or ""
            return unicodedata.normalize("NFKC", letter) if letter.isalpha() else letter
        case "mo", _ if node.text == "\u2061":  # between a function and its argument
            return " " * ("lspace" in node.attrib)
        case "mspace", _:
            return " " * ("width" in node.attrib)
        case "mfrac", (above, below):
            return f"{_whole(above)}/{_alone(below)}"
        case "msqrt", _:
            return f"√{_alone(''.join(parts))}"
        case "msub" | "munder", (base, below):
            return base + _script(below, "_", _SUBSCRIPTS)
        case "msup", (base, above):
            return base + _script(above, "^", _SUPERSCRIPTS)
        case (("msubsup" | "munderover"), (base, below, above)):
            return base + _script(below, "_", _SUBSCRIPTS) + _script(above, "^", _SUPERSCRIPTS)
        case "mover", (base, accent):
            return unicodedata.normalize("NFC", base + _ACCENTS.get(accent, accent))
        case "mtr" | "mtable", _:
            return (", " if node.tag == "mtr" else "; ").join(parts)
    if not parts:
        return _SIGNS.get(node.text or "", node.text or "")
    for before, part in enumerate(parts[1:]):  # what ends with a fraction, a root or a word is no part of what follows
        wide = r"[\w√(]" if node[before].tag == "mfrac" else r"[\w√]"
        apart = re.search(r"/|√|_\w+$", parts[before]) and re.match(wide, part)
        parts[before] += " " * bool(apart)
    return "".join(parts)


def _whole(text: str) -> str:
    return text if re.fullmatch(r"[\w|]+", text) else f"({text})"


def _alone(text: str) -> str:
    """Put a denominator, or what is under a root, in parentheses, but for a number or one letter with its index."""
    return text if re.fullmatch(r"\d+|[^\W\d](?:_?\w)?", text) else f"({text})"


def _script(text: str, mark: str, small: dict[int, int]) -> str:
    text = text.strip()
    if re.fullmatch(r"[0-9+-]+", text):
        return text.translate(small)
    if not text.strip("*′″"):
        return text
    return mark + (text if re.fullmatch(r"\w+|.", text) else f"({text})")
