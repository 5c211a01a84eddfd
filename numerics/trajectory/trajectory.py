"""The result of solving a scene: segments joined by events. Nothing is sampled, or made, until somebody asks."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, Self

import numpy as np

from numerics.arithmetic.by_name import arithmetic_named
from numerics.linear.record import END_ROW, ROW, How, Knot, Record
from numerics.trajectory.saved import plain
from numerics.trajectory.solution import Solution

Kind = Literal["velocities", "positions", "load", "force", "friction", "phase", "relative", "excess", "energy"]


class Trajectory(Solution):
    """A solved scene, with the attribute names of SciPy's solution objects, and modes, events and energies.

    Rows of `y` are x1, v1 (m, m/s) and x2, v2; columns belong to `t` (s): start, events, end; with t_eval, those times
    instead. With float64 they are float arrays, otherwise object arrays of the arithmetic's numbers (enclosures for
    balls). Two trajectories are equal if every number is.

    Status, events (k of them, m = k + 2 columns), evaluation at any time, error bounds, and energy (J):

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
    >>> run.arithmetic.name, run.right_digits == run.accuracy.digits, run.without_digits, run.certain, run.phase_lost
    ('float64', True, (), True, False)
    >>> run.check().right  # what its numbers are really off by is within its bounds
    True
    >>> solve(run.scene, digits=20).digits, solve(run.scene, t_eval=[0, 1]).t_eval
    (20, [0, 1])
    >>> round(run.dissipated, 9), round(run.final_energy, 9), abs(run.ledger.residual) < 1e-15
    (0.00868247, 0.00256753, True)
    >>> run.end_time, [round(one, 6) for one in run.final_state]
    (5.0, [0.002483, 0.044169, 0.001745, 0.044169])
    >>> [round(one, 6) for one in run.units]  # L (m), Omega (1/s) and E_cr (J) of reduced coordinates
    [0.005, 10.0, 0.0025]
    >>> round(run.final.w, 6), float(run.initial.X), round(run.reduced(0.5).w, 6), round(run.energy_excess[-1], 6)
    (0.027012, 0.0, 0.247939, 0.027012)

    Tables, and a file from which it is restored to the last bit:

    >>> run.to_csv()[:22], len(run.to_dataframe())
    ('from,to,t (s),x1 (m),v', 34)
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     run.save(f"{folder}/run.npz")
    ...     Trajectory.load(f"{folder}/run.npz") == run
    True
    """

    FORMAT = "inertial-pair trajectory 3"
    ARITHMETICS = ("float64", "mpmath", "ball")
    COLUMNS = ("t", "y", "energy", "energy_excess")

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
        from numerics.trajectory.figures import animate

        return animate(self, file, duration, frames_per_second)

    def check(self) -> Any:
        """Return what every number of the run is really off by: `numerics.check` solves its scene again, in balls."""
        import numerics

        return numerics.check(self)

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

    def kept(self) -> dict[str, Any]:
        """Return what the run wrote, as what JSON holds."""
        rows, end, how, *rest = self.record
        return {"rows": plain(rows), "end": plain(end), "how": int(how), "rest": plain(rest)}

    @classmethod
    def restored(cls, scene: Any, header: dict[str, Any]) -> Self:
        """Return the trajectory of a scene with what its run wrote. Raises ValueError, and what others' files can."""
        (name, digits), (events, certain) = header["arithmetic"], header["rest"]
        rows: Any
        end: Any
        if name == "float64":
            rows, end = (np.array(header[one], dtype=float) for one in ("rows", "end"))
            if rows.shape[1:] != (ROW,) or end.shape != (END_ROW,):
                raise ValueError("its rows have other lengths")
        else:
            *rows, end = (Knot(*one)._replace(cell=tuple(one[-1])) for one in (*header["rows"], header["end"]))
        record = Record(rows, end, How(header["how"]), events, certain)
        found = cls(scene, arithmetic_named(name, digits), record)
        if not (
            np.isin(found.row_signs, (-1, 0, 1)).all() and np.isin(found.row_pieces, range(len(found.pieces))).all()
        ):
            raise ValueError("its rows are not those of a run of its scene")
        if not 0 <= events < len(rows):
            raise ValueError("its count of events is not that of its rows")
        return found
