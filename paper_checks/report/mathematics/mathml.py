"""LaTeX mathematics as a MathML tree: converted, checked, mended where the converter leaves spacing to chance, checked again."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import cache
from xml.etree import ElementTree

NAMESPACE = "http://www.w3.org/1998/Math/MathML"
ARITY = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "mover": 2, "munder": 2, "munderover": 3, "mroot": 2}
"""Elements that take exactly so many arguments; anything more among them is an error."""
ROWS = {"math", "mrow", "msqrt", "mtd", "mstyle", "mpadded", "mphantom", "menclose"}
"""Elements whose children stand side by side: only here may a space be added."""
LEAVES = {"mi", "mn", "mo", "mtext", "mspace"}
ELEMENTS = {*ROWS, *LEAVES, *ARITY, "mtable", "mtr"}
FUNCTIONS = {"sin", "cos", "tan", "cot", "acot", "arccot", "atan", "acos", "exp", "log", "ln", "max", "min", "lim"}
ACCENTS = {"˙", "¨", "¯", "‾", "~", "˜", "^", "ˆ", "→"}
_COMMAND = re.compile(r"\s*\\[A-Za-z]+")
_SIGNS = {"\u2212", "+", "±", "∓"}
CLOSING = {")", "]", "}", "|", "‖", "⌉", "⌋", "⟩", "!", "′"}
THIN = {"width": "0.167em"}
_TALL = {"mfrac", "msqrt", "mroot", "mtable", "munder", "munderover"}
"""Elements that are higher than a letter, so that the fences around them have to grow."""
_SCRIPTS = {"msub", "msup", "msubsup", "munder", "mover", "munderover"}
_PRIMES = "′″"
_CLOSE = {"lspace": "0", "rspace": "0"}

Element = ElementTree.Element


class UnreadableMathematicsError(ValueError):
    """LaTeX that cannot be turned into MathML."""


@cache
def mathml(latex: str, *, display: bool = False) -> str:
    """Return LaTeX mathematics as the text of a MathML element; raises UnreadableMathematicsError."""
    element = tree(latex, display=display)
    element.set("xmlns", NAMESPACE)
    return ElementTree.tostring(element, encoding="unicode")


def tree(latex: str, *, display: bool = False) -> Element:
    """Return the MathML element of LaTeX source, its names without the namespace; raises UnreadableMathematicsError."""
    from latex2mathml.converter import convert  # a terminal, which imports this module too, does without it

    try:
        text = convert(latex, display="block" if display else "inline")
    except Exception as error:
        raise UnreadableMathematicsError(f"{latex!r}: {type(error).__name__}: {error}") from error
    try:
        element = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise UnreadableMathematicsError(f"{latex!r}: not well-formed, {error}") from error
    for node in element.iter():
        node.tag = node.tag.removeprefix(f"{{{NAMESPACE}}}")
    for step in (lambda: None, lambda: _mend(element)):
        step()
        if objection := objection_to(element):
            raise UnreadableMathematicsError(f"{latex!r}: {objection}")
    return element


def objection_to(element: Element) -> str | None:
    """Say why an element is no MathML: an unknown element or command, an argument lost or one too many."""
    for node in element.iter():
        if node.tag not in ELEMENTS:
            return f"{node.tag} is no element of mathematics"
        if len(node) != ARITY.get(node.tag, len(node)):
            return f"{node.tag} has {len(node)} arguments"
        if command := _COMMAND.match(node.text or ""):
            return f"the command {command[0]} is not known"
    return None


def _mend(element: Element) -> None:
    """Set in place as TeX would: operators, fences, primes, and spaces about functions, in indices and at a stroke."""
    _mend_operators(element)
    for node in list(element.iter()):
        if node.tag in _SCRIPTS:
            for one in (one for script in list(node)[1:] for one in script.iter("mo")):
                one.attrib.update(_CLOSE)
        if not any(one.tag in _TALL for one in node.iter()):  # a fence of the next size is wider, too
            for one in node:
                if one.get("fence") == "true":
                    one.set("stretchy", "false")
        node[:] = [_with_prime(child) for child in node]
        if node.tag in ROWS:
            node[:] = list(_spaced(list(node)))


def _mend_operators(element: Element) -> None:
    """Set relations and brackets as operators, and close up fences and strokes."""
    for node in element.iter():
        text = node.text or ""
        if node.tag == "mi" and _is_operator(text):
            node.tag = "mo"
        elif node.tag == "mo" and text == "∞":
            node.tag = "mi"
        if node.tag == "mo":
            node.text = text.removeprefix("\\")
            if node.get("fence") == "true" or node.text in "|⌈⌉⌊⌋/":
                node.attrib.update(_CLOSE)
        if node.tag == "mover" and (node[1].text or "") in ACCENTS:
            node.set("accent", "true")


def _with_prime(node: Element) -> Element:
    """Return a letter with its prime beside it: the font's prime is a raised one, and would be raised twice."""
    if node.tag not in ("msup", "msubsup"):
        return node
    mark = "".join(node[-1].itertext())
    if not mark or mark.strip(_PRIMES):
        return node
    base = node[0]
    if node.tag == "msubsup":
        base = Element("msub")
        base.extend(list(node)[:2])
    prime = Element("mo", {"form": "postfix", **_CLOSE})
    prime.text = mark
    row = Element("mrow")
    row.extend([base, prime])
    return row


def _is_operator(text: str) -> bool:
    """Return whether a letter of the converter is a relation or a bracket."""
    kind = unicodedata.category(text) if len(text) == 1 else ""
    return kind in ("Ps", "Pe") or (kind == "Sm" and text not in "∞∅∂∇")


def _spaced(children: list[Element]) -> Iterator[Element]:
    """Yield what stands side by side, with thin spaces about a function's name, and signs as prefixes where they are."""
    before: Element | None = None
    letter: Element | None = None  # the last one that is no space
    for index, child in enumerate(children):
        opened = letter is not None and letter.tag == "mo" and (letter.text or "") not in CLOSING
        if child.tag == "mo" and (child.text or "") in _SIGNS and opened:
            child.set("form", "prefix")
        factor = before is not None and (
            before.tag not in ("mo", "mspace") or (before.text or "") in CLOSING - {"|", "‖"}
        )
        if _is_function(child) and factor:
            yield Element("mspace", THIN)
        yield child
        after = children[index + 1] if index + 1 < len(children) else None
        if _is_function(child) and after is not None and _is_argument(after):
            yield Element("mspace", THIN)
        before, letter = child, letter if child.tag == "mspace" else child


def _is_function(node: Element) -> bool:
    """Return whether the element is a function's name, with or without an index or a power."""
    base = node[0] if node.tag in ("msub", "msup", "msubsup") else node
    return base.tag in ("mi", "mo") and (base.text or "") in FUNCTIONS


def _is_argument(node: Element) -> bool:
    """Return whether a function's name needs a space before this: not before a bracket or an operator."""
    while node.tag == "mrow" and len(node):
        node = node[0]
    return node.tag not in ("mo", "mspace")
