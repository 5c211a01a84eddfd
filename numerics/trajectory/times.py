"""Times that somebody asks for: exact, or refused by their names."""

from __future__ import annotations

import math
import operator
from fractions import Fraction
from typing import Any

import numpy as np

from numerics.scene.decimals import short, shown


def exact_time(t: Any, name: str = "t") -> Fraction:
    """Return a time as an exact rational: text as a decimal, a float as its binary value. Raises ValueError."""
    try:
        if isinstance(t, bool):
            raise TypeError
        if hasattr(t, "as_integer_ratio"):
            return Fraction(*t.as_integer_ratio())
        return Fraction(t if isinstance(t, str) else operator.index(t))
    except (TypeError, ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"{name} = {shown(t)} is not a time in seconds; give a finite number >= 0") from None


def require_times(t_eval: Any, until: Fraction) -> None:
    """Raise ValueError unless these are times (s) of a run, in order; balls and mpmath's are looked at later."""
    try:
        given = np.asarray(t_eval)
    except ValueError:  # rows that differ in length
        given = np.asarray(None)
    except MemoryError:
        raise ValueError(f"t_eval = {shown(t_eval)} has more times than memory holds; give fewer at once") from None
    if given.ndim != 1:
        raise ValueError(f"t_eval = {shown(t_eval)} must be a sequence of times in seconds; give one such as [0, 0.5]")
    last, listed = float(min(until, Fraction(10**300))), given.tolist()
    if given.dtype.kind in "fiu":
        times = given.astype(float)
    else:
        exact = (one if hasattr(one, "man_exp") else exact_time(one, f"t_eval[{k}]") for k, one in enumerate(listed))
        times = np.array([float(one) if one <= 2 * last else math.inf for one in exact])
    for k in np.flatnonzero(~((times >= 0) & (times <= last)))[:1]:
        exact_time(listed[k], f"t_eval[{k}]")
        outside = f"t_eval[{k}] = {shown(listed[k])} s is outside the run, [0, {short(until)}] s"
        raise ValueError(f"{outside}; give times within it, or a later until")
    for k in np.flatnonzero(np.diff(times) < 0)[:1] + 1:
        raise ValueError(f"t_eval[{k}] = {shown(listed[k])} s comes after a later time; put the times in order")
