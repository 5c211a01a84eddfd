"""What amplitudes a transfer over a distance needs: stuck at the limit of friction, and at least, by slipping first."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.thresholds import cosine_and_sine
from numerics.errors import EventUndecided
from numerics.scene import Pair


def stuck_amplitude(pair: Pair, far: Fraction, margin: Fraction) -> arb:
    """Return the largest |u| of the transfer that sticks at (1 - margin) b, N; an enclosure."""
    number, gain = Ball.number, (1 - margin) * pair.b / pair.m2
    found = number(pair.mass * gain + pair.a2 * far / 2) + number(pair.a1) * number(gain * far).sqrt()
    found = found.max(number(pair.a2 * far))
    if pair.a1**2 * gain <= pair.a2**2 * far:
        found = found.max(number(pair.a2 * far + pair.a1**2 * gain / (2 * pair.a2) - pair.mass * gain))
    return found


def least_amplitude(pair: Pair, far: Fraction) -> arb | None:
    """Return U_min = b + beta tau/g(tau), N, an enclosure; None where g' < 0 somewhere on [0, tau]."""
    number = Ball.number
    tau = number(pair.m2 * far / pair.b).sqrt()
    g, slope = _impulse_response(pair, tau)
    if slope is None or slope < 0:
        return None
    if not slope > 0:
        raise EventUndecided("does body 1 still run ahead at half time?", slope.str(6), working_digits())
    return number(pair.b) + number(pair.b / pair.m2) * tau / g


def _impulse_response(pair: Pair, t: arb) -> tuple[arb, arb | None]:
    """Return g(t) (m/(N s)), and m1 e^(a1 t/(2 m1)) g'(t), None if g' has changed sign for certain before t."""
    number, decay = Ball.number, pair.a1 / (2 * pair.m1)
    squared = pair.a2 / pair.m1 - decay**2
    cosine, sine = cosine_and_sine(squared, t)
    if squared > 0 and number(squared).sqrt() * t > arb.pi() / 2:
        return sine, None  # g' first vanishes at tan(omegad t) = omegad/decay, before a quarter turn
    return (-number(decay) * t).exp() * sine / number(pair.m1), cosine - number(decay) * sine


def reaches(most: Fraction, needed: arb) -> bool:
    """Return whether an amplitude is at least an enclosed one. Raises EventUndecided."""
    over = Ball.number(most) - needed
    if over >= 0:
        return True
    if over < 0:
        return False
    raise EventUndecided("does the amplitude suffice?", over.str(6), working_digits())
