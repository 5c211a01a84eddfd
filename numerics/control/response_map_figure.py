"""The response map as a picture: frequency against amplitude, both logarithmic; colours that differ in grey too."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from numerics.control.figures import BETWEEN, ENTRAINED, NON_STOP, REGIME_COLOURS, plain_decades, threshold_curves
from numerics.control.response_map import Regimes, ResponseMap
from numerics.quadtree.tree import raster
from numerics.trajectory.figures import BLUE, ORANGE

COLOURS = {
    Regimes.ENTRAINED: REGIME_COLOURS[ENTRAINED],
    Regimes.BETWEEN: REGIME_COLOURS[BETWEEN],
    Regimes.NON_STOP: REGIME_COLOURS[NON_STOP],
    Regimes.UNDECIDED: "#777777",
}
LABELS = {
    Regimes.ENTRAINED: f"proved: {ENTRAINED}",
    Regimes.BETWEEN: f"proved: {BETWEEN}",
    Regimes.NON_STOP: f"proved: {NON_STOP}",
    Regimes.UNDECIDED: "undecided at this depth",
}


def draw_response_map(found: ResponseMap) -> Figure:
    """Return a matplotlib figure of the map: proved cells, U*, U**, and from where on a motion without stops exists.

    That last line is approximate, as `non_stop_edge` says; where it lies above U**, a cell between is not non-stop.
    """
    edges = [np.geomspace(float(low), float(high), 2**found.depth + 1) for low, high in (found.omega, found.amplitude)]
    figure = Figure(figsize=(7.6, 6.4), layout="constrained")
    axes = figure.subplots()
    colours = ListedColormap(list(COLOURS.values()))
    grid = raster(found.leaves, found.depth, list(COLOURS))
    axes.pcolormesh(*edges, grid, cmap=colours, vmin=-0.5, vmax=len(COLOURS) - 0.5, rasterized=True)
    omegas = np.geomspace(edges[0][0], edges[0][-1], 600)
    low, high, edge = threshold_curves(found.pair, omegas.tolist())
    lines = axes.plot(omegas, low, color=BLUE, label="$U_*$: up to it a motion sticks for ever")
    lines += axes.plot(omegas, edge, color="black", label="no stops from this line on (drawn, not proved)")
    lines += axes.plot(omegas, high, color=ORANGE, ls="--", label="$U_{**}$: none without a stop below it")
    axes.set(xscale="log", yscale="log", xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    plain_decades(axes)
    axes.set(xlabel=r"frequency $\omega$ (rad/s)", ylabel="amplitude U (N)")
    shares = found.shares()
    handles: list[Any] = [Patch(fc=COLOURS[one], ec="black", lw=0.5, label=_label(one, shares[one])) for one in COLOURS]
    figure.legend(handles=[*handles, *lines], loc="outside lower center", ncols=2, fontsize=9, frameon=False)
    axes.set_title("What a sine does to the pair: every decided cell is proved")
    return figure


def _label(one: Regimes, share: float) -> str:
    return f"{LABELS[one]} ({share:.1%})"
