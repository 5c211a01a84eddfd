"""The vocabulary of the texts: what every arithmetic says in its own way.

An arithmetic is a module that defines each of these names; float64.py is the one that the texts import them from.

    ZERO UNIT WIDTH      0; what roundings are counted in; columns of a number in a row of an array
    exactly(n)           a small whole number, or a power of 2, as a number        undefined()  infinite()
    signed(side, x)      side x, for side = -1.0 or +1.0                           turn()  half_turn()  2 pi and pi
    sqrt exp expm1 log log1p sin atan2 sine_cosine      each accurate relative to its own value
    versine(x)           1 - cos x                    sine_deficit(x)    x - sin x
    cosine_deficit(x)    x^2/2 - 1 + cos x
    depth_and_cotangent(x)     2 - x cot(x/2) and cot(x/2)
    sign(x, question)    -1, 0 or +1; raises EventUndecided(question) where balls leave it open; 0 for nan
    positive(x)          whether x > 0 is certain     below(x, y)        whether x < y, for numbers that are points
    rough(x)             a float next to x: it chooses, it never decides
    leading(x)           x to half of its digits, where that is cheaper    part(x)   the same as a number
    finite(x)            whether it is a number       resolved(angle)    whether the digits keep its phase
    ceiling(x, question) the least whole number >= x, 0 for x <= 0
    nonnegative(x)       max(x, 0)                    clock(total, rest, term)   a sum and what its rounding leaves out
    size(x)              |x|, to compare with others  tolerance()  settled()     relative steps at which a search ends
    fading()             decay times after which an oscillation has died away below the last digit
    middle(x)  spread(x)  widened(x, by)   the point in the middle of x; its radius, 0 for points; x and all within `by`
    put(row, index, numbers)   write numbers to a row, from a column on
"""

from __future__ import annotations

from types import ModuleType
from typing import Any

WORDS = (
    *("ZERO", "UNIT", "WIDTH", "exactly", "undefined", "infinite", "signed", "turn", "half_turn"),
    *("sqrt", "exp", "expm1", "log", "log1p", "sin", "atan2", "sine_cosine"),
    *("versine", "sine_deficit", "cosine_deficit", "depth_and_cotangent"),
    *("sign", "positive", "below", "rough", "leading", "part", "finite", "resolved", "ceiling", "nonnegative", "clock"),
    *("size", "tolerance", "settled", "fading", "middle", "spread", "widened", "put"),
)


def words_of(module: ModuleType) -> dict[str, Any]:
    """Return the words that an arithmetic's module defines."""
    return {name: getattr(module, name) for name in WORDS}
