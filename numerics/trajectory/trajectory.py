"""The result of solving a scene: segments joined by events. Nothing is sampled, or made, until somebody asks."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, Self

from numerics.trajectory.export import dataframe
from numerics.trajectory.solution import Solution

Kind = Literal["velocities", "positions", "load", "force", "friction", "phase", "relative", "excess", "energy"]


class Trajectory(Solution):
    """A solved scene, in the words of SciPy's solution objects and with the physics beside them.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Two trajectories are equal if every number is.

    How it ended, its events (k of them, m = k + 2 columns), any time, how sure it is, and the energy (J):

    >>> from numerics import Pair, Scene, State, solve
    >>> run = solve(Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(v1="0.15"), until=5))
    >>> run.success, run.status.name, run.message, run.reached, run.tried
    (True, 'REACHED_HORIZON', 'reached the horizon', True, '')
    >>> run.t.shape, run.y.shape, run.energy.shape, run.event_times.shape, run.event_states.shape
    ((34,), (4, 34), (34,), (32,), (4, 32))
    >>> run.events[0].kind.value, run.event_kinds[1].value, run.modes[0].value, run.final_mode.value
    ('crossing', 'entry', 'slip+', 'stick')
    >>> run.segments[0]
    Segment(mode='slip+', start=0, end=0.0768788, length=0.0768788)
    >>> [len(one) for one in run.t_events], [one.shape for one in run.y_events]  # entries, exits, crossings
    ([16, 15, 1], [(16, 4), (15, 4), (1, 4)])
    >>> run.sol([[0.5, 1.0], [1.5, 2.0]]).shape, run.mode_at(0.5).value
    ((4, 2, 2), 'slip+')
    >>> run.arithmetic.name, run.right_digits == run.accuracy.digits, run.certain, run.phase_lost
    ('float64', True, True, False)
    >>> solve(run.scene, digits=20).digits, solve(run.scene, t_eval=[0, 1]).t_eval
    (20, [0, 1])
    >>> round(run.dissipated, 9), round(run.final_energy, 9), abs(run.ledger.residual) < 1e-15
    (0.00868247, 0.00256753, True)
    >>> run.end_time, [round(one, 6) for one in run.final_state]
    (5.0, [0.002483, 0.044169, 0.001745, 0.044169])
    >>> [round(one, 6) for one in run.units]  # L (m), Omega (1/s) and E_cr (J) of reduced coordinates
    [0.005, 10.0, 0.0025]
    >>> round(run.final.w, 6), float(run.initial.X), round(run.reduced(0.5).w, 6)
    (0.027012, 0.0, 0.247939)
    """

    def plot(self, kind: Kind = "velocities", ax: Any = None) -> Any:
        """Draw into matplotlib axes (new ones, if none are given) and return them; stick phases are shaded."""
        from numerics.trajectory.figures import draw

        return draw(self, kind, ax)

    def animate(self, file: str | Path | None = None, *, duration: float = 10.0, frames_per_second: int = 15) -> Any:
        """Return a matplotlib animation of both bodies and their velocities; write it to a .gif or .mp4 file, if given.

        `duration`: s that the film lasts, whatever the run does. A GIF needs pillow, which comes with matplotlib, an
        MP4 needs ffmpeg. A frame takes some 50 ms. Raises MissingTool, OSError, ValueError for other files or
        numbers that are not above 0.
        """
        from numerics.trajectory.animation import animate

        return animate(self, file, duration, frames_per_second)

    def save(self, file: str | Path) -> None:
        """Write this trajectory to a file, exactly: no pickle, no digit lost. Raises OSError.

        >>> import tempfile
        >>> from numerics import load_scene, solve
        >>> run = solve(load_scene("start-with-speed"), digits=40)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     run.save(f"{folder}/run.npz")
        ...     Trajectory.load(f"{folder}/run.npz") == run
        True
        """
        from numerics.trajectory.saved import save

        save(self, file)

    @classmethod
    def load(cls, file: str | Path) -> Self:
        """Return the trajectory that `save` wrote to a file. Raises OSError, InvalidFile (what is no such file)."""
        from numerics.trajectory.saved import load

        found: Self = load(file, cls)
        return found

    def to_dataframe(self) -> Any:
        """Return t, mode, x1, v1, x2, v2 and energy at start, events and end as a pandas DataFrame."""
        return dataframe(self)

    def __repr__(self) -> str:
        """Return a short summary, as SciPy's solutions have."""
        right = self.digits or (self.right_digits if self.bounded else None)
        digits = f"{self.arithmetic.digits} working digits" if right is None else f"{right} right digits"
        shown = {
            "message": self.message,
            "success": self.success,
            "status": int(self.status),
            "arithmetic": f"{self.arithmetic.name}, {digits}",
            "events": self.record.events,
            "t": f"[0, {self.arithmetic.text(self.end_time)}] s",
            "final mode": self.final_mode.value,
        }
        return "\n".join(f"{name:>12}: {value}" for name, value in shown.items())

    def __reduce__(self) -> tuple[Any, ...]:
        """Return what a pickle holds: the scene and what the run wrote, without what was made of it since."""
        from numerics.trajectory.saved import header_text, run_of, unpickled

        header, arrays = run_of(self)
        return unpickled, (type(self), self.scene, header_text(header), arrays)

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        if not isinstance(other, Trajectory):
            return False
        from numerics.trajectory.saved import header_text, run_of

        (one, rows), (two, others) = run_of(self), run_of(other)
        # as texts: a bound of an open run may be no number, which equals nothing
        same = self.scene == other.scene and header_text(one) == header_text(two)
        return same and [a.tobytes() for a in rows.values()] == [a.tobytes() for a in others.values()]

    __hash__ = None  # type: ignore[assignment]
