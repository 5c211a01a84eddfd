"""The pictures of which motions merge: the interval of energies, the bands of speeds, the share of an energy sphere."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cache
from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure

from paper_checks.claims.merging_share import MERGES, SPEEDS, by_quadrature, decided, start
from paper_checks.drawing.excursions import CRITICAL_SHARE, slip
from paper_checks.drawing.style import panels

LARGEST_RATIO = 100
"""m2/m1 up to which the interval is shown; beyond, only its scale changes, with q."""
SHARES = ((Fraction(3, 5), "#1b4f8f"), (Fraction(7, 10), "#2e8b3d"), (Fraction(4, 5), "#c8641e"))


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


def merging_bands() -> Figure:
    """Draw for three mass shares which speeds on S0 merge, solved in float64."""
    figure, axes = panels(7.2, 2.3)
    speeds = np.array([float(one) for one in SPEEDS])
    half = (speeds[1] - speeds[0]) / 2
    for height, (share, colour) in enumerate(SHARES):
        axes.broken_barh(
            [
                (a - half, b - a + 2 * half)
                for a, b in ((speeds[first], speeds[last - 1]) for first, last in _runs(_merged(share)))
            ],
            (height - 0.3, 0.6),
            color=colour,
        )
    axes.set(xlabel="speed at $x_1=0$ on $S_0$, in $L\\Omega$ (dimensionless)", ylim=(-0.6, 2.6), xlim=(1, speeds[-1]))
    axes.set_yticks(range(3), [f"$r={float(share):g}$" for share, _ in SHARES])
    return figure


@cache
def _merged(share: Fraction) -> tuple[bool, ...]:
    """Return for each of SPEEDS whether the pair merges, solved in float64."""
    scenes = [start(share, speed) for speed in SPEEDS]
    return tuple(decided(one.pair, one.initial) == MERGES for one in scenes)


@cache
def _shares(share: float, energies: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(by_quadrature(share, energy) for energy in energies)


def _runs(chosen: Iterable[object]) -> list[tuple[int, int]]:
    """Return start and end (the first place after it) of each run of chosen places."""
    edges = [n for n, (before, here) in enumerate(pairwise([False, *map(bool, chosen), False])) if before is not here]
    return list(zip(edges[::2], edges[1::2], strict=True))


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
