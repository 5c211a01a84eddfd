"""Derivatives of a solved scene by differences of solves in balls: no derivative is written down here."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from flint import arb, fmpq
from strategies import scaled_speed

from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.derivatives import WRT, Sensitivity
from numerics.trajectory.sensitivity import sensitivities
from numerics.trajectory.trajectory import Trajectory

DIGITS = 70
COORDINATES = ("x1", "v1", "x2", "v2")
STEP = Fraction(1, 10**24)
"""Relative to the natural scale of what is moved."""
SMALLEST = 1e-9
"""Dimensionless derivatives that are all smaller are compared absolutely: they may be 0."""


class Deviation(NamedTuple):
    """The largest deviation of a derivative, relative to the largest of its kind; whether events could be compared."""

    wrt: str
    size: float
    events_compared: bool


def moved(scene: Scene, name: str, by: Fraction) -> Scene:
    """The scene with one number changed."""
    numbers = {key: getattr(scene.pair, key) for key in Pair.__slots__}
    state = {key: getattr(scene.initial, key) for key in COORDINATES}
    target = state if name in state else numbers
    target[name] += by
    return Scene(Pair(**numbers), State(**state), scene.until, scene.law)


def natural_scale(scene: Scene, name: str) -> Fraction:
    """L, L Omega, or the parameter itself; Omega M for a missing damper."""
    pair = scene.pair
    speed = scaled_speed(pair, Fraction(1))
    if name in COORDINATES:
        return pair.half_width if name in {"x1", "x2"} else speed
    return getattr(pair, name) or speed / pair.half_width * pair.mass


def _units(base: Trajectory) -> tuple[arb, ...]:
    frame = base.frame
    return frame.length, frame.speed, frame.length, frame.speed


def numbers(trajectory: Trajectory, base: Trajectory, events: int) -> list[arb]:
    """Final state and the last so many events, in the units of the base."""
    units, frame = _units(base), trajectory.frame
    found = [value / unit for value, unit in zip(frame.si_state(trajectory.final), units, strict=True)]
    for event in trajectory.events[len(trajectory.events) - events :]:
        found += [event.t * base.frame.rate, *(value / unit for value, unit in zip(event.y, units, strict=True))]
    return found


def derivatives(base: Trajectory, found: Sensitivity, name: str, events: int) -> list[arb]:
    """The derivatives of `numbers`, from the sensitivities."""
    units, index = _units(base), WRT.index(name)
    rows = [value / unit for value, unit in zip(found.final[:, index], units, strict=True)]
    for t, y in list(zip(found.t[:, index], found.y[:, :, index], strict=True))[len(found.t) - events :]:
        rows += [t * base.frame.rate, *(value / unit for value, unit in zip(y, units, strict=True))]
    return rows


def deviation(scene: Scene, base: Trajectory, found: Sensitivity, name: str) -> Deviation:
    """Compare one column of the sensitivities with differences of neighbours.

    Where only one side has the same itinerary the difference is one-sided. Neighbours that both start with one short
    slip or stick more are compared from there on; if the itineraries differ otherwise, only the ends are compared.
    """
    scale = natural_scale(scene, name)
    sides = [STEP] if name == "a1" and not scene.pair.a1 else [STEP, -STEP]
    neighbours = [(by, solve(moved(scene, name, by * scale), digits=DIGITS, arithmetic="ball")) for by in sides]
    same = [(by, one) for by, one in neighbours if one.modes == base.modes]
    compared = bool(same) or all(one.modes[1:] == base.modes for _, one in neighbours)
    events = len(base.events) if compared else 0
    with base.arithmetic.context():
        ends = [(by, numbers(one, base, events)) for by, one in same or neighbours]
        if len(ends) == 1:
            ends.append((Fraction(0), numbers(base, base, events)))
        (one, upper), (two, lower) = ends
        ours = [value * ball(scale) for value in derivatives(base, found, name, events)]
        gaps = [abs((up - low) / ball(one - two) - value) for up, low, value in zip(upper, lower, ours, strict=True)]
        largest = max(float(abs(value).upper()) for value in ours)
        size = max(float(gap.upper()) for gap in gaps) / max(largest, SMALLEST)
    return Deviation(name, size, compared)


def ball(value: Fraction) -> arb:
    """An exact rational as a ball."""
    return arb(fmpq(value.numerator, value.denominator))


def deviations(scene: Scene) -> list[Deviation]:
    """All columns."""
    base = solve(scene, digits=DIGITS, arithmetic="ball")
    found = sensitivities(base)
    return [deviation(scene, base, found, name) for name in WRT]
