"""Where dual numbers see more: each text returns what was found.

The formulas of undamped.py hold with guard, gap or damping exactly 0, and derivatives need neighbours. Over dual
numbers the texts of sensitivity/gradients.py stand in the place of these, and give what was found its gradients.
"""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text


@text
def seen_exit_time(pair: Any, start: Any, side: float, duration: Number) -> Number:  # noqa: ARG001
    """Return the duration of a stick phase."""
    return duration


@text
def seen_excess_at_exit(pair: Any, start: Any, duration: Number) -> Number:  # noqa: ARG001
    """Return the excess at the end of a stick phase."""
    return start.w


@text
def seen_on_ray(pair: Any, start: Any) -> Any:  # noqa: ARG001
    """Return the start of a slip from an exit ray."""
    return start


@text
def seen_ray_landing(pair: Any, start: Any, found: Any) -> Any:  # noqa: ARG001
    """Return the end of a slip from an exit ray."""
    return found


@text
def seen_landing(pair: Any, start: Any, found: Any) -> Any:  # noqa: ARG001
    """Return the end of another slip."""
    return found


@text
def seen_flow(pair: Any, start: Any, tau: Number, found: Any) -> Any:  # noqa: ARG001
    """Return a state."""
    return found
