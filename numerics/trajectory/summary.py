"""What a trajectory shows of itself."""

from __future__ import annotations

from typing import Any


def summary(trajectory: Any) -> dict[str, Any]:
    """Return the lines of a trajectory's `repr`: a name and a value each."""
    arithmetic, accuracy = trajectory.arithmetic, trajectory.accuracy
    right = trajectory.digits if accuracy is None else trajectory.digits or accuracy.digits
    digits = f"{arithmetic.digits} working digits" if right is None else f"{right} right digits"
    return {
        "message": trajectory.message,
        "success": trajectory.success,
        "status": int(trajectory.status),
        "arithmetic": f"{arithmetic.name}, {digits}",
        "events": len(trajectory.record),
        "t": f"[0, {arithmetic.text(trajectory.end_time)}] s",
        "final mode": trajectory.final_mode.value,
    }
