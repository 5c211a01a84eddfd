"""What a pair does in the long run under a periodic force: entrained, stick-slip, non-stop, or growing without bound.

The last piece of the force decides, a constant and sines of commensurable frequencies, with the last friction. For a1 >
0 there is one periodic (x1, v1, v2), and every motion tends to it. For a1 = 0 what is found exists; `attraction` says
more.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction

from flint import acb, arb

from numerics.arithmetic.ball import Ball
from numerics.arithmetic.ball_words import working_digits
from numerics.control.asked import Tell, most_digits, silent, to_digits
from numerics.control.given_sine import given_sine
from numerics.control.orbit import Drive, Orbit
from numerics.control.search import MAX_EVENTS, Search
from numerics.control.stuck import entrained, others_stick, stuck_multipliers
from numerics.control.thresholds import Thresholds, load_margin, thresholds
from numerics.errors import EventUndecided, InvalidScene
from numerics.scene import Force, Law, Pair, Piece, Scene, Sine
from numerics.scene.decimals import Exact


class Regime(Enum):
    """What the pair does in every period; the value is the sentence that a user reads."""

    ENTRAINED = "entrained: the bodies stick for ever"
    STICK_SLIP = "stick-slip: the bodies slip and stick in every period"
    NON_STOP = "non-stop: the bodies never stick"
    GROWS = "grows without bound: friction cannot take what the force brings at resonance"


@dataclass(frozen=True)
class Response:
    """The long-time behaviour of a scene under its periodic force; numbers are enclosures with `digits` right digits.

    `thresholds` (one sine only); `orbit`: the events of the periodic motion, None if it has none; `multipliers`:
    Floquet multipliers of (x1, v1, v2), largest first, None where the linearisation does not exist; `drift`: mean
    velocity of body 2, m/s; `growth`: the least rate at which v1's amplitude grows, m/s^2, 0 unless it grows.
    """

    drive: Drive
    regime: Regime
    thresholds: Thresholds | None
    orbit: Orbit | None
    multipliers: tuple[acb, ...] | None
    drift: arb | None
    growth: arb
    attraction: str
    digits: int


def response(
    scene: Scene,
    *,
    amplitude: Exact | None = None,
    omega: Exact | None = None,
    digits: int = 15,
    max_digits: int | None = None,
    max_events: int = MAX_EVENTS,
    tell: Tell = silent,
) -> Response:
    """Return the long-time response of a scene; amplitude (N) and omega (rad/s) replace those of its one sine.

    For a scene without a force both together are its force, amplitude sin(omega t). Where more than one sine acts, a
    run of up to `max_events` events finds the motion; `tell` hears what is being done.

    Raises InvalidScene (a force that is not periodic), EventUndecided (nothing was proved at the cap on digits, by
    default 16 times as many as are asked for), NotSettled (no motion was found within max_events),
    PrecisionExhausted.
    """
    asked = given_sine(amplitude, omega)
    if not scene.force.pieces:
        if amplitude is None or omega is None:
            raise InvalidScene("the scene has no force; add [[force]] with one sine, or give amplitude and omega")
        scene = replace(scene, force=Force.sine(amplitude, omega))
    drive = steady_drive(scene)
    if asked:
        drive = _replaced(drive, asked)
    sines = drive.piece.sines
    known = None
    if len(sines) == 1:
        known = thresholds(drive.pair, sines[0].omega, digits=digits, max_digits=max_digits)
    most = most_digits(digits, max_digits)
    search = Search(max_events, tell)
    return to_digits(lambda _: _attempt(drive, known, digits, search), digits, most)


def steady_drive(scene: Scene) -> Drive:
    """Return what acts in the long run. Raises InvalidScene unless that is a constant and sines."""
    if scene.law is not Law.FILIPPOV:
        raise InvalidScene(f'law = "{scene.law.value}" has no such theory; leave the law out for a response')
    drive = last_drive(scene)
    if drive is None or not drive.piece.sines:
        raise InvalidScene(
            "the last piece of the force is not periodic; a response needs sines and at most a constant there"
        )
    return drive


def last_drive(scene: Scene) -> Drive | None:
    """Return what acts from the last piece of force and friction on; None unless that is a constant and sines."""
    last = scene.force.pieces[-1] if scene.force.pieces else Piece(0)
    if len(last.polynomial) > 1:
        return None
    steady = Force((Piece(0, last.polynomial, last.sines),))
    frequency = steady.frequency or Fraction(0)  # rational frequencies are commensurable
    b = scene.friction.pieces[-1][1] if scene.friction.pieces else scene.pair.b
    pair = scene.pair
    return Drive(Pair(pair.m1, pair.m2, pair.a2, b, pair.a1), b, steady.pieces[0], frequency)


def _replaced(drive: Drive, asked: dict[str, Fraction]) -> Drive:
    if len(drive.piece.sines) != 1:
        raise InvalidScene("amplitude and omega replace those of one sine; the last piece of this force has more")
    one = drive.piece.sines[0]
    sine = Sine(asked.get("amplitude", one.amplitude), asked.get("omega", one.omega), one.phase)
    return replace(drive, piece=Piece(0, drive.piece.polynomial, [sine]), frequency=sine.omega)


def _attempt(drive: Drive, known: Thresholds | None, digits: int, search: Search) -> tuple[Response, list[arb]]:
    growth = resonant_growth(drive)
    if growth > 0:
        found = Response(drive, Regime.GROWS, known, None, None, None, growth, "every motion grows", digits)
        return found, [growth]
    if entrained(drive) or others_stick(drive, known):
        return _entrained(drive, known, digits)
    return _of_orbit(search.orbit(drive), known, digits)


def resonant_growth(drive: Drive) -> arb:
    """Return (U^ - 4b/pi)/(2 m1) if a1 = 0 and the force's amplitude U^ at omega1 is above 4b/pi, m/s^2; else 0."""
    pair = drive.pair
    resonant = [one for one in drive.piece.sines if one.omega**2 * pair.m1 == pair.a2]
    if pair.a1 != 0 or not resonant:
        return arb(0)
    total = sum((acb.exp(acb(0, Ball.number(one.phase))) * Ball.number(one.amplitude) for one in resonant), acb(0))
    over = abs(total) - 4 * Ball.number(drive.b) / arb.pi()
    if over.contains(0):
        raise EventUndecided(
            "does the force bring more than friction takes at resonance?", over.str(6), working_digits()
        )
    return over / (2 * Ball.number(pair.m1)) if over > 0 else arb(0)


_FLATTENED = (
    "not all motions do; the response breaks, but with a free oscillation that flattens the load's peaks they stick"
)


def _entrained(drive: Drive, known: Thresholds | None, digits: int) -> tuple[Response, list[arb]]:
    pair = drive.pair
    if pair.a1 == 0:
        why = "not all motions tend to it: a free oscillation of the stuck pair stays"
        if known is not None and known.exception is not None:
            up_to = f"up to {known.exception.str(6, radius=False)} N, as Omega/omega is odd"
            why = f"{why}; others stick {up_to}" if entrained(drive) else f"{_FLATTENED} {up_to}"
        pairs = stuck_multipliers(drive)
        return Response(drive, Regime.ENTRAINED, known, None, pairs, arb(0), arb(0), why, digits), []
    multipliers: tuple[acb, ...] | None = stuck_multipliers(drive)
    sine = drive.piece.sines[0]
    touches = len(drive.piece.sines) == 1 and load_margin(pair, sine.amplitude, sine.omega) == 0
    why = "every motion tends to it, and sticks after a finite time"
    if touches:
        multipliers, why = None, "every motion tends to it; its load touches the limit"
    found = Response(drive, Regime.ENTRAINED, known, None, multipliers, arb(0), arb(0), why, digits)
    return found, [abs(one) for one in multipliers or ()]


def _of_orbit(orbit: Orbit, known: Thresholds | None, digits: int) -> tuple[Response, list[arb]]:
    drive = orbit.drive
    regime = Regime.STICK_SLIP if any(leg.side == 0 for leg in orbit.legs) else Regime.NON_STOP
    multipliers = tuple(orbit.multipliers())
    is_only_one, attraction = _attraction(orbit)
    # the only periodic motion of an odd force is odd itself, but for the constant part of x1
    drift = arb(0) if drive.is_odd and is_only_one else orbit.travel / drive.period
    found = Response(drive, regime, known, orbit, multipliers, drift, arb(0), attraction, digits)
    numbers = [abs(one) for one in multipliers] + [drift]
    for leg in orbit.legs:
        numbers += [leg.t, leg.x, leg.v]
    return found, numbers


def _attraction(orbit: Orbit) -> tuple[bool, str]:
    """Return whether it is proved to be the only periodic motion, and what is proved of other motions."""
    pair = orbit.drive.pair
    if pair.a1 > 0:
        return True, "every motion tends to it"
    rate = Ball.number(pair.a2 / pair.m1).sqrt()
    for before, (leg, after) in zip((orbit.legs[-1], *orbit.legs[:-1]), orbit.turns, strict=True):
        turns = rate * (after.t - leg.t) / (2 * arb.pi())
        if before.side == 0 and leg.side != 0 and turns.ceil().unique_fmpz() is not None:
            return True, "every motion tends to it: a slip after a stick phase is no whole number of turns of body 1"
    return False, "motions next to it tend to it if all multipliers are below 1"
