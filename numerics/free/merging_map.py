"""The merging set as a map of proved cells: from which energies on S0 does which mass ratio merge, from which creep?

A window of m2/m1 and E/E_cr - 1 is cut into a quadtree (quadtree.py), each cell decided by merging.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from numerics.errors import InvalidMap
from numerics.free.merging import CRITICAL_SHARE, Verdict, verdict
from numerics.free.quadtree import CellMap, Sides, map_of
from numerics.scene.decimals import decimal_text

COLOURS = {Verdict.CREEPS: "#f3e6c4", Verdict.UNDECIDED: "#d1603d", Verdict.MERGES: "#1f3a5f"}
LABELS = {
    Verdict.CREEPS: "creeps to $E_{cr}$, never merges",
    Verdict.UNDECIDED: "undecided at this depth",
    Verdict.MERGES: "merges in finite time",
}
SMALLEST, LARGEST, NARROWEST = Fraction(1, 10**6), Fraction(10**6), Fraction(1001, 1000)


@dataclass(frozen=True)
class Window:
    """Ranges of m2/m1 and of E/E_cr > 1 of a start on S0; exact, dimensionless. Raises InvalidMap."""

    ratio: tuple[Fraction, Fraction] = (Fraction(4, 5), Fraction(100))
    energy: tuple[Fraction, Fraction] = (Fraction(101, 100), Fraction(101))

    def __post_init__(self) -> None:
        """Refuse empty ranges, and what neither binary64 axes nor 10,000 slips resolve."""
        named = (
            ("m2/m1", self.ratio, "A and B from 1e-6 to 1e6 and B/A"),
            ("E/E_cr", self.energy, "A and B from 1.000001 to 1000001 and (B - 1)/(A - 1)"),
        )
        for (low, high), (name, given, asked) in zip(self.sides, named, strict=True):
            if not (low >= SMALLEST and low * NARROWEST <= high <= LARGEST):
                shown = " to ".join(decimal_text(one)[:20] for one in given)
                raise InvalidMap(f"{name}: {shown} is no range; give {asked} at least 1.001")

    @property
    def sides(self) -> Sides:
        """Return the ranges of m2/m1 and of E/E_cr - 1: the cell that holds all others."""
        low, high = self.energy
        return self.ratio, (low - 1, high - 1)


def merging_cells(window: Window, depth: int, **roads: Any) -> CellMap:
    """Return the map of a window, cells down to 2^-depth of its sides; every verdict is proved for its whole cell.

    In JSON a cell is [m2/m1 from, to, E/E_cr from, to, verdict]. `roads` are `jobs`, `dask`, `resume` and `progress` of
    quadtree.map_of; none changes the result. Raises InvalidMap (depth, checkpoint of another map) and MissingTool
    (joblib or distributed is not installed).
    """
    sides = {name: [str(one) for one in getattr(window, name)] for name in ("ratio", "energy")}
    return map_of(window.sides, depth, verdict, Verdict.UNDECIDED, {"map": "merging", **sides}, (0, 1), **roads)


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
