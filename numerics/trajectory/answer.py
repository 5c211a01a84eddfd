"""What solved scenes on a line and on a surface answer in the same words: how it ended, files, tables, equality."""

from __future__ import annotations

import json
from contextlib import AbstractContextManager
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np

from numerics.arithmetic.protocol import Arithmetic
from numerics.habits import Helpful
from numerics.scene.decimals import listed, short
from numerics.scene.short_repr import html_table
from numerics.trajectory import export, saved
from numerics.trajectory.columns import STATE, Array, Floats
from numerics.trajectory.status import Status

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.animation import FuncAnimation
    from numpy.typing import ArrayLike
    from pandas import DataFrame

    from numerics.scene import Scene
    from numerics.scene.decimals import Exact, Quantity, Times
    from numerics.scene.plane import PlaneScene

_AT_ASKED_TIMES = {"_asked_times", "_asked_states", "_points", "energy", "energy_excess"}
"""What depends on t_eval, and is made when it is looked at."""


class Answer(Helpful):
    """A solved scene; two are equal if every number is."""

    FORMAT: ClassVar[str]
    """How the header of a file begins."""
    ENERGIES: ClassVar[tuple[str, ...]]
    """Those that a table has."""
    EVENT_COLUMNS: ClassVar[tuple[str, ...]] = ()
    """What an event has besides its time, its modes and its state."""
    scene: Scene | PlaneScene
    status: Status
    arithmetic: Arithmetic
    digits: int | None = None
    """Right digits that were asked for and reached."""
    tried: str = ""
    """What did not answer."""
    t_eval: Sequence[Exact] | None = None

    def but(self, **changed: object) -> Self:
        """Return the same trajectory with other `digits`, `tried` or `t_eval`."""
        new = object.__new__(type(self))
        new.__dict__ = {name: value for name, value in vars(self).items() if name not in _AT_ASKED_TIMES} | changed
        new.look_up_times()
        return new

    def look_up_times(self) -> None:
        """Raise ValueError for times in t_eval that are outside the run."""

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
        raise NotImplementedError

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
        run: Any = self
        count, at, until = len(run.event_times), float(run.floats(run.end_time)), short(run.scene.until)
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

    def _pictures(self) -> ModuleType:
        """Return what draws such a run."""
        raise NotImplementedError

    def animate(
        self, file: str | Path | None = None, *, duration: float = 10.0, frames_per_second: int = 15
    ) -> FuncAnimation:
        """Return a matplotlib animation: both bodies and their velocities, on a surface both bodies from above.

        It is written to a .gif or .mp4 file, if given. `duration`: s that the film lasts, whatever the run does. A GIF
        needs pillow, which comes with matplotlib, an MP4 needs ffmpeg. A frame takes some 80 ms. Raises MissingTool,
        OSError, ValueError for other files or numbers that are not above 0.
        """
        return self._pictures().animate(self, file, duration, frames_per_second)

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
