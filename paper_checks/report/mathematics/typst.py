"""LaTeX mathematics as typst's, by way of the MathML element: so both show the same, checked, tree."""

from __future__ import annotations

from paper_checks.report.mathematics.mathml import ARITY, FUNCTIONS, Element, tree

_ACCENTS = {
    "˙": "dot",
    "¨": "dot.double",
    "¯": "macron",
    "‾": "macron",
    "~": "tilde",
    "˜": "tilde",
    "^": "hat",
    "→": "arrow",
}
_SPECIAL = set("#$\\`\"'/_^&*~@<>()[]{},;:|.!?=+-")


def typst(latex: str, *, display: bool = False) -> str:
    """Return typst markup of LaTeX source, dollars included; raises UnreadableMathematicsError."""
    body = _write(tree(latex, display=display))
    return f"$ {body} $" if display else f"${body}$"


def _write(node: Element) -> str:  # noqa: PLR0911  one return for each kind of element
    inside = [_write(child) for child in node]
    if node.tag not in ARITY:
        inside = _words(node, inside)
    match node.tag:
        case "mi" | "mo" | "mn" | "mtext":
            return _leaf(node)
        case "mspace":
            return " space.thin "
        case "mfrac":
            return f"frac({inside[0]}, {inside[1]})"
        case "msup" | "msub" | "msubsup":
            return _attached(node, inside)
        case "mover" | "munder" | "munderover":
            return _stacked(node, inside)
        case "msqrt":
            return f"sqrt({' '.join(inside)})"
        case "mroot":
            return f"root({inside[1]}, {inside[0]})"
        case "mtable":
            return _table(node)
        case _:
            return " ".join(inside)


def _words(node: Element, inside: list[str]) -> list[str]:
    """Join upright letters that stand side by side: they are one word."""
    found: list[str] = []
    upright = False
    for child, written in zip(node, inside, strict=True):
        letter = child.tag == "mi" and child.get("mathvariant") == "normal" and (child.text or "").isalpha()
        if letter and upright:
            found[-1] = f'{found[-1][:-2]}{child.text}")'
        else:
            found.append(written)
        upright = letter
    return found


def _leaf(node: Element) -> str:
    text = node.text or ""
    if node.tag == "mtext" or (len(text) > 1 and text.isalpha()):
        return f"op({_quoted(text)})" if text in FUNCTIONS else f"upright({_quoted(text)})"
    if node.get("mathvariant") == "normal" or (
        node.tag == "mi" and len(text) == 1 and node.get("mathvariant") == "bold"
    ):
        return f"upright({_quoted(text)})"
    return "".join(f"\\{one}" if one in _SPECIAL else one for one in text) or "zws"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _attached(node: Element, inside: list[str]) -> str:
    base = inside[0]
    marks = dict(zip({"msup": "t", "msub": "b", "msubsup": "bt"}[node.tag], inside[1:], strict=True))
    return f"attach({base}, {', '.join(f'{place}: {mark}' for place, mark in marks.items())})"


def _stacked(node: Element, inside: list[str]) -> str:
    accent = _ACCENTS.get((node[1].text or "").strip())
    if node.tag == "mover" and accent:
        return f"accent({inside[0]}, {accent})"
    marks = dict(zip({"mover": "t", "munder": "b", "munderover": "bt"}[node.tag], inside[1:], strict=True))
    return f"attach(limits({inside[0]}), {', '.join(f'{place}: {mark}' for place, mark in marks.items())})"


def _table(node: Element) -> str:
    """Return a table without its fences: they stand beside it in the tree."""
    rows = [", ".join(" ".join(_write(child) for child in cell) for cell in row) for row in node]
    return f"mat(delim: #none, {'; '.join(rows)})"
