"""MathML for browsers, set as TeX would: primes, fences, and spaces about functions, in indices and at a stroke.

For the PDF nothing is done: TeX sets these by itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from xml.etree import ElementTree

from paper_checks.report.mathematics.mathml import CLOSING, NAMESPACE, ROWS, THIN, Element, is_function, tree

_TALL = {"mfrac", "msqrt", "mroot", "mtable", "munder", "munderover"}
"""Elements that are higher than a letter, so that the fences around them have to grow."""
_SCRIPTS = {"msub", "msup", "msubsup", "munder", "mover", "munderover"}
_PRIMES = "′″"
_CLOSE = {"lspace": "0", "rspace": "0"}


@cache
def mathml(latex: str, *, display: bool = False) -> str:
    """Return LaTeX mathematics as the text of a MathML element; raises UnreadableMathematicsError."""
    element = tree(latex, display=display)
    set_as_tex(element)
    element.set("xmlns", NAMESPACE)
    return ElementTree.tostring(element, encoding="unicode")


def set_as_tex(element: Element) -> None:
    """Change the element in place; what it says stays the same."""
    for node in list(element.iter()):
        _close_up(node)
        _flatten_fences(node)
        for index, child in enumerate(node):
            node[index] = _with_prime(child)
        if node.tag in ROWS:
            node[:] = list(_spaced(list(node)))


def _close_up(node: Element) -> None:
    """Take the space from the operators of an index, and from a stroke that divides."""
    if node.tag in _SCRIPTS:
        for script in list(node)[1:]:
            for one in script.iter("mo"):
                one.attrib.update(_CLOSE)
    elif node.tag == "mo" and node.text == "/":
        node.attrib.update(_CLOSE)


def _flatten_fences(row: Element) -> None:
    """Keep fences at a letter's height where nothing between them is higher: the next size is wider, too."""
    fences = [one for one in row if one.get("fence") == "true"]
    if fences and not any(one.tag in _TALL for one in row.iter()):
        for one in fences:
            one.set("stretchy", "false")


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


def _spaced(children: list[Element]) -> Iterator[Element]:
    """Yield what stands side by side, with a thin space between a factor and a function's name."""
    before: Element | None = None
    for child in children:
        if is_function(child) and before is not None and _is_factor(before):
            yield Element("mspace", THIN)
        yield child
        before = child


def _is_factor(node: Element) -> bool:
    """Return whether something is multiplied by what follows: it is no operator, no space, and closes what was open."""
    return node.tag not in ("mo", "mspace") or (node.text or "") in CLOSING - {"|", "‖"}
