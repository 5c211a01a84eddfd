"""A solver for one pair and many starts, for people who call it in their own loops."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from numerics.arithmetic.double_double import nearest
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.telling import compiles_now
from numerics.errors import InvalidScene
from numerics.motion.begin import si_numbers
from numerics.motion.codes import OUT_OF_RANGE
from numerics.run.families import run_telling
from numerics.run.one import MAX_EVENTS, halved, run_scene
from numerics.run.row import solve_row
from numerics.scene import Law, Pair, Scene, State, read_law
from numerics.scene.decimals import Exact, exact_decimal, require_whole
from numerics.trajectory.record import Record, end_length, row_length
from numerics.trajectory.trajectory import Trajectory

_FLOAT64 = Float64()
_STATE, _UNTIL = slice(8, 16), slice(16, 18)
"""Where the halves of the initial state and of the horizon stand in a row (motion/start.py, SI)."""


class Solver:
    """`solver = Solver(pair)`, then `solver(state, until)`: the Trajectory in float64, with the bits of `solve`.

    The pair is read once; what is left is one compiled call. Without numba it solves scene by scene, in Python.

    >>> solver = Solver(Pair(m1=1, m2=1, a2=200, b="0.5"))
    >>> solver(State(v1="0.15"), until=5).modes[-1].value
    'stick'
    """

    def __init__(self, pair: Pair, law: Law | str = Law.FILIPPOV, *, max_events: int = MAX_EVENTS) -> None:
        """Read the pair. Raises InvalidScene, ValueError."""
        if not isinstance(pair, Pair):
            raise InvalidScene(f"a Solver takes a Pair, not a {type(pair).__name__}; build Pair(m1=..., m2=..., ...)")
        require_whole("max_events", max_events, 1)
        self.pair, self.law, self.max_events = pair, read_law(law), max_events
        self._literal = self.law is Law.THREE_VALUED_SGN
        self._row = halved(si_numbers(Scene(pair, State(), 1, self.law)))
        self._telling, self._room = run_telling(FLOAT64, is_damped=pair.a1 > 0), 64
        self._until: tuple[Any, Fraction, Any] = (None, Fraction(0), None)

    def __call__(self, state: State, until: Exact) -> Trajectory:
        """Solve from a State up to `until` (s), both read as exact decimals. Raises InvalidScene, OutOfRange."""
        if self._until[0] is not until:
            self._until = self._read(until)
        if not isinstance(state, State):
            raise InvalidScene(
                f"a Solver takes a State, not a {type(state).__name__}; build State(x1=..., v1=..., ...)"
            )
        scene = Scene.of(self.pair, state, self._until[1], self.law)
        if state.row is None:
            object.__setattr__(state, "row", (self._state_row(scene),))
        halves = state.row[0]
        if halves is None or self._row is None or not compiles_now():
            return run_scene(scene, _FLOAT64, self.max_events)
        row, length = self._row, self._room
        row[_STATE], row[_UNTIL] = halves, self._until[2]
        rows, end = np.empty((length, row_length(1))), np.empty(end_length(1))
        count = self._telling.compiled(solve_row)(row, self._literal, self.max_events, rows, end)
        if not 0 <= count <= length or end[0] == OUT_OF_RANGE:
            self._room = max(length, count)
            return run_scene(scene, _FLOAT64, self.max_events)
        return Trajectory(scene, _FLOAT64, Record(rows[:count], end, 1), bounded=True)

    @staticmethod
    def _state_row(scene: Scene) -> Any:
        halves = halved(si_numbers(scene))
        return None if halves is None else halves[_STATE]

    @staticmethod
    def _read(until: Exact) -> tuple[Any, Fraction, Any]:
        exact = exact_decimal(until, "until")
        if exact <= 0:
            raise InvalidScene(f"until = {float(exact):g} must be > 0; give the horizon in seconds")
        return until, exact, nearest(exact)
