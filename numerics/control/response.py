"""What a pair does in the long run under a periodic force: entrained, stick-slip, non-stop, or growing without bound.

The last piece of the force decides, a constant and sines of commensurable frequencies, with the last friction. For a1 >
0 there is one periodic (x1, v1, v2), and every motion tends to it. For a1 = 0 what is found exists; `attraction` says
more.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction
from functools import partial
from typing import Any, cast

from flint import acb, arb

from numerics.arithmetic.ball import Ball
from numerics.control.answers import (
    KEPT_DIGITS,
    Claim,
    Tell,
    most_digits,
    not_negative,
    number,
    rounded,
    silent,
    to_digits,
    undecided,
)
from numerics.control.guesses import MAX_EVENTS, find_orbit, stuck_state
from numerics.control.orbit import Drive, Orbit
from numerics.control.thresholds import Thresholds, load_margin, odd_ratio, thresholds
from numerics.errors import InvalidScene, MissingTool
from numerics.linear.system import ONE, is_positive_on
from numerics.plane.rotating import rotating_force, rotating_response
from numerics.scene import Force, Law, Pair, Piece, Scene, Sine, State
from numerics.scene.decimals import Exact, exact_decimal, short
from numerics.scene.model import BUILD, require_kind
from numerics.scene.plane import PlaneScene
from numerics.scene.short_repr import ShortRepr


class Regime(Enum):
    """What the pair does in every period; the value is the sentence that a user reads."""

    ENTRAINED = "entrained: the bodies stick for ever"
    STICK_SLIP = "stick-slip: the bodies slip and stick in every period"
    NON_STOP = "non-stop: the bodies never stick"
    GROWS = "grows without bound: friction cannot take what the force brings at resonance"


@dataclass(frozen=True, repr=False)
class Response(ShortRepr):
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

    def plot(self) -> Any:
        """Return a matplotlib figure: a period of the motion, the friction in it, and the thresholds over frequency.

        Raises MissingTool.
        """
        try:
            from numerics.control.response_picture import draw_response
        except ModuleNotFoundError as error:
            raise MissingTool(f"a plot needs {error.name}; python -m pip install {error.name}") from None
        return draw_response(self)

    def claim(self) -> Claim | None:
        """Return that its periodic motion comes back after a period, None without events."""
        return self.orbit.claim(self.digits) if self.orbit is not None else None

    def one_period(self) -> Scene | None:
        """Return a period of its motion as a scene, in decimals; None if it has none."""
        claim = self.claim()
        if claim is not None:
            return claim.scene
        with Ball(KEPT_DIGITS).context():
            state = stuck_state(self.drive, arb(0)) if self.regime is Regime.ENTRAINED else None
            if state is not None and not entrained(self.drive):
                state = flattened_state(self.drive, arb(0))
            start = None if state is None else State(*map(rounded, state))
            return None if start is None else self.drive.one_period(Fraction(0), start, KEPT_DIGITS)


def response(
    scene: Scene | PlaneScene,
    *,
    amplitude: Exact | None = None,
    omega: Exact | None = None,
    digits: int = 15,
    max_digits: int | None = None,
    max_events: int = MAX_EVENTS,
    tell: Tell = silent,
) -> Response:
    """Return the long-time response of a scene; amplitude (N) and omega (rad/s) replace those of its one sine.

    For a scene without a force both together are its force, amplitude sin(omega t). On a surface the force goes round,
    and the answer is a RotatingResponse (plane/rotating.py). A run of up to `max_events` events
    finds the motion; `tell` hears what is being done.

    Raises InvalidScene (a force that is not periodic), EventUndecided (nothing was proved at the cap on digits, by
    default 16 times as many as are asked for), NotSettled (no motion was found within max_events),
    PrecisionExhausted, TypeError (no scene).

    >>> from numerics import load_scene
    >>> found = response(load_scene("forced-sine-stick-slip"), digits=8)
    >>> found.regime.name, found.attraction, found.thresholds.entrainment.str(6, radius=False)
    ('STICK_SLIP', 'every motion tends to it', '0.300167')
    """
    if isinstance(scene, PlaneScene):
        if amplitude is None or omega is None:
            size, rate = rotating_force(scene, digits)
            amplitude, omega = (size if amplitude is None else amplitude), (rate if omega is None else omega)
        return cast("Response", rotating_response(scene.pair, amplitude, omega, digits))
    require_kind("response", scene, Scene, BUILD)
    drive = _drive_under(scene, amplitude, omega)
    known, orbit = None, None
    if len(drive.piece.sines) == 1:
        known = thresholds(drive.pair, drive.piece.sines[0].omega, digits=digits, max_digits=max_digits)

    def attempt(_: Ball) -> tuple[Response, list[arb]]:
        nonlocal orbit
        growth = resonant_growth(drive)
        if growth > 0:
            found = Response(drive, Regime.GROWS, known, None, None, None, growth, "every motion grows", digits)
            return found, [growth]
        if entrained(drive) or others_stick(drive, known):
            found = _entrained(drive, known, digits)
            return found, [abs(one) for one in found.multipliers or () if drive.pair.a1 > 0]
        orbit = find_orbit(drive, orbit, max_events, tell)
        found = _of_orbit(orbit, known, digits)
        events = [one for leg in orbit.legs for one in (leg.t, leg.x, leg.v)]
        return found, [found.drift or arb(0), *(abs(one) for one in found.multipliers or ()), *events]

    return to_digits(attempt, digits, most_digits(digits, max_digits))


def _drive_under(scene: Scene, amplitude: Exact | None, omega: Exact | None) -> Drive:
    """Return what acts in the long run, its one sine as it is given. Raises InvalidScene for what no sine can have."""
    given = {"amplitude": amplitude, "omega": omega}
    asked = {name: exact_decimal(one, name) for name, one in given.items() if one is not None}
    if asked.get("omega", Fraction(1)) <= 0:
        raise InvalidScene(f"omega = {short(asked['omega'])} must be > 0; give a frequency in rad/s")
    if asked.get("amplitude") == 0:
        raise InvalidScene("amplitude = 0 must not be 0; without a force there is no response")
    if not scene.force.pieces:
        if len(asked) < 2:
            raise InvalidScene("the scene has no force; add [[force]] with one sine, or give amplitude and omega")
        scene = replace(scene, force=Force.sine(**asked))
    drive = steady_drive(scene)
    if not asked:
        return drive
    if len(drive.piece.sines) != 1:
        raise InvalidScene("amplitude and omega replace those of one sine; the last piece of this force has more")
    one = drive.piece.sines[0]
    sine = Sine(asked.get("amplitude", one.amplitude), asked.get("omega", one.omega), one.phase)
    return Drive(drive.pair, Piece(0, drive.piece.polynomial, [sine]))


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
    scene.require_one_b("what happens in the long run")
    last = scene.force.pieces[-1] if scene.force.pieces else Piece(0)
    if len(last.polynomial) > 1:
        return None
    pair, b = scene.pair, scene.friction.pieces[-1][1] if scene.friction.pieces else scene.pair.b
    return Drive(Pair(pair.m1, pair.m2, pair.a2, b, pair.a1), Piece(0, last.polynomial, last.sines))


def resonant_growth(drive: Drive) -> arb:
    """Return (U^ - 4b/pi)/(2 m1) if a1 = 0 and the force's amplitude U^ at omega1 is above 4b/pi, m/s^2; else 0."""
    pair = drive.pair
    resonant = [one for one in drive.piece.sines if one.omega**2 * pair.m1 == pair.a2]
    if pair.a1 != 0 or not resonant:
        return arb(0)
    total = sum((acb.exp(acb(0, number(one.phase))) * number(one.amplitude) for one in resonant), acb(0))
    over = abs(total) - 4 * number(pair.b) / arb.pi()
    grows = not_negative(over, "does the force bring more than friction takes at resonance?")
    return over / (2 * number(pair.m1)) if grows else arb(0)


# stuck for ever


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


def flattened_state(drive: Drive, t: arb) -> tuple[arb, arb, arb, arb]:
    """Return (x1, v1, 0, v1) of the stuck motion under one sine whose load has the lowest peaks, where others stick.

    The response A sin p, p = omega t + phase, and with Omega = n omega the free A c/n^2 sin(n p), where c =
    -(-1)^((n - 1)/2) sin(pi/(2 n))/n: the acceleration is then cos(pi/(2 n)) of that of the response at most.
    """
    pair, sine = drive.pair, drive.piece.sines[0]
    odd, state = odd_ratio(pair, pair.mass, sine.omega), stuck_state(drive, t)
    assert odd is not None
    assert state is not None
    share = (1 if odd % 4 == 3 else -1) * (arb.pi() / (2 * odd)).sin() / odd**2
    free = share * number(sine.amplitude / (pair.a2 - pair.mass * sine.omega**2))
    turn, turned = (odd * (number(sine.omega) * t + number(sine.phase))).sin_cos()
    v = state[1] + free * number(sine.omega) * turned
    return state[0] + free / odd * turn, v, arb(0), v


def stuck_multipliers(drive: Drive) -> tuple[acb, ...]:
    """Return exp(lambda T) of the stuck pair's two rates, and 0: w dies in a finite time."""
    pair = drive.pair
    half = pair.a1 / (2 * pair.mass)
    rest = acb(number(half**2 - pair.a2 / pair.mass)).sqrt()
    return (*(acb.exp((one - number(half)) * drive.period) for one in (rest, -rest)), acb(0))


def _entrained(drive: Drive, known: Thresholds | None, digits: int) -> Response:
    pair, sines = drive.pair, drive.piece.sines
    multipliers: tuple[acb, ...] | None = stuck_multipliers(drive)
    why = "every motion tends to it, and sticks after a finite time"
    if pair.a1 == 0:
        why = "not all motions tend to it: a free oscillation of the stuck pair stays"
        if known is not None and known.exception is not None:
            up_to = f"up to {known.exception.str(6, radius=False)} N, as Omega/omega is odd"
            breaks = (
                "not all motions do; the response breaks, but with a free oscillation that flattens the load's peaks"
            )
            why = f"{why}; others stick {up_to}" if entrained(drive) else f"{breaks} they stick {up_to}"
    elif len(sines) == 1 and load_margin(pair, sines[0].amplitude, sines[0].omega) == 0:
        multipliers, why = None, "every motion tends to it; its load touches the limit"
    return Response(drive, Regime.ENTRAINED, known, None, multipliers, arb(0), arb(0), why, digits)


# with events


def _of_orbit(orbit: Orbit, known: Thresholds | None, digits: int) -> Response:
    drive = orbit.drive
    regime = Regime.STICK_SLIP if any(leg.side == 0 for leg in orbit.legs) else Regime.NON_STOP
    multipliers = tuple(orbit.multipliers())
    is_only_one, attraction = _attraction(orbit)
    # the only periodic motion of an odd force is odd itself, but for the constant part of x1
    drift = arb(0) if drive.is_odd and is_only_one else orbit.travel / drive.period
    return Response(drive, regime, known, orbit, multipliers, drift, arb(0), attraction, digits)


def _attraction(orbit: Orbit) -> tuple[bool, str]:
    """Return whether it is proved to be the only periodic motion, and what is proved of other motions."""
    pair = orbit.drive.pair
    if pair.a1 > 0:
        return True, "every motion tends to it"
    rate = number(pair.a2 / pair.m1).sqrt()
    for before, (leg, after) in zip((orbit.legs[-1], *orbit.legs[:-1]), orbit.turns, strict=True):
        turns = rate * (after.t - leg.t) / (2 * arb.pi())
        if before.side == 0 and leg.side != 0 and turns.ceil().unique_fmpz() is not None:
            return True, "every motion tends to it: a slip after a stick phase is no whole number of turns of body 1"
    return False, "motions next to it tend to it if all multipliers are below 1"
