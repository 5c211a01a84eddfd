"""A run that is over: its record, how it ended, and what it is compared, pickled and shown by."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, Self

from numerics.arithmetic.by_name import arithmetic_named
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.motion.begin import Begun, begin
from numerics.motion.codes import EVENT_LIMIT, STUCK
from numerics.motion.frame import Frame
from numerics.scene import Scene
from numerics.trajectory.digits import Accuracy, bounds_in_si
from numerics.trajectory.pickled import plain, restored
from numerics.trajectory.record import Record
from numerics.trajectory.status import Status
from numerics.trajectory.summary import summary


class Run:
    """A scene, the arithmetic it was solved in, and the record of the run. Equal if every number is."""

    def __init__(
        self,
        scene: Scene | Callable[[], Scene],
        arithmetic: Arithmetic,
        record: Any,
        *,
        bounded: bool,
        digits: int | None = None,
        tried: str = "",
        t_eval: Any = None,
    ) -> None:
        """Keep what a run wrote. `bounded`: it carried error bounds; `digits`: right digits that were asked for and

        reached; `tried`: why the arithmetic was chosen, where `solve` chose it.
        """
        self._given, self.arithmetic, self.record = scene, arithmetic, record
        self.bounded, self.digits, self.tried, self.t_eval = bounded, digits, tried, t_eval

    def but(self, **changed: Any) -> Self:
        """Return the same trajectory with other `digits`, `tried` or `t_eval`."""
        kept = {name: getattr(self, name) for name in ("bounded", "digits", "tried", "t_eval")}
        return type(self)(self._given, self.arithmetic, self.record, **(kept | changed))

    @cached_property
    def scene(self) -> Scene:
        """Return the scene; a prepared solver makes it when it is looked at."""
        return self._given if isinstance(self._given, Scene) else self._given()

    @property
    def certain(self) -> bool:
        """Return whether the error bounds leave no doubt about the sequence of events; without bounds True."""
        return not self.bounded or self.record.end_code("certain") == 1.0

    @property
    def right_digits(self) -> int:
        """Return how many digits of every number its error bounds leave right."""
        return int(self.record.end_code("digits"))

    @property
    def reached(self) -> bool:
        """Return whether the run got to its horizon."""
        return self.record.end_code("how") != EVENT_LIMIT

    @property
    def status(self) -> Status:
        """Return how the solve ended."""
        if not self.reached:
            return Status.EVENT_LIMIT
        if not self.certain:
            return Status.SEQUENCE_OPEN
        return Status.STUCK_FOR_EVER if self.record.end_code("how") == STUCK else Status.REACHED_HORIZON

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached, by events that are certain."""
        return self.status.success

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended, and whether the phase was lost on the way to the end."""
        if not self.phase_lost:
            return self.status.sentence
        return (
            f"{self.status.sentence}; {self.arithmetic.digits} digits keep no phase over the last segment: at the end "
            'the mode and the energy are known, x1, v1, x2 and v2 are not; use arithmetic="ball"'
        )

    @property
    def phase_lost(self) -> bool:
        """Return whether the last segment turns through more radians than a point arithmetic has digits for."""
        if self.arithmetic.name == "ball":
            return False
        number, length = self.arithmetic.to_float, self.record.end("length")
        if length <= 10 ** (self.arithmetic.digits - 3):
            return False
        # e^(-zeta length) is no rounding yet
        return bool(number(self.frame.two_zeta * length) < 5 * self.arithmetic.digits)

    @cached_property
    def units(self) -> tuple[Number, Number, Number]:
        """Return L (m), Omega (1/s) and E_cr (J)."""
        end = self.record.end
        return end("length_unit"), end("rate"), end("energy_unit")

    @cached_property
    def frame(self) -> Frame:
        """Return the constants of the pair, between SI units and reduced coordinates."""
        with self.arithmetic.context():
            return Frame(self.arithmetic, self.scene.pair)

    @cached_property
    def begun(self) -> Begun:
        """Return the pair and the first motion, in numbers of the arithmetic."""
        with self.arithmetic.context():
            return begin(self.scene, self.arithmetic)

    @cached_property
    def signs(self) -> list[float]:
        """Return the sign of v1 - v2 in every segment, and in the motion after the last event."""
        return [self.record.end_code("first_mode"), *self.record.codes("mode").tolist()]

    @cached_property
    def accuracy(self) -> Accuracy | None:
        """Return the error bounds of a float64 or double-double trajectory, else None (balls carry their own)."""
        return bounds_in_si(self) if self.bounded else None

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        return isinstance(other, Run) and self.__getstate__() == other.__getstate__()

    __hash__ = None  # type: ignore[assignment]

    def __getstate__(self) -> tuple[Any, ...]:
        """Return what is pickled: the scene and what the run wrote, without what was made of it since."""
        arithmetic = self.arithmetic.name, self.arithmetic.digits
        times = None if self.t_eval is None else plain(tuple(self.t_eval))
        return self.scene, arithmetic, self.record.plain(), self.bounded, self.digits, self.tried, times

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Restore a pickled trajectory."""
        scene, (name, digits), record, bounded, asked, tried, t_eval = state
        arithmetic, record = arithmetic_named(name, digits), self.restored_record(record)
        self.__init__(  # type: ignore[misc]
            scene, arithmetic, record, bounded=bounded, digits=asked, tried=tried, t_eval=restored(t_eval)
        )

    @staticmethod
    def restored_record(parts: tuple[Any, ...]) -> Any:
        """Return the record from its plain form."""
        return Record.restored(*parts)

    def __repr__(self) -> str:
        """Return a short summary, as SciPy's solutions have."""
        return "\n".join(f"{name:>12}: {value}" for name, value in summary(self).items())

    def _repr_html_(self) -> str:
        """Return the same as a small table, for notebooks."""
        cells = "".join(f"<tr><th>{name}</th><td>{value}</td></tr>" for name, value in summary(self).items())
        return f"<table>{cells}</table>"
