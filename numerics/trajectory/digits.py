"""How many digits are right: read off the radii of balls, or off the error bounds that a run carried."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import NDArray

from numerics.arithmetic import double_words, float64
from numerics.arithmetic.protocol import Number

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


def proved_digits(trajectory: Any) -> int:
    """Return the right digits that every event (t, x1, v1, x2, v2) and the final state and energy have; for balls."""
    with trajectory.arithmetic.context():
        values = list(checked_values(trajectory))
        # the count of accurate bits is quick to have, and within two bits of the logarithm: only the worst are
        # measured, beside every ball that contains 0, of which it says nothing
        bits = [_ZERO if value.contains(0) else value.rel_accuracy_bits() for value, _ in values]
        close = min((count for count in bits if count != _ZERO), default=0) + 4
        worst = [one for one, count in zip(values, bits, strict=True) if count <= close]
        return min(digits_within(value.rad(), value, scale) for value, scale in worst)


def checked_values(trajectory: Any) -> Iterator[tuple[Number, Number]]:
    """Yield every number a trajectory states, with the scale to which an exact zero is compared."""
    frame = trajectory.frame
    scales = (frame.length, frame.speed, frame.length, frame.speed)
    for t, y in zip(trajectory.event_times, trajectory.event_states.T, strict=True):
        yield t, t
        yield from zip(y, scales, strict=True)
    final = trajectory.final
    yield from zip(frame.si_state(final), scales, strict=True)
    yield frame.energy(final), frame.critical_energy
    yield final.w, trajectory.arithmetic.number(1)


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


def rounding_of(trajectory: Any) -> tuple[float, int]:
    """Return the rounding of one operation of the run that gave a trajectory, and the most digits it can have."""
    return (float64.UNIT, 17) if trajectory.arithmetic.name == "float64" else (double_words.UNIT, 31)


def bounds_in_si(trajectory: Any) -> Accuracy:
    """Return the bounds of a trajectory in SI units; they are binary64, whatever its numbers are."""
    record, number, (rounding, most) = trajectory.record, trajectory.arithmetic.to_float, rounding_of(trajectory)
    length, rate, unit = (number(one) for one in trajectory.units)
    speed = length * rate
    late, x, v, place = (record.codes(name) for name in ("late", "x", "v", "place"))
    t, y = trajectory.event_times.astype(float), trajectory.event_states.astype(float).T
    t_error, y_error = late / rate, np.stack([length * x, speed * v, length * (x + place), speed * v], axis=1)
    t_error, y_error = (
        errors + 8 * rounding * abs(values) + _underflow(errors, values)
        for errors, values in ((t_error, t), (y_error, y.reshape(-1, 4)))
    )
    final = np.array(trajectory.final_state, dtype=float)
    off = {name: record.end_code(f"{name}_error") for name in ("x", "v1", "v2", "place", "w", "spent", "damped")}
    reduced = np.array([length * off["x"], speed * off["v1"], length * (off["x"] + off["place"]), speed * off["v2"]])
    final_error = reduced + 8 * rounding * abs(final) + _underflow(reduced, final)
    # of E = E_cr (1 + w) the state forms the left side, and w stands beside it: both bound its error
    w, energy = number(trajectory.final.w), number(trajectory.final_energy)
    energy_error = unit * min(off["w"] + 16 * rounding * abs(w), _energy_error(trajectory, off))
    # what decays, or is squared, may be below every number and not be zero
    is_damped, lost = trajectory.scene.pair.a1 > 0, _TINY + 2.0**-1070 * unit
    is_moving = is_damped or bool(final[[0, 1, 3]].any())
    final_error += _TINY + 2.0**-1070 * (length + speed) if is_damped else 0.0
    energy_error += 16 * rounding * energy + (lost if energy or energy_error or is_moving else 0.0)
    taken = number(record.end("spent")) + number(record.end("damped"))
    dissipated = unit * (off["spent"] + off["damped"] + 16 * rounding * taken)
    dissipated += lost if dissipated > 0 or taken > 0 or is_damped else 0.0
    certain = trajectory.certain
    digits = min(most, int(record.end_code("digits"))) if certain else 0
    excess_error = off["w"] + 4 * rounding * abs(w)
    return Accuracy(t_error, y_error, final_error, energy_error, excess_error, dissipated, certain, digits)


def _energy_error(trajectory: Any, off: dict[str, float]) -> float:
    """Return a bound on the error of X^2 + q V1^2 + r V2^2 from those of the state."""
    number, at, q = trajectory.arithmetic.to_float, trajectory.final, float(trajectory.scene.pair.share)
    parts = ((1.0, at.X, off["x"]), (q, at.V1, off["v1"]), (1 - q, at.V2, off["v2"]))
    return sum(weight * error * (2 * abs(number(value)) + error) for weight, value, error in parts)


def _underflow(errors: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what products with SI units may have lost below the normal numbers; nothing for what is exactly 0."""
    return np.where((abs(values) < _SUBNORMAL) & ((values != 0) | (errors > 0)), _TINY, 0.0)
