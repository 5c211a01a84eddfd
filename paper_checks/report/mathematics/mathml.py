"""LaTeX mathematics as a MathML tree: converted, checked, mended where the converter leaves spacing to chance, checked again."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from xml.etree import ElementTree

from latex2mathml.converter import convert

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

Element = ElementTree.Element


class UnreadableMathematicsError(ValueError):
    """LaTeX that cannot be turned into MathML."""


def tree(latex: str, *, display: bool = False) -> Element:
    """Return the MathML element of LaTeX source, its names without the namespace; raises UnreadableMathematicsError."""
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
    """Set relations and brackets as operators, close up fences and signs, put a space after a function's name."""
    for node in element.iter():
        if node.tag == "mi" and _is_operator(node.text or ""):
            node.tag = "mo"
        elif node.tag == "mo" and node.text == "∞":
            node.tag = "mi"
        if node.tag == "mo":
            _mend_fence(node)
        if node.tag == "mover" and (node[1].text or "") in ACCENTS:
            node.set("accent", "true")
    for node in list(element.iter()):
        if node.tag in ROWS:
            node[:] = list(_spaced(list(node)))


def _is_operator(text: str) -> bool:
    """Return whether a letter of the converter is a relation or a bracket."""
    kind = unicodedata.category(text) if len(text) == 1 else ""
    return kind in ("Ps", "Pe") or (kind == "Sm" and text not in "∞∅∂∇")


def _mend_fence(node: Element) -> None:
    text = (node.text or "").removeprefix("\\")
    node.text = text
    if node.get("fence") == "true" or text in "|⌈⌉⌊⌋":
        node.set("lspace", "0")
        node.set("rspace", "0")


def _spaced(children: list[Element]) -> Iterator[Element]:
    """Yield what stands side by side, with a thin space after a function's name, and signs as prefixes where they are."""
    before: Element | None = None
    for index, child in enumerate(children):
        text = child.text or ""
        if child.tag == "mo" and text in _SIGNS and _is_open(before):
            child.set("form", "prefix")
        yield child
        after = children[index + 1] if index + 1 < len(children) else None
        if is_function(child) and after is not None and _is_argument(after):
            yield Element("mspace", THIN)
        if child.tag != "mspace":
            before = child


def _is_open(before: Element | None) -> bool:
    """Return whether a sign after this element is a prefix: it follows an operator that closes nothing."""
    return before is not None and before.tag == "mo" and (before.text or "") not in CLOSING


def is_function(node: Element) -> bool:
    """Return whether the element is a function's name, with or without an index or a power."""
    base = node[0] if node.tag in ("msub", "msup", "msubsup") else node
    return base.tag in ("mi", "mo") and (base.text or "") in FUNCTIONS


def _is_argument(node: Element) -> bool:
    """Return whether a function's name needs a space before this: not before a bracket or an operator."""
    while node.tag == "mrow" and len(node):
        node = node[0]
    return node.tag not in ("mo", "mspace")
