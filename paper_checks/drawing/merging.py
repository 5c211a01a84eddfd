"""The pictures of which motions merge: the interval of energies, the share of an energy sphere."""

from __future__ import annotations

from functools import cache

import numpy as np
from matplotlib.figure import Figure

from paper_checks.claims.beyond.merging_share import by_quadrature
from paper_checks.drawing.excursions import CRITICAL_SHARE, slip
from paper_checks.drawing.style import panels

LARGEST_RATIO = 100
"""m2/m1 up to which the interval is shown; beyond, only its scale changes, with q."""


def merging_interval() -> Figure:
    """Draw the energies that merge at the first landing over the mass ratio: along their edge r = R^2 and w = q h^2."""
    _, speed, deep = slip(last=6.2)
    share = (speed / deep) ** 2
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


@cache
def _shares(share: float, energies: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(by_quadrature(share, energy) for energy in energies)


def merging_share() -> Figure:
    """Draw the share of all states of an energy that merge, by the integral, for three mass shares up to r*."""
    energies = np.geomspace(1.01, 100, 25)
    figure, axes = panels(5.4, 3.0)
    for share, colour, marker in (
        (0.2, "#1b4f8f", "o"),
        (0.4, "#2e8b3d", "s"),
        (CRITICAL_SHARE, "#c8641e", "D"),
    ):
        values = _shares(share, tuple(energies))
        axes.loglog(energies, values, color=colour, marker=marker, ms=3.5, lw=1, label=f"$r={share:.4g}$")
        axes.loglog(energies, 1 / (2 * np.sqrt(1 - share) * energies), color=colour, lw=0.8, ls=":")
    axes.set(xlabel="$E/E_{cr}$ (dimensionless)", ylabel="share that merges (dimensionless)", ylim=(2e-3, 1.3))
    axes.legend(title="dotted: limit for large $E$")
    return figure
