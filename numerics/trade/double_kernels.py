"""The double-double kernels as a contender: one row of numbers in, events and the end in high and low halves out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np

from numerics.arithmetic.double_double import exactly
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.double_packed import ANSWER, STATE, run_one
from numerics.kernel.double_state import COLUMNS
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode, event_kind
from numerics.old.binary64 import mode_of
from numerics.old.double_double import double_start
from numerics.scene import Scene
from numerics.trade.comparisons.peer import Unsupported
from numerics.trade.outcome import Outcome, letters

DOUBLE_COMPILED = "double-double, compiled"
_MOST_EVENTS = 10**7
_DIGITS = 50
_TAU, _SPENT = COLUMNS.index("tau"), 11


@dataclass(frozen=True, slots=True)
class Halves:
    """Where the kernels leave their answers, and what is needed to read them."""

    frame: Frame
    first_mode: Mode
    rows: Any
    end: Any


class DoubleKernels:
    """The double-double kernels, compiled by numba, every event recorded (a1 = 0).

    The exact conversion of the scene comes before the clock, as a peer's preparation does.
    """

    label = name = DOUBLE_COMPILED
    use, knob, ours = "", "bits", True
    settings: tuple[float, ...] = (106.0,)

    def missing(self) -> str | None:
        """Return what the compiled path needs."""
        return None if can_compile() else "numba: pip install 'inertial-pair[compiled]'"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], tuple[int, Halves]]:  # noqa: ARG002
        """Compile, count the events, and return the run that is timed."""
        if scene.pair.a1 > 0:
            raise Unsupported("these kernels are for a1 = 0")
        frame, motion, first = double_start(scene)
        run, state, end = compiled(run_one), np.empty(STATE), np.empty(ANSWER)
        count = run(first, state, _MOST_EVENTS, np.empty((0, len(COLUMNS))), end)
        rows = np.empty((count + 1, len(COLUMNS)))
        left = Halves(frame, motion.mode, rows, end)
        return lambda: (run(first, state, _MOST_EVENTS, rows, end), left)

    def outcome(self, run: tuple[int, Halves]) -> Outcome:
        """Return a run as text."""
        count, left = run
        frame, end, rows = left.frame, left.end.tolist(), left.rows[:count]
        modes = [mode_of(code) for code in rows[:, 0]]
        kinds = [event_kind(before, after) for before, after in zip([left.first_mode, *modes], modes, strict=False)]
        times = rows[:, _TAU] / float(frame.rate)
        X, V1, V2, Z, w, spent = (exactly(end[at], end[at + 1]) for at in range(1, _SPENT + 1, 2))
        with frame.arithmetic.context():
            final = frame.si_state(ReducedState(X, V1, V2, Z, w))
            last = frame.si_time(exactly(*rows[-1, _TAU : _TAU + 2].tolist())) if count else None
            dissipated = frame.critical_energy * spent
        return Outcome(
            kinds=letters(kinds),
            times=times.tolist(),
            last_event=None if last is None else _text(last),
            final=[_text(value) for value in final],
            dissipated=_text(dissipated),
            steps=count,
        )


def _text(value: Any) -> str:
    with mpmath.workdps(_DIGITS):
        return str(mpmath.nstr(value, _DIGITS))
