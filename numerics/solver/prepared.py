"""A solver for one pair and many starts, for people who call it in their own loops."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from math import isfinite
from typing import Any

from numerics.arithmetic.compiled import can_compile
from numerics.arithmetic.float64 import Float64
from numerics.arithmetic.pair import nearest
from numerics.errors import InvalidScene
from numerics.free.engine import run_row, scene_row
from numerics.scene import Law, Pair, Scene, State, read_law
from numerics.scene.decimals import Exact, positive, require_whole, shown
from numerics.scene.model import HORIZON
from numerics.trajectory.run import MAX_EVENTS, free_scene, run_scene
from numerics.trajectory.trajectory import Trajectory

_FLOAT64 = Float64()
Four = tuple[float, float, float, float]
"""x1, v1, x2, v2."""
_STATE, _UNTIL = slice(8, 16), slice(16, 18)
"""Where the halves of the initial state and of the horizon stand in a row of SI numbers."""


class Solver:
    """`solver = Solver(pair)`, then `solver(state, until)`: the Trajectory of solve(scene, arithmetic="float64").

    The pair is read once, and numba loaded if it is installed; of a free pair one compiled call is left.

    >>> solver = Solver(Pair(m1=1, m2=1, a2=200, b="0.5"))
    >>> solver(State(v1="0.15"), until=5).modes[-1].value
    'stick'
    >>> solver((0.0, 0.15, 0.0, 0.0), until=5).modes[-1].value
    'stick'
    """

    def __init__(self, pair: Pair, law: Law | str = Law.FILIPPOV, *, max_events: int = MAX_EVENTS) -> None:
        """Read the pair. Raises InvalidScene, ValueError."""
        if not isinstance(pair, Pair):
            raise InvalidScene(f"a Solver takes a Pair, not {type(pair).__name__}; build Pair(m1=..., m2=..., ...)")
        require_whole("max_events", max_events, 1)
        self.pair, self.law, self.max_events = pair, read_law(law), max_events
        any_scene = Scene(pair, State(), 1, self.law)
        self._row = scene_row(any_scene) if free_scene(any_scene) and can_compile() else None
        self._until: tuple[Any, Fraction, Any] = object(), Fraction(0), None

    def __repr__(self) -> str:
        """Return a short text."""
        return f"Solver({self.pair!r}, law={self.law.value!r})"

    def __call__(self, state: State | Sequence[float], until: Exact) -> Trajectory:
        """Solve from a state up to `until` (s).

        A State holds exact decimals; four floats x1, v1, x2, v2 (m, m/s) are taken as the binary numbers that they are,
        as in `solve_many`, and that is quicker: a loop that makes its states itself should give floats. Raises
        InvalidScene, OutOfRange, EventUndecided.
        """
        horizon = self._until  # as another thread may solve to another
        if horizon[0] is not until:
            end = positive(until, "until", HORIZON)
            self._until = horizon = until, end, nearest(end) if end < 10**300 else None  # which a float holds
        if not isinstance(state, State):
            state = _four(state)  # kept as it is now, whatever becomes of a list or an array
        halves = _halves(state)
        if self._row is not None and halves is not None and horizon[2] is not None:
            row = self._row.copy()
            row[_STATE], row[_UNTIL] = halves, horizon[2]
            found = run_row(row, self.law is Law.THREE_VALUED_SGN, self.max_events)
            if found is not None:
                return Trajectory(partial(self._scene, state, horizon[1]), _FLOAT64, found)
        return run_scene(self._scene(state, horizon[1]), _FLOAT64, self.max_events)

    def _scene(self, state: State | Four, until: Fraction) -> Scene:
        """Return the scene, exact."""
        if not isinstance(state, State):
            state = State(*map(Fraction, state))
        return Scene.of(self.pair, state, until, self.law)


def _halves(state: State | Four) -> list[float] | None:
    """Return a state as high and low halves; None where floats do not hold it, or would make two velocities equal."""
    if not isinstance(state, State):
        return [half for one in state for half in (one, 0.0)]
    try:
        halves = [half for one in (state.x1, state.v1, state.x2, state.v2) for half in nearest(one)]
    except OverflowError:
        return None
    return halves if (halves[2:4] == halves[6:8]) == (state.v1 == state.v2) else None


def _four(state: Any) -> Four:
    """Return x1, v1, x2, v2 as floats."""
    try:
        x1, v1, x2, v2 = map(float, state)
    except (TypeError, ValueError):
        raise InvalidScene(
            f"a Solver takes a State or four floats x1, v1, x2, v2, not {shown(state)}; give those"
        ) from None
    if not isfinite(x1 + v1 + x2 + v2):
        raise InvalidScene(f"the state {(x1, v1, x2, v2)} must be finite; correct it")
    return x1, v1, x2, v2
