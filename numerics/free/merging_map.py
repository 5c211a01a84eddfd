"""The merging set as a map of proved cells: from which energies on S0 does which mass ratio merge, from which creep?

A window of m2/m1 and E/E_cr - 1 is cut into a quadtree (quadtree.py), each cell decided by merging.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import InvalidMap
from numerics.free.merging import CRITICAL_SHARE, Rectangle, Verdict, verdict
from numerics.free.quadtree import Leaf, Sides, Verdicts, leaves_of, raster, shares
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
        for (low, high), (name, given, asked) in zip(self.rectangle, named, strict=True):
            if not (low >= SMALLEST and low * NARROWEST <= high <= LARGEST):
                shown = " to ".join(decimal_text(one)[:20] for one in given)
                raise InvalidMap(f"{name}: {shown} is no range; give {asked} at least 1.001")

    @property
    def rectangle(self) -> Rectangle:
        """Return the window as the cell that holds all others."""
        low, high = self.energy
        return Rectangle(self.ratio, (low - 1, high - 1))


class MapCell(NamedTuple):
    """A leaf of the map: its rectangle, its level (0 is the whole window), column and row there, and what is proved."""

    rectangle: Rectangle
    level: int
    column: int
    row: int
    verdict: Verdict


@dataclass(frozen=True)
class MergingMap:
    """The leaves of a window's quadtree; they cover it."""

    window: Window
    depth: int
    leaves: tuple[Leaf, ...]

    @property
    def cells(self) -> tuple[MapCell, ...]:
        """Return the leaves with their rectangles by name."""
        return tuple(MapCell(Rectangle(*one.sides), *one[1:]) for one in self.leaves)

    def shares(self) -> dict[Verdict, float]:
        """Return the share of each verdict in the window's area on logarithmic axes."""
        return shares(self.leaves, Verdict)

    def raster(self) -> Any:
        """Return the verdicts on the finest grid as indices into COLOURS, shape (2^depth, 2^depth), energy upwards."""
        return raster(self.leaves, self.depth, list(COLOURS))

    def as_record(self) -> dict[str, Any]:
        """Return the map for JSON: exact fractions as text, one [m2/m1 from, to, E/E_cr from, to, verdict] a cell."""
        return {
            **_title(self.window, self.depth),
            "shares": {one.name.lower(): share for one, share in self.shares().items()},
            "cells": [
                [*(str(one) for one in cell.rectangle.ratio + cell.rectangle.energy), cell.verdict.name.lower()]
                for cell in self.cells
            ],
        }


def decide(sides: Sides) -> Verdict:
    """Return the verdict of a cell by its sides."""
    return verdict(Rectangle(*sides))


def merging_cells(window: Window, depth: int, **roads: Any) -> MergingMap:
    """Return the map of a window, cells down to 2^-depth of its sides; every verdict is proved for its whole cell.

    `roads` are `jobs`, `dask`, `resume` and `progress` of quadtree.leaves_of; none changes the result.
    Raises InvalidMap (depth, checkpoint of another map) and MissingTool (joblib or distributed is not installed).
    """
    verdicts = Verdicts(decide, Verdict, Verdict.UNDECIDED)
    return MergingMap(
        window,
        depth,
        leaves_of(window.rectangle, depth, verdicts, {"map": "merging", **_title(window, depth)}, **roads),
    )


def _title(window: Window, depth: int) -> dict[str, object]:
    """Return what a checkpoint must agree with, but for the kind of the map."""
    sides = {"ratio": [str(one) for one in window.ratio], "energy": [str(one) for one in window.energy]}
    return {**sides, "depth": depth}


def draw_map(cells: MergingMap) -> Any:
    """Return a matplotlib figure of the map."""
    from matplotlib.colors import ListedColormap
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

    window = cells.window.rectangle
    edges = [np.geomspace(float(low), float(high), 2**cells.depth + 1) for low, high in window]
    figure = Figure(figsize=(8, 6.4), layout="constrained")
    axes = figure.subplots()
    colours = ListedColormap(list(COLOURS.values()))
    axes.pcolormesh(*edges, cells.raster(), cmap=colours, vmin=-0.5, vmax=len(COLOURS) - 0.5, rasterized=True)
    axes.set(xscale="log", yscale="log", xlabel="mass ratio $m_2/m_1$", ylabel="excess energy $E/E_{cr}-1$ on $S_0$")
    shares = cells.shares()
    handles: list[Any] = [
        Patch(fc=COLOURS[one], ec="black", lw=0.5, label=f"{LABELS[one]} ({shares[one]:.1%})") for one in COLOURS
    ]
    threshold = float(CRITICAL_SHARE / (1 - CRITICAL_SHARE))
    if window.ratio[0] < threshold < window.ratio[1]:
        line = axes.axvline(threshold, color="black", lw=1.2, ls="--")
        line.set_label(f"$m_2/m_1 = {threshold:.6f}$, $m_2/M = r^* = {float(CRITICAL_SHARE):.6f}$")
        handles.append(line)
    figure.legend(handles=handles, loc="outside lower center", ncols=2, fontsize=9, frameon=False)
    axes.set_title("From which energies on $S_0$ the pair merges: every decided cell is proved")
    return figure
