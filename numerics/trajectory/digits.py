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
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import EXACT, Ball, digits_within
from numerics.arithmetic.compiled import compiled, compiles_now
from numerics.linear.errors_of import JUDGED, errors_of
from numerics.linear.pieces import starts_of
from numerics.linear.record import AT
from numerics.scene import Scene
from numerics.scene.short_repr import ShortRepr
from numerics.trajectory.columns import Floats
from numerics.trajectory.events import energy_of
from numerics.trajectory.rendering import MOST_DIGITS

FEW_DIGITS = 3
"""So few right digits are said in the message of a run."""
ROUNDING = 2.0**-53
"""Of one operation in float64."""
_ZERO_BITS = 3
"""A ball that holds 0 has no more accurate bits than that."""

_STATE = slice(AT["x1"], AT["v2"] + 1)
_STATE_ERRORS = slice(AT["x1_error"], AT["v2_error"] + 1)
"""Where the bounds of x1, v1, x2, v2 stand in a row."""


def proved_digits(trajectory: Any) -> int:
    """Return how many digits the balls of a trajectory leave right: of every event, and of the end."""
    with trajectory.context():
        values = list(_enclosed(trajectory))
        # the count of accurate bits is within two bits of the logarithm: only the worst are measured, and all zeros
        bits = [value.rel_accuracy_bits() for value, _ in values]
        close = min((count for count in bits if count > _ZERO_BITS), default=0) + 4
        worst = [one for one, count in zip(values, bits, strict=True) if count <= max(close, _ZERO_BITS)]
        return min((digits_within(value.rad(), value, scale) for value, scale in worst), default=EXACT)


def _enclosed(trajectory: Any) -> Iterator[tuple[arb, arb]]:
    """Yield every number that a trajectory in balls states, with the scale to which a zero is compared."""
    x, v, energy = _scales(trajectory)
    for t in trajectory.event_times:
        yield t, t
    for state in (*trajectory.event_states.T, trajectory.final_state):
        yield from zip(state, (x, v, x, v), strict=True)
    _, _, _, _, *ends = trajectory.end_numbers()
    yield from zip(ends, (energy, trajectory.arithmetic.number(1)), strict=False)


def _scales(trajectory: Any) -> tuple[arb, arb, arb]:
    """Return L, L Omega and E_cr; of a pair without them the largest position, speed and energy along the run."""
    if trajectory.has_frame:
        frame = trajectory.frame
        return frame.length, frame.speed, frame.critical_energy
    times, states = trajectory._own_moments
    x, v = (_largest(states[k::2].ravel()) for k in range(2))
    slow = _rate(trajectory.scene) * x  # a block that rests at every event has moved all the same
    moving = Ball.number(trajectory.scene.pair.m1) * slow * slow / 2
    return x, max(v, slow), max(_largest(energy_of(trajectory, times, states)), moving)


def _rate(scene: Scene) -> arb:
    """Return Omega, without a spring 1/until: a speed is small beside it times the largest position."""
    pair = scene.pair
    squared = pair.a2 / (pair.m1 if pair.is_fixed else pair.mass) if pair.a2 else 1 / scene.until**2
    return Ball.number(squared).sqrt()


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
    """Bounds on the last energy (J) and excess; and what has so many right digits."""

    energy: float
    excess: float
    digits: int
    worst: Sequence[float]
    """The worst relative errors of what JUDGED names; none where nothing is known."""

    @property
    def least(self) -> tuple[str, ...]:
        """Return the quantities that have no more digits."""
        return tuple(name for name, one in zip(JUDGED, self.worst, strict=False) if _right(one) <= self.digits)


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
    if trajectory.arithmetic.name != "ball":
        return Judged(math.nan, math.nan, 0, ())
    worst = _worst_of_balls(trajectory)
    return Judged(math.nan, math.nan, min(trajectory.arithmetic.digits, _right(max(worst))), worst)


def _judged_floats(trajectory: Any) -> Judged:
    record, scene = trajectory.record, trajectory.scene
    judge = compiled(errors_of) if compiles_now() else np.errstate(all="ignore")(errors_of)
    weights, critical = _weights(scene)
    energy, excess, worst = judge(record.rows, record.end, starts_of(scene)[0], weights, critical, ROUNDING)
    if scene.wall.pieces:  # the spring is longer or shorter than x1
        end = record.end[_STATE]
        x1, stretched = abs(float(end[0])), abs(float(end[0] - float(scene.wall(Fraction(trajectory.end_time)))))
        energy += (
            weights[0] * max(0.0, stretched - x1) * (record.end[_STATE_ERRORS][0] + 8 * ROUNDING * (x1 + stretched))
        )
        excess = energy / critical + 8 * ROUNDING * (1 + trajectory.final_energy / critical)
    if not trajectory.certain and _right(max(worst)):
        return Judged(energy, excess, 0, ())
    return Judged(energy, excess, min(MOST_DIGITS, _right(max(worst))), worst)


def _worst_of_balls(trajectory: Any) -> list[float]:
    with trajectory.context():
        (times, states), mass = trajectory._own_moments, Ball.number(trajectory.scene.pair.m1)
        energies = energy_of(trajectory, times, states)
        x, v = (states[k::2].ravel() for k in range(2))
        far: arb = _largest(x)
        carried: Any = [] if trajectory.row_excess is None else trajectory.row_excess
        slow, fast = _rate(trajectory.scene) * far, _mean_speed(times, states[0])
        return [
            max((_relative([t], abs(t.mid())) for t in trajectory.event_times), default=0.0),
            _relative(x, far),
            _relative(v, _largest(v), slow, max(fast, _mean_speed(times, states[2]))),
            _relative(energies[-1:], _largest(energies), mass * slow * slow / 2, mass * fast * fast / 2),
            _relative(carried[-1:], _largest(carried)),
        ]


def _largest(balls: Any) -> arb:
    """Return the largest midpoint."""
    return max((abs(one.mid()) for one in balls), default=arb(0))


def _mean_speed(times: Any, places: Any) -> arb:
    """Return the largest mean speed between two times, which a speed on the way attains, from below."""
    found = [(gone / lasted).abs_lower() for gone, lasted in zip(np.diff(places), np.diff(times), strict=False)]
    return max((one for one in found if one.is_finite()), default=arb(0))


def _relative(balls: Any, size: arb, scale: arb | None = None, on_the_way: arb | None = None) -> float:
    """Return the largest radius relative to a size, or as `moved` to a scale; inf of what is not finite."""
    if not all(one.is_finite() for one in balls):
        return math.inf
    error = max((one.rad() for one in balls), default=arb(0))
    if error.is_zero():
        return 0.0
    largest = size if on_the_way is None else max(size, on_the_way)
    found = float((error / largest).upper()) if error < largest else math.inf
    if scale is not None and not error < size and 10_000 * error < scale:
        return min(found, float((error / scale).upper()) ** 0.25)
    return found


def _right(error: float) -> int:
    """Return how many digits a relative error leaves right."""
    return (math.floor(-math.log10(error)) if error > 0 else EXACT) if error < 1 else 0


def accuracy_of(trajectory: Any, found: Judged) -> Accuracy:
    """Return the bounds of a trajectory in SI units, of which `judged` are some; binary64, whatever its numbers are."""
    if not trajectory.bounded:
        return _radii(trajectory, found.digits)
    record, (energy, excess, digits, _) = trajectory.record, found
    late = record.rows[trajectory.event_rows, AT["late"]] + 4 * ROUNDING * trajectory.event_times
    errors, end = record.rows[trajectory.event_rows, _STATE_ERRORS], record.end[_STATE_ERRORS]
    return Accuracy(late, errors, end, energy, excess, trajectory.certain, digits, partial(_off_in_ledger, trajectory))


def _radii(trajectory: Any, digits: int) -> Accuracy:
    """Return the radii of balls, rounded upwards."""
    with trajectory.context():
        *final, energy = trajectory.end_numbers()[:5]
        excess = trajectory.end_numbers()[5:] or (arb("nan"),)
        some = trajectory.event_times, trajectory.event_states.T, final, [energy, excess[0]]
        t, y, ends, others = (_radii_of(one) for one in some)
    off_energy, off_excess = others.tolist()
    return Accuracy(t, y, ends, off_energy, off_excess, True, digits, partial(_off_in_ledger, trajectory))


def _off_in_ledger(trajectory: Any) -> float:
    """Return the bound on what a run says that friction and damper took, J."""
    if trajectory.bounded:
        return float(2 * trajectory.ledger.error)
    with trajectory.context():
        return float(_radii_of(trajectory.dissipated))


_radii_of = np.vectorize(lambda x: 0.0 if x.is_exact() else math.nextafter(float(x.rad()), math.inf), otypes=[float])
