"""The functions of numbers, by the type of the number: float, mpmath's mpf, flint's arb.

A formula is written once, with operators and these, and works in every arithmetic. Each is accurate relative to its own
value; for balls every answer encloses the true one, and comparisons mean "proven". They stand under their names in
elementary.py, multiprecision.py and ball.py; where compiled code calls one of them, it takes that of the first.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb
from mpmath import mpf

from numerics.arithmetic import ball, elementary, multiprecision
from numerics.arithmetic.compiled import by_type, compilable
from numerics.arithmetic.protocol import Number


def _by_type(name: str, says: str) -> Callable[..., Any]:
    """Return the function of this name, as it is for the type of its first argument."""
    of_floats = getattr(elementary, name)
    of = {float: of_floats, mpf: getattr(multiprecision, name), arb: getattr(ball, name)}

    def function(x: Number, *further: Any) -> Any:
        return of[type(x)](x, *further)

    function.__name__, function.__doc__ = name, says
    return by_type(of_floats)(function)


like = _by_type("like", "Of (x, value): return a float, exactly, as a number of the type of x.")
as_float = _by_type("as_float", "Return the float nearest to x, or to the midpoint of a ball: it chooses only.")
two_pi = _by_type("two_pi", "Return 2 pi as a number of the type of x.")
sqrt = _by_type("sqrt", "Return the square root of x >= 0; of a ball, of its points that are >= 0.")
sine_cosine = _by_type("sine_cosine", "Return (sin x, cos x).")
atan2 = _by_type("atan2", "Of (y, x): return the angle of the point (x, y).")
sine_deficit = _by_type("sine_deficit", "Return x - sin x.")
depth_and_cotangent = _by_type("depth_and_cotangent", "Return 2 - x cot(x/2), cot(x/2), 0 < x < 2 pi (points: - 1).")
sign = _by_type("sign", "Of (x, question): return -1, 0, +1; raises EventUndecided where a ball leaves it open.")
ceiling = _by_type("ceiling", "Of (x, question): return the least whole number >= x, 0 for x <= 0; may raise, as sign.")
finite = _by_type("finite", "Return whether x is a number.")
resolved = _by_type("resolved", "Return whether the digits keep the phase of an angle > 0.")
tolerance = _by_type("tolerance", "Return the relative step at which a search among numbers of the type of x ends.")
clock = _by_type("clock", "Of (total, rest, term): return their sum, and what its rounding left out, to be added on.")


@compilable
def signed(side: float, x: Number) -> Number:
    """Return side x, for side = -1.0 or +1.0."""
    return x if side > 0.0 else -x


@compilable
def versine(x: Number) -> Number:
    """Return 1 - cos x = 2 sin^2(x/2), which does not cancel; in floats normal from |x| = 1e-153 on.

    Within 2.1 ulp: for a sine of mantissa m its square has the error (2.2/m + 0.5) u.
    """
    sine, _ = sine_cosine(x / 2)
    return 2 * (sine * sine)


@compilable
def cosine_deficit(x: Number) -> Number:
    """Return x^2/2 - 1 + cos x = 2 (t - sin t)(t + sin t), t = x/2; in floats normal from |x| = 1e-76 on."""
    half = x / 2
    return 2 * sine_deficit(half) * (half + sine_cosine(half)[0])
