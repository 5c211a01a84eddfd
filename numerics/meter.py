"""Progress on a terminal, in the manner of tqdm: one line on stderr for what lasts over two seconds; nothing elsewhere.

solving  42 %|########            | 3 s, 4 s left
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

_AFTER, _EVERY, _WIDTH = 2.0, 0.25, 20
"""Seconds before the first line and between two; characters of the bar."""
_ACTIVE = threading.local()


class _Line:
    """What is shown: it is told how far the work is, and writes now and then."""

    def __init__(self, what: str) -> None:
        self.what, self.began, self.told, self.fraction = what, time.monotonic(), 0.0, 0.0

    def __call__(self, done: int, whole: float) -> None:
        """Take a count and the fraction done (a float), or a count and how many there are (an int)."""
        self.fraction = whole if isinstance(whole, float) else done / max(whole, 1)
        if self.fraction < 1:
            self.tell()

    def tell(self) -> None:
        now = time.monotonic()
        if now < max(self.began + _AFTER, self.told + _EVERY):
            return
        self.told, spent, done = now, now - self.began, self.fraction
        bar, left = "", ""
        if done > 0:
            bar = f"{100 * done:3.0f} %|{'#' * int(_WIDTH * done):{_WIDTH}}| "
            left = f", {spent * (1 - done) / done:.0f} s left"
        sys.stderr.write(f"\r\033[K{self.what} {bar}{spent:.0f} s{left}")
        sys.stderr.flush()

    def close(self) -> None:
        if self.told:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()


@contextmanager
def meter(
    what: str, given: Callable[..., None] | None = None, ticks: bool = True
) -> Iterator[Callable[..., None] | None]:
    """Yield what takes the progress of some work: what is `given`, or a line on a terminal, else None.

    With `ticks` it also counts the seconds of work that tells nothing. As a decorator it is the line of a function.
    """
    is_free = sys.stderr is not None and sys.stderr.isatty() and not getattr(_ACTIVE, "line", False)
    if given is not None or not is_free:
        yield given
        return
    line, ended = _Line(what), threading.Event()
    _ACTIVE.line = True

    def tick() -> None:
        while not ended.wait(_AFTER if not line.told else 2 * _EVERY):
            line.tell()

    ticker = threading.Thread(target=tick, daemon=True) if ticks else None
    if ticker is not None:
        ticker.start()
    try:
        yield line
    finally:
        ended.set()
        if ticker is not None:
            ticker.join()
        _ACTIVE.line = False
        line.close()
