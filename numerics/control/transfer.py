"""From rest to rest over a distance D in the least time, or cheapest, by a force that acts on body 2 through friction.

Friction gives body 2 at most beta = b/m2: no control arrives before 2 sqrt(m2 D/b). With tau = sqrt(m2 D/b), D > 0:

    stuck at the limit   +beta, then -beta: needs the amplitude max(M beta + a1 sqrt(beta D) + a2 D/2, a2 D to hold,
                         a2 D + a1^2 beta/(2 a2) - M beta if a1^2 beta <= a2^2 D)
    slip, then stick     body 1 runs ahead under a constant force through the first half and is met at tau. At least
                         U_min = b + beta tau/g(tau), g the impulse response of body 1, if g' >= 0 on [0, tau]
    bang-bang, stuck     a1 = 0, d = a2 D/U <= 1: +U, then -U, in
                         (acos(1 - d/2 - d^2/4) + acos((1 + d/2 + d^2/4)/(1 + d)))/Omega

A margin E keeps the load of a stuck transfer at most (1 - E) b. The times of a force are exact decimals next to these.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from fractions import Fraction

from flint import arb

from numerics.arithmetic.attempts import to_digits
from numerics.arithmetic.ball import Ball, proved_sign
from numerics.control.answers import (
    KEPT_DIGITS,
    TIME_DIGITS,
    SlipsAgain,
    number,
    rounded,
    rounded_up,
    solved_again,
)
from numerics.control.optimal import LeastEnergy, LeastPeak
from numerics.control.thresholds import pushed
from numerics.control.tracking import stuck_force
from numerics.errors import InvalidScene, NotSettled
from numerics.scene import Force, Pair, Piece, Scene
from numerics.scene.decimals import (
    Exact,
    decimal_text,
    exact_decimal,
    positive,
    require_digits,
    require_one_of,
    short,
)
from numerics.scene.model import require_plain
from numerics.scene.short_repr import ShortRepr

_MET = Fraction(1, 10**20)
"""By this part the slip transfer stays inside the limits, so that the bodies meet and stick beyond doubt."""
_CLOSE = 1e-12
"""By this part at most what is proved to be the least may be below the cost of the force."""


class TransferKind(Enum):
    """Type of a transfer; the value is a sentence."""

    STUCK = "the bodies stick throughout, at the limit of friction or the margin below it"
    SLIP = "body 1 slips ahead in the first half; the bodies stick in the second half"
    BANG_BANG = "the bodies stick throughout, under full force forwards, then backwards"
    CHEAPEST = (
        "the bodies stick throughout, and no transfer in this time that sticks, and keeps the margin, has less "
        "int u^2 dt on the way"
    )
    GENTLEST = (
        "the bodies stick throughout, and no transfer in this time that sticks, and keeps the margin, has a lower peak "
        "of |u| on the way"
    )
    OPEN = "open: the minimum time for this amplitude is not known"


_FIND = {"energy": (TransferKind.CHEAPEST, LeastEnergy), "peak": (TransferKind.GENTLEST, LeastPeak)}


@dataclass(frozen=True, repr=False)
class Transfer(ShortRepr):
    """A transfer over `distance` (m): enclosures with `digits` right digits, and its force as a scene if there is one.

    `margin`: unused share of b while stuck, dimensionless; `road`: a TransferKind. `bound` (s): lower bound on the time
    of every transfer; `time` (s): of this one. Of the fastest one `stuck_amplitude` (N): required for sticking at (1 -
    margin) b. `least_amplitude` (N): the minimum to arrive at the bound, None where g' changes sign. `fastest`: a
    sentence on what is proved about `time`. Of the cheapest one `cost`: int u^2 dt (N^2 s), or max |u| (N), up to that
    time; `least_cost`: proved lower bound on it for all transfers that stick and keep the margin, which is less by a
    part of some 10^-18. `is_at_limit`: whether friction is at its limit, or at the margin, at times.
    `holding_force`: a2 D, which holds the pair at its new place after that time, N; no part of the cost.

    >>> from numerics import load_scene
    >>> found = fastest_transfer(load_scene("at-rest"), "0.01", margin="0.1", digits=8)
    >>> found.road.name, [one.str(6, radius=False) for one in (found.bound, found.time, found.stuck_amplitude)]
    ('STUCK', ['0.282843', '0.298142', '2.00000'])
    >>> found.least_amplitude, found.fastest
    (None, 'no force that keeps the margin is faster: friction is at it all the time')
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.01", "0.3")
    >>> [one.str(15, radius=False) for one in (found.cost, found.least_cost)], found.is_at_limit
    (['0.295046099130115', '0.295046099130115'], True)
    """

    distance: Fraction
    margin: Fraction
    road: TransferKind
    bound: arb
    time: arb | None
    scene: Scene | None
    digits: int
    stuck_amplitude: arb | None = None
    least_amplitude: arb | None = None
    fastest: str = ""
    cost: arb | None = None
    least_cost: arb | None = None
    is_at_limit: bool = True
    holding_force: Fraction | None = None

    @property
    def sticks(self) -> bool:
        """Return whether the bodies never slip on the way."""
        return self.road is not TransferKind.SLIP

    def goal(self, scene: Scene) -> tuple[arb, arb]:
        """Return where body 2 is to be at the horizon of its scene, and the size beside which an error counts, m."""
        return number(scene.initial.x2 + self.distance), number(abs(self.distance))


def fastest_transfer(
    scene: Scene,
    distance: Exact,
    *,
    amplitude: Exact | None = None,
    margin: Exact = 0,
    digits: int = 15,
    max_digits: int | None = None,
) -> Transfer:
    """Return the fastest known transfer of a scene's pair over a distance (m) from its initial state, at rest.

    `amplitude` bounds |u| (N), else u is free; 0 <= margin < 1. Raises InvalidScene, EventUndecided (an amplitude on a
    boundary), PrecisionExhausted, TypeError (no scene), ValueError (digits).

    >>> from numerics import load_scene
    >>> found = fastest_transfer(load_scene("at-rest"), "0.01")
    >>> found.time.str(8, radius=False), found.scene.force.starts[0]
    ('0.28284271', Fraction(0, 1))
    """
    by, part = read_transfer("fastest_transfer", scene, distance, margin, digits, max_digits)
    most = None if amplitude is None else positive(amplitude, "amplitude", "leave it out for a force without bound")

    def attempt(_: Ball) -> tuple[Transfer, list[arb]]:
        pair, far = scene.pair, abs(by)
        bound = 2 * number(pair.m2 * far / pair.b).sqrt()
        stuck, least = stuck_amplitude(pair, far, part), least_amplitude(pair, far)
        road, time, fastest, force = _choice(pair, far, most, part, stuck, least)
        planned = None
        if force is not None and time is not None:
            planned = Scene(pair, scene.initial, until=rounded_up(time * 3 / 2, 6), force=force if by > 0 else -force)
        answer = Transfer(by, part, road, bound, time, planned, digits, stuck, least, fastest)
        return answer, [one for one in (bound, stuck, least, time) if one is not None]

    return to_digits(attempt, max(digits, KEPT_DIGITS), max_digits)


def cheapest_transfer(
    scene: Scene,
    distance: Exact,
    time: Exact,
    *,
    least: str = "energy",
    margin: Exact = 0,
    digits: int = 15,
    max_digits: int | None = None,
) -> Transfer:
    """Return the transfer of a scene's pair over a distance (m) in a time (s) that sticks and has the least int u^2 dt.

    `least="peak"`: the least max |u| up to that time instead. The load is at most (1 - margin) b. Raises InvalidScene
    (a time below the least one among others), NotSettled (no force was found), PrecisionExhausted, TypeError (no
    scene), ValueError (digits, least).

    >>> from numerics import load_scene
    >>> found = cheapest_transfer(load_scene("at-rest"), "0.001", "0.2")
    >>> found.cost.str(6, radius=False), found.is_at_limit, len(found.scene.force.pieces)
    ('0.00408826', False, 3)
    >>> cheapest_transfer(load_scene("at-rest"), "0.001", "0.2", least="peak").cost.str(6, radius=False)
    '0.167016'
    """
    by, part = read_transfer("cheapest_transfer", scene, distance, margin, digits, max_digits)
    pair, far, until = scene.pair, abs(by), positive(time, "time")
    tight = replace(pair, b=(1 - part) * pair.b)
    require_one_of("least", least, _FIND)
    road, find = _FIND[least]

    def attempt(_: Ball) -> tuple[Transfer, list[arb]]:
        bound, fastest = (2 * number(one.m2 * far / one.b).sqrt() for one in (pair, tight))
        if number(until) < fastest:
            raise InvalidScene(
                f"time = {decimal_text(until)} s must be at least 2 sqrt(m2 D/((1 - margin) b)) = "
                f"{fastest.str(15, radius=False)} s, as no transfer that keeps the margin is faster; give more time, "
                "or less distance or margin"
            )
        search = find(tight, far, until)
        found = search.force()
        cost, least_cost = search.bound(found)
        if not cost - least_cost < cost * _CLOSE:
            raise search.not_found
        force = Force((*search.pieces(found), Piece(until, (pair.a2 * far,))))
        at_limit = any(one.arc.side for one in found.parts)
        planned = Scene(pair, scene.initial, until=until * 3 / 2, force=force if by > 0 else -force)
        known = {"cost": cost, "least_cost": least_cost, "is_at_limit": at_limit, "holding_force": pair.a2 * by}
        return Transfer(by, part, road, bound, number(until), planned, digits, **known), [cost, least_cost]

    try:
        found = to_digits(attempt, max(digits, KEPT_DIGITS), max_digits)
        assert found.scene is not None
        run = solved_again(replace(found, scene=replace(found.scene, pair=tight)))
        assert run is not None
        with run.context():
            _, _, x2, v2 = run.sol(until)
            if not abs(x2 - number(scene.initial.x2 + by)) + abs(v2) * number(until) < number(far) * _CLOSE:
                raise NotSettled("the bodies do not come to rest in time under the force that was found")
    except (NotSettled, SlipsAgain) as error:  # under the force of a search that fails friction may give way
        end = pair.a2 * far - tight.b * pair.mass / pair.m2
        needed = f"; with any time the end needs a peak of {short(end)} N" if least == "peak" and end > 0 else ""
        raise NotSettled(f"{error}{needed}; give another time") from error
    return found


def read_transfer(
    name: str, scene: Scene, by: Exact, share: Exact, digits: int, most: int | None
) -> tuple[Fraction, Fraction]:
    """Return the distance (m) and the margin of a transfer, exact; raises where they or the scene allow none."""
    require_plain(name, scene, "a transfer")
    require_digits(digits, max_digits=most)
    distance, margin = exact_decimal(by, "distance"), exact_decimal(share, "margin")
    at = scene.initial
    if distance == 0:
        raise InvalidScene("distance = 0 must not be 0; give a distance in metres")
    if not 0 <= margin < 1:
        raise InvalidScene(
            f"margin = {short(margin)} must be at least 0 and below 1; give the share of b to leave unused"
        )
    if any((at.x1, at.v1, at.v2)):
        raise InvalidScene(f"a transfer starts at rest with the spring unloaded, not from {at!r}; set x1 = v1 = v2 = 0")
    scene.require_filippov("a transfer")
    if scene.is_forced:
        raise InvalidScene("a transfer computes its own force, for constant b; leave [[force]] and [[friction]] out")
    return distance, margin


Choice = tuple[TransferKind, arb | None, str, Force | None]
"""A road, its time, what is proved of it, and its force."""


def _choice(
    pair: Pair, far: Fraction, most: Fraction | None, margin: Fraction, stuck: arb, least: arb | None
) -> Choice:
    """Return the fastest transfer that is known; `stuck` and `least`: what it takes to stick, and to slip ahead, N."""
    if most is None or _suffices(most, stuck):
        return _stuck(pair, far, margin)
    slips = least is not None and _suffices(most, least)
    if margin == 0 and slips and (ahead := _slip_then_stick(pair, far, most, least)):
        return ahead
    if bang := _bang_bang(pair, far, most, margin):
        return bang
    known = f"a stuck transfer at the {'margin' if margin else 'limit'} needs {stuck.str(6, radius=False)} N"
    if least is None:
        known += "; whether a slip arrives at the bound with less is open too"
    elif slips:
        known += "; with less, body 2 can arrive at the bound, but whether both bodies can then be at rest is open"
    else:
        known += f", and no force arrives at the bound with less than {least.str(6, radius=False)} N"
    known += '; of a given time, cheapest_transfer with least="peak" finds the force of the least peak'
    return TransferKind.OPEN, None, f"{TransferKind.OPEN.value}; {known}", None


def _suffices(most: Fraction, needed: arb) -> bool:
    return proved_sign(number(most) - needed, "does the amplitude suffice?") >= 0


def stuck_amplitude(pair: Pair, far: Fraction, margin: Fraction) -> arb:
    """Return the largest |u| of the transfer that sticks at (1 - margin) b, N; an enclosure."""
    gain = (1 - margin) * pair.b / pair.m2
    found = number(pair.mass * gain + pair.a2 * far / 2) + number(pair.a1) * number(gain * far).sqrt()
    found = found.max(number(pair.a2 * far))
    if pair.a1**2 * gain <= pair.a2**2 * far:
        found = found.max(number(pair.a2 * far + pair.a1**2 * gain / (2 * pair.a2) - pair.mass * gain))
    return found


def least_amplitude(pair: Pair, far: Fraction) -> arb | None:
    """Return U_min = b + beta tau/g(tau), N, an enclosure; None where g' < 0 somewhere on [0, tau]."""
    tau, squared = number(pair.m2 * far / pair.b).sqrt(), pair.a2 / pair.m1 - (pair.a1 / (2 * pair.m1)) ** 2
    if squared > 0 and number(squared).sqrt() * tau > arb.pi() / 2:
        return None  # g' first vanishes at tan(omegad t) = omegad/decay, before a quarter turn
    _, g, slope = pushed(pair, tau)
    if proved_sign(slope, "does body 1 still run ahead at half time?") < 0:
        return None
    return number(pair.b) + number(pair.b / pair.m2) * tau / g


def _stuck(pair: Pair, far: Fraction, margin: Fraction) -> Choice:
    """Return the transfer that sticks: its exact times are rounded up, its acceleration is exactly D/tau^2."""
    gain = (1 - margin) * pair.b / pair.m2
    exact = number(far / gain).sqrt()
    tau = rounded_up(exact, TIME_DIGITS)
    gain = far / tau**2
    go, stop = Piece(0, (0, 0, gain / 2)), Piece(tau, (far / 2, gain * tau, -gain / 2))
    force = stuck_force(pair, Force((go, stop, Piece(2 * tau, (far,)))))
    faster, there = ("", "its limit") if margin == 0 else (" that keeps the margin", "it")
    return TransferKind.STUCK, 2 * exact, f"no force{faster} is faster: friction is at {there} all the time", force


def _slip_then_stick(pair: Pair, far: Fraction, most: Fraction, least: arb) -> Choice | None:
    """Return the transfer in which body 1 runs ahead; None if holding the place needs more than U.

    Braking never does. It begins with -M beta + a1 v + a2 x <= U - b - M beta, as g'(tau) >= 0, and never falls below
    -M beta >= -U_min. It gets above the force that holds only if a1^2 > 2 a2 M, and then at a velocity a1 beta/a2 <=
    beta tau; but g turns before a1/a2 if a1^2 >= 2 a2 m1.
    """
    beta = pair.b / pair.m2
    slow = (1 - _MET) * beta
    tau = rounded(number(2 * far * slow / (beta * (slow + beta))).sqrt(), TIME_DIGITS)
    push = min(most, rounded_up(least * number(1 + _MET), TIME_DIGITS))
    x, v = rounded(number(push - pair.b) * pushed(pair, number(tau))[0]), beta * tau
    end = x + v**2 / (2 * slow)
    if pair.a2 * end > most:
        return None
    braked = Force((Piece(tau, (x, v, -slow / 2)), Piece(tau + v / slow, (end,))))
    force = Force((Piece(0, (push,)), *stuck_force(pair, braked).pieces))
    proved = "no force is faster: friction is at its limit all the time"
    return TransferKind.SLIP, 2 * number(far / beta).sqrt(), proved, force


def _bang_bang(pair: Pair, far: Fraction, most: Fraction, margin: Fraction) -> Choice | None:
    """Return the stuck transfer between -U and +U; None with a damper, beyond d = 1, or where friction gives way."""
    d = pair.a2 * far / most
    held = (1 - margin) * pair.mass * pair.b / pair.m2
    if pair.a1 != 0 or d > 1 or most + pair.a2 * far > held:
        return None
    rate, more = number(pair.a2 / pair.mass).sqrt(), d / 2 + d**2 / 4
    go, stop = number(1 - more).acos() / rate, number((1 + more) / (1 + d)).acos() / rate
    first, second = rounded(go), rounded(stop)
    force = Force((Piece(0, (most,)), Piece(first, (-most,)), Piece(first + second, (pair.a2 * far,))))
    swing = (rate * (go + stop)).min(arb.pi()).cos()
    proved = "no force under which the bodies stick is faster; whether slip helps is open"
    if number(most) * (2 - swing) <= number(pair.mass * pair.b / pair.m2):
        proved = "no force within the amplitude is faster: none can make the bodies slip before"
    return TransferKind.BANG_BANG, go + stop, proved, force
