"""Our own methods as contenders: the only place where the trade knows which functions we offer."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.comparison import as_fraction
from numerics.scene import Scene
from numerics.solve import ArithmeticName, solve
from numerics.trade.outcome import Outcome, float_text, letters
from numerics.trajectory import Trajectory

DIGITS = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0)
_SPARE_DIGITS = 30
Solved = tuple[Trajectory, tuple[Any, ...], Any]
"""A trajectory with its final state and the energy it lost: all that is judged, computed while the clock runs."""


def our_contenders() -> list[Any]:
    """Return our methods: the compiled and the pure float64 path, mpmath, and balls."""
    return [CompiledFloat(), PureFloat(), Digits("mpmath"), Digits("ball")]


class PureFloat:
    """solve(scene, arithmetic="float64")."""

    label = name = "float64, pure Python"
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


class CompiledFloat:
    """The compiled float64 path of numerics/batch.py, where numba is installed."""

    label = name = "float64, compiled"
    use, knob, ours = "", "bits", True
    settings: tuple[float, ...] = (53.0,)

    def missing(self) -> str | None:
        """Return what the compiled path needs, or that this version has none."""
        if importlib.util.find_spec("numerics.batch") is None:
            return "a compiled path, which this version does not have yet"
        if importlib.util.find_spec("numba") is None:
            return "numba: pip install 'inertial-pair[compiled]'"
        return None

    def prepare(self, scene: Scene, setting: float) -> Callable[[], Any]:
        """Compile, and return the solve that is timed."""
        raise NotImplementedError("numerics.batch is not joined to the trade yet")

    def outcome(self, run: Any) -> Outcome:
        """Return a solve as text."""
        raise NotImplementedError("numerics.batch is not joined to the trade yet")


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


def compiled_contender() -> str:
    """Return the label of the contender whose events are set beside a compiled sine-cosine pair."""
    return CompiledFloat.label


def batch_call(scene: Scene, size: int, cores: int) -> Callable[[], object] | None:  # noqa: ARG001
    """Return a call that solves `size` copies of a scene in one batch on so many cores; None if there is no batch."""
    return None
