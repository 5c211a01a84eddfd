"""A force that jumps at the exit from stick: one pair without a damper has a continuum of periodic motions under it.

Unit masses, a2 = b = 1 in SI units. The force is constant through a slip of sign 1, 0 through the stick after it,
and then repeats with the opposite sign. All members of the family slip and stick at the same times.
"""

from functools import cache

from sympy import Expr, ImmutableMatrix, Symbol, atan, cos, expand, expand_trig, pi, sin, sqrt

from theory.forced import distance_squared, load
from theory.linear import root
from theory.model import slip, stick
from theory.symbols import a1, a2, b, diff, m1, m2, put, t, u, v1, v1_other, v2, v2_other, x1, x1_other

PAIR = {m1: 1, m2: 1, a1: 0, a2: 1, b: 1}
"""The pair of the family, SI units."""
speed = Symbol("v", real=True)  # of both bodies at the exit, m/s: it names the member of the family
other_speed = Symbol(r"\tilde{v}", real=True)
PUSH = 1 - pi / 4  # the force through the slip, N
SLIP_TIME = pi / 2  # s, a quarter of a period of body 1 alone


@cache
def stick_time() -> Expr:
    """Length of the stick, s: the stuck pair turns by twice the angle whose tangent is sqrt(2)."""
    return 2 * atan(sqrt(2)) / _rest_and_rate("stick", PUSH)[1]


def _acceleration(mode: str, force: Expr | int) -> Expr:
    found = slip(1) if mode == "slip" else stick()
    return expand(found.acceleration1.subs(PAIR).subs(u, force))


def _rest_and_rate(mode: str, force: Expr | int) -> tuple[Expr, Expr]:
    """Return the place (m) about which body 1 swings in a mode under a constant force, and its rate (1/s)."""
    acceleration = _acceleration(mode, force)
    return root(acceleration, x1), sqrt(-diff(acceleration, x1))


def path(mode: str, force: Expr | int, start: ImmutableMatrix) -> ImmutableMatrix:
    """Return (x1, v1, v2), SI units, by the time t from a start; the mode is "slip" (of sign 1) or "stick"."""
    rest, rate = _rest_and_rate(mode, force)
    place = rest + (start[0] - rest) * cos(rate * t) + start[1] / rate * sin(rate * t)
    ahead = start[2] + slip(1).acceleration2.subs(PAIR) * t if mode == "slip" else diff(place, t)
    return ImmutableMatrix([place, diff(place, t), ahead])


@cache
def exit_state() -> ImmutableMatrix:
    """(x1, v1, v2) at the exit into the slip of sign 1: both velocities are `speed`, and agree again at its end."""
    place = Symbol("x", real=True)
    start = ImmutableMatrix([place, speed, speed])
    end = path("slip", PUSH, start).subs(t, SLIP_TIME)
    return start.subs(place, root(end[1] - end[2], place))


@cache
def contact_state() -> ImmutableMatrix:
    """(x1, v1, v2) at the end of that slip."""
    return path("slip", PUSH, exit_state()).subs(t, SLIP_TIME).applyfunc(expand)


@cache
def after_half_period() -> ImmutableMatrix:
    """(x1, v1, v2) at the end of the stick after it."""
    end = path("stick", 0, contact_state()).subs(t, stick_time())
    return end.applyfunc(lambda entry: expand(expand_trig(entry)))


def loads() -> tuple[Expr, Expr, Expr]:
    """The load, N: just before the exit, just after it, and where the stick begins."""
    known = load().subs(PAIR)
    start, contact = exit_state(), contact_state()
    at = [known.subs({u: force, x1: state[0]}) for force, state in ((0, start), (PUSH, start), (0, contact))]
    return at[0], at[1], at[2]


def relative_velocity() -> Expr:
    """v1 - v2 in the slip, m/s."""
    state = path("slip", PUSH, exit_state())
    return expand(state[1] - state[2])


def slowest_and_fastest() -> tuple[Expr, Expr]:
    """The speeds, m/s, between which a member leaves its stick at the jump: the load is b after it, or before it."""
    before, after, _ = loads()
    return root(after - PAIR[b], speed), root(before - PAIR[b], speed)


def apart_squared() -> Expr:
    """The squared energy distance of two members at the exit, J."""
    one, two = exit_state(), exit_state().subs(speed, other_speed)
    states = zip((x1, v1, v2, x1_other, v1_other, v2_other), (*one, *two), strict=True)
    return expand(put(distance_squared().subs(PAIR), dict(states)))
