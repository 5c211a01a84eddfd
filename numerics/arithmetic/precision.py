"""Working precision, which flint and mpmath keep for the whole process: one thread at a time may hold it.

Every change of it is made here. A block that holds a precision is never left by `yield`: another thread would wait.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock
from typing import TYPE_CHECKING

import flint
import mpmath

__all__ = ["cached_property", "is_held", "mpmath_precision", "precision", "series_terms"]

if TYPE_CHECKING or sys.version_info >= (3, 12):
    from functools import cached_property
else:
    import functools

    class cached_property(functools.cached_property):  # noqa: N801 - its name there
        """That of Python 3.12: the older one locks its class, where a thread waits for one that waits for _LOCK."""

        def __get__(self, instance, owner=None):
            """Return the value, which is computed when it is first asked for."""
            if instance is None:
                return self
            found = vars(instance)[self.attrname] = self.func(instance)
            return found


_LOCK = RLock()
if hasattr(os, "register_at_fork"):  # a child has no other threads: none of them would ever release it there
    os.register_at_fork(before=_LOCK.acquire, after_in_parent=_LOCK.release, after_in_child=_LOCK.release)


def is_held() -> bool:
    """Return whether this thread holds a precision, so that no thread that it waits for may need one."""
    return bool(_LOCK._is_owned())  # type: ignore[attr-defined]


class precision:  # noqa: N801 - used like a function
    """Compute with balls of so many bits while other threads wait; what was set before is restored.

    The outermost of nested ones alone locks, and an interrupt that meets the end of an inner one leaves nothing behind:
    the outer ones restore what they found.
    """

    __slots__ = ("before", "bits", "is_outermost")

    def __init__(self, bits: int) -> None:
        """Take the bits."""
        self.bits = bits

    def __enter__(self) -> None:
        """Wait for other threads."""
        self.is_outermost = not is_held()
        if self.is_outermost:
            _LOCK.acquire()
        self.before, flint.ctx.prec = flint.ctx.prec, self.bits

    def __exit__(self, *_: object) -> None:
        """Restore what was set before."""
        flint.ctx.prec = self.before
        if self.is_outermost:
            _LOCK.release()


@contextmanager
def series_terms(terms: int) -> Iterator[None]:
    """Cut power series of flint after so many terms while other threads wait; what was set before is restored."""
    with _LOCK:
        before, flint.ctx.cap = flint.ctx.cap, terms
        try:
            yield
        finally:
            flint.ctx.cap = before


@contextmanager
def mpmath_precision(bits: int) -> Iterator[None]:
    """Compute with numbers of mpmath of so many bits while other threads wait; what was set before is restored."""
    with _LOCK, mpmath.workprec(bits):
        yield
