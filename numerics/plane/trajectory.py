"""The result of solving a scene on a surface: what a run answered, in files, as tables, drawn, filmed and compared."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Self

from numerics.plane import export
from numerics.plane.answer import PlaneSolution
from numerics.plane.saved import contents, restored
from numerics.trajectory import saved


class PlaneTrajectory(PlaneSolution):
    """A solved scene on a surface, in the words of Trajectory; two are equal if every number is.

    Rows of `y` are x1, v1, x2, v2 by axes (m, m/s; rad, rad/s of an angle), columns belong to `t` (s). Without `digits`
    they are floats, with proved bounds `t_error`, `y_error` beside them; else enclosures.

    >>> from numerics import PlanePair, PlaneScene, solve
    >>> run = solve(PlaneScene(PlanePair(m1=1, m2=1, a2=200, b="0.5"), until=2, v1=["0.06", "0.01"]))
    >>> run.success, run.status.name, run.message, run.digits >= 8, run.tried, run.is_float, run.arithmetic.name
    (True, 'REACHED_HORIZON', 'reached the horizon', True, '', True, 'float64')
    >>> run.modes, run.final_mode, run.event_kinds[0].value, run.event_times.shape, run.t_eval
    (('slip', 'stick'), 'stick', 'entry', (1,), None)
    >>> run.t.shape, run.y.shape, run.t_error.shape, run.y_error.shape, run.energy.shape
    ((3,), (8, 3), (3,), (8, 3), (3,))
    >>> float(run.end_time), len(run.final_state.x1), float(run.final_energy) < 0.00107, run.sol([0.5, 1]).shape
    (2.0, 2, True, (8, 2))
    >>> run.events[0].kind.value, run.mode_at(0.001), run.mode_at([0, "1/3"]), run.scene.pair.axes
    ('entry', 'slip', ['slip', 'stick'], 2)
    >>> run.record()["final"]["mode"], run.to_csv()[:15], len(run.to_dataframe())
    ('stick', 'from,to,t (s),x', 3)
    """

    def record(self) -> dict[str, Any]:
        """Return the JSON object of the interface: decimal strings of right digits, with radii beside balls."""
        return export.as_record(self)

    def to_csv(self) -> str:
        """Return events and final state as CSV text, with units: the columns of `record`, one for each axis."""
        return export.as_csv(self)

    def to_dataframe(self) -> Any:
        """Return t, mode, the state by axes and energy at `t` as a pandas DataFrame. Raises MissingTool."""
        return export.dataframe(self)

    def plot(self, kind: str = "above", ax: Any = None) -> Any:
        """Draw "above" (both bodies, m) or "relative" (v1 - v2, m/s) into matplotlib axes and return them."""
        from numerics.plane.pictures import draw

        return draw(self, kind, ax)

    def animate(self, file: str | Path | None = None, *, duration: float = 10.0, frames_per_second: int = 15) -> Any:
        """Return a matplotlib animation of both bodies from above; see Trajectory.animate."""
        from numerics.plane.pictures import animate

        return animate(self, file, duration, frames_per_second)

    def save(self, file: str | Path) -> None:
        """Write this trajectory to a file, exactly: no pickle, no digit lost. Raises OSError.

        >>> import tempfile
        >>> from numerics import load_scene, solve
        >>> run = solve(load_scene("plane-circle-merges"), digits=12)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     run.save(f"{folder}/run.npz")
        ...     PlaneTrajectory.load(f"{folder}/run.npz") == run
        True
        """
        saved.write(file, contents(self), {})

    @classmethod
    def load(cls, file: str | Path) -> Self:
        """Return the trajectory that `save` wrote to a file. Raises OSError, InvalidFile (what is no such file)."""
        return cls.of(saved.read(file, restored))

    @classmethod
    def of(cls, found: PlaneSolution) -> Self:
        """Return what a run answered, as a trajectory."""
        new = object.__new__(cls)
        new.__dict__ = vars(found)
        return new

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        """Return what is pickled and compared: the header of a file."""
        return _from_text, (saved.header_text(contents(self)),)

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        return isinstance(other, PlaneTrajectory) and self.__reduce__() == other.__reduce__()

    __hash__ = None  # type: ignore[assignment]


def _from_text(text: str) -> PlaneTrajectory:
    """Return the trajectory of a pickled header."""
    return PlaneTrajectory.of(restored(saved.header_of(text)))
