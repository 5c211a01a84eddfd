"""The bands of energies that ever merge, and how much of an energy sphere does."""

import math
import random

import numpy as np

from numerics.solver.solve import solve
from numerics.trajectory.status import Status
from paper_checks.claims.letters import R
from paper_checks.claims.words import *
from theory.merging_share import density, dissipation, divergence, flux, large_energy_limit, level, relative, sphere
from theory.symbols import r as share_of_q

MERGES, CREEPS = "merges", "creeps"
WITNESSES = {
    Fraction(
        3, 5
    ): "1.25 2.05 3.05 4.15 5.25 6.35 7.55 8.65 9.85 10.95 12.15 13.25 14.45 15.55 16.75 17.85 19.05 20.15 20.95",
    Fraction(
        7, 10
    ): "1.15 2.15 3.25 4.45 5.55 6.75 7.95 9.05 10.25 11.45 12.65 13.85 15.05 16.15 17.35 18.55 19.75 20.45",
    Fraction(
        4, 5
    ): "1.05 2.15 3.25 4.35 5.45 6.55 7.65 8.75 9.85 11.05 12.15 13.25 14.35 15.45 16.55 17.75 18.85 19.95",
}
"""By the share m2/M: speeds on S0 at x1 = 0, in units of L Omega (w = V^2 - 1), that never merge and that do in turn."""


UNTIL = 150
STAGES = (25, 50, 200)
"""Horizons of the runs that decide in float64: a later one where those before leave it open."""


def start(share: Fraction, speed: Fraction) -> Scene:
    """Return the scene that starts on S0 at x1 = 0 with V = speed: L = Omega = M = 1."""
    return Scene(Pair(m1=1 - share, m2=share, a2=1, b=share), State(v1=speed, v2=speed), until=UNTIL)


def outcome(share: Fraction, trajectory: Trajectory) -> str | None:
    """Return whether a trajectory merges, or is proved to creep: on a ray with 0 < w <= q (pi/2 - 1)^2; None if neither."""
    if trajectory.status is Status.STUCK_FOR_EVER:
        return MERGES
    with precision(20):
        level = point(1 - share) * (arb.pi() / 2 - 1) ** 2
        exits = [event.reduced.w for event in trajectory.events if event.kind is EventKind.EXIT]
        return CREEPS if any(w > 0 and w < level for w in exits) else None


def decided(pair: Pair, at: State) -> bool:
    """Return in float64 whether a pair with L = Omega = M = 1 merges, up to the last of `STAGES`.

    A run is made longer only until it is known: on a ray with 0 < w <= q (pi/2 - 1)^2 it never merges.
    """
    level = float(pair.m1) * 0.3258
    for until in STAGES:
        run = solve(Scene(pair, at, until))
        if run.status is Status.STUCK_FOR_EVER:
            return True
        if any(one.kind is EventKind.EXIT and 0 < one.reduced.w < level for one in run.events):
            break
    return False


@cache
def bands(share: Fraction) -> tuple[int, Evidence]:
    """Return how many bands are proved, and the evidence: speeds that merge, in turn with speeds that never do."""
    shown: list[tuple[str, Fraction]] = []
    for speed in map(Fraction, WITNESSES[share].split()):
        name = outcome(share, solve(start(share, speed), digits=15, arithmetic="ball"))
        if name and (not shown or shown[-1][0] != name):
            shown.append((name, speed))
    number = sum(name == MERGES for name, _ in shown)
    text = ", ".join(f"{'merges' if name == MERGES else 'never'} at w = {speed**2 - 1}" for name, speed in shown)
    evidence = enclosed(
        f"for $r={share}$ from $x_1=0$ on $S_0$: {number} energies that merge, with one that never does between any two",
        number > 1,
        text,
        len(shown),
        engine="numerics, balls",
    )
    return number, evidence


@cache
def exact_share() -> Evidence:
    """The share as an integral over the disc of contacts at or below E_cr."""
    return argument(
        r"""
        Every state off $S$ comes to a first contact. For $r\leqslant r^*$ it merges exactly if $X^2+V^2\leqslant 1$
        there: later slips stay above $E_{cr}$, for $r=r^*$ as the limit of smaller $r$ not below it, and at it on a
        null set only. Backwards in time from such a contact the slip never meets $S$ again, as no slip from $S$ leads
        there; so its energy grows without bound and passes $E$ once. The flow of slip preserves volume, so the states
        that it comes from have the measure of the flux through $S$ over the rate at which $E$ is passed; both
        half-spaces are mirror images.
        """,
        *map(kernel.step, ("contact", "sticks-iff", "no-low-level", "heavy-never-merges")),
        identity(
            r"""
            the flow of slip preserves volume (its divergence is 0), the flux through $S$ is $(1-X)/q$, $E/E_{cr}$ falls at the
            rate $2r\,|V_1-V_2|$, and the sphere has the measure $2\pi\sqrt{E/(qr)}$ (units of $E_{cr}$)
            """,
            [divergence(), flux(), dissipation(), sphere()],
            [0, (1 - X) / q, 2 * r * relative, 2 * pi * sqrt(level) / sqrt(q) / sqrt(r)],
        ),
        cites=("Liouville's theorem",),
    )


@cache
def just_above() -> Evidence:
    """Nearly all states just above E_cr merge, whatever the masses are."""
    return argument(
        r"""
        While $E\leqslant 2E_{cr}$ the rate of $V_1-V_2$ is bounded, by $K$. A state with $|V_1-V_2|\geqslant\eta$ has
        half of that at least for the time $\eta/(2K)$, in which $E/E_{cr}$ falls by $r\,\eta^2/(2K)$ at least: from
        below $1+r\,\eta^2/(2K)$ to below $1$, and the pair merges. The states with $|V_1-V_2|<\eta$ are a share that
        tends to $0$ with $\eta$, uniformly up to $2E_{cr}$.
        """,
        kernel.step("contact"),
        kernel.step("sticks-iff"),
        identity("$E/E_{cr}$ falls at the rate $2r\\,|V_1-V_2|$", dissipation(), 2 * r * relative),
    )


@cache
def limit() -> Evidence:
    """The share at large energies."""
    return argument(
        "Where the slip has the energy $E$, $X$ and $V_1$ are bounded, so $r\\,|V_1-V_2|^2/E\\to 1$ as $E\\to\\infty$, uniformly on the disc.",
        exact_share,
    )


def by_quadrature(share: float, energy: float, steps: int = 80) -> float:
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
        scale = math.sqrt(float(energy) / math.hypot(*point) ** 2)
        weights = 1, float(pair.m1), float(pair.m2)
        x, first, second = (Fraction(scale * one / weight**0.5) for one, weight in zip(point, weights, strict=True))
        merged += decided(pair, State(x1=x, v1=first, v2=second))
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


def _bands(share: Fraction) -> Formula:
    """Return how many bands there are at least for a share; decided by the energies that balls prove to merge, and not."""

    def decide(formula: Formula) -> Evidence:

        number, found = bands(share)
        proved = formula.relation == ">=" and bool(formula.right <= number)
        return replace(found, statement=f"${formula.latex}$ for $r={share}$", passed=proved or None)

    return Formula("n", ">=", 9, decide)


@theorem(
    "merging-bands",
    clause(
        "bands",
        r"""
        The energies on $S_0$ above $E_{cr}$ that ever merge, at the first re-entry or later, form more than one band:
        for $r=m_2/M$ equal to $\tfrac{3}{5}$ there are «first», for $\tfrac{7}{10}$ «second», for $\tfrac{4}{5}$
        «third».
        """,
        first=_bands(Fraction(3, 5)),
        second=_bands(Fraction(7, 10)),
        third=_bands(Fraction(4, 5)),
    ),
    open=(
        r"That there are infinitely many bands for every $r>r^*$, equally spaced in $\sqrt w$ in the limit, is observed numerically and not proved.",
    ),
)
def merging_bands() -> Case:
    """Energies that merge, in turn with energies that never do."""
    return because(
        """
        For three mass ratios the energies on $S_0$ that ever merge form many bands: between two that merge lies one
        that never does. Each trajectory is solved in ball arithmetic until it sticks permanently, or leaves $S_0$ by a
        ray so little above $E_{cr}$ that it never merges.
        """,
        carried("bands", kernel.step("merging-energies"), *(bands(share)[1] for share in WITNESSES)),
        reading(
            "bands of energies that ever merge",
            r"the largest intervals of $E>E_{cr}$ such that solutions of that energy on $S_0$ have $v_1=v_2$ at all times from some time on",
        ),
    )


@theorem(
    "merging-share",
    clause(
        "share",
        r"""
        Let $r\leqslant r^*$ and $e=E/E_{cr}>1$. The share (Liouville measure) of the states of energy $E$ that merge
        is the integral over $X^2+V^2\leqslant 1$ of «density», where $g=|V_1-V_2|$ at the energy $E$ of the slip that
        ends at $(X,V)$ on $S$.
        """,
        density=equal(
            "f",
            (1 - X) / relative / (2 * pi * sqrt(q) * sqrt(R) * sqrt(level)),
            density,
            lambda: {R: share_of_q},
        ),
    ),
    clause(
        "near",
        r"As $E$ falls to $E_{cr}$ the share of those that merge tends to $1$, for every $r$.",
    ),
    clause(
        "limit",
        r"As $E$ grows, «limit», for $r\leqslant r^*$.",
        limit=tends(r"e\,\int f", 1 / (2 * sqrt(q)), large_energy_limit),
    ),
)
def merging_share(seed: int) -> Case:
    """The share of the energy sphere, as an integral; random states beside it."""
    return because(
        """
        Merging in finite time is the common case just above $E_{cr}$ in the whole state space, though it never happens
        from $S_0$ there: up to $r^*$ the share of the states that merge is an integral over the disc of captive
        contacts, and falls like $1/E$.
        """,
        carried("share", exact_share),
        carried("near", just_above),
        carried("limit", limit),
        random_states(Fraction(3, 10), Fraction(4), 250, seed),
        random_states(Fraction(1, 2), Fraction(3, 2), 250, seed),
    )
