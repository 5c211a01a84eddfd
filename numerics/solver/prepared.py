"""A solver for one pair and many starts, for people who call it in their own loops."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.double_double import nearest
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.telling import can_compile
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
_ROW, _END = row_length(1), end_length(1)
_STATE, _UNTIL = slice(8, 16), slice(16, 18)
"""Where the halves of the initial state and of the horizon stand in a row (motion/start.py, SI)."""


class Solver:
    """`solver = Solver(pair)`, then `solver(state, until)`: the Trajectory in float64, with the bits of `solve`.

    The pair is read once, and numba loaded if it is installed; what is left is one compiled call.

    >>> solver = Solver(Pair(m1=1, m2=1, a2=200, b="0.5"))
    >>> solver(State(v1="0.15"), until=5).modes[-1].value
    'stick'
    >>> solver((0.0, 0.15, 0.0, 0.0), until=5).modes[-1].value
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
        self._room, self._until = 64, (None, Fraction(0), (0.0, 0.0))
        self._solve = run_telling(FLOAT64, is_damped=pair.a1 > 0).compiled(solve_row) if can_compile() else None

    def __call__(self, state: State | Sequence[float], until: Exact) -> Trajectory:
        """Solve from a state up to `until` (s).

        A State holds exact decimals; four floats x1, v1, x2, v2 (m, m/s) are taken as the binary numbers that they are,
        as in `solve_many`, and that is quicker: a loop that makes its states itself should give floats. Raises
        InvalidScene, OutOfRange.
        """
        if self._until[0] is not until:
            self._until = self._read(until)
        row, room = self._row, self._room
        if self._solve is None or row is None or not self._place(state, row):
            return run_scene(self._scene(state), _FLOAT64, self.max_events)
        row[_UNTIL] = self._until[2]
        rows, end = np.empty((room, _ROW)), np.empty(_END)
        count = self._solve(row, self._literal, self.max_events, rows, end)
        if not 0 <= count <= room or end[0] == OUT_OF_RANGE:
            self._room = max(room, count)
            return run_scene(self._scene(state), _FLOAT64, self.max_events)
        return Trajectory(partial(self._scene, state), _FLOAT64, Record(rows[:count], end, 1), bounded=True)

    def _place(self, state: State | Sequence[float], row: NDArray[np.float64]) -> bool:
        """Write a state into the row; False where it must be converted exactly."""
        if isinstance(state, State):
            if state.row is None:
                numbers = (state.x1, state.v1, state.x2, state.v2)
                halves = [half for number in numbers for half in nearest(number)]
                same = halves[2:4] == halves[6:8]
                object.__setattr__(state, "row", (np.array(halves) if same == (state.v1 == state.v2) else None,))
            if state.row[0] is None:
                return False
            row[_STATE] = state.row[0]
            return True
        x1, v1, x2, v2 = _four(state)
        row[_STATE] = x1, 0.0, v1, 0.0, x2, 0.0, v2, 0.0
        return isfinite(x1 + v1 + x2 + v2)

    def _scene(self, state: State | Sequence[float]) -> Scene:
        """Return the scene from here on, exact."""
        if not isinstance(state, State):
            x1, v1, x2, v2 = _four(state)
            if not isfinite(x1 + v1 + x2 + v2):
                raise InvalidScene(f"the state {(x1, v1, x2, v2)} must be finite; correct it")
            state = State(Fraction(x1), Fraction(v1), Fraction(x2), Fraction(v2))
        return Scene.of(self.pair, state, self._until[1], self.law)

    @staticmethod
    def _read(until: Exact) -> tuple[Any, Fraction, Any]:
        exact = exact_decimal(until, "until")
        if exact <= 0:
            raise InvalidScene(f"until = {float(exact):g} must be > 0; give the horizon in seconds")
        return until, exact, nearest(exact)


def _four(state: Any) -> tuple[float, float, float, float]:
    """Return x1, v1, x2, v2 as floats."""
    try:
        x1, v1, x2, v2 = state
        return float(x1), float(v1), float(x2), float(v2)
    except (TypeError, ValueError):
        shown = type(state).__name__
        raise InvalidScene(f"a Solver takes a State or four floats x1, v1, x2, v2, not a {shown}") from None
