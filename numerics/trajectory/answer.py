"""What solved scenes on a line and on a surface answer in the same words: how it ended, events, any time, files."""

from __future__ import annotations

import json
import math
from contextlib import AbstractContextManager
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Literal, Self, TypeVar, overload

import numpy as np
from flint import arb

from numerics.arithmetic.precision import cached_property
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.habits import Helpful
from numerics.linear.modes import EventKind, event_kind, sticking
from numerics.meter import meter
from numerics.scene.decimals import listed, require_one_of, short, shown
from numerics.scene.short_repr import html_table
from numerics.trajectory import export, saved
from numerics.trajectory.columns import STATE, Array, Counts, Floats
from numerics.trajectory.status import Status
from numerics.trajectory.times import exact_time

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike
    from pandas import DataFrame

    from numerics.scene import Scene
    from numerics.scene.decimals import Exact, Quantity, Times
    from numerics.scene.plane import PlaneScene

_AT_ASKED_TIMES = {"_asked", "energy", "energy_excess"}
"""What depends on t_eval, and is made when it is looked at."""
M = TypeVar("M")
"""A mode: on a surface a word."""
Side = Literal["left", "right"]
Kind = Literal["velocities", "positions", "load", "force", "friction", "phase", "relative", "excess", "energy", "above"]


class Answer(Helpful, Generic[M]):
    """A solved scene; two are equal if every number is. States have 4 n rows, x1, v1, x2, v2 by n axes."""

    FORMAT: ClassVar[str]
    """How the header of a file begins."""
    ENERGIES: ClassVar[tuple[str, ...]]
    """Those that a table has."""
    EVENT_COLUMNS: ClassVar[tuple[str, ...]] = ()
    """What an event has besides its time, its modes and its state."""
    _PICTURES: ClassVar[str]
    """The module that draws it."""
    scene: Scene | PlaneScene
    status: Status
    arithmetic: Arithmetic
    bounded: bool
    """Whether its numbers are floats with bounds on their errors."""
    reached: bool
    """Whether the run got to its horizon."""
    end_time: Quantity
    """s"""
    events: tuple[Any, ...]
    event_times: Array
    """Of all events, s, shape (k,)."""
    event_states: Array
    """Of all events, shape (4 n, k)."""
    initial: tuple[Any, ...]
    final_state: tuple[Any, ...]
    _own_rows: Any = None
    """The segments of start, events and end, where they are known."""
    _begun: Any = MappingProxyType({})
    """The times at which pieces of signals begin, as they stand in a run, by their exact values."""
    _all_modes: tuple[M, ...]
    """Those before, between and after all events."""
    digits: int | None = None
    """Right digits that were asked for and reached."""
    tried: str = ""
    """What did not answer."""
    t_eval: Sequence[Exact] | None = None
    _asked: tuple[Array, Array]
    """These times, and the states there."""

    def but(self, **changed: object) -> Self:
        """Return the same trajectory with other `digits`, `tried` or `t_eval`. Raises ValueError for times outside."""
        new = object.__new__(type(self))
        new.__dict__ = {name: value for name, value in vars(self).items() if name not in _AT_ASKED_TIMES} | changed
        if new.t_eval is not None:
            with new.context():
                times = new._times(new.t_eval)
            new._asked = times, new.sol(times)
        return new

    # ------------------------------------------------------------------ events
    @cached_property
    def modes(self) -> tuple[M, ...]:
        """Return the itinerary: the mode of every segment."""
        return self._all_modes if self.reached else self._all_modes[:-1]

    @property
    def final_mode(self) -> M:
        """Return the mode at the end: after the last event, where the cap on events ended the run."""
        return self._all_modes[-1]

    @property
    def event_kinds(self) -> tuple[EventKind, ...]:
        """Return the kinds of the events in their order."""
        return tuple(map(event_kind, self._gained.tolist()))

    @cached_property
    def _gained(self) -> Counts:
        """How much more sticks after each event."""
        known = {mode: sticking(mode) for mode in {*self._all_modes}}
        return np.diff([known[mode] for mode in self._all_modes])

    @property
    def t_events(self) -> tuple[Array, ...]:
        """Return the event times by kind, in the order of EventKind (entry, exit, crossing), each of shape (k,)."""
        return self._by_kind(self.event_times)

    @property
    def y_events(self) -> tuple[Array, ...]:
        """Return the event states by kind, each of shape (k, 4 n)."""
        return self._by_kind(self.event_states.T)

    def _by_kind(self, events: Array) -> tuple[Array, ...]:
        gained = self._gained
        return events[gained > 0], events[gained < 0], events[gained == 0]

    # ------------------------------------------------------------------ at t
    @property
    def t(self) -> Array:
        """Return the times of start, events and end, or t_eval, s, shape (m,)."""
        return (self._own_moments if self.t_eval is None else self._asked)[0]

    @property
    def y(self) -> Array:
        """Return the states at `t`, shape (4 n, m)."""
        return (self._own_moments if self.t_eval is None else self._asked)[1]

    @cached_property
    def _own_moments(self) -> tuple[Array, Array]:
        """Return the times of start, events and end, and the states there; of a run that was cut off no end."""
        last, end = [self.end_time] * self.reached, [np.ravel(self.final_state)] * self.reached
        times = np.concatenate([[self.arithmetic.number(0)], self.event_times, last])
        return times, np.column_stack([np.ravel(self.initial), self.event_states, *end])

    @cached_property
    def energy(self) -> Array:
        """Return the energy at `t`, J, shape (m,), formed from the states."""
        with self.context():
            return self._energies(self.t, self.y, self._own_rows if self.t_eval is None else None)

    @property
    def final_energy(self) -> Quantity:
        """Return the energy at the end, J, formed from the state."""
        with self.context():
            state = np.reshape(np.array(self.final_state), (-1, 1))
            found: Number = self._energies(np.array([self.end_time]), state, np.array([-1])).tolist()[0]
            return found

    def end_numbers(self) -> tuple[Any, ...]:
        """Return x1, v1, x2, v2 and energy at the end, and what else there is."""
        return *self.final_state, self.final_energy

    def sol(self, t: Times, side: Side = "right") -> Array:
        """Return (x1, v1, x2, v2) at the time(s) t (s): shape (4 n,) for a number, (4 n, ...) for an array.

        t is exact (int, Fraction, decimal text, or a float taken as its binary value) or a number of the arithmetic,
        such as the time of an event; `side` says which segment answers at an event or a jump, where accelerations
        jump, and on a belt v2. Enclosures for balls: where another ball of times may be on both sides, both answer.
        Raises ValueError outside [0, end].
        """
        with self.context():
            given = self._times(t)
            states = self._states_at(given.ravel(), side)
        return states.reshape(len(states), *given.shape)

    @overload
    def mode_at(self, t: Exact | Quantity, side: Side = "right") -> M: ...

    @overload  # as balls are any type here, where flint is not read
    def mode_at(self, t: Times, side: Side = "right") -> Array: ...

    def mode_at(self, t: Any, side: Side = "right") -> Any:
        """Return the mode at time t (s), an object array for a sequence; at an event that on the given side."""
        require_one_of("side", side, ("left", "right"))
        with self.context():
            times = self._times(t)
            after = np.searchsorted(self._points(self.event_times), self._points(times), side=side)
        return np.array(self._all_modes, dtype=object)[after]

    def _energies(self, t: Array, y: Array, rows: Counts | None) -> Array:
        """Return the energies of states (4 n, m) at times, J, in segments if they are known; in the context."""
        raise NotImplementedError

    def _states_at(self, times: Array, side: Side) -> Array:
        """Return the states at times, (4 n, m); in the arithmetic's context."""
        raise NotImplementedError

    def _times(self, t: Any) -> Array:
        """Return times (s) as numbers of the arithmetic, in their shape. Raises ValueError outside [0, end]."""
        try:
            given = np.asarray(t)
        except ValueError:
            raise ValueError("t must be a time in seconds or an array of times; its rows differ in length") from None
        if given.dtype.kind == "f":  # a grid of floats may end a few roundings behind the end
            end = self.arithmetic.to_float(self.end_time)
            t = given = np.where((given > end) & (given <= end + 4 * math.ulp(end)), end, given)
        if self.bounded and given.dtype.kind in "fiu" and ((given >= 0) & (given <= self.end_time)).all():
            return given.astype(float)
        each = np.vectorize(self._time, otypes=[float if self.bounded else object])
        return np.asarray(each(np.asarray(t, dtype=object)))

    def _time(self, t: Any) -> Number:
        """Return a time as a number of the arithmetic: exact from rationals and floats, its own numbers as they are."""
        own, to_float = not self.bounded and isinstance(t, type(self.end_time)), self.arithmetic.to_float
        end, until = to_float(self.end_time), self.scene.until if self.reached else Fraction(0)
        exact: Any = to_float(t) if own else exact_time(t)
        if not 0 <= exact <= max(until, Fraction(end)):
            said = self.arithmetic.text(t) if own else shown(t).strip("'")
            raise ValueError(
                f"t = {said} s is outside the solved time [0, {end:g}] s; give one within it, or solve further"
            )
        return t if own else self._begun.get(exact, self.arithmetic.number(exact))

    def _points(self, times: Array) -> Array:
        """Return times themselves, or midpoints of balls: floats would not tell the ends of a short slip apart."""
        return np.vectorize(arb.mid, otypes=[object])(times) if self.arithmetic.name == "ball" else times

    # ------------------------------------------------------------------ text, pictures and files
    def kept(self) -> dict[str, Any]:
        """Return what the run wrote, as what JSON holds."""
        raise NotImplementedError

    @classmethod
    def restored(cls, scene: Any, header: dict[str, Any]) -> Self:
        """Return the trajectory of a scene with what its run wrote. Raises ValueError, and what others' files can."""
        raise NotImplementedError

    def context(self) -> AbstractContextManager[object]:
        """Return the context of the arithmetic."""
        return self.arithmetic.context()

    def floats(self, numbers: Quantity | ArrayLike) -> Floats:
        """Return numbers of the arithmetic in binary64, in their shape."""
        given = np.asarray(numbers)
        convert = np.vectorize(self.arithmetic.to_float, otypes=[float])
        return np.asarray(convert(given) if given.dtype == object else given)

    def __getitem__(self, name: str) -> Array:
        """Return an array by its name, as SciPy's results do, or the row "x1", "v1", "x2" or "v2" of `y`."""
        run: Any = self
        if name in STATE:
            return np.reshape(run.y, (len(STATE), -1, len(run.t)))[STATE.index(name)].squeeze()
        if not isinstance(name, str) or name.startswith("_") or not hasattr(self, name):
            raise KeyError(f"{name!r}; a run has t, y, x1, v1, x2, v2, and all that dir(run) lists")
        return getattr(run, name)

    def _shown(self) -> dict[str, Any]:
        """Return what a summary says, by its names."""
        run: Any = self
        right = self.digits or (run.right_digits if self.bounded else None)
        digits = f"{self.arithmetic.digits} working digits" if right is None else f"{right} right digits"
        return {
            "message": self.message,
            "success": self.success,
            "status": int(self.status),
            "arithmetic": f"{self.arithmetic.name}, {digits}",
            "events": len(self.event_times),
            "t": f"[0, {self.arithmetic.text(self.end_time)}] s",
            "final mode": self.final_mode,
        }

    def __repr__(self) -> str:
        """Return a short summary, as SciPy's solutions have."""
        return "\n".join(f"{name:>12}: {value}" for name, value in self._shown().items())

    def _repr_html_(self) -> str:
        """Return the summary as a table of a notebook."""
        return html_table(type(self).__name__, self._shown().items())

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached, by events that are certain, with a right digit of every quantity."""
        return self.status.success

    @property
    def message(self) -> str:
        """Return the sentence that says how the solve ended."""
        if self.status is not Status.EVENT_LIMIT:
            return self.status.sentence
        count, until = len(self.event_times), short(self.scene.until)
        at = self.arithmetic.to_float(self.end_time)
        return f"stopped at max_events = {count}, t = {at:g} s of {until} s; raise it, or shorten until"

    def to_csv(self) -> str:
        """Return events and final state as CSV text, with units.

        Numbers have the digits that are right; of a run that does not know them, as in mpmath, the scene is solved in
        balls. Raises SequenceDiffers if the events are not the true ones.
        """
        return export.as_csv(export.as_record(self))

    def to_dataframe(self, times: Times | None = None) -> DataFrame:
        """Return t, mode, the state and energies as a pandas DataFrame, in binary64. Raises MissingTool, ValueError.

        At `times` (s), or at start, events and end. As CSV: `run.to_dataframe(times).to_csv(file)`.
        """
        return export.dataframe(self if times is None else self.but(t_eval=listed("times", times)))

    @property
    def pictures(self) -> Any:
        """Return the module that draws such a run."""
        return import_module(self._PICTURES)

    def plot(self, kind: Kind | None = None, ax: Axes | None = None) -> Axes:
        """Draw into matplotlib axes (new ones, if none are given) and return them; stick phases are marked.

        Left out, `kind` is "velocities", on a surface "above" (both bodies, m), beside which there is "relative" alone.
        """
        with meter("drawing"):
            return self.pictures.draw(self, kind, ax)

    def animate(
        self, file: str | Path | None = None, *, duration: float = 10.0, frames_per_second: int = 15
    ) -> FuncAnimation:
        """Return a matplotlib animation: both bodies and their velocities, on a surface both bodies from above.

        It is written to a .gif or .mp4 file, if given. `duration`: s that the film lasts, whatever the run does. A GIF
        needs pillow, which comes with matplotlib, an MP4 needs ffmpeg. A frame takes some 80 ms. Raises MissingTool,
        OSError, ValueError for other files or numbers that are not above 0.
        """
        return self.pictures.film(self, file, duration, frames_per_second)

    def save(self, file: str | Path) -> None:
        """Write this trajectory to a file, exactly: no pickle, no digit lost. Raises OSError, InvalidScene."""
        saved.save(self, file)

    @classmethod
    def load(cls, file: str | Path) -> Self:
        """Return the trajectory that `save` wrote to a file. Raises OSError, InvalidFile (what is no such file)."""
        found: Self = saved.load(file, cls)
        return found

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        # as texts: a bound of an open run may be no number, which equals nothing
        return (
            isinstance(other, type(self))
            and self.scene == other.scene
            and json.dumps(saved.run_of(self)) == json.dumps(saved.run_of(other))
        )

    __hash__ = None  # type: ignore[assignment]
