"""Bit-for-bit equalities of float64 runs: repeated, under sign flip, under units scaled by powers of two.

Changing the sign of every position and velocity changes the sign of everything and nothing else. With lengths times
2^k, masses times 2^j and times times 2^i the exact parameters scale by powers of two and the reduced motion is the
same. Binary64 rounds both alike, so not one bit may differ; only the sign of a zero is not looked at.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random
from typing import NamedTuple

from numerics.audit.draws import KINDS
from numerics.audit.table import Progress, Row, counted
from numerics.errors import NumericsError
from numerics.motion.records import ReducedState
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory

_MAX_EVENTS = 40
_MAX_POWER = 60
_KEPT = 5

Solver = Callable[[Scene], Trajectory]


class Units(NamedTuple):
    """New units: lengths times 2^length, masses times 2^mass, times times 2^time; `side` = -1 flips every sign."""

    length: int = 0
    mass: int = 0
    time: int = 0
    side: int = 1


def audit_symmetries(seed: int, cases: int, progress: Progress, solver: Solver | None = None) -> Iterator[Row]:
    """Yield a row for each symmetry, `cases` scenes each."""
    power = lambda random: random.randint(-_MAX_POWER, _MAX_POWER)  # noqa: E731
    symmetries: dict[str, Callable[[Random], Units]] = {
        "the same run again": lambda _: Units(),
        "sign flip": lambda _: Units(side=-1),
        "lengths times 2^k": lambda random: Units(length=power(random)),
        "masses times 2^k": lambda random: Units(mass=power(random)),
        "times times 2^k": lambda random: Units(time=power(random)),
        "all three and the sign": lambda random: Units(power(random), power(random), power(random), -1),
    }
    for name, draw in symmetries.items():
        tried = counted(cases, f"bit for bit: {name}, scene", progress)
        yield _symmetry(name, draw, Random(f"{seed} {name}"), tried, solver or _solve)


def _symmetry(name: str, draw: Callable[[Random], Units], random: Random, cases: Iterator[int], solver: Solver) -> Row:
    tried, numbers, refused, differing = 0, 0, 0, []
    kinds = tuple(KINDS.values())
    for case in cases:
        tried = case + 1
        scene, units = kinds[case % len(kinds)](random), draw(random)
        here, there = _figures(scene, Units(), solver), _figures(rescaled(scene, units), units, solver)
        if len(here) == len(there) and all(_equal(one, two) for one, two in zip(here, there, strict=True)):
            numbers, refused = numbers + len(here), refused + (len(here) == 1)
        else:
            differing.append(f"{units}: {scene}")
    measured = {"figures equal": numbers, "scenes differing": len(differing), "scenes refused alike": refused}
    passed = numbers > refused and not differing
    return Row("bit for bit", name, tried, measured, "scenes differing = 0", passed, [{"differing": differing[:_KEPT]}])


def rescaled(scene: Scene, units: Units) -> Scene:
    """Return the same scene in other units, exact."""
    length, mass, time = (Fraction(2) ** power for power in units[:3])
    pair, at, side = scene.pair, scene.initial, units.side
    force = mass * length / time**2
    return Scene(
        Pair(pair.m1 * mass, pair.m2 * mass, pair.a2 * mass / time**2, pair.b * force, pair.a1 * mass / time),
        State(side * at.x1 * length, side * at.v1 * length / time, side * at.x2 * length, side * at.v2 * length / time),
        scene.until * time,
        scene.law,
    )


class _Scaled(NamedTuple):
    """A float and the power of two that takes it back to the first units."""

    value: float
    power: int


def _figures(scene: Scene, units: Units, solver: Solver) -> list[object]:
    """Return everything that a float64 run states, with the way back to the first units; or its refusal's type."""
    try:
        trajectory = solver(scene)
        final, ledger = trajectory.final, trajectory.ledger
    except NumericsError as error:
        return [type(error).__name__]
    length, mass, time, side = units
    found: list[object] = [trajectory.status]
    for event in trajectory.events:
        found += [event.kind, side * event.before.sign, side * event.after.sign, _Scaled(event.t, -time)]
        powers = (-length, time - length, -length, time - length)
        found += [_Scaled(side * value, power) for value, power in zip(event.y, powers, strict=True)]
        found += _reduced(event.reduced, side)
    energy = -(mass + 2 * length - 2 * time)
    books = (ledger.initial, ledger.final, ledger.friction, ledger.viscous)
    return [*found, *_reduced(final, side), *(_Scaled(one, energy) for one in books)]


def _reduced(state: ReducedState, side: int) -> list[object]:
    return [*(_Scaled(side * value, 0) for value in state[:4]), _Scaled(state.w, 0)]


def _equal(one: object, two: object) -> bool:
    """Return whether two figures are equal to the last bit; one that left the normal range in its units is left out."""
    if not isinstance(one, _Scaled) or not isinstance(two, _Scaled):
        return one == two
    if one.power != two.power and min(abs(one.value), abs(two.value)) < sys.float_info.min:
        return max(abs(_exact(one)), abs(_exact(two))) <= Fraction(2) ** (abs(two.power) - 1021)
    return _exact(one) == _exact(two)


def _exact(figure: _Scaled) -> Fraction:
    return Fraction(figure.value) * Fraction(2) ** figure.power


def _solve(scene: Scene) -> Trajectory:
    return solve(scene, max_events=_MAX_EVENTS)
