"""A scene on a surface without the directions in which nothing ever moves: motions are unique, so they stay away.

An axis that nothing drives stays at rest. A motion along one line stays on it where M1, M2, A1, A2, B^2 take its
direction d to multiples of one vector n, and u is one: then q = c d, f = F n, and c is the pair of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from operator import mul
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
    pieces, start = _pieces(scene), (scene.x1, scene.v1, scene.v2)
    pushes = [one for p in pieces for one in (*p.polynomial, *(amplitudes for _, _, amplitudes in p.sines))]
    moving = [part for part in pair.parts if any(one[i] for one in (*start, *pushes) for i in part)] or pair.parts[:1]
    unit = [tuple(Fraction(i == j) for i in range(n)) for j in sorted(chain(*moving))]
    if pair.shape == "ellipsoid":
        # a line has the direction of the start, or if that is at rest, of M1^-1 u
        pushed = ([x / m for x, m in zip(one, pair.m1, strict=True)] for one in pushes)
        d = next((tuple(one) for one in (*start, *pushed) if any(one)), unit[0])
        try:
            return _on(scene, pieces, [d], [tuple(m * x for m, x in zip(pair.m1, d, strict=True))])
        except ValueError:
            pass
    return _on(scene, pieces, unit, unit)


def _on(scene: PlaneScene, pieces: Sequence[Acting], places: list[Vector], forces: list[Vector]) -> Reduced:
    """Return the data for q = sum c_k places[k], f = sum F_k forces[k]. Raises ValueError for what leaves these."""
    pair = scene.pair

    def of(vector: Iterable[Fraction], basis: list[Vector]) -> Vector:
        """Return coordinates; the vectors of a basis do not share axes."""
        given = tuple(vector)
        found = tuple(next(given[i] / x for i, x in enumerate(one) if x) for one in basis)
        if given != tuple(sum(map(mul, found, row), Fraction(0)) for row in zip(*basis, strict=True)):
            raise ValueError("a vector that is not on these axes")
        return found

    def forced(given: Iterable[Iterable[Fraction]]) -> tuple[Vector, ...]:
        return tuple(of(one, forces) for one in given)

    def diagonal(numbers: Vector) -> Vector:
        images = forced(map(mul, numbers, d) for d in places)
        return tuple(one[k] for k, one in enumerate(images))

    def full(matrix: Matrix) -> Matrix:
        images = forced((sum(map(mul, row, d), Fraction(0)) for row in matrix) for d in places)
        return tuple(zip(*images, strict=True))

    acting = tuple(
        p._replace(
            polynomial=forced(p.polynomial),
            sines=tuple((w, at, of(a, forces)) for w, at, a in p.sines),
            b_squared=tuple(
                most * most / sum(map(mul, p.b_squared, map(mul, d, d)))
                for most, d in zip(diagonal(p.b_squared), places, strict=True)
            ),
        )
        for p in pieces
    )
    x1, v1, v2 = (of(one, places) for one in (scene.x1, scene.v1, scene.v2))
    matrices = full(pair.a1), full(pair.a2), (x1, v1, v2), acting
    transposed = (tuple(zip(*basis, strict=True)) for basis in (places, forces))
    return Reduced(diagonal(pair.m1), diagonal(pair.m2), *matrices, *transposed)


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
