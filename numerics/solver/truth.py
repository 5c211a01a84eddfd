"""A trajectory once more, in balls: which of its digits are right, where it cannot know itself."""

from __future__ import annotations

from typing import Any

from numerics.solver.solve import solve
from numerics.trajectory.comparison import require_same_sequence
from numerics.trajectory.export import as_record, knows_its_digits
from numerics.trajectory.trajectory import Trajectory


def proved(trajectory: Trajectory, digits: int) -> Trajectory:
    """Return a trajectory solved again in balls, to some digits more; raises SequenceDiffers if its events differ."""
    # one event more than were found shows a lost one; a run that was cut off is cut off at the same event
    limit = trajectory.record.events + (1 if trajectory.reached else 0)
    balls = solve(trajectory.scene, digits=digits + 3, arithmetic="ball", max_events=max(limit, 1))
    require_same_sequence(trajectory, balls)
    return balls


def record(trajectory: Trajectory, events: Any = None) -> dict[str, Any]:
    """Return the JSON record of any trajectory (export.as_record); one that knows no right digits is proved first."""
    if knows_its_digits(trajectory):
        return as_record(trajectory, None, events)
    digits = 17 if trajectory.arithmetic.name == "float64" else trajectory.arithmetic.digits
    return as_record(trajectory, proved(trajectory, digits), events)
