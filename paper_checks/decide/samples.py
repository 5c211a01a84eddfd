"""Random scenes as supporting evidence: they never settle a claim about all trajectories."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from paper_checks.evidence.evidence import Evidence, EvidenceKind


def scenes(seed: int, cases: int, periods: int = 40) -> Iterator[Scene]:
    """Yield random scenes with a1 = 0, over `periods` half periods of stick: parameters drawn by exponent, states within a
    few half widths of the sliding region, half of them on S."""
    source = random.Random(seed)
    for _ in range(cases):
        m1, m2, a2, b = (Fraction(source.randint(10, 99), 10 ** source.randint(0, 3)) for _ in range(4))
        pair = Pair(m1=m1, m2=m2, a2=a2, b=b)
        time = Fraction(str(float(pair.mass / pair.a2) ** 0.5))  # a rational near 1/Omega
        x1, *speeds = (Fraction(source.randint(-300, 300), 100) * pair.half_width for _ in range(3))
        v1, v2 = (one / time for one in speeds)
        start = State(x1=x1, v1=v1, v2=source.choice((v1, v2)))
        yield Scene(pair, start, until=periods * Fraction("3.15") * time)


def dichotomy_samples(seed: int, cases: int = 50) -> Evidence:
    """Return that random trajectories have merged, or are above E_cr with an excess that falls at every event."""
    trajectories = [solve(scene) for scene in scenes(seed, cases)]
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
    final = trajectory.reduced.final.w
    return falls and (final <= 0 if trajectory.status is Status.STUCK_FOR_EVER else final > 0)
