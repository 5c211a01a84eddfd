"""Our own methods as contenders: the only place where the trade knows which functions we offer.

What a user calls is measured as a user gets it: events, itinerary and final state are read while the clock runs, as a
peer's are. PARTS stand beside: the run inside, which starts from a row of numbers and leaves rows of numbers, and
`solve` whose answer nobody has looked at.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Final

import numpy as np

from numerics.arithmetic.double_numbers import DoubleDouble
from numerics.arithmetic.double_words import DOUBLE_DOUBLE
from numerics.arithmetic.float64 import FLOAT64, Float64
from numerics.arithmetic.protocol import Arithmetic
from numerics.arithmetic.telling import Telling, can_compile
from numerics.batch.answer import Batch
from numerics.batch.batch import solve_many
from numerics.errors import EventUndecided
from numerics.motion.begin import begin, in_halves, si_numbers
from numerics.run.families import run_telling
from numerics.run.forced_loop import run_forced
from numerics.run.one import scene_row
from numerics.run.row import solve_row, solve_start
from numerics.scene import Law, Pair, Scene, State
from numerics.solver.prepared import Solver
from numerics.solver.solve import ArithmeticName, solve
from numerics.trade.comparisons.peer import Unsupported
from numerics.trade.outcome import Outcome, number_text, trajectory_outcome
from numerics.trajectory.record import Record, end_length, row_length
from numerics.trajectory.trajectory import Trajectory

DIGITS = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0)
COMPILED, PLAIN, DOUBLE = "float64, compiled", "float64, pure Python", "double-double, compiled"
SOLVE, READ, TWELVE, PREPARED, MANY = "solve, unread", "solve", "solve, digits=12", "Solver", "solve_many"
MPMATH: Final = "mpmath"
BALL: Final = "ball"
PARTS = frozenset({COMPILED, PLAIN, DOUBLE, SOLVE})
"""Of what a user calls: never what a headline goes by."""
FORCED = frozenset({SOLVE, READ, TWELVE, MPMATH, BALL})
"""Those that take a force."""
MOST_EVENTS = 10**7
_BATCH, _BATCH_EVENTS = 1000, 500_000
"""Scenes in the batch of which one is judged, and the events that they may have together."""


@dataclass(frozen=True)
class Left:
    """What a run left in arrays: a trajectory once somebody asks."""

    scene: Scene
    arithmetic: Arithmetic
    rows: Any
    end: Any
    width: int = 1
    elapsed: float | None = None

    def trajectory(self) -> Trajectory:
        """Return it as a trajectory."""
        rows = np.asarray(self.rows[: int(self.end[1])], dtype=float).reshape(-1, row_length(self.width))
        record = Record(rows, np.asarray(self.end), self.width)
        return Trajectory(self.scene, self.arithmetic, record, bounded=True)


Answer = Trajectory | Left
Call = Callable[[], Answer]


@dataclass(frozen=True)
class Ours:
    """A method of ours: `make(scene, setting)` returns the call that is timed."""

    label: str
    make: Callable[[Scene, float], Call]
    use: str = ""
    knob: str = "bits"
    settings: tuple[float, ...] = (53.0,)
    needs_numba: bool = False
    write: Callable[[Any, int], str] | None = None
    """write(number, digits): how its numbers are written."""
    ours = True

    def takes(self, scene: Scene) -> bool:
        """Return whether it solves a scene: `solve` takes a force, the others are for free pairs."""
        return not scene.is_forced or self.label in FORCED

    @property
    def name(self) -> str:
        """Return its label."""
        return self.label

    def missing(self) -> str | None:
        """Return what the compiled path needs."""
        return "numba: pip install 'inertial-pair[compiled]'" if self.needs_numba and not can_compile() else None

    def prepare(self, scene: Scene, setting: float) -> Call:
        """Bring up compiled code, where there is any, and return the call."""
        if self.knob == "bits" and not scene.is_forced:
            looked_at(inside(FLOAT64, True)(scene, setting)().trajectory())
        elif self.knob == "bits" and can_compile():
            FLOAT64.compiled(run_forced)  # `solve` takes it from then on
            with suppress(EventUndecided):
                self.make(scene, setting)()
        return self.make(scene, setting)

    def outcome(self, run: Answer) -> Outcome:
        """Return a run as text; of a ball its middle, which is then judged like a peer's number."""
        return trajectory_outcome(run if isinstance(run, Trajectory) else run.trajectory(), self.write or number_text)


def our_contenders() -> list[Any]:
    """Return our methods, from the fastest to the most digits."""
    return [
        Ours(COMPILED, inside(FLOAT64, True), "the run inside, rows of numbers in and out", needs_numba=True),
        Ours(PLAIN, inside(FLOAT64, False), "the same by Python"),
        Ours(DOUBLE, inside(DOUBLE_DOUBLE, True), "the same in double-double", "bits", (106.0,), True),
        Ours(SOLVE, solved(None, read=False), "solve(scene), nothing looked at"),
        Ours(READ, solved(None), "solve(scene), then t, y, modes, t_events"),
        Ours(TWELVE, solved(None, 12), "solve(scene, digits=12), then the same"),
        Ours(PREPARED, prepared_call, "Solver(pair)(State(...), until), a new State each time, then the same"),
        Ours(MANY, batch_share, "one scene of a batch of up to 1,000, one core, all events kept", needs_numba=True),
        Ours(MPMATH, solved("mpmath"), "solve(scene, arithmetic=\"mpmath\", digits=N)", "digits", DIGITS),
        Ours(BALL, solved("ball"), "solve(scene, arithmetic=\"ball\", digits=N)", "digits", DIGITS),
    ]  # fmt: skip


def inside(base: Telling, compiled: bool) -> Callable[[Scene, float], Callable[[], Left]]:
    """Return what makes the call of the run inside, in binary64 or double-double; room for events is made before."""
    width, arithmetic = (1, Float64()) if base is FLOAT64 else (2, DoubleDouble())

    def make(scene: Scene, setting: float) -> Callable[[], Left]:  # noqa: ARG001
        telling = run_telling(base, is_damped=scene.pair.a1 > 0)
        tell = telling.compiled if compiled else telling
        end: Any = np.empty(end_length(width))
        none = np.empty((0, row_length(width)))
        given, literal, count = scene_row(scene), scene.law is Law.THREE_VALUED_SGN, -1
        run: Any = tell(solve_row)
        start: Any = (given if given is None or compiled else given.tolist(), literal)
        if width == 1 and given is not None:
            count = run(*start, MOST_EVENTS, none, end)
        if count < 0:  # as `solve` does: from the exact start
            run, start = tell(solve_start), _exact_start(scene, arithmetic)
            count = run(*start, MOST_EVENTS, none, end)
        rows: Any = np.empty((count, row_length(width)))
        if not compiled:  # NumPy's floats would slow plain Python down
            rows, end = rows.tolist(), end.tolist()
        left = Left(scene, arithmetic, rows, end, width)

        def call() -> Left:
            run(*start, MOST_EVENTS, rows, end)
            return left

        return call

    return make


def _exact_start(scene: Scene, arithmetic: Any) -> Any:
    with arithmetic.context():
        begun = begin(scene, arithmetic)
        return begun if arithmetic.name == "float64" else in_halves(begun, arithmetic.halves)


def solved(
    arithmetic: ArithmeticName | None, digits: int | None = None, read: bool = True
) -> Callable[[Scene, float], Call]:
    """Return what makes the call of `solve`; in mpmath and balls its digits are the setting."""

    def make(scene: Scene, setting: float) -> Call:
        asked = digits if arithmetic is None else int(setting)

        def call() -> Trajectory:
            found = solve(scene, arithmetic=arithmetic, digits=asked, max_events=MOST_EVENTS)
            return looked_at(found) if read else found

        return call

    return make


def prepared_call(scene: Scene, setting: float) -> Call:  # noqa: ARG001
    """Return the call of a prepared solver, with a new State each time."""
    solver, at, until = Solver(scene.pair, scene.law, max_events=MOST_EVENTS), scene.initial, scene.until
    return lambda: looked_at(solver(State(at.x1, at.v1, at.x2, at.v2), until))


def batch_share(scene: Scene, setting: float) -> Call:  # noqa: ARG001
    """Return a call of `solve_many` for many copies of a scene, timed by the copy. Raises Unsupported."""
    events = len(solve(scene, max_events=MOST_EVENTS).record)
    size = max(1, min(_BATCH, _BATCH_EVENTS // (events + 1)))
    batch_call(scene, 1, 1)()  # brings up compiled code
    batch = batch_call(scene, size, 1, events)

    def call() -> Left:
        start = time.perf_counter()
        found = batch()
        found.event_t, found.event_y, found.event_mode, found.y, found.dissipated  # noqa: B018 - made when looked at
        return Left(scene, Float64(), found.kept[0], found.ends[0], 1, (time.perf_counter() - start) / size)

    return call


def batch_call(scene: Scene, size: int, cores: int, keep_events: int = 0) -> Callable[[], Batch]:
    """Return a call that solves `size` copies of a scene in one batch. Raises Unsupported.

    A batch reads binary numbers, so it must be the same scene in them, to what float64 can tell.
    """
    numbers = {name: float(value) for name, value in si_numbers(scene)._asdict().items()}
    m1, m2, a2, b, x1, v1, x2, v2, until, a1 = (Fraction(value) for value in numbers.values())
    binary = Scene(Pair(m1, m2, a2, b, a1), State(x1, v1, x2, v2), until, scene.law)
    if abs(binary.energy_excess - scene.energy_excess) > abs(scene.energy_excess) / 10**12:
        raise Unsupported("its decimals are no binary numbers, and next to E_cr those are another scene")
    first = {name: numbers.pop(name) for name in ("m1", "m2", "a2", "b")}
    many: dict[str, Any] = numbers | {"v1": np.full(size, numbers["v1"])}
    return lambda: solve_many(*first.values(), **many, law=scene.law, keep_events=keep_events, jobs=cores)


def looked_at(trajectory: Trajectory) -> Trajectory:
    """Look at what a user looks at, and return the trajectory."""
    trajectory.t, trajectory.y, trajectory.modes, trajectory.t_events  # noqa: B018 - made when looked at
    return trajectory
