"""The unit of time of a run under a force: seconds, or a power of two of them where the horizon is out of all measure.

Third and fourth derivatives of the motion go with the fourth power of a rate: in seconds they leave the range of floats
for a horizon of 1e+-60 s, though the motion is as plain as any. A power of two changes the unit, and no bit else.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np

from numerics.arithmetic.protocol import Arithmetic
from numerics.errors import OutOfRange
from numerics.scene import Force, Friction, Pair, Piece, Scene, Sine, State
from numerics.trajectory.forced_record import CODES, NUMBERS, ForcedRecord

_USUAL = 40
"""Horizons between 2^-40 s and 2^40 s are followed in seconds."""
_POWERS = {"local": 1, "late": 1, "v1": -1, "v2": -1, "norm": -1, "v1_error": -1, "v2_error": -1}
"""Powers of the second in the numbers of a row (trajectory/forced_record.py)."""


def unit_of_time(scene: Scene) -> Fraction:
    """Return the unit in which a scene is followed, s; a power of two."""
    until = scene.until
    exponent = until.numerator.bit_length() - until.denominator.bit_length()
    return Fraction(2) ** exponent if abs(exponent) > _USUAL else Fraction(1)


def in_unit(scene: Scene, unit: Fraction) -> Scene:
    """Return the same scene with its times counted in another unit (s); exact."""
    pair, at, square = scene.pair, scene.initial, unit**2
    pieces = (
        Piece(
            one.start / unit,
            [c * unit ** (k + 2) for k, c in enumerate(one.polynomial)],
            [Sine(s.amplitude * square, s.omega * unit, s.phase) for s in one.sines],
        )
        for one in scene.force.pieces
    )
    return Scene(
        Pair(pair.m1, pair.m2, pair.a2 * square, pair.b * square, pair.a1 * unit),
        State(at.x1, at.v1 * unit, at.x2, at.v2 * unit),
        scene.until / unit,
        scene.law,
        Force(pieces),
        Friction([(start / unit, b * square) for start, b in scene.friction.pieces]),
    )


def in_seconds(record: ForcedRecord, unit: Fraction, arithmetic: Arithmetic) -> ForcedRecord:
    """Return what a run has left behind with times in a unit (s), in seconds; 1/unit: back. Raises OutOfRange."""
    factors = {power: arithmetic.number(unit**power) for power in (1, -1)}
    if record.width > 1:  # halves scale as they are
        factors = {power: float(unit**power) for power in factors}

    def scaled(row: Any) -> list[Any]:
        powers = [power for name in NUMBERS for power in [_POWERS.get(name, 0)] * record.width]
        numbers = [one * factors[power] if power else one for one, power in zip(row[len(CODES) :], powers, strict=True)]
        if any(isinstance(one, float) and not math.isfinite(one) for one in numbers):
            raise OutOfRange('a number of this scene is beyond the range of float64; use arithmetic="ball"')
        return [*row[: len(CODES)], *numbers]

    rows, end = [scaled(row) for row in record.rows], scaled(record.end_row)
    if isinstance(record.rows, np.ndarray):
        return ForcedRecord(np.array(rows).reshape(record.rows.shape), np.array(end), record.how, record.width)
    return ForcedRecord(rows, end, record.how, record.width)
