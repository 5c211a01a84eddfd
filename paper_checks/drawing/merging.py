"""Which slips merge at their first landing, by the energy of a pair."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from sympy import lambdify

from paper_checks.claims.beyond.critical_ratio import critical_value
from paper_checks.decide.balls import precision
from paper_checks.drawing.style import panels
from theory.excursion import h
from theory.return_map import depth
from theory.symbols import theta

with precision():
    CRITICAL_SHARE = float(critical_value())
    """r*, rounded to binary64."""
LARGEST_RATIO = 100
"""m2/m1 up to which the interval is shown; beyond, only its scale changes, with q."""


def merging_interval() -> Figure:
    """Draw the energies that merge at the first landing over the mass ratio: along their edge r = R^2 and w = q h^2."""
    angles = np.linspace(1e-2, 6.2, 2000)  # of slips from a ray
    speed = lambdify(theta, h())(angles)
    share = (speed / lambdify(theta, depth())(angles)) ** 2
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
