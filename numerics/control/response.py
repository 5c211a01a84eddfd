"""Long-time response of a pair to a periodic force: entrained, stick-slip, non-stop, or growing without bound.

The last piece of the force, a constant and sines of commensurable frequencies, and the last friction decide. For a1 >
0 there is one periodic (x1, v1, v2), and every motion tends to it. For a1 = 0 the motion found exists; `attraction`
says more. Friction that depends on the state is refused: there several periodic motions may exist.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction
from typing import TYPE_CHECKING, cast

from flint import acb, arb

from numerics.arithmetic.attempts import SPARE_DIGITS, to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import KEPT_DIGITS, most_digits, number, rounded
from numerics.control.drive import (
    PeriodicDrive,
    entrained,
    last_drive,
    others_stick,
    resonant_growth,
    stuck_motion,
    stuck_multipliers,
)
from numerics.control.orbit import MAX_EVENTS, Orbit, middle, search, solve_orbit
from numerics.control.rotating import pictures, rotating_force, rotating_response
from numerics.control.thresholds import Thresholds, load_margin, thresholds
from numerics.errors import EventUndecided, InvalidScene, NotSettled
from numerics.meter import meter
from numerics.scene import Force, Scene
from numerics.scene.decimals import Exact, exact_decimal, positive, require_digits
from numerics.scene.model import require_plain
from numerics.scene.plane import PlaneScene
from numerics.scene.short_repr import ShortRepr

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_EVERY = "every motion tends to it"
_SEARCHES = 2
"""So many searches without a damper may end undecided: with more digits there may be no motion to find either."""


class Regime(Enum):
    """Long-time regime; the value is a sentence."""

    ENTRAINED = "entrained: a motion in which the bodies stick permanently"
    STICK_SLIP = "stick-slip: the bodies slip and stick in every period"
    NON_STOP = "non-stop: the bodies never stick"
    GROWS = "grows without bound: at resonance the force supplies more energy than friction dissipates"


@dataclass(frozen=True, repr=False)
class Response(ShortRepr):
    """The long-time behaviour of a scene under its periodic force; numbers are enclosures with `digits` right digits.

    `drive`: the periodic pair, force and friction; `regime`; `attraction`: a sentence on what is proved about other
    motions; `thresholds` (one sine only); `orbit`: the events of the periodic motion, None if it has none;
    `multipliers`: Floquet multipliers of (x1, v1, v2), dimensionless, largest first, None where the linearisation does
    not exist; `drift`: mean velocity of body 2, m/s; `growth`: a lower bound on the growth rate of the amplitude of v1,
    m/s^2, 0 unless it grows.

    >>> from numerics import load_scene
    >>> found = response(load_scene("forced-sine-entrained"), digits=8)
    >>> print(found.regime.value, found.orbit, found.growth, found.digits, sep="; ")
    entrained: a motion in which the bodies stick permanently; None; 0; 8
    >>> [abs(one).str(5, radius=False) for one in found.multipliers], found.drift.is_zero()
    (['0.73040', '0.73040', '0'], True)
    >>> float(found.one_period().until), found.drive.pair.b
    (1.2566370614359172, Fraction(1, 20))
    """

    drive: PeriodicDrive
    regime: Regime
    thresholds: Thresholds | None
    orbit: Orbit | None
    multipliers: tuple[acb, ...] | None
    drift: arb | None
    growth: arb
    attraction: str
    digits: int

    @property
    def moduli(self) -> tuple[arb, ...]:
        """Return the moduli of the multipliers, dimensionless: of a stuck pair without a damper exactly 1, 1 and 0."""
        is_kept = self.regime is Regime.ENTRAINED and self.drive.pair.a1 == 0
        return tuple(arb(one != 0) if is_kept else abs(one) for one in self.multipliers or ())

    def plot(self) -> Figure:
        """Return a matplotlib figure: one period of the motion, its friction, and the thresholds over frequency.

        Raises MissingTool.
        """
        with meter("drawing"):
            return pictures().draw_response(self)

    def one_period(self) -> Scene | None:
        """Return one period of its motion as a scene, in decimals; None if there is no such scene."""
        kept = max(self.digits + 12, KEPT_DIGITS)
        with Ball(2 * self.digits + 20).context():
            if self.orbit is not None:
                begin, at = middle(self.orbit.legs[:1])
            elif self.regime is Regime.ENTRAINED and entrained(self.drive) and (motion := stuck_motion(self.drive)):
                begin, at = Fraction(0), (motion[0], motion[1], motion[1])
            else:
                return None
            return self.drive.one_period(begin, [rounded(one, kept) for one in at], kept)


def response(
    scene: Scene | PlaneScene,
    *,
    amplitude: Exact | None = None,
    omega: Exact | None = None,
    digits: int = 15,
    max_digits: int | None = None,
    max_events: int = MAX_EVENTS,
) -> Response:
    """Return the long-time response of a scene; amplitude (N) and omega (rad/s) replace those of its one sine.

    For a scene without a force, both together define its force, amplitude sin(omega t). On a surface the force must
    rotate, and the result is a RotatingResponse (rotating.py). A period may have a fifth of `max_events` events.
    Progress is logged.

    Raises InvalidScene (a force that is not periodic, friction that depends on the state), EventUndecided (nothing
    was proved at the limit on digits, by default 16 times those requested), NotSettled (a period has too many events;
    without a damper no search succeeds), PrecisionExhausted, TypeError (no scene), ValueError (digits).

    >>> from numerics import load_scene
    >>> found = response(load_scene("forced-sine-stick-slip"), digits=8)
    >>> found.regime.name, found.attraction, found.thresholds.entrainment.str(6, radius=False)
    ('STICK_SLIP', 'every motion tends to it', '0.300167')
    """
    require_digits(digits, max_digits=max_digits, max_events=max_events)
    if isinstance(scene, PlaneScene):
        clockwise = False
        if scene.is_forced or amplitude is None or omega is None:
            size, rate, clockwise = rotating_force(scene, digits)
            amplitude, omega = (size if amplitude is None else amplitude), (rate if omega is None else omega)
        return cast("Response", rotating_response(scene.pair, amplitude, omega, digits, clockwise=clockwise))
    require_plain("response", scene, "a response")
    drive = _drive_under(scene, amplitude=amplitude, omega=omega)
    known, orbit, sines, left = None, None, drive.piece.sines, _SEARCHES
    if len(sines) == 1:
        known = thresholds(drive.pair, sines[0].omega, digits=digits, max_digits=max_digits)

    def searched() -> Orbit:
        nonlocal left
        try:
            return search(drive, max_events)
        except EventUndecided:
            left -= 1
            if drive.pair.a1 > 0 or left > 0:
                raise
            raise NotSettled(
                "no search came to a periodic motion with events; without a damper the bodies may also stick while "
                "they swing freely; give a damper, or follow one motion by solve"
            ) from None

    def attempt(_: Ball) -> tuple[Response, list[arb]]:
        nonlocal orbit
        growth = resonant_growth(drive)
        if growth > 0:
            found = Response(drive, Regime.GROWS, known, None, None, None, growth, "every motion grows", digits)
        elif entrained(drive) or others_stick(drive, known):
            found = _entrained(drive, known, digits)
        else:
            orbit = searched() if orbit is None else solve_orbit(drive, orbit)
            found = _of_orbit(orbit, known, digits)
        legs = () if found.orbit is None else found.orbit.legs
        numbers = [growth, found.drift or arb(0), *(one for leg in legs for one in (leg.start, *leg.state[:2]))]
        return found, [*numbers, *found.moduli]

    # v2 is lost beside a v1 that so much larger a force gives
    times = sum(abs(one.amplitude) for one in sines) / drive.pair.b
    lost = max(0, times.numerator.bit_length() - times.denominator.bit_length()) * 3 // 10
    return to_digits(attempt, digits, most_digits(digits, max_digits), SPARE_DIGITS + lost)


def _drive_under(scene: Scene, **given: Exact | None) -> PeriodicDrive:
    """Return what acts in the long run, its one sine as it is given. Raises InvalidScene for what no sine can have."""
    asked = {name: exact_decimal(one, name) for name, one in given.items() if one is not None}
    positive(asked.get("omega", 1), "omega", "give a frequency in rad/s")
    if asked.get("amplitude") == 0:
        raise InvalidScene("amplitude = 0 must not be 0; without a force there is no response")
    if not scene.force.pieces:
        if len(asked) < 2:
            raise InvalidScene("the scene has no force; add [[force]] with one sine, or give amplitude and omega")
        scene = replace(scene, force=Force.sine(**asked))
    scene.require_filippov("a response")
    drive = last_drive(scene)
    if drive is None or not drive.piece.sines:
        raise InvalidScene("the last piece of the force is not periodic; it must be sines and at most a constant")
    if not asked:
        return drive
    if len(drive.piece.sines) != 1:
        raise InvalidScene("amplitude and omega replace those of one sine; the last piece of this force has more")
    return replace(drive, piece=replace(drive.piece, sines=(replace(drive.piece.sines[0], **asked),)))


def _entrained(drive: PeriodicDrive, known: Thresholds | None, digits: int) -> Response:
    pair, sines = drive.pair, drive.piece.sines
    touches = len(sines) == 1 and load_margin(pair, sines[0].amplitude, sines[0].omega) == 0
    tends = "each tends to one in which the bodies stick permanently"
    stays = (
        "a1 = 0, so not all motions tend to it: a free oscillation of the stuck pair does not decay, and motions that "
        "slip may do so for thousands of periods"
    )
    if len(sines) == 1:
        stays = f"{stays}, but {tends}"
    if known is not None and known.exception is not None:  # a1 = 0
        why = f"{stays}; others"
        if not entrained(drive):
            breaks = "but motions with a free oscillation that flattens the peaks of the load"
            why = f"{tends}; the stuck response itself breaks, {breaks}"
        why = f"{why} stick up to {known.exception.str(6, radius=False)} N, as Omega/omega is odd"
    elif touches:
        why = _EVERY if pair.a1 > 0 else tends
    else:
        why = f"{_EVERY}, and sticks after a finite time" if pair.a1 > 0 else stays
    multipliers = None if touches else stuck_multipliers(drive)
    why += "; the load of the stuck response touches the limit" * touches
    return Response(drive, Regime.ENTRAINED, known, None, multipliers, arb(0), arb(0), why, digits)


def _of_orbit(orbit: Orbit, known: Thresholds | None, digits: int) -> Response:
    drive = orbit.drive
    regime = Regime.STICK_SLIP if any(leg.side == 0 for leg in orbit.legs) else Regime.NON_STOP
    multipliers = tuple(orbit.multipliers())
    attraction = attraction_of(orbit, multipliers)
    # the only periodic motion of an odd force is odd itself, but for the constant part of x1
    drift = arb(0) if drive.is_odd and attraction.startswith(_EVERY) else orbit.travel / drive.period
    return Response(drive, regime, known, orbit, multipliers, drift, arb(0), attraction, digits)


def attraction_of(orbit: Orbit, multipliers: Sequence[acb]) -> str:
    """Return what is proved of other motions, "every motion ..." if it is the only periodic one.

    Where all multipliers are below 1 a motion at a distance eps comes nearer by a factor theta < 1 in some periods. No
    two motions part in the norm N: so one at a distance D > eps, with the point at eps on the way to it, comes nearer
    by (1 - theta) eps in these.
    """
    pair = orbit.drive.pair
    if pair.a1 > 0:
        return _EVERY
    rate = number(pair.a2 / pair.m1).sqrt()
    for before, leg in zip((orbit.legs[-1], *orbit.legs), orbit.legs, strict=False):
        turns = rate * (leg.end - leg.start) / (2 * arb.pi())
        if before.side == 0 and leg.side != 0 and turns.ceil().unique_fmpz() is not None:
            return f"{_EVERY}: a slip after a stick phase does not last a whole number of periods of body 1"
    if all(abs(one) < 1 for one in multipliers):
        return f"{_EVERY}: all multipliers are below 1, and no two motions part"
    return "whether others tend to it is not proved: not all multipliers are below 1"
