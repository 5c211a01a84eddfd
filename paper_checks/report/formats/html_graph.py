"""The graph of what rests on what, as vector graphics whose nodes are links."""

from __future__ import annotations

from collections.abc import Callable, Collection
from html import escape

from paper_checks.report.content.blocks import Graph, Node

_LINE, _TOP, _LEFT, _RIGHT, _WIDTH = 17, 14, 300, 640, 920
"""Height of a line, margin above, ends of the curves, width (user units of the drawing)."""


def graph(drawn: Graph, anchors: Collection[str], text: Callable[[str], str]) -> str:
    """Return the figure; a node whose anchor the page lacks is no link. `text` writes the caption."""
    lines = max(len(drawn.rows), len(drawn.steps), 1)
    height = _TOP * 2 + _LINE * lines
    places = {node.anchor: _height(n, len(drawn.steps), lines) for n, node in enumerate(drawn.steps)}
    rows = "\n".join(
        _row(node, _height(n, len(drawn.rows), lines), places, anchors) for n, node in enumerate(drawn.rows)
    )
    steps = "\n".join(
        f'<g class="{node.kind}">{_label(node, _RIGHT + 10, places[node.anchor], "start", anchors)}</g>'
        for node in drawn.steps
    )
    key = "".join(f'<li class="{kind}">{kind}</li>' for kind in drawn.kinds)
    return (
        f'<figure class="graph"><ul class="key">{key}</ul>\n'
        '<div class="wide" role="group" aria-label="What rests on what, as a graph of links">'
        f'<svg viewBox="0 0 {_WIDTH} {height}" role="group" aria-label="Rows on the left, what they rest on on the right">\n'
        f"{rows}\n{steps}\n</svg></div>\n<figcaption>{text(drawn.caption)}</figcaption></figure>"
    )


def _height(index: int, count: int, lines: int) -> float:
    """Return the height of a node, so that both columns are as high as the longer one."""
    return round(_TOP + _LINE * (lines - 1) * (index / max(1, count - 1)), 1)


def _row(node: Node, y: float, places: dict[str, float], anchors: Collection[str]) -> str:
    half = (_LEFT + _RIGHT) // 2
    curves = "".join(
        f'<path d="M{_LEFT} {y} C{half} {y} {half} {places[one]} {_RIGHT} {places[one]}"/>'
        for one in node.below
        if one in places
    )
    return f'<g class="{node.kind}">{curves}{_label(node, _LEFT - 10, y, "end", anchors)}</g>'


def _label(node: Node, x: float, y: float, side: str, anchors: Collection[str]) -> str:
    dot = _LEFT - 3 if side == "end" else _RIGHT + 3
    words = (
        f'<circle cx="{dot}" cy="{y}" r="3.5"/>'
        f'<text x="{x}" y="{y + 4}" text-anchor="{side}">{escape(node.text)}</text>'
    )
    return f'<a href="#{node.anchor}">{words}</a>' if node.anchor in anchors else words
