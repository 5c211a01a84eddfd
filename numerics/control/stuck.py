"""Whether a pair sticks permanently under a periodic force, and in which motion; whether it grows without a damper.

The stuck pair is one body of the mass M on the spring. Its own response (`stuck_state`) is a motion of the pair exactly
if its load stays within what friction holds at rest; for a1 = 0 others, with a free oscillation, may stick where that
breaks.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from flint import acb, arb

from numerics.arithmetic.ball import proved_sign, undecided
from numerics.control.answers import number, rounded
from numerics.control.orbit import PeriodicDrive, State3
from numerics.control.thresholds import Thresholds, impedance, load_margin
from numerics.linear.system import Motion, is_positive_on

_PARTS = 8
"""Times of a period among which the one with the least load is taken."""


def stuck_state(drive: PeriodicDrive, t: arb, mass: Fraction | None = None) -> State3 | None:
    """Return (x1, v1, v1) of the stuck response at a time (s); None at a resonance of the stuck pair, a1 = 0.

    With another mass than M (kg) that of so large a body on the spring.
    """
    pair, mass = drive.pair, mass or drive.pair.mass
    x, v = number(drive.rest), arb(0)
    for one in drive.piece.sines:
        below = impedance(pair, mass, one.omega)
        if below == 0:
            return None
        turned = acb.exp(acb(0, number(one.omega) * t + number(one.phase)))
        moved = turned * number(one.amplitude) / below
        x, v = x + moved.imag, v + number(one.omega) * moved.real
    return x, v, v


def next_to_the_stuck_response(drive: PeriodicDrive) -> Iterator[tuple[Fraction, State3]]:
    """Yield the stuck response, and the motion next to the critical orbit, each at the time of a period that loads it

    least of some.
    """
    times = [rounded(drive.period * k / _PARTS) for k in range(1, _PARTS)]
    for state_at in (stuck_state, _creeping_state):
        states = [(t, state) for t in times if (state := state_at(drive, number(t))) is not None]
        if states:
            yield min(states, key=lambda one: _load(drive, *one))


def _creeping_state(drive: PeriodicDrive, t: arb) -> State3 | None:
    """Return (x1, v1, v1) about where the bodies stick at a time (s), if a weak sine near resonance makes them slip.

    The stuck pair swings as x1 = -A cos(p - phi) under U sin p, U sin phi = -(a2 - M omega^2) A. What is left of U cos
    phi beside damping friction takes, near the critical orbit by A^2 = L^2 (1 + w), w^2 = 4 pi (U cos phi - a1 omega L)
    m1/(9 b M), L the half-width. Approximate, of the sine next to resonance.
    """
    pair = drive.pair
    sine = min(
        (one for one in drive.piece.sines if one.amplitude),
        key=lambda one: abs((pair.a2 - pair.mass * one.omega**2) / one.amplitude),
    )
    U, L, omega = abs(sine.amplitude), pair.half_width, number(sine.omega)
    across = number((pair.mass * sine.omega**2 - pair.a2) * L / U)
    left = 1 - across * across
    along = left.sqrt() - number(pair.a1 * sine.omega * L / U)
    if not (left > 0 and along > 0):
        return None
    square = along * arb.pi() * number(4 * U * pair.m1 / (9 * pair.b * pair.mass))
    far = number(L if sine.amplitude > 0 else -L) * (1 + square.sqrt()).sqrt()
    s, c = (omega * t + number(sine.phase) - across.asin()).sin_cos()
    return number(drive.rest) - far * c, omega * far * s, omega * far * s


def _stuck(drive: PeriodicDrive, t: arb, state: State3) -> Motion:
    """Return the stuck motion from (x1, v1, v1) at a time (s)."""
    x1, v1, v2 = state
    return drive.motion(0, (x1, v1, arb(0), v2), t)


def _load(drive: PeriodicDrive, t: Fraction, state: State3) -> float:
    """Return the size of the load at a time (s) in a state, N."""
    motion = _stuck(drive, number(t), state)
    return abs(float(motion.range(motion.mode.load, arb(0))))


def resonant_growth(drive: PeriodicDrive) -> arb:
    """Return (U^ - 4b/pi)/(2 m1) if a1 = 0 and the force's amplitude U^ at omega1 is above 4b/pi, m/s^2; else 0."""
    pair = drive.pair
    resonant = [one for one in drive.piece.sines if one.omega**2 * pair.m1 == pair.a2]
    if pair.a1 != 0 or not resonant:
        return arb(0)
    total = sum((acb.exp(acb(0, number(one.phase))) * number(one.amplitude) for one in resonant), acb(0))
    over = abs(total) - 4 * number(pair.b) / arb.pi()
    grows = proved_sign(over, "does the force bring more than friction takes at resonance?") > 0
    return over / (2 * number(pair.m1)) if grows else arb(0)


def entrained(drive: PeriodicDrive) -> bool:
    """Return whether the stuck response exists: |Lambda| <= b along it. Raises EventUndecided."""
    sines = drive.piece.sines
    if len(sines) == 1:
        return load_margin(drive.pair, sines[0].amplitude, sines[0].omega) >= 0
    state = stuck_state(drive, arb(0))
    if state is None:
        return False
    motion = _stuck(drive, arb(0), state)
    held = [is_positive_on(partial(motion.range, row), arb(0), drive.period) for row in motion.mode.guards]
    if None in held and False not in held:
        raise undecided("does friction hold the pair in its stuck response?", "load near b")
    return all(held)


def others_stick(drive: PeriodicDrive, known: Thresholds | None) -> bool:
    """Return whether other motions than the response stick permanently (`Thresholds.exception`)."""
    if known is None or known.exception is None:
        return False
    under = known.exception - number(abs(drive.piece.sines[0].amplitude))
    return proved_sign(under, "does a free oscillation let the pair stick?") >= 0


def stuck_multipliers(drive: PeriodicDrive) -> tuple[acb, ...]:
    """Return exp(lambda T) of the stuck pair's two rates, and 0: w dies in a finite time."""
    pair = drive.pair
    half = pair.a1 / (2 * pair.mass)
    rest = acb(number(half**2 - pair.a2 / pair.mass)).sqrt()
    return (*(acb.exp((one - number(half)) * drive.period) for one in (rest, -rest)), acb(0))
