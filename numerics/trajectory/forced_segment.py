"""Segments under a force, and where the energy went: E' = u v1 - a1 v1^2 - b |v1 - v2|.

Friction's part is b times the way slid. The work of u and the loss to viscosity are integrated (flows/forced_work.py):
an evidence of their own beside the closed form of the motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball_words import precision, widened
from numerics.arithmetic.float64 import FLOAT64, UNIT
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.errors import OutOfRange
from numerics.flows.forced_records import HEAD, ROUNDINGS, SINE, Drive
from numerics.flows.forced_work import integrals
from numerics.motion.forced_pair import bits_of
from numerics.motion.modes import Mode
from numerics.trajectory.forced_units import unit_of_time
from numerics.trajectory.segment import EnergyLedger

_MOST_PANELS, _PANEL = 20_000, 2
"""Panels of a segment, and how many times the fastest rate's inverse one of them is long."""


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


class Parts(NamedTuple):
    """What friction and viscosity took, and what u put in, J; in points `off` bounds the error of the last one."""

    friction: Number
    viscous: Number
    work: Number
    off: Number


def parts_of(trajectory: Any) -> Parts:
    """Return the parts of the whole run; in the arithmetic's context. Raises OutOfRange for too stiff a motion."""
    zero = trajectory.arithmetic.number(0)
    totals, count = (zero, zero, zero, zero), len(trajectory.record.rows)
    fast = trajectory.arithmetic.name == "float64" and FLOAT64.has_compiled(integrals)
    drive = trajectory.tables[1]
    if fast:
        drive = Drive(np.array(drive.numbers), np.array(drive.places, dtype=np.int64))
    for row in range(count if trajectory.reached else count - 1):
        found = _row_parts(trajectory, row, drive, fast=fast)
        totals = tuple(one + two for one, two in zip(totals, found, strict=True))
    return Parts(*totals)


def ledger_of(trajectory: Any) -> EnergyLedger:
    """Return the ledger of the whole run; in the arithmetic's context. Raises OutOfRange."""
    followed, unit, number = trajectory.in_unit, unit_of_time(trajectory.scene), trajectory.arithmetic.number
    friction, viscous, work, _ = trajectory.parts
    initial, final = number(followed.scene.energy), followed.final_energy
    found = EnergyLedger(initial, final, friction, viscous, initial + work - final - friction - viscous, work)
    return found if unit == 1 else found.times(number(1 / unit**2))


def length_of(trajectory: Any, row: int) -> Number:
    """Return how long the segment of a row lasts, s."""
    rows, record = trajectory.record.rows, trajectory.record
    piece = int(rows[row][3])
    after = row + 1 if row + 1 < len(rows) else -1
    code = record.end_row if after < 0 else rows[after]
    if int(code[3]) == piece:
        return record.number(after, "local") - record.number(row, "local")
    return trajectory.arithmetic.number(trajectory.pieces[piece].length) - record.number(row, "local")


def _row_parts(trajectory: Any, row: int, drive: Drive, *, fast: bool) -> Parts:
    """Return the parts of a row's segment."""
    dense, (pair, _), arithmetic = trajectory.dense, trajectory.tables, trajectory.arithmetic
    start, length, number = dense.motion_of(row), length_of(trajectory, row), arithmetic.to_float
    first, count, sines, _ = drive.places[start.piece]
    at = first + HEAD + 3 * count
    fastest = max((number(drive.numbers[at + SINE * k + 1]) for k in range(sines)), default=0.0)
    rho = (pair.stick if start.mode == 0 else pair.slip).rate + 1.0001 * fastest
    if 0.0 < rho * number(length) < _PANEL:  # U of a polynomial is less for a greater rho
        rho = _PANEL / number(length)
    panels = max(1, math.ceil(rho * number(length) / _PANEL))
    if panels > _MOST_PANELS:
        raise OutOfRange(f"the ledger of a segment would take {panels} panels; ask for a shorter run")
    nodes, weights, rest = _rule(arithmetic)
    rule = (np.array(nodes), np.array(weights)) if fast else (nodes, weights)
    told = FLOAT64.compiled(integrals) if fast else arithmetic.telling(integrals)
    found = told(pair, drive, start, length, panels, rho, rule)
    # |v1| is off by N/sqrt(m1); U and V grow by e^2 in a panel at most
    off, grown = start.norm / pair.root_m1, 8
    work_off = off * found.of_u * grown + found.of_uv * rest
    viscous, friction = pair.a1 * found.square, length * 0
    if start.mode:
        begin, end = dense.after(row, length * 0), dense.after(row, length)
        friction = drive.numbers[first + 2] * start.mode * ((end[0] - begin[0]) - (end[2] - begin[2]))
    if arithmetic.name == "ball":
        square_off = off * (2 * grown * found.of_v + off * length) + found.of_vv * rest
        # next to an event the other mode may hold: |v1 - v2| is below N sqrt(kappa) there
        late = trajectory.record.number(row, "late") + trajectory.record.number(min(row + 1, _last(trajectory)), "late")
        slid = drive.numbers[first + 2] * pair.guard_norm * start.norm * late * 2
        return Parts(
            widened(friction, slid), widened(viscous, pair.a1 * square_off), widened(found.work, work_off), length * 0
        )
    return Parts(friction, viscous, found.work, work_off + ROUNDINGS * UNIT * found.rounded_work)


def _last(trajectory: Any) -> int:
    return len(trajectory.record.rows) - 1


def _rule(arithmetic: Arithmetic) -> tuple[list[Number], list[Number], Number]:
    """Return Gauss's nodes and weights on (0, 1), and what bounds the remainder: that times h U V."""
    nodes, weights, rest = _gauss(bits_of(arithmetic))
    if arithmetic.name == "ball":
        return nodes, weights, rest
    if arithmetic.name == "float64":
        return [float(one) for one in nodes], [float(one) for one in weights], float(rest.upper())
    return [_point(one) for one in nodes], [_point(one) for one in weights], _point(rest)


def _point(x: arb) -> Any:
    import mpmath

    mantissa, exponent = x.mid().man_exp()
    return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))


@cache
def _gauss(bits: int) -> tuple[list[arb], list[arb], arb]:
    """Return the rule for panels of `_PANEL`, and its remainder over h U V."""
    with precision(bits + 32):
        n = _count(bits)
        pairs = [arb.legendre_p_root(n, k, weight=True) for k in range(n)]
        return [(1 + x) / 2 for x, _ in pairs], [w / 2 for _, w in pairs], _remainder(n)


def _count(bits: int) -> int:
    """Return the least number of nodes whose remainder is below the last digit."""
    n = 1
    while not _remainder(n) < arb(2) ** (-bits - 24):
        n += 1
    return n


def _remainder(n: int) -> arb:
    """Return e^a a^(2n) n!^4/((2n+1) (2n)!^3), with a = 2 rho h, twice the length of a panel."""
    a = 2 * arb(_PANEL)
    return a.exp() * a ** (2 * n) * arb(n).fac() ** 4 / ((2 * n + 1) * arb(2 * n).fac() ** 3)
