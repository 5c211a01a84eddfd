"""The result of solving a scene: segments joined by events. Nothing is sampled, or made, until somebody asks."""

from __future__ import annotations

from typing import Any, Literal

from numerics.arithmetic.by_name import arithmetic_named
from numerics.trajectory.columns import plain, restored, restored_record
from numerics.trajectory.export import dataframe
from numerics.trajectory.solution import Solution

Kind = Literal["velocities", "positions", "load", "force", "friction", "phase", "excess", "energy"]


class Trajectory(Solution):
    """A solved scene, in the words of SciPy's solution objects and with the physics beside them.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Two trajectories are equal if every number is.
    """

    def plot(self, kind: Kind = "velocities", ax: Any = None) -> Any:
        """Draw into matplotlib axes (new ones, if none are given) and return them; stick phases are shaded."""
        from numerics.trajectory.figures import draw

        return draw(self, kind, ax)

    def to_dataframe(self) -> Any:
        """Return t, mode, x1, v1, x2, v2 and energy at start, events and end as a pandas DataFrame."""
        return dataframe(self)

    def __repr__(self) -> str:
        """Return a short summary, as SciPy's solutions have."""
        return "\n".join(f"{name:>12}: {value}" for name, value in self._summary().items())

    def _repr_html_(self) -> str:
        """Return the same as a small table, for notebooks."""
        cells = "".join(f"<tr><th>{name}</th><td>{value}</td></tr>" for name, value in self._summary().items())
        return f"<table>{cells}</table>"

    def _summary(self) -> dict[str, Any]:
        right = self.digits or (self.right_digits if self.bounded else None)
        digits = f"{self.arithmetic.digits} working digits" if right is None else f"{right} right digits"
        return {
            "message": self.message,
            "success": self.success,
            "status": int(self.status),
            "arithmetic": f"{self.arithmetic.name}, {digits}",
            "events": self.record.events,
            "t": f"[0, {self.arithmetic.text(self.end_time)}] s",
            "final mode": self.final_mode.value,
        }

    def __getstate__(self) -> tuple[Any, ...]:
        """Return what is compared and pickled: the scene and what the run wrote, without what was made of it since."""
        arithmetic = self.arithmetic.name, self.arithmetic.digits
        times = None if self.t_eval is None else plain(tuple(self.t_eval))
        return self.scene, arithmetic, plain(self.record), self.digits, self.tried, times

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        """Restore a pickled trajectory."""
        scene, arithmetic, record, digits, tried, t_eval = state
        self.__init__(  # type: ignore[misc]
            scene,
            arithmetic_named(*arithmetic),
            restored_record(record),
            digits=digits,
            tried=tried,
            t_eval=restored(t_eval),
        )

    def __eq__(self, other: object) -> bool:
        """Return whether another trajectory answers the same scene with the same numbers."""
        return isinstance(other, Trajectory) and self.__getstate__() == other.__getstate__()

    __hash__ = None  # type: ignore[assignment]
