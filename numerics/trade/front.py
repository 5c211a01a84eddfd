"""Who is best: the front of right runs that no other right run beats in time and error, and by how much we lead.

We lead by what a user calls; what runs inside stands beside it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from numerics.trade.measure import Measurement
from numerics.trade.ours import PARTS


@dataclass(frozen=True)
class Point:
    """A measured run as a point of the plane: s, log10 of its error, and whether its event sequence is right."""

    contender: str
    ours: bool
    setting: float
    seconds: float
    error: float
    right: bool


def points(measurements: Iterable[Measurement]) -> list[Point]:
    """Return the points of the measurements that have a time and an error."""
    return [
        Point(one.contender, one.ours, one.setting, one.ran.seconds, one.verdict.error, one.verdict.right)
        for one in measurements
        if one.ran.seconds is not None and one.verdict is not None and one.verdict.error is not None
    ]


def best_front(candidates: Sequence[Point]) -> list[Point]:
    """Return the right points that no right point beats: none is as fast and as accurate, and better in one of both.

    From fast to slow, thus from coarse to accurate.
    """
    right = [one for one in candidates if one.right]
    kept = [one for one in right if not any(_beats(other, one) for other in right)]
    return sorted(kept, key=lambda one: (one.seconds, one.error))


def _beats(one: Point, other: Point) -> bool:
    no_worse = one.seconds <= other.seconds and one.error <= other.error
    return no_worse and (one.seconds < other.seconds or one.error < other.error)


@dataclass(frozen=True)
class Lead:
    """How many times faster our fastest right call is that is at least as accurate as a peer's point."""

    peer: Point
    ours: Point | None
    """What a user calls; None: none of it is right and as accurate."""
    inside: Point | None = None
    """The same among the parts that run inside."""

    @property
    def ratio(self) -> float | None:
        """Return the peer's time by ours; below 1 the peer is faster."""
        return None if self.ours is None else self.peer.seconds / self.ours.seconds

    @property
    def ratio_inside(self) -> float | None:
        """Return the peer's time by that of what runs inside."""
        return None if self.inside is None else self.peer.seconds / self.inside.seconds

    def as_record(self, scene: str) -> dict[str, Any]:
        """Return it as the object that JSON carries."""
        return {
            "scene": scene,
            "peer": self.peer.contender,
            "setting": self.peer.setting,
            "right": self.peer.right,
            "ours": None if self.ours is None else self.ours.contender,
            "times_faster": self.ratio,
            "times_faster_inside": self.ratio_inside,
        }


def leads(candidates: Sequence[Point]) -> list[Lead]:
    """Return our lead over every point of a peer, also over those whose event sequence is wrong."""
    found = []
    for peer in (one for one in candidates if not one.ours):
        equal = [one for one in candidates if one.ours and one.right and one.error <= peer.error]
        calls, parts = ([one for one in equal if (one.contender in PARTS) is part] for part in (False, True))
        found.append(Lead(peer, *(min(some, key=lambda one: one.seconds, default=None) for some in (calls, parts))))
    return found
