"""A scene on a surface without the directions in which nothing ever moves: motions are unique, so they stay away.

An axis that nothing drives stays at rest. An ellipsoid's motion along one line stays on it as long as M1, M2, A1, A2,
B^2 take its direction d to multiples of one vector, and u is one: then q = c d, and c is the pair of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain, combinations, pairwise
from typing import Any, NamedTuple

from numerics.plane.vector import Vector
from numerics.scene.plane import PlaneScene


class Acting(NamedTuple):
    """What acts from `start` (s) on, time counted from there: u by axes and the squares of b; exact."""

    start: Fraction
    end: Fraction
    terms: dict[int | tuple[Fraction, Fraction], Vector]
    """What a power of t is multiplied by, or the sine with an omega and a phase: (n,) each."""
    b_squared: Vector


class ReducedPlane(NamedTuple):
    """The data for q = sum c_k places[k], f = sum F_k forces[k], where places.forces = 1."""

    m1: Vector
    m2: Vector
    a1: Vector
    a2: Vector
    start: tuple[Vector, Vector, Vector]
    """q1, v1, v2 at t = 0."""
    pieces: tuple[Acting, ...]
    place: Vector
    force: Vector
    apart: Vector
    """x1 - x2 at t = 0, on the axes of the scene."""
    is_round: bool
    """Whether K is an ellipsoid, or the line through it, and no box."""

    @property
    def push(self) -> Vector:
        """Return u - A2 q1 - A1 v1 at t = 0, without sines."""
        u, (q1, v1, _) = self.pieces[0].terms.get(0, self.m1 * 0), self.start
        return Vector(u - self.a2 @ q1 - self.a1 @ v1)

    @property
    def weight(self) -> Vector:
        """Return what squares of pushes on stuck bodies are worth of |B^-1 Lam|^2."""
        share = self.m2 / (self.m1 + self.m2)
        return share * share / self.pieces[0].b_squared

    def is_on_edge(self, axes: Iterable[int]) -> bool:
        """Return whether |B^-1 Lam|^2 of some axes is 1 at t = 0; False where a sine is not exactly known."""
        strains = self.weight * self.push * self.push
        turned = any(isinstance(one, tuple) and one[1] for one in self.pieces[0].terms)
        return not turned and sum(strains[i] for i in axes) == 1

    def sticks_for_ever(self, groups: Iterable[Iterable[int]]) -> bool:
        """Return whether the loads of bodies that stick at t = 0 stay in K as long as the first piece lasts.

        Without a damper under a constant force p = u - A2 q has p'' = -A2 M^-1 p. With W such that |B^-1 Lam|^2 = p.W p
        and W A2 M^-1 symmetric, p.W p + p'.W (A2 M^-1)^-1 p' is kept: it is enough that it is at most 1.
        Where all loads swing with one frequency, Lam = C cos w t + w^-1 Lam' sin w t, K has the whole ellipse if
        and only if the larger root of B^-1 (C C^T + w^-2 Lam' Lam'^T) B^-1 is at most 1. Else False.
        """
        mass, (_, speed, _) = self.m1 + self.m2, self.start
        if self.pieces[0].terms.keys() - {0} or any(map(any, self.a1)):
            return False
        push, rate, worth = self.push, self.a2 @ speed, self.weight * mass
        is_kept = all(worth[i] == worth[j] or not self.a2[i][j] for i, j in combinations(range(len(mass)), 2))
        if is_kept and self.weight * push @ push + worth * speed @ rate <= 1:
            return True
        bends = [(one, self.a2 @ (one / mass)) for one in (push, rate)]
        square = next((y / x for pair in bends for x, y in zip(*pair, strict=True) if x), Fraction(1))
        if any(two != one * square for one, two in bends):
            return False
        products = [self.weight * one * two for one, two in ((push, push), (push, rate), (rate, rate))]
        sums = [[sum(one[i] for i in axes) for one in products] for axes in groups]
        return all(
            place <= 1 and speed <= square and (1 - place) * (square - speed) >= mixed * mixed
            for place, mixed, speed in sums
        )


def reduced(scene: PlaneScene) -> list[ReducedPlane]:
    """Return the data of the line on which an ellipsoid moves up to some piece, and those of all axes that move."""
    pair, pieces = scene.pair, pieces_of(scene)
    start, pushes = (scene.x1, scene.v1, scene.v2), [one for piece in pieces for one in piece.terms.values()]
    is_round = pair.shape == "ellipsoid"
    moving = [part for part in pair.parts if not is_round or any(one[i] for one in (*start, *pushes) for i in part)]
    axes = sorted(chain(*moving or pair.parts[:1]))
    unit = [Vector(Fraction(i == j) for i in range(pair.axes)) for j in axes]
    ways = (Vector(one) for one in (*start, *(one / Vector(pair.m1) for one in pushes)))
    d, straight = next(filter(any, ways), unit[0]), 0
    while is_round and straight < len(pieces) and _stays_on(scene, pieces[straight], d):
        straight += 1
    line = [_on(scene, pieces[:straight], [d])] if straight else []
    return line if straight == len(pieces) else [*line, _on(scene, pieces, unit)]


def _stays_on(scene: PlaneScene, piece: Acting, d: Vector) -> bool:
    """Return whether a motion on the line with a direction stays on it in a piece."""
    pair = scene.pair
    n, (a1, a2) = Vector(pair.m1) * d, (Vector(map(Vector, one)) for one in (pair.a1, pair.a2))
    pulls = Vector(pair.m2) * d, a1 @ d, a2 @ d, piece.b_squared * d, *piece.terms.values()
    along = [(Vector(one), d) for one in (scene.x1, scene.v1, scene.v2)] + [(one, n) for one in pulls]
    return all(x * (y @ y) == y * (x @ y) for x, y in along)


def _on(scene: PlaneScene, pieces: Sequence[Acting], places: list[Vector]) -> ReducedPlane:
    """Return the data on axes with these directions, which nothing leaves."""
    pair, m1 = scene.pair, Vector(scene.pair.m1)
    forces = [m1 * d / (m1 * d @ d) for d in places]

    def pull(force: Vector) -> Vector:
        return Vector(force @ d for d in places)

    def diagonal(numbers: Iterable[Fraction]) -> Vector:
        return Vector(Vector(numbers) * d @ d for d in places)

    def full(matrix: Sequence[Sequence[Fraction]]) -> Vector:
        return Vector(pull(Vector(map(Vector, matrix)) @ d) for d in places)

    def piece(given: Acting) -> Acting:
        return given._replace(
            terms={key: pull(one) for key, one in given.terms.items()}, b_squared=diagonal(given.b_squared)
        )

    x1, v1, v2 = (Vector(n @ one for n in forces) for one in (scene.x1, scene.v1, scene.v2))
    return ReducedPlane(
        m1=diagonal(pair.m1),
        m2=diagonal(pair.m2),
        a1=full(pair.a1),
        a2=full(pair.a2),
        start=(x1, v1, v2),
        pieces=tuple(map(piece, pieces)),
        place=Vector(places),
        force=Vector(forces),
        apart=Vector(scene.x1) - Vector(scene.x2),
        is_round=pair.shape == "ellipsoid",
    )


def pieces_of(scene: PlaneScene) -> tuple[Acting, ...]:
    """Return what acts, begun anew wherever u or b changes."""
    starts = {Fraction(0), *(s for one in scene.force for s in one.starts), *(s for s, _ in scene.friction)}
    order = [*sorted(one for one in starts if one < scene.until), scene.until]
    found = []
    for start, end in pairwise(order):
        terms: dict[Any, list[Fraction]] = {}
        for i, piece in enumerate(one.piece_at(start).moved(start) for one in scene.force):
            sines = (((one.omega, one.phase + one.omega * start), one.amplitude) for one in piece.sines)
            for key, size in (*enumerate(piece.polynomial), *sines):
                terms.setdefault(key, [Fraction(0)] * len(scene.force))[i] += size
        b = Vector([scene.pair.b, *(b for at, b in scene.friction if at <= start)][-1])
        found.append(Acting(start, end, {key: Vector(one) for key, one in terms.items()}, b * b))
    return tuple(found)
