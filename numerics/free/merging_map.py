"""The merging set as a map of proved cells: from which energies on S0 does which mass ratio merge, from which creep?

A window of m2/m1 and E/E_cr - 1 is cut into a quadtree (quadtree.py), each cell decided by merging.py.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from numerics.free.merging import CRITICAL_SHARE, Merging, verdict
from numerics.free.quadtree import CellMap, map_of, side_of

COLOURS = {Merging.CREEPS: "#f3e6c4", Merging.UNDECIDED: "#d1603d", Merging.MERGES: "#1f3a5f"}
LABELS = {
    Merging.CREEPS: "creeps to $E_{cr}$, never merges",
    Merging.UNDECIDED: "undecided at this depth",
    Merging.MERGES: "merges in finite time",
}
SMALLEST, LARGEST = Fraction(1, 10**6), Fraction(10**6)


def merging_cells(depth: int, ratio: Any = ("0.8", 100), energy: Any = ("1.01", 101), **roads: Any) -> CellMap:
    """Return the map of ranges of m2/m1 and E/E_cr > 1, cells down to 2^-depth; each verdict is proved for its cell.

    In JSON a cell is [m2/m1 from, to, E/E_cr from, to, verdict]. `roads` are `jobs`, `dask`, `resume` and `progress` of
    quadtree.map_of; none changes the result. Raises InvalidMap (a range that neither binary64 axes nor 10,000 slips
    resolve, depth, checkpoint of another map) and MissingTool (joblib or distributed is not installed).
    """
    added = 0, 1
    sides = side_of("m2/m1", ratio, SMALLEST, LARGEST), side_of("E/E_cr", energy, SMALLEST, LARGEST, less=1)
    named = zip(("ratio", "energy"), sides, added, strict=True)
    title = {name: [str(one + more) for one in side] for name, side, more in named}
    return map_of(sides, depth, verdict, Merging.UNDECIDED, {"map": "merging", **title}, added, **roads)


def draw_map(cells: CellMap) -> Any:
    """Return a matplotlib figure of the map."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 6.4), layout="constrained")
    axes = figure.subplots()
    handles = cells.draw(axes, COLOURS, LABELS)
    axes.set(xlabel="mass ratio $m_2/m_1$", ylabel="excess energy $E/E_{cr}-1$ on $S_0$")
    (low, high), threshold = cells.window[0], float(CRITICAL_SHARE / (1 - CRITICAL_SHARE))
    if low < threshold < high:
        line = axes.axvline(threshold, color="black", lw=1.2, ls="--")
        line.set_label(f"$m_2/m_1 = {threshold:.6f}$, $m_2/M = r^* = {float(CRITICAL_SHARE):.6f}$")
        handles.append(line)
    figure.legend(handles=handles, loc="outside lower center", ncols=2, fontsize=9, frameon=False)
    axes.set_title("From which energies on $S_0$ the pair merges: every decided cell is proved")
    return figure
