"""Whether a pair sticks for ever under a periodic force, and in which motion; whether it grows without a damper.

The stuck pair is one body of the mass M on the spring. Its own response (`stuck_state`) is a motion of the pair exactly
if its load stays within what friction holds at rest; for a1 = 0 others, with a free oscillation, may stick where that
breaks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial

from flint import acb, arb

from numerics.arithmetic.ball import undecided
from numerics.control.answers import not_negative, number, rounded
from numerics.control.orbit import Drive
from numerics.control.thresholds import Thresholds, load_margin, stiffness
from numerics.linear.system import ONE, is_positive_on

_PARTS = 8
"""Times of a period among which the one with the least load is taken."""


def stuck_state(drive: Drive, t: arb, mass: Fraction | None = None) -> tuple[arb, arb, arb, arb] | None:
    """Return (x1, v1, 0, v1) of the stuck response at a time (s); None at a resonance of the stuck pair, a1 = 0.

    With another mass than M (kg) that of so large a body on the spring.
    """
    pair, mass = drive.pair, mass or drive.pair.mass
    x, v = number(drive.rest), arb(0)
    for one in drive.piece.sines:
        if stiffness(pair, mass, one.omega).is_zero():
            return None
        below = acb(number(pair.a2 - mass * one.omega**2), number(pair.a1 * one.omega))
        turned = acb.exp(acb(0, number(one.omega) * t + number(one.phase)))
        moved = turned * number(one.amplitude) / below
        x, v = x + moved.imag, v + number(one.omega) * moved.real
    return x, v, arb(0), v


def next_to_the_stuck_response(drive: Drive) -> Iterator[tuple[Fraction, list[arb]]]:
    """Yield the stuck response, and the motion next to the critical orbit, each at the time of a period that loads it

    least of some.
    """
    times = [rounded(drive.period * k / _PARTS) for k in range(1, _PARTS)]
    for state_at in (stuck_state, _creeping_state):
        states = [(t, state) for t in times if (state := state_at(drive, number(t))) is not None]
        for t, (x1, v1, _, v2) in sorted(states, key=lambda one: _load(drive, *one))[:1]:
            yield t, [x1, v1, v2]


def _creeping_state(drive: Drive, t: arb) -> tuple[arb, arb, arb, arb] | None:
    """Return (x1, v1, 0, v1) about where the bodies stick at a time (s), if a weak sine near resonance makes them slip.

    The stuck pair swings as x1 = -A cos(p - phi) under U sin p, U sin phi = -(a2 - M omega^2) A. What is left of U cos
    phi beside damping friction takes, near the critical orbit by A^2 = L^2 (1 + w), w^2 = 4 pi (U cos phi - a1 omega L)
    m1/(9 b M), L the half-width. Approximate, of the sine next to resonance.
    """
    pair, sines = drive.pair, [one for one in drive.piece.sines if one.amplitude]
    away = [abs((pair.a2 - pair.mass * one.omega**2) / one.amplitude) for one in sines]
    sine = sines[away.index(min(away))]
    across = number((pair.mass * sine.omega**2 - pair.a2) * pair.half_width / abs(sine.amplitude))
    left = 1 - across * across
    if not left > 0:
        return None
    along = left.sqrt() - number(pair.a1 * sine.omega * pair.half_width / abs(sine.amplitude))
    if not along > 0:
        return None
    square = along * arb.pi() * number(4 * abs(sine.amplitude) * pair.m1 / (9 * pair.b * pair.mass))
    far = number(pair.half_width * (1 if sine.amplitude > 0 else -1)) * (1 + square.sqrt()).sqrt()
    s, c = (number(sine.omega) * t + number(sine.phase) - across.asin()).sin_cos()
    v1 = number(sine.omega) * far * s
    return number(drive.rest) - far * c, v1, arb(0), v1


def _load(drive: Drive, t: Fraction, state: Sequence[arb]) -> float:
    """Return the size of the load at a time (s) in a state, N."""
    motion = drive.mode(0).motion(state, number(t))
    return abs(float(motion.range(motion.mode.load, arb(0))))


def resonant_growth(drive: Drive) -> arb:
    """Return (U^ - 4b/pi)/(2 m1) if a1 = 0 and the force's amplitude U^ at omega1 is above 4b/pi, m/s^2; else 0.

    Where friction depends on the speed b is the most that it can be.
    """
    pair = drive.pair
    resonant = [one for one in drive.piece.sines if one.omega**2 * pair.m1 == pair.a2]
    most = drive.most_friction
    if pair.a1 != 0 or not resonant or most is None:
        return arb(0)
    total = sum((acb.exp(acb(0, number(one.phase))) * number(one.amplitude) for one in resonant), acb(0))
    over = abs(total) - 4 * number(most) / arb.pi()
    grows = not_negative(over, "does the force bring more than friction takes at resonance?")
    return over / (2 * number(pair.m1)) if grows else arb(0)


def entrained(drive: Drive) -> bool:
    """Return whether the stuck response exists: |Lambda| <= b along it. Raises EventUndecided."""
    sines = drive.piece.sines
    if len(sines) == 1:
        return load_margin(drive.pair, sines[0].amplitude, sines[0].omega) >= 0
    state = stuck_state(drive, arb(0))
    if state is None:
        return False
    motion = drive.mode(0).motion(state, arb(0))
    rows = [(*((place, -side * c) for place, c in motion.mode.load), (ONE, drive.pair.b)) for side in (1, -1)]
    held = [is_positive_on(partial(motion.range, row), arb(0), drive.period) for row in rows]
    if None in held and False not in held:
        raise undecided("does friction hold the pair in its stuck response?", "load near b")
    return all(held)


def others_stick(drive: Drive, known: Thresholds | None) -> bool:
    """Return whether motions other than the response stick for ever (`Thresholds.exception`). Raises EventUndecided."""
    if known is None or known.exception is None:
        return False
    under = known.exception - number(abs(drive.piece.sines[0].amplitude))
    return not_negative(under, "does a free oscillation let the pair stick?")


def stuck_multipliers(drive: Drive) -> tuple[acb, ...]:
    """Return exp(lambda T) of the stuck pair's two rates, and 0: w dies in a finite time."""
    pair = drive.pair
    half = pair.a1 / (2 * pair.mass)
    rest = acb(number(half**2 - pair.a2 / pair.mass)).sqrt()
    return (*(acb.exp((one - number(half)) * drive.period) for one in (rest, -rest)), acb(0))
