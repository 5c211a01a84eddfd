"""Steps about the energies on S0 that ever merge: more bands than one, each shown by balls (a1 = 0)."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import groupby

from flint import arb

from numerics.linear.modes import EventKind
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.status import Status
from numerics.trajectory.trajectory import Trajectory
from paper_checks.engines.balls import point, precision
from paper_checks.evidence.evidence import Evidence, EvidenceKind

MERGES, CREEPS = "merges", "creeps"
SPEEDS = tuple(Fraction(n, 20) for n in range(21, 421))
"""Speeds on S0 at x1 = 0, in units of L Omega, that are looked through: w = V^2 - 1."""
UNTIL = 150
STAGES = (35, 200)
"""Horizons of the runs that decide in float64: the second one where the first leaves it open."""


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


def decided(pair: Pair, at: State) -> str:
    """Return in float64 what becomes of a pair with L = Omega = M = 1: it merges, or creeps; "" if that stays open.

    A run is made longer only until that is known: on a ray with 0 < w <= q (pi/2 - 1)^2 it never merges.
    """
    level = float(pair.m1) * 0.3258
    for until in STAGES:
        run = solve(Scene(pair, at, until))
        if run.status is Status.STUCK_FOR_EVER:
            return MERGES
        if any(one.kind is EventKind.EXIT and 0 < one.reduced.w < level for one in run.events):
            return CREEPS
    return ""


def looked_through(share: Fraction) -> list[tuple[str, Fraction]]:
    """Return the middle of each run of speeds with one outcome in float64, in order: where to look in balls."""
    scenes = [start(share, speed) for speed in SPEEDS]
    found = [(decided(one.pair, one.initial), speed) for one, speed in zip(scenes, SPEEDS, strict=True)]
    runs = [(name, [speed for _, speed in members]) for name, members in groupby(found, key=lambda one: one[0])]
    return [(name, speeds[len(speeds) // 2]) for name, speeds in runs if name]


@cache
def bands(share: Fraction) -> tuple[int, Evidence]:
    """Return how many bands are proved, and the evidence: speeds that merge, in turn with speeds that never do."""
    shown: list[tuple[str, Fraction]] = []
    for name, speed in looked_through(share):
        proved = outcome(share, solve(start(share, speed), digits=15, arithmetic="ball"))
        if proved == name and (not shown or shown[-1][0] != name):
            shown.append((name, speed))
    number = sum(name == MERGES for name, _ in shown)
    text = ", ".join(f"{'merges' if name == MERGES else 'never'} at w = {speed**2 - 1}" for name, speed in shown)
    evidence = Evidence(
        EvidenceKind.ENCLOSURE,
        "numerics, balls",
        f"for $r={share}$ from $x_1=0$ on $S_0$: {number} energies that merge, with one that never does between any two",
        number > 1,
        len(shown),
        text,
    )
    return number, evidence
