"""Steps about how much of an energy sphere merges for r <= r*: the exact share, its limit, and random states (a1 = 0)."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from functools import cache

import numpy as np
import sympy as sp

from numerics.scene import Pair, State
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, EvidenceKind, argument
from paper_checks.steps.capture import stays_below_critical
from paper_checks.steps.merging_bands import MERGES, decided
from paper_checks.steps.merging_no_slip import no_slip_merges
from paper_checks.steps.turned_back import contact_again
from theory.merging_share import density, dissipation, divergence, flux, large_energy_limit, level, relative, sphere
from theory.symbols import X, q, r


@cache
def exact_share() -> Evidence:
    """The share as an integral over the disc of contacts at or below E_cr."""
    return argument(
        "Every state off $S$ comes to a first contact. For $r\\leqslant r^*$ it merges exactly if $X^2+V^2\\leqslant 1$ there: later slips "
        "stay above $E_{cr}$. Going back from such a contact the slip never meets $S$ again, as no slip from $S$ leads there; so its "
        "energy grows without bound and passes $E$ once. The slip's flow keeps volume, so the states that it comes from have the "
        "measure of the flux through $S$ over the rate at which $E$ is passed; both half-spaces are mirror images.",
        contact_again(),
        stays_below_critical(),
        no_slip_merges(),
        identity("the slip's flow keeps volume: its divergence is 0", divergence()),
        identity("the flux through $S$ is $(1-X)/q$", flux(), (1 - X) / q),
        identity("$E/E_{cr}$ falls at the rate $2r\\,|V_1-V_2|$", dissipation(), 2 * r * relative),
        identity(
            "the sphere has the measure $2\\pi\\sqrt{E/(qr)}$ (units of $E_{cr}$)",
            sphere(),
            2 * sp.pi * sp.sqrt(level) / sp.sqrt(q) / sp.sqrt(r),
        ),
        identity(
            "together: the density on the disc",
            density(),
            (1 - X) / relative / (2 * sp.pi * sp.sqrt(q) * sp.sqrt(r) * sp.sqrt(level)),
        ),
        cites=("Liouville's theorem",),
    )


@cache
def limit() -> Evidence:
    """The share at large energies."""
    return argument(
        "Where the slip has the energy $E$, $X$ and $V_1$ are bounded, so $r\\,|V_1-V_2|^2/E\\to 1$ as $E\\to\\infty$, evenly on the disc.",
        exact_share(),
        identity("$E$ times the share tends to $\\frac{1}{2\\sqrt q}$", large_energy_limit(), 1 / (2 * sp.sqrt(q))),
    )


def by_quadrature(share: float, energy: float, steps: int = 200) -> float:
    """Return the share that merges by the integral; approximate, midpoints in polar coordinates."""
    mass = 1 - share
    rho, phi = np.meshgrid((np.arange(steps) + 0.5) / steps, (np.arange(steps) + 0.5) * 2 * math.pi / steps)
    x, v = rho * np.cos(phi), rho * np.sin(phi)

    def state(angle: np.ndarray) -> tuple[np.ndarray, ...]:
        place = share + (x - share) * np.cos(angle) - math.sqrt(mass) * v * np.sin(angle)
        first = v * np.cos(angle) + (x - share) / math.sqrt(mass) * np.sin(angle)
        return place, first, v + math.sqrt(mass) * angle

    low, high = np.zeros_like(x), np.full_like(x, 4 * math.sqrt(energy / share / mass) + 4 / math.sqrt(mass))
    for _ in range(60):
        middle = (low + high) / 2
        place, first, second = state(middle)
        beyond = place**2 + mass * first**2 + share * second**2 > energy
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    _, first, second = state(low)
    over = (1 - x) / np.abs(first - second) * rho
    return float(over.sum() * (1 / steps) * (2 * math.pi / steps) / (2 * math.pi * math.sqrt(mass * share * energy)))


def random_states(share: Fraction, energy: Fraction, cases: int, seed: int) -> Evidence:
    """Compare the share of random states on the sphere that merge with the integral, to four standard deviations."""
    source, merged = random.Random(seed), 0
    pair = Pair(m1=1 - share, m2=share, a2=1, b=share)
    for _ in range(cases):
        point = [source.gauss(0, 1) for _ in range(3)]
        scale = math.sqrt(float(energy) / sum(one**2 for one in point))
        x, first, second = (
            scale * one / root
            for one, root in zip(point, (1, float(pair.m1) ** 0.5, float(pair.m2) ** 0.5), strict=True)
        )
        start = State(x1=Fraction(x), v1=Fraction(first), v2=Fraction(second))
        merged += decided(pair, start) == MERGES
    expected = by_quadrature(float(share), float(energy))
    deviation = math.sqrt(expected * (1 - expected) / cases)
    return Evidence(
        EvidenceKind.SIMULATION,
        "numerics, float64",
        f"of random states with $E={energy}\\,E_{{cr}}$, $r={share}$ the share of the integral merges, to four standard deviations",
        abs(merged / cases - expected) < 4 * deviation,
        cases,
        f"{merged / cases:.4f} of the states, {expected:.4f} by the integral",
    )
