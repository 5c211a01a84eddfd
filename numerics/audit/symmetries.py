"""Float64 runs repeated, mirrored, and in other units.

The same run again and the mirror image agree bit for bit. With lengths, masses and times each scaled by a power of two
the exact parameters scale too: everything agrees within its bounds, and how many runs agree bit for bit is counted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random
from typing import NamedTuple

from numerics.audit.draws import KINDS
from numerics.audit.solves import SOLVERS, Solver, bounds, numbers, sequence
from numerics.audit.table import Progress, Row, counted
from numerics.errors import NumericsError
from numerics.scene import Force, Friction, Pair, Piece, Scene, Sine, State

_KEPT = 5


class Units(NamedTuple):
    """New units: lengths, masses and times are multiplied; `side` = -1 flips every sign."""

    length: Fraction = Fraction(1)
    mass: Fraction = Fraction(1)
    time: Fraction = Fraction(1)
    side: int = 1


def _scaled(random: Random) -> Units:
    length, mass, time = (Fraction(2) ** random.randint(-40, 40) for _ in range(3))
    return Units(length, mass, time, random.choice((-1, 1)))


SYMMETRIES: dict[str, Callable[[Random], Units]] = {
    "the same run again": lambda _: Units(),
    "mirror image": lambda _: Units(side=-1),
    "units times 2^k": _scaled,
}


def audit_symmetries(seed: int, cases: int, progress: Progress, solver: Solver = SOLVERS["float64"]) -> Iterator[Row]:
    """Yield a row for each symmetry, `cases` scenes each."""
    kinds = tuple(KINDS.values())
    for name, draw in SYMMETRIES.items():
        random, exactly, tried, differing = Random(f"{seed} {name}"), 0, 0, []
        for case in counted(cases, f"symmetries: {name}, scene", progress):
            scene, units = kinds[case % len(kinds)](random), draw(random)
            one, two = _figures(scene, Units(), solver), _figures(rescaled(scene, units), units, solver)
            if one is None or two is None:
                continue
            same, near = _agree(one, two)
            tried, exactly = tried + 1, exactly + same
            if not (near if draw is _scaled else same):
                differing.append(f"{units}: {scene}")
        measured = {"differing": len(differing), "equal bit for bit": exactly, "refused or open": cases - tried}
        passed, required = tried > 0 and not differing, "differing = 0"
        yield Row("symmetries", name, tried, measured, required, passed, [{"differing": differing[:_KEPT]}])


def rescaled(scene: Scene, units: Units) -> Scene:
    """Return the same scene in other units, exact."""
    pair, at, (length, mass, time, side) = scene.pair, scene.initial, units
    speed, force = side * length / time, mass * length / time**2
    pieces = []
    for one in scene.force.pieces:
        powers = [side * c * force / time**k for k, c in enumerate(one.polynomial)]
        waves = [Sine(side * wave.amplitude * force, wave.omega / time, wave.phase) for wave in one.sines]
        pieces.append(Piece(one.start * time, powers, waves))
    return Scene(
        Pair(pair.m1 * mass, pair.m2 * mass, pair.a2 * mass / time**2, pair.b * force, pair.a1 * mass / time),
        State(side * at.x1 * length, at.v1 * speed, side * at.x2 * length, at.v2 * speed),
        scene.until * time,
        scene.law,
        Force(pieces),
        Friction([(start * time, b * force) for start, b in scene.friction.pieces]),
    )


Figures = tuple[list[int], list[tuple[Fraction, Fraction]]]
"""The modes, and every number with its bound, in the first units."""


def _figures(scene: Scene, units: Units, solver: Solver) -> Figures | None:
    """Return what a run states; None where it is refused, or leaves its sequence or a number without a bound."""
    try:
        found = solver(scene)
    except NumericsError:
        return None
    if found.accuracy is None or not found.accuracy.bounded:
        return None
    length, mass, time, side = units
    state = [side * length, side * length / time] * 2
    factors = [time, *state] * len(found.events) + [*state, mass * length**2 / time**2, Fraction(1)]
    both = zip(numbers(found), bounds(found), factors, strict=True)
    rows = [(Fraction(value) / factor, Fraction(bound) / abs(factor)) for value, bound, factor in both]
    return [side * one for one in sequence(found)], rows


def _agree(one: Figures, two: Figures) -> tuple[bool, bool]:
    """Return whether two runs are equal to the last bit, and whether they are within their bounds."""
    if one[0] != two[0]:
        return False, False
    rows = list(zip(one[1], two[1], strict=True))
    return all(x == y for (x, _), (y, _) in rows), all(abs(x - y) <= a + b for (x, a), (y, b) in rows)
