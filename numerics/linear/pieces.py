"""The pieces of force and friction of a scene as one sequence, exact: on each, u is one polynomial plus sines."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.scene import Friction, Scene, Sine
from numerics.scene.pieces import shifted

_AT_ONCE = np.zeros(1)


@dataclass(frozen=True, slots=True)
class ExactPiece:
    """u and b from `start` (s) for `length` (s): u = sum_k polynomial[k] (t - start)^k + sines, N. Exact.

    Sines count t from the start of the run. `is_jump`: u or b may jump where the piece begins, as on the first one.
    """

    start: Fraction
    length: Fraction
    b: Fraction
    polynomial: tuple[Fraction, ...]
    sines: tuple[Sine, ...]
    is_jump: bool


def pieces_of(scene: Scene, known: Known | None = None) -> Sequence[ExactPiece]:
    """Return the pieces from t = 0 up to the horizon, in order; made once and kept with the scene.

    `known`: what was made of scenes before this one.
    """
    if "pieces" in scene.made:
        return scene.made["pieces"]
    found: list[ExactPiece] = []
    grid = (known.of if known else at_once)(_grid, scene.friction, scene.until, *scene.force.starts)
    for start, length, forces, frictions in grid:
        b = scene.friction.pieces[frictions - 1][1] if frictions else scene.pair.b
        polynomial, sines = (), ()  # type: tuple[Fraction, ...], tuple[Sine, ...]
        if forces:
            piece = scene.force.pieces[forces - 1]
            polynomial, sines = piece.polynomial, piece.sines
            if polynomial and piece.start != start:
                polynomial = shifted(polynomial, start - piece.start)
        jumps = not found or _may_jump(found[-1], b, polynomial, sines)
        found.append(ExactPiece(start, length, b, polynomial, sines, jumps))
    scene.made["pieces"] = found
    return found


def starts_of(scene: Scene) -> NDArray[np.float64]:
    """Return when the pieces begin, s; made once and kept with the scene."""
    if not (scene.force.pieces or scene.friction.pieces):
        return _AT_ONCE
    if "starts" not in scene.made:
        scene.made["starts"] = np.array([float(piece.start) for piece in pieces_of(scene)])
    return scene.made["starts"]


def at_once(make: Callable[..., Any], *given: object) -> Any:
    """Return make(*given): a single scene has few numbers twice."""
    return make(*given)


class Known:
    """What was made of numbers and objects, which many pieces and scenes of a batch share: made once."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self._found: dict[tuple[object, ...], tuple[Any, object]] = {}

    def of(self, make: Callable[..., Any], *given: object) -> Any:
        """Return make(*given), as it was made of the very same objects before."""
        key = make, *map(id, given)
        if key not in self._found:
            self._found[key] = make(*given), given  # what is kept keeps its id
        return self._found[key][0]


def _grid(friction: Friction, until: Fraction, *forces: Fraction) -> list[tuple[Fraction, Fraction, int, int]]:
    """Return of each piece start and length, s, and how many pieces of force and of friction have begun."""
    starts, frictions = [Fraction(0)], friction.starts
    for t in sorted((*forces, *frictions)):
        if starts[-1] < t < until:
            starts.append(t)
    return [
        (start, end - start, bisect_right(forces, start), bisect_right(frictions, start))
        for start, end in pairwise([*starts, until])
    ]


def polynomial_at(polynomial: Sequence[Fraction], t: Fraction) -> Fraction:
    """Return the value of a polynomial with these coefficients, from the constant on."""
    value = Fraction(0)
    for coefficient in reversed(polynomial):
        value = value * t + coefficient
    return value


def particular(polynomial: Sequence[Fraction], mass: Fraction, a1: Fraction, a2: Fraction) -> list[Fraction]:
    """Return the polynomial x (m) with mass x'' + a1 x' + a2 x = polynomial (N)."""
    found = [Fraction(0)] * (len(polynomial) + 2)
    for k in reversed(range(len(polynomial))):
        pull = a1 * (k + 1) * found[k + 1] + mass * (k + 1) * (k + 2) * found[k + 2]
        found[k] = (polynomial[k] - pull) / a2
    return found[: len(polynomial)]


def _may_jump(before: ExactPiece, b: Fraction, polynomial: Sequence[Fraction], sines: tuple[Sine, ...]) -> bool:
    """Return whether u or b may differ on both sides of where a piece begins: sines that change count as a jump."""
    if before.b != b or before.sines != sines:
        return True
    return polynomial_at(before.polynomial, before.length) != (polynomial[0] if polynomial else 0)
