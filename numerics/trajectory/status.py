"""How a solve ended, alone or in a batch."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """How a solve ended; `sentence` is what the user reads.

    >>> Status.STUCK_FOR_EVER.success, Status.STUCK_FOR_EVER.sentence
    (True, 'reached the horizon; the pair has stuck for ever')
    """

    REACHED_HORIZON = 0
    STUCK_FOR_EVER = 1
    EVENT_LIMIT = 2
    OUT_OF_RANGE = 3
    """In a batch only: a single solve raises."""
    SEQUENCE_OPEN = 4
    """The run got to its end, but its own error bounds reach as far as another sequence of events."""

    @property
    def sentence(self) -> str:
        """Return the sentence that says so."""
        return _SENTENCES[self]

    @property
    def success(self) -> bool:
        """Return whether the horizon was reached, by events that are certain."""
        return self in {Status.REACHED_HORIZON, Status.STUCK_FOR_EVER}


_SENTENCES = {
    Status.REACHED_HORIZON: "reached the horizon",
    Status.STUCK_FOR_EVER: "reached the horizon; the pair has stuck for ever",
    Status.EVENT_LIMIT: "stopped at the cap on events before the horizon; raise the cap max_events",
    Status.OUT_OF_RANGE: "left the range of float64; ball arithmetic has none",
    Status.SEQUENCE_OPEN: "the error bounds leave the sequence of events open; ask for digits, or for ball arithmetic",
}
