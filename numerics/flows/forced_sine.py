"""The answer of a mode's oscillator from rest to one sine, in three forms, none of which cancels where it is used.

A power series for short times; next to resonance phi(z) = (1 - e^(-z tau))/z, with z the complex distance from it;
elsewhere the steady state and the free motion that starts against it.
"""

from __future__ import annotations

from numerics.arithmetic.float64 import ZERO, exp, expm1, rough, sign, sine_cosine, versine, widened
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.questions import SIDE_OF_ZERO
from numerics.arithmetic.telling import text
from numerics.flows.forced_records import PHASES, Moved, Swing
from numerics.flows.oscillator import propagate


@text
def sine_by_series(swing: Swing, amplitude: Number, omega: Number, phase: Number, off: float, tau: Number) -> Moved:
    """Return the answer from rest by its power series: |x^(k)| <= (A/m) (rate + omega)^(k-2) at the start."""
    sine, cosine = sine_cosine(phase)
    turned, v_size = omega * tau, 0.0
    # the series of the force, two at a time, and d_k, d_(k+1)/tau as in flows/forced.py
    f, g, drag, stiff = amplitude * sine, amplitude * turned * cosine, swing.a1 * tau, swing.a2 * tau
    a, b, position, speed = ZERO, ZERO, ZERO, ZERO
    for k in range(swing.terms):
        c = ((f * tau - drag * ((k + 1) * b) - stiff * a) / swing.mass) / ((k + 1) * (k + 2))
        speed, position = speed + (k + 2) * c, position + c * tau
        v_size += (k + 2) * abs(rough(c))
        a, b = b * tau, c
        f, g = g, -(turned * turned) * f / ((k + 1) * (k + 2))
    rest = amplitude / swing.mass * tau
    for k in range(2, swing.terms + 2):
        rest = rest * (tau * swing.rate + tau * omega) / k
    # a phase that is off changes the force by its other half
    v_size += abs(rough(amplitude * cosine / swing.mass * tau)) * off
    x_size = v_size * rough(tau)
    return Moved(widened(position, 4 * rest * tau), widened(speed, 4 * (swing.terms + 2) * rest), x_size, v_size)


@text
def sine_by_steady_state(
    swing: Swing, amplitude: Number, omega: Number, phase: Number, off: float, stiff: Number, tau: Number
) -> Moved:
    """Return the answer from rest as steady state plus free motion; `stiff` = a2 - m omega^2."""
    drag = swing.a1 * omega
    scale = amplitude / (stiff * stiff + drag * drag)
    in_phase, behind = stiff * scale, drag * scale
    sine, cosine = sine_cosine(phase)
    sine_end, cosine_end = sine_cosine(phase + omega * tau)
    y, z = in_phase * sine - behind * cosine, omega * (in_phase * cosine + behind * sine)
    free, free_speed = propagate(swing.of, -y, -z, tau)
    x = in_phase * sine_end - behind * cosine_end + free
    v = omega * (in_phase * cosine_end + behind * sine_end) + free_speed
    x_begin, v_begin = steady_sizes(in_phase, behind, sine, cosine, rough(omega), off)
    x_end, v_end = steady_sizes(in_phase, behind, sine_end, cosine_end, rough(omega), off + rough(omega * tau) / PHASES)
    # the free motion from (y, z): |z| t or |z|/rate, whichever is less
    reach = v_begin * min(rough(tau), 1.0 / rough(swing.of.frequency) if swing.of.regime > 0 else rough(tau))
    return Moved(x, v, x_end + x_begin + reach, v_end + v_begin + swing.rate * x_begin)


@text
def steady_sizes(
    in_phase: Number, behind: Number, sine: Number, cosine: Number, omega: float, off: float
) -> tuple[float, float]:
    """Return the sizes of what a steady state's position and velocity are sums of; `off` is the size of its phase."""
    one = abs(rough(in_phase * sine)) + abs(rough(behind * cosine))
    two = abs(rough(in_phase * cosine)) + abs(rough(behind * sine))
    return one + off * two, omega * (two + off * one)


@text
def sine_near_resonance(
    swing: Swing, amplitude: Number, omega: Number, phase: Number, off: float, detuning: Number, tau: Number
) -> Moved:
    """Return the answer from rest, exact at resonance and free of cancellation next to it; light damping.

    With n the frequency, r = -decay +- i n and Q = (1 - e^(-z tau))/z at z = i omega - r: Q(r+) - Q(r-) times
    e^(i(omega tau + phase)) has minus its real part in x, over 2 m n/A. `detuning` = n^2 - omega^2, from exact numbers.
    """
    n, decay = swing.of.frequency, swing.of.decay
    near = -detuning / (n + omega)
    re_1, im_1 = faded_turn(decay, near, tau)
    re_2, im_2 = faded_turn(decay, n + omega, tau)
    sine, cosine = sine_cosine(phase + omega * tau)
    scale = -amplitude / (2 * swing.mass * n)
    re, im = re_1 - re_2, im_1 - im_2
    # r+ Q+ - r- Q- = -decay (Q+ - Q-) + i n (Q+ + Q-)
    re_v, im_v = -decay * re - n * (im_1 + im_2), n * (re_1 + re_2) - decay * im
    scaled = abs(rough(scale)) * (abs(rough(re_1)) + abs(rough(im_1)) + abs(rough(re_2)) + abs(rough(im_2)))
    turned = 1.0 + off + (rough(omega) + rough(n)) * rough(tau) / PHASES
    x, v = scale * (cosine * re - sine * im), scale * (cosine * re_v - sine * im_v)
    return Moved(x, v, scaled * turned, scaled * turned * swing.rate)


@text
def faded_turn(decay: Number, omega: Number, tau: Number) -> tuple[Number, Number]:
    """Return real and imaginary part of (1 - e^(-z tau))/z for z = decay + i omega; tau at z = 0 exactly."""
    if sign(decay, SIDE_OF_ZERO) == 0:
        if sign(omega, SIDE_OF_ZERO) == 0:
            return tau, ZERO
        sine, _ = sine_cosine(omega * tau)
        return sine / omega, -versine(omega * tau) / omega
    left = exp(-decay * tau)
    sine, _ = sine_cosine(omega * tau)
    re, im = left * versine(omega * tau) - expm1(-decay * tau), left * sine
    square = decay * decay + omega * omega
    return (re * decay + im * omega) / square, (im * decay - re * omega) / square
