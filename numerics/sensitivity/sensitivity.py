"""Sensitivities of a solved scene: how its events and its end move with the initial state and the parameters.

The scene is solved once more, over dual numbers: the same algorithm, the same values, and their gradients beside them,
through every event. An initial state with v1 = v2 has neighbours with v1 != v2, which slip:

    stick   the slip has a vanishing length and keeps the momentum: both velocities change by (m1 dv1 + m2 dv2)/M
    slip    from the surface the derivative along v1 - v2 is one-sided: towards the sign of v1 - v2 that follows.
            On the other side the neighbour meets the surface at once, and its bodies share the momentum first

For a1 = 0 the derivative with respect to a1 is one-sided, towards a1 > 0. On the critical orbit (E = E_cr exactly,
stuck for ever) neighbours with more energy slip, by amounts of second order: the derivatives are those of the stuck
pair. Under the law three-valued-sgn a pair that sticks outside the sliding region comes apart on one side of v1 = v2:
then, too, the derivative is the one towards the other side.

Under a force (forced.py) `until` and every number of force and friction are among the parameters, by the names that
forced_parameters.py gives them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.dual_number import DualNumber
from numerics.arithmetic.protocol import Arithmetic, Sign
from numerics.errors import EventUndecided, OutOfRange
from numerics.motion.begin import begin, mode_at_start
from numerics.motion.frame import Frame
from numerics.motion.modes import Mode
from numerics.motion.records import ReducedState
from numerics.run.families import run_telling
from numerics.run.one import run_scene
from numerics.run.row import solve_start
from numerics.run.rows import Growing
from numerics.scene import Pair, Scene, State
from numerics.sensitivity.duals import dual, frozen, unit
from numerics.trajectory.digits import EXACT, digits_within
from numerics.trajectory.record import Record, end_length, row_length
from numerics.trajectory.si_table import si_table
from numerics.trajectory.trajectory import Trajectory

WRT = ("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1")
"""The initial state and the parameters of a free pair, in the order of the last axis of every array."""


@dataclass(frozen=True)
class Sensitivity:
    """Partial derivatives in SI units with respect to `wrt`, the last axis; enclosed, if the trajectory is of balls.

    Float arrays for float64, otherwise object arrays of the arithmetic's numbers.
    """

    wrt: tuple[str, ...]
    t: NDArray[Any]
    """Of the time of every event, shape (k, p), with p = 9 without a force."""
    y: NDArray[Any]
    """Of x1, v1, x2, v2 at every event, shape (k, 4, p): total derivatives, the time of the event moves too."""
    final: NDArray[Any]
    """Of x1, v1, x2, v2 at the fixed horizon, shape (4, p); at the last event if the cap on events ended the run."""
    energy: NDArray[Any]
    """Of the energy there, shape (p,)."""

    def __repr__(self) -> str:
        """Return a short summary."""
        return f"Sensitivity of {len(self.t)} events and the final state by {', '.join(self.wrt)}"

    def _repr_html_(self) -> str:
        """Return the derivatives of the final state as a table, for notebooks."""
        head = "".join(f"<th>by {name}</th>" for name in self.wrt)
        names = ("x1", "v1", "x2", "v2", "energy")
        rows = ""
        for name, row in zip(names, [*self.final, self.energy], strict=True):
            cells = "".join(f"<td>{float(one):.4g}</td>" for one in row)
            rows += f"<tr><th>final {name}</th>{cells}</tr>"
        return f"<table><tr><th></th>{head}</tr>{rows}</table>"


def sensitivities(trajectory: Trajectory) -> Sensitivity:
    """Return the sensitivities of a trajectory, by solving its scene again, at 5 to 15 times the cost.

    Under a force its path is followed once more. In balls the derivatives are enclosed; elsewhere they are approximate.

    It works with the arithmetic and precision of the trajectory. Where balls were asked for N digits the precision is
    raised, at most three times, until the radii are below 10^-N of the largest derivative of the same quantity by the
    same variable.

    Raises EventUndecided if the events are not those of the trajectory, if one falls on the horizon, or if a derivative
    is not enclosed; OutOfRange if one leaves the range of float64; NotDifferentiable, under a force, where a motion has
    no derivative by its data, as where an event falls on a jump (motion/forced_corners.py).
    """
    base = trajectory.arithmetic
    found = _differentiate(trajectory, base)
    if base.name == "ball" and trajectory.digits is not None:
        for _ in range(3):
            missing = trajectory.digits - _proved_digits(found)
            if missing <= 0:
                break
            base = Ball(base.digits + missing + 3)
            found = _differentiate(trajectory, base)
    return found


def _proved_digits(found: Sensitivity) -> int:
    """Return the digits that all derivatives have, relative to the largest by the same variable of t, y or energy."""
    digits = EXACT
    for arrays in ((found.t,), *((found.y[:, k], found.final[k]) for k in range(4)), (found.energy,)):
        for column in np.vstack(arrays).T:
            if len(column):
                radius, largest = max(one.rad() for one in column), max(abs(one).upper() for one in column)
                digits = min(digits, digits_within(radius, largest, largest))
    return digits


def _differentiate(trajectory: Trajectory, base: Arithmetic) -> Sensitivity:
    if trajectory.scene.is_forced:
        return _differentiate_forced(trajectory, base)
    arithmetic, scene = dual(base), differentiable(trajectory.scene)
    with arithmetic.context():
        record = _run(trajectory, scene, arithmetic)
        table = np.empty((5, len(record) + 1 + trajectory.reached), dtype=object)
        si_table(*record.in_numbers(), table, np.empty(len(record) + 2, dtype=np.int64))
        events, final = table[:, 1 : len(record) + 1].T, table[1:, -1]
        at = ReducedState(*(record.end(name) for name in ReducedState._fields))
        energy = Frame(arithmetic, scene.pair).energy(at)

        def gradients(numbers: Any) -> NDArray[Any]:
            zeros = [arithmetic.base.number(0)] * len(WRT)
            return arithmetic.array([zeros if one.gradient is None else one.gradient for one in numbers])

        found = Sensitivity(
            wrt=WRT,
            t=gradients(events[:, 0]).reshape(-1, len(WRT)),
            y=gradients(events[:, 1:].ravel()).reshape(-1, 4, len(WRT)),
            final=gradients(final),
            energy=gradients([energy])[0],
        )
        _require_finite(trajectory, found)
    return found


def _differentiate_forced(trajectory: Trajectory, base: Arithmetic) -> Sensitivity:
    """Return the same under a force, along the trajectory's own path, or along that of another precision."""
    from numerics.sensitivity.forced import derivatives_of

    path: Any = trajectory
    if base is not trajectory.arithmetic:
        path = run_scene(trajectory.scene, base, len(trajectory.record) + trajectory.reached)
        if path.modes != trajectory.modes:
            raise _undecided(trajectory, "are the events those of the trajectory?", f"{len(path.record)} events")
    wrt, t, y, final, energy = derivatives_of(path)
    array = dual(base).array
    found = Sensitivity(wrt, array(t).reshape(-1, len(wrt)), array(y).reshape(-1, 4, len(wrt)), final, energy)
    with base.context():
        _require_finite(trajectory, found)
    return found


def _run(trajectory: Trajectory, scene: Scene, arithmetic: Any) -> Record:
    """Return the record of the same run over dual numbers; raises EventUndecided if its events are others."""
    # one event more than were found shows a lost one
    most, events = len(trajectory.record) + trajectory.reached, len(trajectory.record)
    rows, end = Growing(row_length(1), most), [0.0] * end_length(1)
    told = run_telling(arithmetic.telling, is_damped=trajectory.scene.pair.a1 > 0)
    told(solve_start)(*begin(scene, arithmetic), most, rows, end)
    record = Record(rows.rows, end, 1)
    if len(record) != events or record.codes("mode").tolist() != trajectory.record.codes("mode").tolist():
        raise _undecided(trajectory, "are the events those of the trajectory?", f"{len(record)} events")
    last = record.end("length")
    if trajectory.reached and events and arithmetic.sign(last) is Sign.ZERO:
        raise _undecided(trajectory, "does the last event come before the horizon or after it?", arithmetic.text(last))
    return record


def differentiable(scene: Scene) -> Scene:
    """Return the scene over exact dual numbers: each of `WRT` with its unit vector as gradient."""
    pair, at = scene.pair, scene.initial
    units = {name: unit(index, len(WRT)) for index, name in enumerate(WRT)}
    if mode_at_start(scene) is Mode.STICK:
        units["v1"] = units["v2"] = (units["v1"] * pair.m1 + units["v2"] * pair.m2) / pair.mass
    numbers = {
        name: DualNumber(getattr(pair if hasattr(pair, name) else at, name), unit) for name, unit in units.items()
    }
    made_pair = frozen(Pair, **{name: numbers[name] for name in ("m1", "m2", "a2", "b", "a1")})
    initial = frozen(State, **{name: numbers[name] for name in ("x1", "v1", "x2", "v2")})
    return Scene.of(made_pair, initial, scene.until, scene.law)


def _require_finite(trajectory: Trajectory, found: Sensitivity) -> None:
    arrays = (found.t, found.y, found.final, found.energy)
    if trajectory.arithmetic.name == "float64":
        if not all(np.isfinite(array).all() for array in arrays):
            raise OutOfRange('a derivative left the range of float64 (1e-308 to 1e308); use arithmetic="ball"')
        return
    for one in (one for array in arrays for one in array.flat):
        if not (one.is_finite() if trajectory.arithmetic.name == "ball" else mpmath.isfinite(one)):
            raise _undecided(trajectory, "has the scene this derivative?", trajectory.arithmetic.text(one))


def _undecided(trajectory: Trajectory, question: str, enclosure: str) -> EventUndecided:
    return EventUndecided(question, enclosure, trajectory.arithmetic.digits)
