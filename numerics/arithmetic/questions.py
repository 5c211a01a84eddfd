"""What a text may ask of a sign. The texts carry numbers, since compiled code has no use for sentences."""

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
    "is the guard rising?",
    "on which side of zero does the oscillation start?",
    "does the damped motion head for zero?",
    "has the overdamped motion a slow part?",
    "does the overdamped motion turn after its start?",
    "has the load on the interface died away?",
    "does the load on the interface exceed what friction can hold?",
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
    GUARD_RISES,
    SIDE_OF_ZERO,
    HEADS_FOR_ZERO,
    HAS_SLOW_PART,
    TURNS_LATER,
    DIED_AWAY,
    EXCEEDS_FRICTION,
) = range(len(QUESTIONS))
