"""Where a periodic motion is looked for: next to the last one found, by its exact equations, then in a run."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from numerics.arithmetic.ball_words import working_digits
from numerics.control.asked import Tell, silent
from numerics.control.orbit import Drive, Orbit, solve_orbit
from numerics.control.simulated import simulated_guesses
from numerics.control.two_stop import non_stop_guesses, two_stop_guesses
from numerics.errors import EventUndecided

MAX_EVENTS = 10_000
"""Cap on the events of a run that looks for a periodic motion; a fifth of it may belong to one period."""


@dataclass
class Search:
    """How a periodic motion is looked for, from one attempt to the next; `found` is that of the attempt before."""

    max_events: int = MAX_EVENTS
    tell: Tell = silent
    found: Orbit | None = None

    def orbit(self, drive: Drive) -> Orbit:
        """Return a periodic motion, proved. Raises EventUndecided, NotSettled."""
        undecided: EventUndecided | None = None
        for guess in self._guesses(drive):
            try:
                self.found = solve_orbit(guess, self.tell)
            except EventUndecided as error:
                undecided = error
            else:
                return self.found
        raise undecided or EventUndecided("what is the periodic motion?", "no guess", working_digits())

    def _guesses(self, drive: Drive) -> Iterator[Orbit]:
        """Yield periodic motions that may be the one: the last one, by their exact equations, then by simulation."""
        if self.found is not None:
            yield self.found
        if len(drive.piece.sines) == 1:
            yield from non_stop_guesses(drive)
            yield from two_stop_guesses(drive)
        yield from simulated_guesses(drive, self.max_events, self.tell)
