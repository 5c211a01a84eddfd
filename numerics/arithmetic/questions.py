"""What may be asked of a sign. Formulas carry numbers, since compiled code has no use for sentences."""

from __future__ import annotations

from typing import Final

QUESTIONS: Final = (
    "is the energy above the critical energy?",
    "which way does the stuck pair move?",
    "does the guard of this slip turn at all?",
    "is the guard's minimum next to the start before it?",
    "does the slip touch the switching surface without crossing it (a graze)?",
    "does the slip end inside the sliding region, or cross beyond its edge?",
    "does the pair leave the edge of the sliding region at once?",
    "does the next event come before the horizon?",
    "on which side of zero does the oscillation start?",
)
(
    ABOVE_CRITICAL,
    WHICH_WAY,
    GUARD_TURNS,
    MINIMUM_BEFORE_START,
    GRAZES,
    ENDS_INSIDE,
    LEAVES_AT_ONCE,
    BEFORE_HORIZON,
    SIDE_OF_ZERO,
) = range(len(QUESTIONS))
