"""How many digits are right: read off the radii of balls, or off the error bounds that a run carried.

An error counts relative to the size that its quantity has along the run: positions have one scale, the largest |x1| or
|x2| at start, events, jumps of u or b, and end; velocities likewise, or the largest mean velocity between two of these,
which is attained on the way, where that is larger; the energy the largest energy there, or of body 1 at that velocity;
the excess E/E_cr - 1, where it is carried, the largest |excess|. Times count relative to themselves. An x1 that passes
0 has then as many right digits as its neighbours. Velocities that may be 0 all along, as of a pair in balance, count as
right to n digits below 10^(-4 n) of Omega times the largest |position|. A run has no right digit of a quantity whose
error is as large as that scale. Where digits of balls are asked for, an error counts relative to each value itself, and
a zero to n digits below 10^(-4 n) of its scale, as digits cost little there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import EXACT, Ball, digits_within
from numerics.arithmetic.compiled import compiled, compiles_now
from numerics.linear.errors_of import errors_of
from numerics.linear.pieces import starts_of
from numerics.linear.record import AT
from numerics.scene import Scene
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.columns import Floats
from numerics.trajectory.events import energy_of, wall_of

FEW_DIGITS = 3
"""So few right digits are said in the message of a run."""
ROUNDING = 2.0**-53
"""Of one operation in float64."""
_ZERO_BITS = 3
"""A ball that holds 0 has no more accurate bits than that."""
_SHORT = Ball(15)
"""In which right digits are counted."""

_STATE = slice(AT["x1"], AT["v2"] + 1)
_STATE_ERRORS = slice(AT["x1_error"], AT["v2_error"] + 1)
"""Where the bounds of x1, v1, x2, v2 stand in a row."""


def proved_digits(trajectory: Any) -> int:
    """Return how many digits of each number the balls of a trajectory leave right: of every event, and of the end."""
    return min(_digits_of_balls(trajectory, relative_to_all=False))


def _digits_of_balls(trajectory: Any, *, relative_to_all: bool) -> tuple[int, ...]:
    """Return the least right digits of what JUDGED names, relative to each number, or to the largest of its kind."""
    times, states = trajectory.event_times, np.column_stack([trajectory.event_states, trajectory.final_state])
    energy, *excess = trajectory.end_numbers()[len(states) :]
    carried = [] if trajectory.row_excess is None else trajectory.row_excess
    if relative_to_all:
        excess = carried[-1:]  # another one is formed from the energy
    numbers, found = (times, states[::2].ravel(), states[1::2].ravel(), [energy], excess), []
    with _SHORT.context():  # of numbers of any length
        most = max((abs(one.mid()) for one in carried), default=arb(0))
        scales = (arb(1), arb(0)), *_scales(trajectory), (arb(1), most)
        for some, (scale, attained) in zip(numbers, scales, strict=True):
            largest = max((one.rad() for one in some), default=arb(0))
            reached = digits_within(largest, attained, attained) if relative_to_all else 0
            found.append(reached or _least_digits(some, scale))
    return tuple(found)


def _least_digits(some: Any, scale: arb) -> int:
    """Return the least right digits of some numbers, each relative to itself, of a zero to a scale."""
    # the count of accurate bits is within two bits of the logarithm: only the worst are measured, and all zeros
    bits = [one.rel_accuracy_bits() for one in some]
    close = 4 + min((count for count in bits if count > _ZERO_BITS), default=0)
    worst = [one for one, count in zip(some, bits, strict=True) if count <= close]
    return min((digits_within(one.rad(), one, scale) for one in worst), default=EXACT)


def _scales(trajectory: Any) -> Iterator[tuple[arb, arb]]:
    """Yield, of positions, speeds and energies along a run, to what a zero is compared, and the largest attained."""
    (times, states), pair = trajectory._own_moments, trajectory.scene.pair
    gone, lasted = np.diff(states[::2]), np.diff(times)
    means = [one.abs_lower() for one in (gone / lasted).flat if one.is_finite()]
    x = max(abs(one.mid()) for one in states[::2].flat)
    v = max([abs(one.mid()) for one in states[1::2].flat] + means)  # a mean speed is attained on the way
    squared = pair.a2 / (pair.m1 if pair.is_fixed else pair.mass) if pair.a2 else 1 / trajectory.scene.until**2
    slow, m1 = Ball.number(squared).sqrt() * x, Ball.number(pair.m1)
    most = max([one.mid() for one in energy_of(trajectory, times, states, trajectory._own_rows)] + [m1 * v * v / 2])
    yield x, x
    yield max(v, slow), v
    yield max(most, m1 * slow * slow / 2), most


@dataclass(frozen=True, repr=False)
class Accuracy(ShortRepr):
    """Bounds on the rounding errors of a float64 trajectory, in SI units.

    `t` (k,) s and `y` (k, 4) at the events, `final` (4,), `energy` and `dissipated` (J) and `energy_excess` at the end.
    The bounds are conservative and tested, not proved. `certain`: they exclude any other sequence of events.
    `digits` is the least number of right digits of times, states, and of energy and excess at the end, 0 if not
    certain: relative to each time, to the largest |position|, |velocity|, energy and excess along the run (digits.py).
    """

    t: Floats
    y: Floats
    final: Floats
    energy: float
    energy_excess: float
    certain: bool
    digits: int
    of_ledger: Callable[[], float] = field(repr=False, compare=False)

    @property
    def dissipated(self) -> float:
        """Return the bound of what friction and damper took, J: that of the ledger, which is formed for it."""
        return self.of_ledger()

    @property
    def bounded(self) -> bool:
        """Return whether the sequence of events is certain and every bound a number."""
        excess = [] if math.isnan(self.energy_excess) else [self.energy_excess]  # without E_cr there is none
        bounds = [*self.t, *self.y.ravel(), *self.final, self.energy, *excess, self.dissipated]
        return self.certain and bool(np.all(np.isfinite(bounds)))


class Judged(NamedTuple):
    """Bounds on the last energy (J) and excess; how many digits are right of what JUDGED names, none if unknown."""

    energy: float = math.nan
    excess: float = math.nan
    right: tuple[int, ...] = ()


@lru_cache(maxsize=128)
def _weights(scene: Scene) -> tuple[tuple[float, float, float], float]:
    """Return a2, m1, m2 (0 where it is infinite) and E_cr (J; nan where there is none) as floats."""
    pair = scene.pair
    critical = float(pair.critical_energy) if pair.a2 and pair.b else math.nan
    return (float(pair.a2), float(pair.m1), 0.0 if pair.is_fixed else float(pair.m2)), critical


def judged(trajectory: Any) -> Judged:
    """Return what the bounds of a run in floats leave, or the balls of another one; mpmath knows nothing."""
    if trajectory.bounded:
        return _judged_floats(trajectory)
    is_known = trajectory.arithmetic.name == "ball"
    return Judged(right=_digits_of_balls(trajectory, relative_to_all=True)) if is_known else Judged()


def _judged_floats(trajectory: Any) -> Judged:
    record, scene = trajectory.record, trajectory.scene
    judge = compiled(errors_of) if compiles_now() else np.errstate(all="ignore")(errors_of)
    weights, critical = _weights(scene)
    energy, excess, worst = judge(record.rows, record.end, starts_of(scene)[0], weights, critical, ROUNDING)
    if scene.wall.pieces:  # the spring is longer or shorter than x1
        end = record.end[_STATE]
        wall = wall_of(trajectory, np.array([-1]), np.array([trajectory.end_time]))[0, 0]
        x1, stretched = abs(float(end[0])), abs(float(end[0] - wall))
        energy += (
            weights[0] * max(0.0, stretched - x1) * (record.end[_STATE_ERRORS][0] + 8 * ROUNDING * (x1 + stretched))
        )
        excess = energy / critical + 8 * ROUNDING * (1 + trajectory.final_energy / critical)
    return Judged(energy, excess, tuple(map(_right, worst)))


def _right(error: float) -> int:
    """Return how many digits a relative error leaves right."""
    return (math.floor(-math.log10(error)) if error > 0 else EXACT) if error < 1 else 0


def accuracy_of(trajectory: Any, found: Judged) -> Accuracy:
    """Return the bounds of a trajectory in SI units, or the radii of its balls, rounded upwards; in binary64."""
    energy, excess, _ = found
    if trajectory.bounded:
        rows, at = trajectory.record.rows, trajectory.event_rows
        t, y = rows[at, AT["late"]] + 4 * ROUNDING * trajectory.event_times, rows[at, _STATE_ERRORS]
        end = trajectory.record.end[_STATE_ERRORS]
    else:
        with trajectory.context():
            t, y = _radii_of(trajectory.event_times), _radii_of(trajectory.event_states.T)
            *final, energy, excess = _radii_of([*trajectory.end_numbers(), arb("nan")])[:6]
        end = np.array(final)
    of_ledger = partial(_off_in_ledger, trajectory)
    return Accuracy(t, y, end, energy, excess, trajectory.certain, trajectory.right_digits, of_ledger)


def _off_in_ledger(trajectory: Any) -> float:
    """Return the bound on what a run says that friction and damper took, J."""
    if trajectory.bounded:
        return float(2 * trajectory.ledger.error)
    with trajectory.context():
        return float(_radii_of(trajectory.dissipated))


_radii_of = np.vectorize(lambda x: 0.0 if x.is_exact() else math.nextafter(float(x.rad()), math.inf), otypes=[float])
