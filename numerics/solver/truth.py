"""A trajectory once more, in balls: which of its digits are right, where it cannot know itself."""

from __future__ import annotations

from typing import Any

from numerics.solver.solve import solve
from numerics.trajectory.export import as_record, knows_its_digits
from numerics.trajectory.trajectory import Trajectory


def in_balls(trajectory: Trajectory, digits: int) -> Trajectory:
    """Return the scene of a trajectory solved again, in balls, as far as the trajectory goes."""
    # one event more than were found shows a lost one; a run that was cut off is cut off at the same event
    limit = trajectory.record.events + trajectory.reached
    return solve(trajectory.scene, digits=digits, arithmetic="ball", max_events=max(limit, 1))


def record(trajectory: Trajectory, events: Any = None) -> dict[str, Any]:
    """Return the JSON record of any trajectory (export.as_record); one that knows no right digits is proved first."""
    if knows_its_digits(trajectory):
        return as_record(trajectory, None, events)
    digits = 17 if trajectory.arithmetic.name == "float64" else trajectory.arithmetic.digits
    return as_record(trajectory, in_balls(trajectory, digits + 3), events)
