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
def sine_by_series(swing: Swing, amplitude: Number, omega: Number, phase: Number, tau: Number, total: float) -> Moved:
    """Return the answer from rest by its power series: |x^(k)| <= (A/m) (rate + omega)^(k-2) at the start."""
    sine, cosine = sine_cosine(phase)
    f, g = amplitude * sine, amplitude * omega * cosine  # of the series of the force, two at a time
    a, b, power, position, speed = ZERO, ZERO, tau, ZERO, ZERO
    for k in range(swing.terms):
        c = ((f - swing.a1 * ((k + 1) * b) - swing.a2 * a) / swing.mass) / ((k + 1) * (k + 2))
        term = c * power
        speed, position = speed + (k + 2) * term, position + term * tau
        a, b, power = b, c, power * tau
        f, g = g, -(omega * omega) * f / ((k + 1) * (k + 2))
    rest = amplitude / swing.mass * tau
    for k in range(2, swing.terms + 2):
        rest = rest * (tau * swing.rate + tau * omega) / k
    push = abs(rough(amplitude / swing.mass)) * rough(tau)
    return Moved(
        widened(position, 4 * rest * tau),
        widened(speed, 4 * (swing.terms + 2) * rest),
        push * rough(tau) * (1.0 + total),
        push * (1.0 + total),
    )


@text
def sine_by_steady_state(
    swing: Swing, amplitude: Number, omega: Number, phase: Number, stiff: Number, tau: Number
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
    height, frequency = abs(rough(in_phase)) + abs(rough(behind)), rough(omega)
    turned = 1.0 + (abs(rough(phase)) + frequency * rough(tau)) / PHASES
    # the free motion: |z| t or |z|/rate, whichever is less
    reach = height * frequency * min(rough(tau), 1.0 / rough(swing.of.frequency) if swing.of.regime > 0 else rough(tau))
    return Moved(x, v, 2.0 * height * turned + reach, height * (frequency * turned + swing.rate))


@text
def sine_near_resonance(
    swing: Swing, amplitude: Number, omega: Number, phase: Number, detuning: Number, tau: Number
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
    turned = 1.0 + (abs(rough(phase)) + (rough(omega) + rough(n)) * rough(tau)) / PHASES
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
