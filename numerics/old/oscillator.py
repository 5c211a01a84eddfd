"""The damped harmonic oscillator y'' + 2 d y' + k y = 0 in its three regimes, free of cancellation at their borders.

Which regime holds is decided on exact rationals by the caller; near the border both neighbours stay accurate, since
sin(n t)/n and (1 - e^(-2 n t))/(2 n) are formed whole (n^2 = |k - d^2|).
"""

from __future__ import annotations

from dataclasses import dataclass

from numerics.arithmetic.dual import differentiated
from numerics.arithmetic.protocol import Arithmetic, Number, Sign, decide_sign
from numerics.old import tangent


@dataclass(frozen=True, slots=True)
class Oscillator:
    """y'' + 2 decay y' + stiffness y = 0, dimensionless; regime = sign of stiffness - decay^2, exact."""

    arithmetic: Arithmetic
    decay: Number
    stiffness: Number
    regime: int
    frequency: Number
    """sqrt(|stiffness - decay^2|)."""

    def propagate(self, y: Number, v: Number, t: Number) -> tuple[Number, Number]:
        """Return (y, y') after time t from (y, v); exact up to rounding, an enclosure for balls."""
        if self.regime < 0 and self.arithmetic.to_float(self.frequency * t) > 1:
            return self._separated(y, v, t)
        cosine, sine = self._basis(t)
        return (
            y * cosine + (v + self.decay * y) * sine,
            v * cosine - (self.decay * v + self.stiffness * y) * sine,
        )

    def _basis(self, t: Number) -> tuple[Number, Number]:
        """Return e^(-dt) (cos nt, sin(nt)/n), their limits (1, t), or cosh and sinh instead."""
        formula = lambda found: tangent.basis(self, t, found)  # noqa: E731
        return differentiated(self.arithmetic, lambda: self._values(t), formula)

    def _values(self, t: Number) -> tuple[Number, Number]:
        arithmetic, n = self.arithmetic, self.frequency
        if self.regime > 0:
            cosine, sine = arithmetic.cos_sin(n * t)
            envelope = arithmetic.exp(-self.decay * t)
            return envelope * cosine, envelope * sine / n
        if self.regime == 0:
            envelope = arithmetic.exp(-self.decay * t)
            return envelope, envelope * t
        slow = arithmetic.exp(-self.slow_rate * t)
        drop = -arithmetic.expm1(-2 * n * t)
        return slow * (2 - drop) / 2, slow * drop / (2 * n)

    @property
    def slow_rate(self) -> Number:
        """decay - frequency of the overdamped regime, as stiffness/(decay + frequency): float64 within 1.5 ulp."""
        return self.stiffness / (self.decay + self.frequency)

    def _separated(self, y: Number, v: Number, t: Number) -> tuple[Number, Number]:
        """Return the overdamped solution by its two exponentials: right once they differ by more than e^2."""
        slow, fast = self.slow_rate, self.decay + self.frequency
        c1 = (v + fast * y) / (2 * self.frequency) * self.arithmetic.exp(-slow * t)
        c2 = -(v + slow * y) / (2 * self.frequency) * self.arithmetic.exp(-fast * t)
        return c1 + c2, -slow * c1 - fast * c2

    def first_zero(self, y: Number, v: Number, horizon: Number | None = None) -> Number | None:
        """Return the first t > 0 with y(t) = 0 for the solution from (y, v); None if there is none (up to the horizon).

        The horizon settles starts on an eigenline, whose zero at infinity balls cannot tell from one that is very late.
        Zeros of the underdamped regime follow each other at distance pi/frequency. Raises EventUndecided.
        The overdamped zero in float64, as long as v + d y does not cancel: the counted roundings give 5.2 ulp (1.2 u in
        the reach, 1 u in 2 n y, 1 u in their ratio, 1.5 u in log1p, the division 0.5 ulp), the audit measures 3.
        """
        arithmetic, n = self.arithmetic, self.frequency
        lean = v + self.decay * y
        side = decide_sign(arithmetic, y, "on which side of zero does the oscillation start?")
        if self.regime > 0:
            return (arithmetic.atan2(side * y * n, -side * lean) if side else arithmetic.pi()) / n
        if self.regime == 0 and horizon is not None and self._smaller(lean * horizon, y):
            return None
        towards = decide_sign(arithmetic, -side * lean, "does the damped motion head for zero?") if side else 0
        if towards <= 0:
            return None
        if self.regime == 0:
            return -y / lean
        reach = v + (self.decay + n) * y
        if decide_sign(arithmetic, -side * reach, "does the overdamped motion pass zero?") <= 0:
            return None
        return self._log_quotient(reach, lean - n * y, -2 * n * y) / (2 * n)

    def _smaller(self, x: Number, y: Number) -> bool:
        """Return whether |x| < |y| is proved."""
        return self.arithmetic.sign(y * y - x * x) is Sign.POSITIVE

    def _log_quotient(self, base: Number, other: Number, excess: Number) -> Number:
        """Return log(other/base), other = base + excess; next to critical damping the quotient would round to 1.

        The logarithm of 1 + ratio takes over no more than twice the relative error of a ratio > -1/2.
        """
        arithmetic, ratio = self.arithmetic, excess / base
        return arithmetic.log1p(ratio) if arithmetic.to_float(ratio) > -0.5 else arithmetic.log(other / base)

    def first_jerk_zero(self, y: Number, v: Number, horizon: Number, *, level: bool) -> Number | None:
        """Return the first t in (0, horizon] with third derivative 0, or a later one, or None if there is none.

        `level` says that it is 0 exactly at t = 0.

        It obeys the same equation; its overdamped zero is taken from the two exponentials of y, since far above
        critical damping the slow one cancels in the derivatives at 0. Raises EventUndecided.
        """
        arithmetic = self.arithmetic
        if self.regime >= 0:
            acceleration = -(2 * self.decay * v + self.stiffness * y)
            jerk = arithmetic.number(0) if level else -(2 * self.decay * acceleration + self.stiffness * v)
            return self.first_zero(jerk, -(2 * self.decay * jerk + self.stiffness * acceleration), horizon)
        if level:
            return None
        slow, fast = self.slow_rate, self.decay + self.frequency
        ratio = fast / slow
        slow_part, fast_part = v + fast * y, v + slow * y  # up to one factor
        faded = ratio * ratio * ratio * fast_part * arithmetic.exp(-2 * self.frequency * horizon)
        if self._smaller(slow_part, faded):
            return None  # the slow part is too small, or exactly 0, to take over before the horizon
        side = decide_sign(arithmetic, slow_part, "has the overdamped motion a slow part?")
        # a fast part that has died away has no sign, but it is proved to be too small
        excess = side * (ratio * ratio * ratio * fast_part - slow_part)
        if not side or decide_sign(arithmetic, excess, "does the overdamped motion turn after its start?") <= 0:
            return None
        twice = 2 * self.frequency
        return (
            3 * self._log_quotient(slow, fast, twice) + self._log_quotient(slow_part, fast_part, -twice * y)
        ) / twice

    def integral_of_square(self, y: Number, v: Number, t: Number) -> Number:
        """Return the integral of y(s)^2 over 0 <= s <= t for the solution from (y, v).

        From the end values: (y'^2 + k y^2)' = -4 d y'^2 gives the integral of y'^2, then (y y' + d y^2)' = y'^2 - k y^2
        that of y^2. The absolute rounding error is a few ulp of (y^2 + y'^2/k)/d, which is too much where damping is
        far above critical: there the squares of the two exponentials are integrated.
        """
        if self.regime < 0 and self.arithmetic.to_float(2 * self.frequency - self.decay) > 0:
            return self._separated_integral(y, v, t)
        y_end, v_end = self.propagate(y, v, t)
        k, d = self.stiffness, self.decay
        square_rate = (v * v - v_end * v_end + k * (y * y - y_end * y_end)) / (4 * d)
        return (square_rate + (y * v - y_end * v_end) + d * (y * y - y_end * y_end)) / k

    def _separated_integral(self, y: Number, v: Number, t: Number) -> Number:
        slow, fast = self.slow_rate, self.decay + self.frequency
        c1, c2 = (v + fast * y) / (2 * self.frequency), -(v + slow * y) / (2 * self.frequency)

        def spent(rate: Number) -> Number:
            return -self.arithmetic.expm1(-rate * t) / rate

        return c1 * c1 * spent(2 * slow) + 2 * c1 * c2 * spent(slow + fast) + c2 * c2 * spent(2 * fast)
