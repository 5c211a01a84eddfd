"""How a solve ended, alone or in a batch."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """How a solve ended; `sentence` is the message.

    >>> Status.STUCK_FOR_EVER.success, Status.STUCK_FOR_EVER.sentence
    (True, 'reached the horizon; the pair sticks permanently')
    """

    REACHED_HORIZON = 0
    STUCK_FOR_EVER = 1
    EVENT_LIMIT = 2
    OUT_OF_RANGE = 3
    """In a batch only: a single solve raises."""
    SEQUENCE_OPEN = 4
    """The run reached its end, but its error bounds do not exclude another sequence of events."""

    NO_RIGHT_DIGIT = 5
    """The sequence of events is certain, but no digit of some quantity is right (trajectory/digits.py)."""

    @property
    def sentence(self) -> str:
        """The status as a sentence."""
        return _SENTENCES[self]

    @property
    def success(self) -> bool:
        """Whether the horizon was reached with a certain sequence of events and a right digit of every quantity."""
        return self in {Status.REACHED_HORIZON, Status.STUCK_FOR_EVER}


_SENTENCES = {
    Status.REACHED_HORIZON: "reached the horizon",
    Status.STUCK_FOR_EVER: "reached the horizon; the pair sticks permanently",
    Status.EVENT_LIMIT: "stopped at the limit on events before the horizon; raise max_events",
    Status.OUT_OF_RANGE: "left the range of float64, or the steps that it takes; solve(scene) goes on in balls",
    Status.SEQUENCE_OPEN: "the error bounds do not decide the sequence of events; solve(scene) goes on in balls",
    Status.NO_RIGHT_DIGIT: "reached the horizon, but no digit of a quantity is right; request digits",
}
