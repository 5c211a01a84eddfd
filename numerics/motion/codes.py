"""Whole numbers that texts use for kinds of motion and for how a run goes on: compiled code has no enumerations."""

from __future__ import annotations

STICK, RAY, SURFACE, FREE = 0, 1, 2, 3
"""Kinds of motion: stick; slips from an exit ray, from elsewhere on the switching surface, from off it."""
REACHED, STUCK, EVENT_LIMIT, OUT_OF_RANGE, MOVING = 0, 1, 2, 3, 4
"""How a run ended: at its horizon, in a last stick phase, ...; or that it has not."""
