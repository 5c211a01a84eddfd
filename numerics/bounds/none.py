"""No bounds: for arithmetics that carry their own errors, or none. Each text stands in the place of its namesake."""

from __future__ import annotations

from typing import Any

from numerics.arithmetic.protocol import Number
from numerics.bounds.records import EventErrors

NOTHING = EventErrors(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def initial(pair: Any, start: Any, V1: Number, V2: Number) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return NOTHING


def when_stuck(pair: Any, start: Any, errors: EventErrors) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors


def after_event(pair: Any, before: Any, errors: EventErrors, at: Any, after: Any, duration: Number) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors


def before_horizon(
    pair: Any, start: Any, errors: EventErrors, at: Any, duration: Number, tau: Number, rest: Number, horizon: Number  # noqa: ARG001
) -> EventErrors:
    """Return nothing."""
    return errors


def at_event(pair: Any, start: Any, errors: EventErrors) -> EventErrors:  # noqa: ARG001
    """Return nothing."""
    return errors
