"""Progress of what lasts, in the manner of tqdm: on a terminal one line on stderr after two seconds.

solving  42 %|########            | 3 s, 4 s left

Elsewhere a line after a minute, and one whenever the time has doubled; of a command every five seconds.
"""

from __future__ import annotations

import logging
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext

_AFTER, _EVERY, _SILENT, _COMMAND, _WIDTH = 2.0, 0.25, 60.0, 5.0, 20
"""Seconds before the first line on a terminal and between two, before the first one elsewhere, and between two of a
command; characters of the bar."""
_ACTIVE = threading.local()


class _Line:
    """What is shown while some work lasts: it takes how far that is, and writes now and then.

    With `ticks` it also counts the seconds of work that tells nothing.
    """

    def __init__(self, what: str, ticks: bool, every: float = 0.0) -> None:
        self.what, self.ticks, self.every, self.began, self.fraction = what, ticks, every, time.monotonic(), 0.0
        self.due, self.is_terminal, self.has_told, self.is_named = self.began + _AFTER, False, False, False

    def __enter__(self) -> _Line:
        _ACTIVE.line = self
        if self.ticks:
            self.ended = threading.Event()
            self.ticker = threading.Thread(target=self.tick, daemon=True)
            self.ticker.start()
        return self

    def __exit__(self, *_: object) -> None:
        _ACTIVE.line = None
        if self.ticks:
            self.ended.set()
            self.ticker.join()
        if self.has_told and self.is_terminal:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()

    def __call__(self, done: int, whole: float) -> None:
        """Take a count and the fraction done (a float), or a count and how many there are (an int)."""
        self.fraction = whole if isinstance(whole, float) else done / max(whole, 1)
        if self.fraction < 1:
            self.tell()

    def tell(self) -> None:
        now = time.monotonic()
        if now < self.due:
            return
        self.is_terminal, spent, done = sys.stderr.isatty(), now - self.began, self.fraction
        if not self.has_told and not self.is_terminal and spent < (first := self.every or _SILENT):
            self.due = self.began + first
            return
        self.has_told, self.due = True, now + (_EVERY if self.is_terminal else self.every or spent)
        bar, left = "", ""
        if done > 0:
            bar = f"{100 * done:3.0f} %|{'#' * int(_WIDTH * done):{_WIDTH}}| "
            left = f", {spent * (1 - done) / done:.0f} s left"
        line = f"{self.what} {bar}{spent:.0f} s{left}"
        sys.stderr.write(f"\r\033[K{line}" if self.is_terminal else f"{line}\n")
        sys.stderr.flush()

    def tick(self) -> None:
        while not self.ended.wait(max(self.due - time.monotonic(), _EVERY)):
            self.tell()


class _Messages(logging.Handler):
    """Messages of a log name the work of a line."""

    def __init__(self, line: _Line) -> None:
        super().__init__()
        self.line = line

    def emit(self, record: logging.LogRecord) -> None:
        """Take one."""
        self.line.what, self.line.fraction, self.line.is_named = record.getMessage(), 0.0, True
        self.line.tell()


def meter(
    what: str, given: Callable[..., None] | None = None, ticks: bool = True
) -> AbstractContextManager[Callable[..., None] | None]:
    """Return the context of some work, which yields what takes its progress: what is `given`, or a line.

    None within other work that has a line. With `ticks` that also counts the seconds of work that tells nothing.
    """
    line = getattr(_ACTIVE, "line", None)
    if given is None and line is not None and line.every and not line.is_named:  # that of a command
        line.what, line.fraction = what, 0.0
        return nullcontext(line)
    if given is not None or line is not None or sys.stderr is None:
        return nullcontext(given)
    return _Line(what, ticks)


@contextmanager
def shown_steps() -> Iterator[Callable[[str], None]]:
    """Show the progress of a command; yields the function that logs a message."""
    log, line = logging.getLogger("numerics"), _Line("computing", True, _COMMAND)
    handler = _Messages(line)
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        with line:
            yield log.info
    finally:
        log.removeHandler(handler)
