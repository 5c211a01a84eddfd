"""A run in reduced coordinates (free/frame.py), those of the paper's own pair."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from numerics.free.frame import ReducedState
from numerics.trajectory.answer import Side
from numerics.trajectory.rows import RecordedRun

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity, Times


class Reduced:
    """`initial`, `final` (at the last event, where the cap on events ended the run), and the state at any time.

    >>> from numerics import load_scene, solve
    >>> reduced = solve(load_scene("velocities")).reduced
    >>> round(float(reduced.final.w), 6), float(reduced.initial.X), round(float(reduced(0.5).X), 6)
    (0.173401, 0.0, 13.389309)
    """

    def __init__(self, run: RecordedRun) -> None:
        """Take a run on a line."""
        self.run = run

    def __call__(self, t: Times, side: Side = "right") -> ReducedState:
        """Return the reduced state at time t (s), of the pair's own b; as `sol`."""
        with self.run.context():
            y = self.run.sol(t, side)
            return self.run.frame.reduced(y.tolist() if y.ndim == 1 else y, self.run.row_excess_at(t, side))

    def row(self, y: Iterable[Quantity], row: int) -> ReducedState:
        """Return the reduced state y at a row, or at the end (-1)."""
        with self.run.context():
            return self.run.frame.reduced(y, None if self.run.row_excess is None else self.run.row_excess[row])

    @property
    def final(self) -> ReducedState:
        """Return that at the end."""
        return self.row(self.run.final_state, -1)

    @property
    def initial(self) -> ReducedState:
        """Return that at the start."""
        with self.run.context():
            excess = self.run.arithmetic.number(self.run.scene.energy_excess)
            return self.run.frame.reduced(self.run.row_states[:, 0], excess)
