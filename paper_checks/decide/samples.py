"""Random scenes as supporting evidence: they never settle a claim about all trajectories."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise

from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from paper_checks.evidence.evidence import Evidence, EvidenceKind


def random_pair(source: random.Random, damping: Fraction = Fraction(0)) -> Pair:
    """Return a pair whose parameters are drawn by exponent, 1e-2 to 1e2."""

    def magnitude() -> Fraction:
        return Fraction(source.randint(10, 99)) * Fraction(10) ** source.randint(-3, 0)

    return Pair(m1=magnitude(), m2=magnitude(), a1=damping, a2=magnitude(), b=magnitude())


def random_state(source: random.Random, pair: Pair) -> State:
    """Return a state within a few half widths of the sliding region, half of the states on S."""
    width = pair.half_width
    # a rational near L Omega: the unit of velocity
    speed = width * Fraction(str(float(pair.a2 / pair.mass) ** 0.5))
    positions, velocities = [
        [Fraction(source.randint(-300, 300), 100) * unit for _ in range(2)] for unit in (width, speed)
    ]
    v2 = velocities[0] if source.random() < 0.5 else velocities[1]
    return State(x1=positions[0], v1=velocities[0], x2=positions[1], v2=v2)


def solved_samples(seed: int, cases: int, periods: int = 40) -> list[Trajectory]:
    """Return float64 trajectories of seeded random scenes with a1 = 0, over `periods` half periods of stick."""
    source, trajectories = random.Random(seed), []
    for _ in range(cases):
        pair = random_pair(source)
        until = Fraction(str(periods * 3.15 * float(pair.mass / pair.a2) ** 0.5))
        trajectories.append(solve(Scene(pair, random_state(source, pair), until=until)))
    return trajectories


def dichotomy_samples(seed: int, cases: int = 100) -> Evidence:
    """Return that random trajectories have merged, or are above E_cr with an excess that falls at every event."""
    trajectories = solved_samples(seed, cases)
    merged = sum(one.status is Status.STUCK_FOR_EVER for one in trajectories)
    right = sum(_merged_or_creeping(one) for one in trajectories)
    return Evidence(
        EvidenceKind.PROPERTY,
        "numerics, float64",
        "every random trajectory has merged with $E\\leqslant E_{cr}$, or stays above $E_{cr}$ with an energy that falls at every slip",
        right == cases,
        cases,
        f"{merged} merged, {right - merged} above, {cases - right} neither",
    )


def _merged_or_creeping(trajectory: Trajectory) -> bool:
    excesses = [event.reduced.w for event in trajectory.events if event.kind is EventKind.ENTRY]
    falls = all(later < earlier for earlier, later in pairwise(excesses))
    final = trajectory.final.w
    return falls and (final <= 0 if trajectory.status is Status.STUCK_FOR_EVER else final > 0)
