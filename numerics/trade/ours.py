"""Our own methods as contenders: the only place where the trade knows which functions we offer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.batch.batch import solve_many
from numerics.kernel.compilation import can_compile, compiled
from numerics.kernel.packed import ANSWER, STATE, run_in_si, run_one
from numerics.kernel.state import COLUMNS, End
from numerics.motion.frame import Frame
from numerics.motion.modes import Mode, event_kind
from numerics.old.binary64 import kernel_start, mode_of
from numerics.scene import Scene
from numerics.solver.solve import ArithmeticName, solve
from numerics.trade.comparisons.peer import Unsupported
from numerics.trade.double_kernels import DoubleKernels
from numerics.trade.outcome import Outcome, float_text, letters
from numerics.trajectory.comparison import as_fraction
from numerics.trajectory.trajectory import Trajectory

DIGITS = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0)
COMPILED, PLAIN, OBJECTS = "float64, compiled", "float64, pure Python", "float64, Trajectory"
MPMATH: Final = "mpmath"
BALL: Final = "ball"
_SPARE_DIGITS = 30
_MOST_EVENTS = 10**7
Solved = tuple[Trajectory, tuple[Any, ...], Any]
"""A trajectory with its final state and the energy it lost: all that is judged, computed while the clock runs."""


def our_contenders() -> list[Any]:
    """Return our methods, from the fastest to the most digits."""
    return [
        Kernels(compiled=True),
        Kernels(compiled=False),
        FloatTrajectory(),
        DoubleKernels(),
        Digits(MPMATH),
        Digits(BALL),
    ]


class Kernels:
    """The float64 kernels on one row of numbers, every event recorded: compiled by numba, or as plain Python.

    The exact conversion of the scene, and the room for its events, come before the clock, as a peer's preparation does;
    the run ends with times, positions and velocities in SI units.
    """

    use, knob, ours = "", "bits", True
    settings: tuple[float, ...] = (53.0,)

    def __init__(self, compiled: bool) -> None:
        """Choose how the kernels run."""
        self.compiled = compiled
        self.label = self.name = COMPILED if compiled else PLAIN

    def missing(self) -> str | None:
        """Return what the compiled path needs."""
        return "numba: pip install 'inertial-pair[compiled]'" if self.compiled and not can_compile() else None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], tuple[int, Arrays]]:  # noqa: ARG002
        """Compile, count the events, and return the run that is timed."""
        if scene.pair.a1 > 0:
            raise Unsupported("these kernels are for a1 = 0")
        frame, motion, start = kernel_start(scene)
        run, once = (compiled(run_in_si), compiled(run_one)) if self.compiled else (run_in_si, run_one)
        units = np.array([frame.length, frame.rate])
        first, state, end, units = (self._row(row) for row in (start, np.empty(STATE), np.empty(ANSWER), units))
        count = once(first, state, _MOST_EVENTS, np.empty((0, len(COLUMNS))), end)
        rows, si = np.empty((count + 1, len(COLUMNS))), np.empty((count + 1, 4))
        left = Arrays(frame, motion.mode, rows, end, si)
        return lambda: (run(first, state, _MOST_EVENTS, rows, end, units, si), left)

    def _row(self, row: Any) -> Any:
        """Return a row for compiled code, or as a list: NumPy's floats would slow plain Python down."""
        return row if self.compiled else row.tolist()

    def outcome(self, run: tuple[int, Arrays]) -> Outcome:
        """Return a run as text."""
        count, left = run
        frame, end = left.frame, dict(zip((*End._fields, "events", "how", "tau"), left.end, strict=True))
        times = left.si[:count, 0].tolist()
        modes = [mode_of(code) for code in left.rows[:count, COLUMNS.index("mode")]]
        kinds = [event_kind(before, after) for before, after in zip([left.first_mode, *modes], modes, strict=False)]
        return Outcome(
            kinds=letters(kinds),
            times=times,
            last_event=float_text(times[-1]) if times else None,
            final=[float_text(value) for value in left.si[count].tolist()],
            dissipated=float_text(frame.critical_energy * float(end["spent"])),
            steps=count,
        )


@dataclass(frozen=True, slots=True)
class Arrays:
    """Where the kernels leave their answers, and what is needed to read them."""

    frame: Frame
    first_mode: Mode
    rows: Any
    end: Any
    si: Any


class FloatTrajectory:
    """solve(scene): from exact decimals to a Trajectory of Python objects, with its ledger."""

    label = name = OBJECTS
    use, knob, ours = "", "bits", True
    settings: tuple[float, ...] = (53.0,)

    def missing(self) -> str | None:
        """Return None: it is always there."""
        return None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Solved]:  # noqa: ARG002
        """Return the solve that is timed."""
        return lambda: solved(scene, "float64", None)

    def outcome(self, run: Solved) -> Outcome:
        """Return a solve as text."""
        return solved_outcome(run)


class Digits:
    """solve(scene, digits=N) in mpmath or in balls."""

    use, knob, ours, settings = "", "digits", True, DIGITS

    def __init__(self, arithmetic: ArithmeticName) -> None:
        """Choose the arithmetic."""
        self.label = self.name = arithmetic

    def missing(self) -> str | None:
        """Return None: it is always there."""
        return None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Solved]:
        """Return the solve that is timed."""
        arithmetic = self.name
        return lambda: solved(scene, arithmetic, int(setting))

    def outcome(self, run: Solved) -> Outcome:
        """Return a solve as text; of a ball its middle, which is then judged like a peer's number."""
        return solved_outcome(run)


def solved(scene: Scene, arithmetic: ArithmeticName, digits: int | None) -> Solved:
    """Solve a scene with everything that is judged: events, final state, and dissipated energy from its ledger.

    The ledger adds what each slip takes; the difference of the energies would cancel close to the critical orbit.
    """
    trajectory = solve(scene, arithmetic=arithmetic, digits=digits, max_events=10**7)
    final, ledger = trajectory.final, trajectory.ledger
    with trajectory.arithmetic.context():
        return trajectory, trajectory.frame.si_state(final), ledger.friction + ledger.viscous


def solved_outcome(run: Solved, write: Callable[[Any, int], str] | None = None) -> Outcome:
    """Return a solve as text; `write(number, digits)` is how its numbers are written."""
    trajectory, final, dissipated = run
    arithmetic, events = trajectory.arithmetic, trajectory.events
    texts = write or number_text
    with arithmetic.context():
        digits = arithmetic.digits + _SPARE_DIGITS
        return Outcome(
            kinds=letters(trajectory.event_kinds),
            times=[arithmetic.to_float(event.t) for event in events],
            last_event=texts(events[-1].t, digits) if events else None,
            final=[texts(value, digits) for value in final],
            dissipated=texts(dissipated, digits),
            steps=len(events),
        )


def number_text(value: Any, digits: int) -> str:
    """Return a float exactly, an mpmath number or the middle of a ball with this many digits."""
    if isinstance(value, float):
        return float_text(value)
    if not isinstance(value, arb):
        exact = as_fraction(value)
        with Ball(digits).context():
            value = arb(exact.numerator) / arb(exact.denominator)
    return str(value.mid().str(digits, radius=False))


def batch_call(scene: Scene, size: int, cores: int) -> Callable[[], object] | None:
    """Return a call that solves `size` copies of a scene in one batch on so many cores; None without numba."""
    if not can_compile():
        return None
    pair, at = scene.pair, scene.initial
    m1, m2, a2, b = (float(one) for one in (pair.m1, pair.m2, pair.a2, pair.b))
    x1, x2, v2, until = (float(one) for one in (at.x1, at.x2, at.v2, scene.until))
    v1 = np.full(size, float(at.v1))
    return lambda: solve_many(m1, m2, a2, b, x1=x1, v1=v1, x2=x2, v2=v2, until=until, jobs=cores)
