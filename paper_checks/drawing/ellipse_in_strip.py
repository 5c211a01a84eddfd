"""The levels of the energy on S in the strip S0: closed up to E_cr, cut into two arcs above it."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from sympy import lambdify

from paper_checks.drawing.style import SLIDING, panels
from theory.scaling import reduced_energy
from theory.symbols import V1, V2, X

BELOW, CRITICAL, ABOVE = 0.45, 1.0, 1.6
"""The levels that are drawn, E0/E_cr."""
COLOURS = {BELOW: "#1b4f8f", CRITICAL: "black", ABOVE: "#cc2222"}
WIDE, HIGH = 1.5, 1.55
"""What is shown of X and V."""


def ellipse_in_strip() -> Figure:
    """Draw three levels of theory's energy on S, in units of L and L Omega, the strip, and the rays."""
    energy = lambdify((X, V1), reduced_energy().subs(V2, V1).simplify())
    figure, axes = panels(5.0, 4.6)
    axes.axvspan(-1, 1, color=SLIDING, linewidth=0, label="$S_0$")
    outside, inside = np.linspace(-WIDE, WIDE, 301), np.linspace(-1, 1, 201)
    v = np.linspace(-HIGH, HIGH, 301)
    axes.contour(
        outside, v, energy(*np.meshgrid(outside, v)), [ABOVE], colors=[COLOURS[ABOVE]], linestyles=":", alpha=0.6
    )
    for level, colour in COLOURS.items():
        axes.contour(inside, v, energy(*np.meshgrid(inside, v)), [level], colors=[colour], linewidths=1.6)
        at = np.sqrt(level - 0.45**2)
        for side in (1, -1):  # clockwise, as x1' = v1
            axes.annotate("", (side * 0.5, side * np.sqrt(level - 0.25)), (side * 0.45, side * at),
                          arrowprops={"arrowstyle": "-|>", "color": colour})  # fmt: skip
        name = f"$E_0={level:g}\\,E_{{cr}}$" if level != CRITICAL else "$E_0=E_{cr}$"
        axes.plot([], [], color=colour, label=name)
    axes.plot([1, 1], [0, HIGH], color="#c8641e", lw=3, label=r"$\ell_+$")
    axes.plot([-1, -1], [0, -HIGH], color="#2e8b3d", lw=3, label=r"$\ell_-$")
    axes.set(
        xlim=(-WIDE, WIDE),
        ylim=(-HIGH, HIGH),
        xlabel="$x_1/L$ (dimensionless)",
        ylabel=r"$v_1/(L\,\Omega)=v_2/(L\,\Omega)$ (dimensionless)",
    )
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure
