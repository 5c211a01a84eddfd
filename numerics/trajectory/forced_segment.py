"""Segments under a force, and where the energy went: E' = u v1 - a1 v1^2 - b |v1 - v2|.

Friction's part is b times the way slid. The work of u and the loss to viscosity are integrals of products, which are
formed from the power series of u and v1 on short panels: an evidence of their own beside the closed form of the motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from numerics.arithmetic.ball_words import widened
from numerics.arithmetic.protocol import Number
from numerics.errors import OutOfRange
from numerics.flows.forced import coefficient_at
from numerics.flows.forced_records import HEAD, SINE
from numerics.motion.modes import Mode
from numerics.trajectory.segment import EnergyLedger

_MOST_PANELS = 20_000


@dataclass(frozen=True, slots=True)
class ForcedSegment:
    """One mode of motion from `start` to `end` (s); jumps of u and b may lie in it."""

    mode: Mode
    start: Number
    end: Number
    of: Any = field(repr=False)

    def state(self, t: Number) -> Any:
        """Return (x1, v1, x2, v2) at a time of the run, s."""
        return self.of.sol(t)


def ledger_of(trajectory: Any) -> EnergyLedger:
    """Return the ledger of the whole run; in the arithmetic's context. Raises OutOfRange for too stiff a motion."""
    number = trajectory.arithmetic.number
    friction = viscous = work = number(0)
    for row in range(len(trajectory.record.rows)):
        lost, damped, done = row_parts(trajectory, row, length_of(trajectory, row))
        friction, viscous, work = friction + lost, viscous + damped, work + done
    initial, final = number(trajectory.scene.energy), trajectory.final_energy
    residual = initial + work - final - friction - viscous
    return EnergyLedger(initial, final, friction, viscous, residual, work)


def length_of(trajectory: Any, row: int) -> Number:
    """Return how long the segment of a row lasts, s."""
    rows, record = trajectory.record.rows, trajectory.record
    piece = int(rows[row][3])
    after = row + 1 if row + 1 < len(rows) else -1
    code = record.end_row if after < 0 else rows[after]
    if int(code[3]) == piece:
        return record.number(after, "local") - record.number(row, "local")
    return trajectory.arithmetic.number(trajectory.pieces[piece].length) - record.number(row, "local")


def row_parts(trajectory: Any, row: int, length: Number) -> tuple[Number, Number, Number]:
    """Return what friction and viscosity took, and what u put in, J, in the first `length` s of a row's segment."""
    dense, (pair, drive) = trajectory.dense, trajectory.tables
    start, number = dense.motion_of(row), trajectory.arithmetic.to_float
    first, count, sines, _ = drive.places[start.piece]
    at = first + HEAD + 3 * count
    fastest = max((number(drive.numbers[at + SINE * k + 1]) for k in range(sines)), default=0.0)
    swing = pair.stick if start.mode == 0 else pair.slip
    panels = max(1, math.ceil((swing.rate + fastest) * number(length)))
    if panels > _MOST_PANELS:
        raise OutOfRange(f"the ledger of a segment would take {panels} panels; ask for a shorter run")
    viscous = work = length * 0
    begin = dense.after(row, length * 0)
    friction = length * 0
    for panel in range(panels):
        h, tau = length / panels, length * panel / panels
        x, v, _, _ = dense.after(row, tau)
        u_series = _force_series(drive, start.piece, start.local + tau, swing.terms)
        v_series = _speed_series(pair, swing, drive, start, (x, v), u_series)
        viscous = viscous + pair.a1 * _integral(v_series, v_series, h)
        work = work + _integral(u_series, v_series, h)
    if start.mode:
        end, b = dense.after(row, length), drive.numbers[first + 2]
        friction = b * start.mode * ((end[0] - begin[0]) - (end[2] - begin[2]))
    return friction, viscous, work


def _force_series(drive: Any, piece: int, local: Number, terms: int) -> list[Number]:
    """Return u^(k)/k! at a time in a piece."""
    first, count, sines, _ = drive.places[piece]
    numbers = drive.numbers
    found = [coefficient_at(numbers, first + HEAD, count, k, local) for k in range(min(count, terms))]
    found += [local * 0] * (terms - len(found))
    for k in range(sines):
        amplitude, omega, phase = numbers[first + HEAD + 3 * count + SINE * k :][:3]
        sine, cosine = _sine_cosine(phase + omega * local)
        one, two = amplitude * sine, amplitude * omega * cosine
        for n in range(terms):
            found[n] = found[n] + one
            one, two = two, -(omega * omega) * one / ((n + 1) * (n + 2))
    return found


def _sine_cosine(x: Number) -> tuple[Number, Number]:
    if hasattr(x, "sin_cos"):
        sine, cosine = x.sin_cos()
        return sine, cosine
    if isinstance(x, float):
        return math.sin(x), math.cos(x)
    import mpmath

    return mpmath.sin(x), mpmath.cos(x)


def _speed_series(
    pair: Any, swing: Any, drive: Any, start: Any, state: tuple[Number, Number], force: list[Number]
) -> list[Number]:
    """Return v1^(k)/k! from the state and the series of the force."""
    push = -start.mode * drive.numbers[drive.places[start.piece][0] + 2]
    found = list(state)
    for k, one in enumerate(force[:-1]):
        f = one + push if k == 0 else one
        pull = f - pair.a1 * ((k + 1) * found[k + 1]) - pair.a2 * found[k]
        found.append(pull / swing.mass / ((k + 1) * (k + 2)))
    return [(k + 1) * c for k, c in enumerate(found[1:])]


def _integral(one: list[Number], two: list[Number], h: Number) -> Number:
    """Return the integral of a product of two power series from 0 to h."""
    terms = len(one)
    total, power = h * 0, h
    for n in range(terms):
        total = total + sum((one[k] * two[n - k] for k in range(n + 1)), h * 0) * power / (n + 1)
        power = power * h
    if hasattr(h, "rad"):
        sizes = [sum((abs(c) * h**k for k, c in enumerate(series)), h * 0) for series in (one, two)]
        rest = 2**terms * sizes[0] * sizes[1] * h
        for n in range(2, terms):
            rest = rest / n
        total = widened(total, rest)
    return total
