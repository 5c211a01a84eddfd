"""What rests on what: the rows of the ledger on the left, what their clauses rest on to the right, layer by layer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from paper_checks import kernel
from paper_checks.evidence import Evidence, EvidenceKind
from paper_checks.report.mathematics import plain
from paper_checks.runner import Row

COLOURS = {
    EvidenceKind.KERNEL: "#1b4f8f",
    EvidenceKind.SMT: "#2e8b3d",
    EvidenceKind.EXACT: "#7a9a1e",
    EvidenceKind.ENCLOSURE: "#c8641e",
    EvidenceKind.ARGUMENT: "#8a4a8f",
    None: "#999999",
}
SHOWN = (EvidenceKind.KERNEL, EvidenceKind.ARGUMENT)
WIDTH = 46
"""Characters of an inference that are shown."""


def edges(rows: Sequence[Row]) -> Iterator[tuple[str, Evidence]]:
    """Yield each row's id with the theorems and shared inferences that its clauses rest on directly."""
    for row in rows:
        for proof in row.proofs:
            yield from ((row.claim.id, step) for step in (*proof.kernel, *proof.steps) if step.kind in SHOWN)


def name_of(step: Evidence) -> str:
    """Return the short name of a step."""
    if step.kind is EvidenceKind.KERNEL:
        return kernel.name_of(step)
    text = step.statement
    if len(text) <= WIDTH:
        return text
    cut = text[:WIDTH].rsplit(" ", 1)[0]
    return (cut if cut.count("$") % 2 == 0 else cut.rsplit("$", 1)[0].rstrip()) + " ..."


def proof_graph(rows: Sequence[Row]) -> Figure:
    """Draw the rows, the theorems of the kernel, and the inferences that more than one row or inference rests on."""
    links = list(edges(rows))
    links += [(name_of(step), below) for step in _all(links) for below in step.rests_on if below.kind in SHOWN]
    used = {name_of(step): sum(name_of(other) == name_of(step) for _, other in links) for _, step in links}
    nodes = {name_of(step): step for _, step in links if step.kind is EvidenceKind.KERNEL or used[name_of(step)] > 1}
    figure = Figure(figsize=(11, max(3.0, 0.17 * max(len(rows), len(nodes)))))
    axes = figure.subplots()
    axes.set_axis_off()
    left = {row.claim.id: (0.0, -n / max(1, len(rows) - 1)) for n, row in enumerate(rows)}
    right = {name: (1.0, -n / max(1, len(nodes) - 1)) for n, name in enumerate(sorted(nodes))}
    for row in rows:
        _node(axes, left[row.claim.id], row.claim.id, COLOURS[row.established_by], "right")
    for name, place in right.items():
        kind = nodes[name].kind if nodes[name].passed else None
        _node(axes, place, plain(name), COLOURS[kind], "left")
    for start, step in dict.fromkeys((start, name_of(step)) for start, step in links):
        if step in right and start in left:
            (x, y), (u, v) = left[start], right[step]
            axes.plot([x + 0.02, u - 0.02], [y, v], color="#777777", linewidth=0.4, alpha=0.6)
    axes.set_xlim(-0.55, 1.75)
    return figure


def _all(links: Sequence[tuple[str, Evidence]]) -> list[Evidence]:
    found: dict[Evidence, None] = {}
    waiting = [step for _, step in links]
    while waiting:
        step = waiting.pop()
        if step not in found:
            found[step] = None
            waiting += [below for below in step.rests_on if below.kind in SHOWN]
    return list(found)


def _node(axes: Axes, place: tuple[float, float], text: str, colour: str, side: str) -> None:
    axes.plot(*place, marker="o", color=colour, markersize=4)
    offset = -0.025 if side == "right" else 0.025
    axes.text(place[0] + offset, place[1], text, ha=side, va="center", fontsize=6, color=colour)
