"""Whether a pair sticks permanently under a periodic force, and in which motion; whether it grows without a damper.

The stuck pair is one body of the mass M on the spring. Its own response (`stuck_motion`) is a motion of the pair
exactly if its load stays within what friction holds at rest; for a1 = 0 others, with a free oscillation, may stick
where that breaks.
"""

from __future__ import annotations

from fractions import Fraction

from flint import acb, arb

from numerics.arithmetic.ball import proved_sign, working_digits
from numerics.control.answers import number
from numerics.control.orbit import PeriodicDrive
from numerics.control.thresholds import Thresholds, impedance, load_margin
from numerics.scene.largest import largest_size


def stuck_motion(drive: PeriodicDrive, t: arb | int = 0, mass: Fraction | None = None) -> list[arb] | None:
    """Return x1 and its first four derivatives in the stuck response at a time (s); None at a resonance, a1 = 0.

    With another mass than M (kg) that of so large a body on the spring.
    """
    found = [number(drive.rest), *[arb(0)] * 4]
    for one in drive.piece.sines:
        below = impedance(drive.pair, mass or drive.pair.mass, one.omega)
        if below == 0:
            return None
        turned = acb.exp(acb(0, number(one.omega) * t + number(one.phase))) * number(one.amplitude) / below
        for order in range(5):
            found[order] += turned.imag
            turned *= acb(0, number(one.omega))
    return found


def entrained(drive: PeriodicDrive) -> bool:
    """Return whether the stuck response exists: m2 |x1''| <= b along it. Raises EventUndecided."""
    sines = drive.piece.sines
    if len(sines) == 1:
        return load_margin(drive.pair, sines[0].amplitude, sines[0].omega) >= 0
    if stuck_motion(drive) is None:
        return False

    def acceleration(t: arb, order: int) -> arb:
        motion = stuck_motion(drive, t)
        assert motion is not None
        return motion[2 + order]

    most = number(drive.pair.b / drive.pair.m2)
    peak, _ = largest_size(acceleration, arb(0), drive.period, working_digits() // 2, enough=most)
    return proved_sign(most - peak, "does friction hold the pair in its stuck response?") >= 0


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
