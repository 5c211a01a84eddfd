"""What a pair does in the long run under a periodic force: entrained, stick-slip, non-stop, or growing without bound.

The last piece of the force decides, a constant and sines of commensurable frequencies, with the last friction. For a1 >
0 there is one periodic (x1, v1, v2), and every motion tends to it. For a1 = 0 what is found exists; `attraction` says
more. Where friction depends on the speed there may be several periodic motions (coexisting.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction
from typing import Any, cast

from flint import acb, arb

from numerics.arithmetic.attempts import SPARE_DIGITS, to_digits
from numerics.arithmetic.ball import Ball
from numerics.control.answers import KEPT_DIGITS, Prediction, most_digits, number, rounded
from numerics.control.coexisting import MAX_EVENTS, search
from numerics.control.orbit import Orbit, PeriodicDrive, solve_orbit
from numerics.control.rotating import pictures, rotating_force, rotating_response
from numerics.control.stuck import (
    entrained,
    others_stick,
    resonant_growth,
    stuck_multipliers,
    stuck_state,
)
from numerics.control.thresholds import Thresholds, load_margin, thresholds
from numerics.errors import InvalidScene
from numerics.scene import Force, Piece, Scene, Weakening
from numerics.scene.decimals import Exact, exact_decimal, positive, require_digits
from numerics.scene.model import BUILD, require_kind
from numerics.scene.plane import PlaneScene
from numerics.scene.short_repr import ShortRepr

_EVERY, _NEXT = "every motion tends to it", "motions next to it tend to it"


class Regime(Enum):
    """What the pair does in every period; the value is the sentence that a user reads."""

    ENTRAINED = "entrained: the bodies stick for ever"
    STICK_SLIP = "stick-slip: the bodies slip and stick in every period"
    NON_STOP = "non-stop: the bodies never stick"
    GROWS = "grows without bound: friction cannot take what the force brings at resonance"


@dataclass(frozen=True, repr=False)
class Response(ShortRepr):
    """The long-time behaviour of a scene under its periodic force; numbers are enclosures with `digits` right digits.

    `drive`: pair, force and friction that repeat; `regime`; `attraction`: what is proved of other motions, a sentence;
    `thresholds` (one sine only); `orbit`: the events of the periodic motion, None if it has none; `multipliers`:
    Floquet multipliers of (x1, v1, v2), largest first, None where the linearisation does not exist; `drift`: mean
    velocity of body 2, m/s; `growth`: the least rate at which v1's amplitude grows, m/s^2, 0 unless it grows.

    >>> from numerics import load_scene
    >>> found = response(load_scene("forced-sine-entrained"), digits=8)
    >>> print(found.regime.value, found.orbit, found.growth, found.digits, sep="; ")
    entrained: the bodies stick for ever; None; 0; 8
    >>> [abs(one).str(5, radius=False) for one in found.multipliers], found.drift.is_zero()
    (['0.73040', '0.73040', '0'], True)
    >>> float(found.one_period().until), found.drive.pair.b, found.claim()
    (1.2566370614359172, Fraction(1, 20), None)
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

    def plot(self) -> Any:
        """Return a matplotlib figure: a period of the motion, the friction in it, and the thresholds over frequency.

        Raises MissingTool.
        """
        return pictures().draw_response(self)

    def claim(self) -> Prediction | None:
        """Return that its periodic motion comes back after a period, None without events."""
        return self.orbit.claim(self.digits) if self.orbit is not None else None

    def one_period(self) -> Scene | None:
        """Return a period of its motion as a scene, in decimals; None without one, or if only others stick."""
        claim = self.claim()
        if claim is not None:
            return claim.scene
        with Ball(KEPT_DIGITS).context():
            sticks = self.regime is Regime.ENTRAINED and entrained(self.drive)
            state = stuck_state(self.drive, arb(0)) if sticks else None
            return state and self.drive.one_period(Fraction(0), [*map(rounded, state)], KEPT_DIGITS)


@dataclass(frozen=True, repr=False)
class PeriodicMotions(ShortRepr):
    """The periodic motions of a pair whose friction depends on the speed, as many as were found; each is proved.

    `motions`: a stuck one first if it exists, each a Response whose `attraction` speaks of motions next to it;
    `entrainment`: U* (N), up to which a motion may stick for ever, one sine only; `starts`: so many were looked from.
    `is_all`: no other exists, as B falls nowhere and a1 > 0, or as every motion grows.
    """

    drive: PeriodicDrive
    motions: tuple[Response, ...]
    entrainment: arb | None
    starts: int
    is_all: bool
    digits: int

    @property
    def sentence(self) -> str:
        """Return how many were found, and whether there may be more."""
        if self.is_all:
            return "there is no other long-time behaviour: it is the same from everywhere"
        count = len(self.motions)
        found = "1 periodic motion was" if count == 1 else f"{count} periodic motions were"
        return f"{found} found, from {self.starts} starts; there may be more, and motions that come back later or never"

    def plot(self) -> Any:
        """Return a matplotlib figure: friction against speed, and each motion as x1 against v1 - v2 and in time.

        Raises MissingTool.
        """
        return pictures().draw_motions(self)


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

    For a scene without a force both together are its force, amplitude sin(omega t). On a surface the force goes round,
    and the answer is a RotatingResponse (rotating.py). With a [weakening] by speed there may be several periodic
    motions, and the answer is PeriodicMotions: those found, each proved. A period may have a fifth of `max_events`
    events. What is being done is logged.

    Raises InvalidScene (a force that is not periodic, friction by place), EventUndecided (nothing was proved at the cap
    on digits, by default 16 times as many as are asked for), NotSettled (a period has too many events),
    PrecisionExhausted, TypeError (no scene), ValueError (digits).

    >>> from numerics import load_scene
    >>> found = response(load_scene("forced-sine-stick-slip"), digits=8)
    >>> found.regime.name, found.attraction, found.thresholds.entrainment.str(6, radius=False)
    ('STICK_SLIP', 'every motion tends to it', '0.300167')
    """
    require_digits(digits, max_digits=max_digits, max_events=max_events)
    if isinstance(scene, PlaneScene):
        if amplitude is None or omega is None:
            size, rate = rotating_force(scene, digits)
            amplitude, omega = (size if amplitude is None else amplitude), (rate if omega is None else omega)
        return cast("Response", rotating_response(scene.pair, amplitude, omega, digits))
    require_kind("response", scene, Scene, BUILD)
    drive = _drive_under(scene, amplitude=amplitude, omega=omega)
    known, orbits, starts, sines = None, list[Orbit](), 0, drive.piece.sines
    if len(sines) == 1:
        known = thresholds(drive.pair, sines[0].omega, digits=digits, max_digits=max_digits)

    def attempt(_: Ball) -> tuple[list[Response], list[arb]]:
        nonlocal orbits, starts
        growth = resonant_growth(drive)
        if growth > 0:
            grows = Response(drive, Regime.GROWS, known, None, None, None, growth, "every motion grows", digits)
            return [grows], [growth]
        sticks = entrained(drive) or others_stick(drive, known)
        if orbits:
            orbits = [solve_orbit(one) for one in orbits]
        elif not (sticks and (drive.weakening is None or drive.has_one_motion)):
            orbits, starts = search(drive, sticks=sticks, max_events=max_events)
        found = [_entrained(drive, known, digits)] if sticks else []
        found += [_of_orbit(one, known, digits) for one in orbits]
        return found, [one for motion in found for one in _numbers(motion)]

    # v2 is lost beside a v1 that so much larger a force gives
    times = sum(abs(one.amplitude) for one in sines) / drive.pair.b
    lost = max(0, times.numerator.bit_length() - times.denominator.bit_length()) * 3 // 10
    motions = to_digits(attempt, digits, most_digits(digits, max_digits), SPARE_DIGITS + lost)
    if drive.weakening is None:
        return motions[0]
    is_all = drive.has_one_motion or motions[0].regime is Regime.GROWS
    without = tuple(replace(one, thresholds=None) for one in motions)
    return cast("Response", PeriodicMotions(drive, without, known and known.entrainment, starts, is_all, digits))


def _numbers(found: Response) -> list[arb]:
    """Return the numbers of a response that must have the digits asked for."""
    sizes = [abs(one) for one in found.multipliers or ()]
    if found.orbit is None:
        return sizes if found.drive.pair.a1 > 0 else []
    return [found.drift or arb(0), *sizes, *(one for leg in found.orbit.events for one in (leg.start, *leg.state[:2]))]


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
    drive = steady_drive(scene)
    if asked and len(drive.piece.sines) != 1:
        raise InvalidScene("amplitude and omega replace those of one sine; the last piece of this force has more")
    sines = tuple(replace(one, **asked) for one in drive.piece.sines)
    return replace(drive, piece=replace(drive.piece, sines=sines))


def steady_drive(scene: Scene) -> PeriodicDrive:
    """Return what acts in the long run. Raises InvalidScene unless that is a constant and sines."""
    scene.require_filippov("a response")
    drive = last_drive(scene)
    if drive is None or not drive.piece.sines:
        raise InvalidScene(
            "the last piece of the force is not periodic; a response needs sines and at most a constant there"
        )
    return drive


def last_drive(scene: Scene) -> PeriodicDrive | None:
    """Return what acts from the last piece of force and friction on; None unless that is a constant and sines."""
    last = scene.force.pieces[-1] if scene.force.pieces else Piece(0)
    if len(last.polynomial) > 1:
        return None
    pair, b = scene.pair, scene.friction.pieces[-1][1] if scene.friction.pieces else scene.pair.b
    given = scene.friction.weakening
    if given is not None:
        if given.place:
            raise InvalidScene(
                "where friction depends on the place a motion repeats only if x1 - x2 does, and stuck ones fill "
                "intervals: a response is not worked out for that; leave place out of [weakening]"
            )
        given = Weakening([(w, one * b / pair.b) for w, one in given.speed], given.last_slope * b / pair.b)
    added = Force((replace(last, start=Fraction(0)),)) + Force()  # equal sines become one
    return PeriodicDrive(replace(pair, b=b), added.pieces[0], given)


def _entrained(drive: PeriodicDrive, known: Thresholds | None, digits: int) -> Response:
    pair, sines = drive.pair, drive.piece.sines
    multipliers: tuple[acb, ...] | None = stuck_multipliers(drive)
    every = _EVERY if drive.has_one_motion else ""
    touches = len(sines) == 1 and load_margin(pair, sines[0].amplitude, sines[0].omega) == 0
    stays = "not all motions tend to it: a free oscillation of the stuck pair stays"
    if known is not None and known.exception is not None:  # a1 = 0
        why = f"{stays}; others"
        if not entrained(drive):
            breaks = "but with a free oscillation that flattens the load's peaks they"
            why = f"not all motions do; the response breaks, {breaks}"
        why = f"{why} stick up to {known.exception.str(6, radius=False)} N, as Omega/omega is odd"
    elif touches:
        multipliers, why = None, f"{every or 'what tends to it is open'}; its load touches the limit"
    elif pair.a1 == 0:
        why = stays
    elif every:
        why = f"{every}, and sticks after a finite time"
    else:
        why = f"{_NEXT}, and stick after a finite time"
    return Response(drive, Regime.ENTRAINED, known, None, multipliers, arb(0), arb(0), why, digits)


def _of_orbit(orbit: Orbit, known: Thresholds | None, digits: int) -> Response:
    drive = orbit.drive
    regime = Regime.STICK_SLIP if any(leg.side == 0 for leg in orbit.legs) else Regime.NON_STOP
    multipliers = tuple(orbit.multipliers())
    attraction = _attraction(orbit, [abs(one) for one in multipliers])
    # the only periodic motion of an odd force is odd itself, but for the constant part of x1
    drift = arb(0) if drive.is_odd and attraction.startswith(_EVERY) else orbit.travel / drive.period
    return Response(drive, regime, known, orbit, multipliers, drift, arb(0), attraction, digits)


def _attraction(orbit: Orbit, sizes: Sequence[arb]) -> str:
    """Return what is proved of other motions, "every motion ..." if it is the only periodic one.

    `sizes` are those of its multipliers.
    """
    pair, weakening = orbit.drive.pair, orbit.drive.weakening
    if orbit.drive.has_one_motion:
        return _EVERY
    if weakening is not None and any(one > 1 for one in sizes):
        return "almost all motions next to it leave it"
    if weakening is not None:
        return _NEXT if all(one < 1 for one in sizes) else "whether motions next to it tend to it is open"
    rate = number(pair.a2 / pair.m1).sqrt()
    for before, leg in zip((orbit.legs[-1], *orbit.legs), orbit.legs, strict=False):
        turns = rate * (leg.end - leg.start) / (2 * arb.pi())
        if before.side == 0 and leg.side != 0 and turns.ceil().unique_fmpz() is not None:
            return f"{_EVERY}: a slip after a stick phase is no whole number of turns of body 1"
    return f"{_NEXT} if all multipliers are below 1"
