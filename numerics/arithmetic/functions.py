"""The functions of numbers, by the type of the number: mpmath's mpf, flint's arb.

A formula is written once, with operators and these, and works in both arithmetics; some work for floats, too. Each is
accurate relative to its own value; for balls every answer encloses the true one, and comparisons mean "proven". They
stand under their names in multiprecision.py, ball.py and float64.py.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb
from mpmath import mpf

from numerics.arithmetic import ball, float64, multiprecision
from numerics.arithmetic.protocol import Number


def _by_type(name: str, says: str) -> Callable[..., Any]:
    """Return the function of this name, as it is for the type of its first argument."""
    of = {mpf: getattr(multiprecision, name), arb: getattr(ball, name), float: getattr(float64, name, None)}

    def function(x: Number, *further: Any) -> Any:
        return of[type(x)](x, *further)

    function.__name__, function.__doc__ = name, says
    return function


as_float = _by_type("as_float", "Return the float nearest to x, or to the midpoint of a ball: it chooses only.")
midpoint = _by_type("midpoint", "Return x, or the midpoint of a ball, which is exact.")
two_pi = _by_type("two_pi", "Return 2 pi as a number of the type of x.")
sqrt = _by_type("sqrt", "Return the square root of x >= 0; of a ball, of its points that are >= 0.")
sine_cosine = _by_type("sine_cosine", "Return (sin x, cos x).")
atan2 = _by_type("atan2", "Of (y, x): return the angle of the point (x, y).")
sine_deficit = _by_type("sine_deficit", "Return x - sin x.")
depth_and_cotangent = _by_type("depth_and_cotangent", "Return 2 - x cot(x/2), cot(x/2), 0 < x < 2 pi.")
sign = _by_type("sign", "Of (x, question): return -1, 0, +1; raises EventUndecided where a ball leaves it open.")
ceiling = _by_type("ceiling", "Of (x, question): return the least whole number >= x, 0 for x <= 0; may raise, as sign.")
require_phase = _by_type("require_phase", "Raise OutOfRange if the digits do not keep the phase of an angle > 0.")
tolerance = _by_type("tolerance", "Return the relative step at which a search among numbers of the type of x ends.")


def versine(x: Number) -> Number:
    """Return 1 - cos x = 2 sin^2(x/2), which does not cancel."""
    sine, _ = sine_cosine(x / 2)
    return 2 * (sine * sine)


def cosine_deficit(x: Number) -> Number:
    """Return x^2/2 - 1 + cos x = 2 (t - sin t)(t + sin t), t = x/2."""
    half = x / 2
    return 2 * sine_deficit(half) * (half + sine_cosine(half)[0])
