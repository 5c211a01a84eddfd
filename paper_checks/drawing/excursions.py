"""The pictures of the theorems about one slip: its closed form, the return map, and when it merges."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sympy import lambdify

from paper_checks.claims.beyond.critical_ratio import critical_value
from paper_checks.decide.balls import precision
from paper_checks.drawing.style import panels
from theory.excursion import h
from theory.return_map import depth, depth_series
from theory.symbols import theta

Curve = NDArray[np.float64]
with precision():
    CRITICAL_SHARE = float(critical_value())
    """r*, rounded to binary64."""
SHARES = ((0.4, "#1b4f8f", "-"), (CRITICAL_SHARE, "black", "--"), (0.8, "#c8641e", "-."))
"""Mass shares r = m2/M that are drawn: below the critical share, at it, above it."""
ANGLE = r"slip angle $\theta$ (dimensionless)"


@cache
def slip(points: int = 2000, last: float = 5.6) -> tuple[Curve, Curve, Curve]:
    """Return angles, exit speeds h and depths c of slips from a ray, binary64, shape (points,)."""
    angles = np.linspace(1e-2, last, points)
    return angles, lambdify(theta, h())(angles), lambdify(theta, depth())(angles)


def excursion_curves() -> Figure:
    """Draw the speed at the exit and the depth at the return against the angle of a slip, and where it comes back."""
    angles, speed, deep = slip()
    figure, (left, right) = panels(7.6, 3.0, 1, 2)
    left.plot(angles, speed, color="#1b4f8f", lw=1.5, label="exit speed $h$")
    left.plot(angles, deep, color="#c8641e", lw=1.5, ls="--", label="depth $c$")
    left.set(xlabel=ANGLE, ylabel="$h$, $c$ (dimensionless)", ylim=(0, 10), title="one pair of curves for all masses")
    left.legend()
    for share, colour, dashes in SHARES:
        place = 1 - (1 - share) * deep
        inside = place > -1
        right.plot(angles[inside], place[inside], color=colour, ls=dashes, label=f"$m_2/M={share:.4g}$")
    right.axhspan(-1, 1, color="#f0f0f0", zorder=0)
    right.set(
        xlabel=ANGLE, ylabel="$x_1/L$ at the return (dimensionless)", ylim=(-1.15, 1.15), title="back in $S_0$ (grey)"
    )
    right.legend()
    return figure


def return_map() -> Figure:
    """Draw the depth against y with its Taylor polynomials, and the return map of three pairs."""
    _, speed, deep = slip()
    y = speed**2
    figure, (left, right) = panels(7.6, 3.0, 1, 2)
    near = y < 2.5
    left.plot(y[near], deep[near], color="black", lw=1.6, label="$c$")
    coefficients = [float(one) for one in depth_series(5)]
    for terms, colour, dashes in ((1, "#1b4f8f", ":"), (2, "#c8641e", "--"), (4, "#2e8b3d", "-.")):
        values = sum(coefficients[n] * y[near] ** (n + 1) for n in range(terms))
        left.plot(y[near], values, color=colour, ls=dashes, label=f"{terms} term{'s' if terms > 1 else ''}")
    left.set(
        xlabel="$y$ (dimensionless)",
        ylabel="$c$ (dimensionless)",
        ylim=(0, 3),
        title="the series, the same for every pair",
    )
    left.legend()
    shown = y < 8
    for share, colour, dashes in SHARES:
        after = y - share * deep**2
        right.plot(y[shown], after[shown], color=colour, ls=dashes, label=f"$m_2/M={share:.4g}$")
    right.plot([0, 8], [0, 8], color="#777777", lw=0.8, ls=":")
    _merging(right)
    right.set(
        xlabel="$y$ (dimensionless)",
        ylabel="$y'$ (dimensionless)",
        ylim=(-1, 4),
        title="from exit to exit: below 0 it merges",
    )
    right.legend(loc="upper left")
    return figure


def _merging(axes: Any) -> None:
    axes.axhline(0, color="black", lw=0.8)
    axes.axhspan(-10, 0, color="#f0f0f0", zorder=0)


def merging_window() -> Figure:
    """Draw R^2 = (h/c)^2 against the angle: a slip merges where the line r lies above it."""
    angles, speed, deep = slip()
    ratio = (speed / deep) ** 2
    figure, axes = panels(5.6, 3.1)
    axes.plot(angles, ratio, color="black", lw=1.6, label="$R^2=(h/c)^2$")
    for share, colour, dashes in SHARES:
        label = f"$r={share:.4g}$, $m_1/m_2={1 / share - 1:.4g}$"
        axes.axhline(share, color=colour, lw=1.2, ls=dashes, label=label)
        if share > CRITICAL_SHARE:
            axes.fill_between(angles, ratio, share, where=(ratio < share).tolist(), color="#f3c9a8", lw=0)
    axes.set(xlabel=ANGLE, ylabel="$R^2$ and $r$ (dimensionless)", xlim=(1, 5.6), ylim=(0.3, 1.6))
    axes.legend()
    return figure
