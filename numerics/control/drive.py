"""What drives a pair in the long run, a constant and sines; whether the pair sticks permanently under it, or grows.

The stuck pair is one body of the mass M on the spring. Its own response (`stuck_motion`) is a motion of the pair
exactly if its load stays within what friction holds at rest; for a1 = 0 others, with a free oscillation, may stick
where that breaks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from flint import acb, arb

from numerics.arithmetic.ball import proved_sign, working_digits
from numerics.control.answers import KEPT_DIGITS, number, rounded_up
from numerics.control.thresholds import Thresholds, impedance, load_margin
from numerics.linear.system import LinearMode, LocalNorm
from numerics.scene import Force, Pair, Piece, Scene, Sine, State
from numerics.scene.largest import largest_size
from numerics.scene.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class PeriodicDrive(ShortRepr):
    """A pair under a periodic force: sines and a constant (N), t from the start of the run."""

    pair: Pair
    piece: Piece

    @property
    def frequency(self) -> Fraction:
        """Return the greatest frequency of which all are multiples, rad/s; 0 without sines."""
        return Force((self.piece,)).frequency or Fraction(0)

    @property
    def period(self) -> arb:
        """Return T = 2 pi/frequency, s."""
        return 2 * arb.pi() / number(self.frequency)

    @property
    def is_odd(self) -> bool:
        """Return whether u - c changes its sign after half a period, c its constant part; exact."""
        return all((one.omega / self.frequency) % 2 == 1 for one in self.piece.sines)

    @property
    def norm(self) -> LocalNorm:
        """Return N of differences of two motions, N^2 = a2 x1^2 + m1 v1^2 + m2 v2^2, in the arithmetic's context."""
        return LocalNorm(LinearMode.under(self.pair, 1, self.piece))

    @property
    def rest(self) -> Fraction:
        """Return where the constant part of the force holds body 1, m."""
        return sum(self.piece.polynomial, Fraction(0)) / self.pair.a2

    def one_period(self, begin: Fraction, at: Sequence[Fraction], digits: int = KEPT_DIGITS) -> Scene:
        """Return a period from a time (s) and (x1, v1, v2) on as a scene; it is rounded up to so many digits."""
        # a constant part of a phase beyond a turn is kept: the sine is the same function of time
        sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in self.piece.sines]
        force, (x1, v1, v2) = Force((Piece(0, self.piece.polynomial, sines),)), at
        return Scene(self.pair, State(x1, v1, 0, v2), until=rounded_up(self.period, digits), force=force)


def last_drive(scene: Scene) -> PeriodicDrive | None:
    """Return what acts from the last piece of force and friction on; None unless that is a constant and sines."""
    last = scene.force.pieces[-1] if scene.force.pieces else Piece(0)
    if len(last.polynomial) > 1:
        return None
    pair, b = scene.pair, scene.friction.steps[-1][1] if scene.friction.steps else scene.pair.b
    added = Force((replace(last, start=Fraction(0)),)) + Force()  # equal sines become one
    return PeriodicDrive(replace(pair, b=b), added.pieces[0])


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
