"""How many digits are right: read off the radii of balls, or off the error bounds that the kernels carry."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic.protocol import Number
from numerics.kernel.bounds import ULP
from numerics.kernel.double_state import UNIT
from numerics.kernel.state import End
from numerics.motion.frame import ReducedState
from numerics.trajectory.trajectory import Trajectory

_SUBNORMAL, _TINY = 1e-290, 2.0**-1060
"""Below the first, products lose digits to underflow; never more than the second."""
EXACT = 10**9
"""Stands for "all digits": the number is exact."""
_ZERO = -EXACT
"""Stands for "it contains 0"."""


def digits_within(error: arb, value: arb, scale: arb) -> int:
    """Return how many leading digits an error leaves right, relative to |value|.

    A value that may be 0 has none, unless it is below 10^(-4 n) of its `scale`: then it counts as 0 to n digits.
    """
    if error.is_zero():
        return EXACT
    if not (error.is_finite() and value.is_finite()):
        return 0
    size = scale if value.contains(0) else abs(value)
    ratio = error.upper() / size.lower()
    if not ratio > 0 or not ratio.is_finite():
        return 0
    # log10 through exponent and mantissa: the ratio itself may be far below the range of a float
    digits = max(0, math.floor(-float((ratio.log() / arb(10).log()).mid())))
    return digits // 4 if value.contains(0) else digits


def proved_digits(trajectory: Trajectory) -> int:
    """Return the right digits that every event (t, x1, v1, x2, v2) and the final state and energy have; for balls."""
    with trajectory.arithmetic.context():
        values = list(checked_values(trajectory))
        # the count of accurate bits is quick to have, and within two bits of the logarithm: only the worst are
        # measured, beside every ball that contains 0, of which it says nothing
        bits = [_ZERO if value.contains(0) else value.rel_accuracy_bits() for value, _ in values]
        close = min((count for count in bits if count != _ZERO), default=0) + 4
        worst = [one for one, count in zip(values, bits, strict=True) if count <= close]
        return min(digits_within(value.rad(), value, scale) for value, scale in worst)


def checked_values(trajectory: Trajectory) -> Iterator[tuple[Number, Number]]:
    """Yield every number a trajectory states, with the scale to which an exact zero is compared."""
    frame = trajectory.frame
    position, speed = frame.length, frame.speed
    for event in trajectory.events:
        yield event.t, event.t
        yield from zip(event.y, (position, speed, position, speed), strict=True)
    final: ReducedState = trajectory.final
    yield from zip(frame.si_state(final), (position, speed, position, speed), strict=True)
    yield frame.energy(final), frame.critical_energy
    yield final.w, frame.arithmetic.number(1)


@dataclass(frozen=True)
class Accuracy:
    """Error bounds of a float64 or double-double trajectory in SI units: what rounding can have done at each event.

    `t` (k,) s and `y` (k, 4) at the events, `final` (4,), `energy` and `dissipated` (J) and `energy_excess` at the end.
    They are first-order bounds with slack, not proofs; `certain` says that no bound reaches as far as another sequence
    of events. `digits` is the least number of right digits of any of these, relative to each value; 0 if not certain.
    """

    t: NDArray[np.float64]
    y: NDArray[np.float64]
    final: NDArray[np.float64]
    energy: float
    energy_excess: float
    dissipated: float
    certain: bool
    digits: int

    @property
    def bounded(self) -> bool:
        """Return whether the sequence of events is certain and every bound a number."""
        bounds = [*self.t, *self.y.ravel(), *self.final, self.energy, self.energy_excess, self.dissipated]
        return self.certain and bool(np.all(np.isfinite(bounds)))


def kernel_accuracy(trajectory: Trajectory) -> Accuracy:
    """Return the bounds of a trajectory of the kernels in SI units; they are binary64, whatever its numbers are."""
    assert trajectory.bounds is not None
    frame, (events, end, damped) = trajectory.frame, trajectory.bounds
    (rounding, most), number = rounding_of(trajectory), frame.arithmetic.to_float
    rate, position, speed = number(frame.rate), number(frame.length), number(frame.speed)
    values = np.array([(event.t, *event.y) for event in trajectory.events], dtype=float).reshape(-1, 5)
    late, x, v, place = np.asarray(events).T
    reduced = np.stack([late / rate, position * x, speed * v, position * (x + place), speed * v], axis=1)
    errors = reduced + 8 * rounding * abs(values) + _underflow(reduced, values)
    with frame.arithmetic.context():
        final = np.array(frame.si_state(trajectory.final), dtype=float)
        energy, unit = number(frame.energy(trajectory.final)), number(frame.critical_energy)
    reduced_end = (position * end.x_error, speed * end.v1_error, position * (end.x_error + end.place_error))
    final_errors = np.array([*reduced_end, speed * end.v2_error]) + 8 * rounding * abs(final)
    final_errors += _underflow(final_errors, final)
    # of E = E_cr (1 + w) the state forms the left side, and w stands beside it: both bound its error
    energy_error = unit * min(end.w_error + 16 * rounding * abs(end.w), _energy_error(end, number(frame.q)))
    energy_error += 16 * rounding * energy + (_TINY if energy or energy_error else 0.0)
    excess_error = end.w_error + 4 * rounding * abs(end.w)
    shown = np.concatenate([values.ravel(), final, [energy, end.w]])
    bounds = np.concatenate([errors.ravel(), final_errors, [energy_error, excess_error]])
    digits = _right_digits(bounds, shown, most) if end.certain else 0
    dissipated = unit * (end.spent_error + damped + 16 * rounding * end.spent)
    dissipated += _TINY if dissipated > 0 or end.spent > 0 else 0.0
    return Accuracy(
        errors[:, 0], errors[:, 1:], final_errors, energy_error, excess_error, dissipated, end.certain, digits
    )


def _energy_error(end: End, q: float) -> float:
    """Return a bound on the error of X^2 + q V1^2 + r V2^2 from those of the state."""
    parts = ((1.0, end.X, end.x_error), (q, end.V1, end.v1_error), (1 - q, end.V2, end.v2_error))
    return sum(weight * error * (2 * abs(value) + error) for weight, value, error in parts)


def _underflow(errors: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what products with SI units may have lost below the normal numbers; nothing for what is exactly 0."""
    return np.where((abs(values) < _SUBNORMAL) & ((values != 0) | (errors > 0)), _TINY, 0.0)


def rounding_of(trajectory: Trajectory) -> tuple[float, int]:
    """Return the rounding of one operation of the kernels that gave a trajectory, and the most digits they can have."""
    return (ULP, 17) if trajectory.arithmetic.name == "float64" else (UNIT, 31)


def bounded_digits(trajectory: Trajectory) -> int:
    """Return `Accuracy.digits` or less without making the events: from the worst of them, which the kernels keep."""
    assert trajectory.bounds is not None
    frame, end, (rounding, most) = trajectory.frame, trajectory.bounds.end, rounding_of(trajectory)
    if not end.certain:
        return 0
    with frame.arithmetic.context():
        final, number = trajectory.final, frame.arithmetic.to_float
        x2, ratio = number(final.X - final.Z), number(frame.energy_ratio(final.X, final.V1, final.V2))
    errors = np.array(
        [end.x_error, end.v1_error, end.x_error + end.place_error, end.v2_error, end.w_error, end.w_error]
    )
    values = np.array([end.X, end.V1, x2, end.V2, end.w, ratio])
    rounded = np.array([8, 8, 8, 8, 4, 16]) * rounding * abs(values)
    rounded[-1] += 16 * rounding * abs(end.w)
    return _right_digits(np.append(errors + rounded, end.worst), np.append(values, 1.0), most)


def _right_digits(errors: NDArray[np.float64], values: NDArray[np.float64], most: int) -> int:
    """Return how many digits of every value are right; an exact number has all, a 0 that is not exact none."""
    inexact = errors > 0
    with np.errstate(divide="ignore"):
        worst = float(np.max(errors[inexact] / abs(values[inexact]), initial=10.0**-most))
    return max(0, math.floor(-math.log10(worst))) if worst < 1 else 0
