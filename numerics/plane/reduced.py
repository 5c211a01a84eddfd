"""A scene on a surface without the directions in which nothing ever moves: motions are unique, so they stay away.

An axis that nothing drives stays at rest. A motion along one line stays on it where M1, M2, A1, A2, B^2 take its
direction d to multiples of one vector n, and u is one: then q = c d, f = F n, and c is the pair of the paper.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from numerics.scene.plane import Matrix, PlaneScene, Vector


class Acting(NamedTuple):
    """What acts from `start` (s) on, time counted from there: u by axes and the squares of b; exact."""

    start: Fraction
    end: Fraction
    polynomial: tuple[Vector, ...]
    """The coefficients of 1, t, t^2, ..., (n,) each."""
    sines: tuple[tuple[Fraction, Fraction, Vector], ...]
    """omega, phase, amplitudes (n,)."""
    b_squared: Vector


class Reduced(NamedTuple):
    """The data on the axes that move; `place` takes q and v, `force` forces, back to the axes of the scene."""

    m1: Vector
    m2: Vector
    a1: Matrix
    a2: Matrix
    start: tuple[Vector, Vector, Vector]
    """q1, v1, v2 at t = 0."""
    pieces: tuple[Acting, ...]
    place: Matrix
    force: Matrix


def reduced(scene: PlaneScene) -> Reduced:
    """Return the data on the axes, or on the one line, on which a scene moves."""
    pair, n = scene.pair, scene.pair.axes
    pieces = _pieces(scene)
    start = scene.x1, scene.v1, scene.v2
    pushes = [one for p in pieces for one in (*p.polynomial, *(amplitudes for _, _, amplitudes in p.sines))]
    moving = {i for i in range(n) if any(one[i] for one in (*start, *pushes))} or {0}
    for _ in range(n):
        moving |= {i for i in range(n) for j in moving if pair.a1[i][j] or pair.a2[i][j]}
    kept = sorted(moving)
    unit = tuple(tuple(Fraction(i == j) for j in kept) for i in range(n))

    def only(one: Vector) -> Vector:
        return tuple(one[i] for i in kept)

    found = Reduced(
        only(pair.m1),
        only(pair.m2),
        tuple(only(pair.a1[i]) for i in kept),
        tuple(only(pair.a2[i]) for i in kept),
        (only(scene.x1), only(scene.v1), only(scene.v2)),
        tuple(
            p._replace(
                polynomial=tuple(map(only, p.polynomial)),
                sines=tuple((w, at, only(a)) for w, at, a in p.sines),
                b_squared=only(p.b_squared),
            )
            for p in pieces
        ),
        unit,
        unit,
    )
    return found if scene.pair.shape == "box" else _on_a_line(found) or found


def _pieces(scene: PlaneScene) -> tuple[Acting, ...]:
    """Return what acts, begun anew wherever u or b changes."""
    starts = {Fraction(0), *(s for one in scene.force for s in one.starts), *(s for s, _ in scene.friction)}
    order = [*sorted(one for one in starts if one < scene.until), scene.until]
    found = []
    for start, end in pairwise(order):
        acting = [one.piece_at(start).moved(start) for one in scene.force]
        degree = max(len(one.polynomial) for one in acting)
        polynomial = tuple(
            tuple(one.polynomial[k] if k < len(one.polynomial) else Fraction(0) for one in acting)
            for k in range(degree)
        )
        sines: dict[tuple[Fraction, Fraction], list[Fraction]] = {}
        for i, one in enumerate(acting):
            for sine in one.sines:
                key = sine.omega, sine.phase + sine.omega * start
                sines.setdefault(key, [Fraction(0)] * len(acting))[i] += sine.amplitude
        b = [scene.pair.b, *(b for at, b in scene.friction if at <= start)][-1]
        several = tuple((*key, tuple(amplitudes)) for key, amplitudes in sines.items())
        found.append(Acting(start, end, polynomial, several, tuple(one * one for one in b)))
    return tuple(found)


def _on_a_line(given: Reduced) -> Reduced | None:
    """Return the data along the line on which a motion stays, None if there is none."""
    n = len(given.m1)
    d = next((one for one in (*given.start, *_pushes(given)) if any(one)), None)
    if n == 1 or d is None:
        return None
    if not any(any(one) for one in given.start):  # d is a force: the direction is that of M1^-1 u
        d = tuple(x / m for x, m in zip(d, given.m1, strict=True))
    normal = tuple(m * x for m, x in zip(given.m1, d, strict=True))
    along = [_ratio(one, d) for one in given.start]
    images = [
        _ratio([m * x for m, x in zip(given.m2, d, strict=True)], normal),
        *(_ratio([row[0] for row in column(m, d)], normal) for m in (given.a1, given.a2)),
    ]
    pieces = []
    for p in given.pieces:
        polynomial = [_ratio(one, normal) for one in p.polynomial]
        sines = [(w, at, _ratio(a, normal)) for w, at, a in p.sines]
        most = _ratio([b * x for b, x in zip(p.b_squared, d, strict=True)], normal)
        if most is None or None in polynomial or any(a is None for _, _, a in sines):
            return None
        size = sum(b * x * x for b, x in zip(p.b_squared, d, strict=True))
        pieces.append(
            p._replace(
                polynomial=tuple((one or Fraction(0),) for one in polynomial),
                sines=tuple((w, at, (a or Fraction(0),)) for w, at, a in sines),
                b_squared=(most * most / size,),
            )
        )
    if None in along or None in images:
        return None
    m2, a1, a2 = (((one or Fraction(0)),) for one in images)
    x1, v1, v2 = (((one or Fraction(0)),) for one in along)

    place, force = column(given.place, d), column(given.force, normal)
    return Reduced((Fraction(1),), m2, (a1,), (a2,), (x1, v1, v2), tuple(pieces), place, force)


def _pushes(given: Reduced) -> list[Vector]:
    return [one for p in given.pieces for one in (*p.polynomial, *(a for _, _, a in p.sines))]


def _ratio(one: Sequence[Fraction], to: Sequence[Fraction]) -> Fraction | None:
    """Return c with one = c to, None if there is none."""
    at = next(k for k, x in enumerate(to) if x)
    c = Fraction(one[at]) / to[at]
    return c if all(x == c * y for x, y in zip(one, to, strict=True)) else None


def column(matrix: Matrix, by: Vector) -> Matrix:
    """Return a matrix times a vector, as a column."""
    return tuple((sum((a * x for a, x in zip(row, by, strict=True)), Fraction(0)),) for row in matrix)
