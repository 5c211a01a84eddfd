"""How long a call takes: warm, the median of repeated batches."""

from __future__ import annotations

import importlib
import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

from numerics.arithmetic.telling import can_compile

BATCH = 0.002
"""A batch of calls lasts at least so long, s, so that the clock itself does not count."""
MOST_BATCHES = 500


@dataclass(frozen=True)
class Timing:
    """The median of so many timed batches, s per call."""

    seconds: float
    batches: int


def median_time(call: Callable[[], object], first: float, budget: float) -> Timing:
    """Time a warm call again and again for about `budget` s, at least once; `first` (s) is what it took before.

    Of a run that measured itself its own time counts. The garbage collector stays on: its users have it on, too.
    """
    inner = max(1, round(BATCH / max(first, 1e-9)))
    taken: list[float] = []
    end = time.perf_counter() + budget
    while not taken or (len(taken) < MOST_BATCHES and time.perf_counter() < end):
        start = time.perf_counter()
        for _ in range(inner):
            answer = call()
        elapsed = time.perf_counter() - start
        taken.append(own_seconds(answer, elapsed / inner))
        if elapsed < BATCH / 4:  # the first call was slower than a warm one
            inner, taken = 4 * inner, []
    return Timing(statistics.median(taken), len(taken))


def own_seconds(answer: object, waited: float) -> float:
    """Return the time of a run (s): what it measured itself, as a process or a batch does, or how long we waited."""
    own: float | None = getattr(answer, "elapsed", None)
    return waited if own is None else own


def timed(call: Callable[[], object], budget: float = 0.05) -> Timing:
    """Warm up with one call, then take the median time."""
    start = time.perf_counter()
    call()
    return median_time(call, time.perf_counter() - start, budget)


def compiled_pair_seconds(pairs: int = 20_000) -> float | None:
    """Return the time of one sine and cosine of the same angle in compiled code; None without numba.

    Each pair waits for the one before it, as each event waits for the one before: this is the least that an event of a
    compiled path could cost. (Independent pairs overlap in the processor and take about half of it.)
    """
    if not can_compile():
        return None
    numba = importlib.import_module("numba")

    @numba.njit  # type: ignore[untyped-decorator]
    def many(count: int) -> float:
        angle = 1.0
        for _ in range(count):
            angle = 1.0 + 0.5 * math.sin(angle) * math.cos(angle)
        return angle

    many(1)
    return timed(lambda: many(pairs)).seconds / pairs
