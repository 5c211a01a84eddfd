"""Which slips from a ray merge: by the angle of the slip, and by the energy of a pair."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sympy import lambdify

from paper_checks.claims.beyond.critical_ratio import critical_value
from paper_checks.decide.balls import precision
from paper_checks.drawing.style import panels
from theory.excursion import h
from theory.return_map import depth
from theory.symbols import theta

Curve = NDArray[np.float64]
with precision():
    CRITICAL_SHARE = float(critical_value())
    """r*, rounded to binary64."""
LARGEST_RATIO = 100
"""m2/m1 up to which the interval is shown; beyond, only its scale changes, with q."""


def slip(last: float) -> tuple[Curve, Curve, Curve]:
    """Return angles up to the last one, exit speeds h of slips from a ray, and R^2 = (h/c)^2, binary64."""
    angles = np.linspace(1e-2, last, 2000)
    speed = lambdify(theta, h())(angles)
    return angles, speed, (speed / lambdify(theta, depth())(angles)) ** 2


def merging_window() -> Figure:
    """Draw R^2 against the angle: a slip merges where the line r lies above it."""
    angles, _, ratio = slip(5.6)
    figure, axes = panels(5.6, 3.1)
    axes.plot(angles, ratio, color="black", lw=1.6, label="$R^2=(h/c)^2$")
    for share, colour, dashes in ((0.4, "#1b4f8f", "-"), (CRITICAL_SHARE, "black", "--"), (0.8, "#c8641e", "-.")):
        label = f"$r={share:.4g}$, $m_1/m_2={1 / share - 1:.4g}$"
        axes.axhline(share, color=colour, lw=1.2, ls=dashes, label=label)
        if share > CRITICAL_SHARE:
            axes.fill_between(angles, ratio, share, where=(ratio < share).tolist(), color="#f3c9a8", lw=0)
    axes.set(
        xlabel=r"slip angle $\theta$ (dimensionless)",
        ylabel="$R^2$ and $r$ (dimensionless)",
        xlim=(1, 5.6),
        ylim=(0.3, 1.6),
    )
    axes.legend()
    return figure


def merging_interval() -> Figure:
    """Draw the energies that merge at the first landing over the mass ratio: along their edge r = R^2 and w = q h^2."""
    _, speed, share = slip(6.2)
    drawn = share < 1 - 0.1 / LARGEST_RATIO
    share, excess = share[drawn], ((1 - share) * speed**2)[drawn]
    figure, axes = panels(6.4, 3.6)
    axes.fill(share / (1 - share), excess, color="#1b4f8f", alpha=0.35, lw=0)
    axes.plot(share / (1 - share), excess, color="#1b4f8f", label="$w_a$ and $w_b$")
    critical = CRITICAL_SHARE / (1 - CRITICAL_SHARE)
    axes.axvline(critical, color="black", lw=1.2, ls="--", label=f"$m_2/M=r^*={CRITICAL_SHARE:.4f}$")
    axes.set(xscale="log", yscale="log", xlim=(0.8, LARGEST_RATIO))
    axes.set(xlabel="$m_2/m_1$ (dimensionless)", ylabel="$E/E_{cr}-1$ on $S_0$ (dimensionless)")
    axes.legend()
    return figure
