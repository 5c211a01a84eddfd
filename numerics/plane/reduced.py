"""A scene on a surface without the directions in which nothing ever moves: motions are unique, so they stay away.

An axis that nothing drives stays at rest. A motion along one line stays on it where M1, M2, A1, A2, B^2 take its
direction d to multiples of one vector n, and u is one: then q = c d, f = F n, and c is the pair of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain, pairwise
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
    """The data on the axes that move; `place` takes q and v, `force` forces, back to the axes of the scene."""

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

        Asked where they swing with one frequency, Lam = C cos W t + W^-1 Lam' sin W t: then K has the whole ellipse if
        and only if the larger root of B^-1 (C C^T + W^-2 Lam' Lam'^T) B^-1 is at most 1. Else False.
        """
        mass = self.m1 + self.m2
        if self.pieces[0].terms.keys() - {0} or any(map(any, self.a1)):
            return False
        push, rate = self.push, self.a2 @ self.start[1]
        bends = [(one, self.a2 @ (one / mass)) for one in (push, rate)]
        square = next((y / x for pair in bends for x, y in zip(*pair, strict=True) if x), Fraction(1))
        if any(list(two) != list(one * square) for one, two in bends):
            return False
        products = [self.weight * one * two for one, two in ((push, push), (push, rate), (rate, rate))]
        sums = [[sum(one[i] for i in axes) for one in products] for axes in groups]
        return all(
            place <= 1 and speed <= square and (1 - place) * (square - speed) >= mixed * mixed
            for place, mixed, speed in sums
        )


def reduced(scene: PlaneScene, *, whole: bool = False) -> ReducedPlane:
    """Return the data on the axes, or on the one line, on which a scene moves; the `whole` of it, if that is asked."""
    pair, n = scene.pair, scene.pair.axes
    pieces, start = _pieces(scene), (scene.x1, scene.v1, scene.v2)
    pushes = [one for piece in pieces for one in piece.terms.values()]
    moving = [part for part in pair.parts if whole or any(one[i] for one in (*start, *pushes) for i in part)]
    unit = [Vector(Fraction(i == j) for i in range(n)) for j in sorted(chain(*moving or pair.parts[:1]))]
    if pair.shape == "ellipsoid":
        try:
            return _on_line(scene, pieces, pieces)
        except ValueError:
            pass
    return _on(scene, pieces, unit, unit)


def line_at_first(scene: PlaneScene) -> ReducedPlane | None:
    """Return the data on the one line on which an ellipsoid moves until a change of force or friction leads it away."""
    pieces = _pieces(scene)
    for k, piece in enumerate(pieces):
        try:
            _on_line(scene, pieces, [piece])
        except ValueError:
            return _on_line(scene, pieces, pieces[:k]) if k else None
    return None


def _on_line(scene: PlaneScene, pieces: Sequence[Acting], some: Sequence[Acting]) -> ReducedPlane:
    """Return the data with some pieces on a line, of the direction of the start, or if that is at rest, of M1^-1 u."""
    m1, axis = Vector(scene.pair.m1), Vector(Fraction(i == 0) for i in range(scene.pair.axes))
    pushed = (one / m1 for piece in pieces for one in piece.terms.values())
    d = next((Vector(one) for one in chain((scene.x1, scene.v1, scene.v2), pushed) if any(one)), axis)
    return _on(scene, some, [d], [m1 * d])


def _on(scene: PlaneScene, pieces: Sequence[Acting], places: list[Vector], forces: list[Vector]) -> ReducedPlane:
    """Return the data for q = sum c_k places[k], f = sum F_k forces[k]. Raises ValueError for what leaves these."""
    pair = scene.pair

    def of(vector: Iterable[Fraction], basis: list[Vector]) -> Vector:
        """Return coordinates; the vectors of a basis do not share axes."""
        given = tuple(vector)
        found = Vector(next(given[i] / x for i, x in enumerate(one) if x) for one in basis)
        if given != Vector(basis) @ found:
            raise ValueError("a vector that is not on these axes")
        return found

    def diagonal(numbers: Sequence[Fraction]) -> Vector:
        return Vector(of(d * Vector(numbers), forces)[k] for k, d in enumerate(places))

    def full(matrix: Sequence[Sequence[Fraction]]) -> Vector:
        return Vector(of(Vector(map(Vector, matrix)) @ d, forces) for d in places)

    def piece(given: Acting) -> Acting:
        most, size = diagonal(given.b_squared), Vector(given.b_squared @ (d * d) for d in places)
        return given._replace(
            terms={key: of(one, forces) for key, one in given.terms.items()}, b_squared=most * most / size
        )

    x1, v1, v2 = (of(one, places) for one in (scene.x1, scene.v1, scene.v2))
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


def _pieces(scene: PlaneScene) -> tuple[Acting, ...]:
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
