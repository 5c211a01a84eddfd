"""The merging map as a picture: m2/m1 against E/E_cr - 1, both logarithmic; colours that differ in grey too."""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.merging.cell import CRITICAL_SHARE, Verdict
from numerics.merging.map import MergingMap
from numerics.quadtree import tree

COLOURS = {Verdict.CREEPS: "#f3e6c4", Verdict.UNDECIDED: "#d1603d", Verdict.MERGES: "#1f3a5f"}
LABELS = {
    Verdict.CREEPS: "creeps to $E_{cr}$, never merges",
    Verdict.UNDECIDED: "undecided at this depth",
    Verdict.MERGES: "merges in finite time",
}


def raster(cells: MergingMap) -> Any:
    """Return the verdicts on the finest grid as indices into COLOURS, shape (2^depth, 2^depth), energy upwards."""
    return tree.raster(cells.leaves, cells.depth, list(COLOURS))


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
    axes.pcolormesh(*edges, raster(cells), cmap=colours, vmin=-0.5, vmax=len(COLOURS) - 0.5, rasterized=True)
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
