"""Control of body 2 through the interface: what it can follow, where it can be, transfers, the ring (a1 >= 0)."""

from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Symbol,
    acos,
    cos,
    exp,
    expand,
    integrate,
    sin,
    sqrt,
    together,
)

from theory.energy import metric, slip_rate
from theory.filippov import STATE, guard
from theory.forced_response import decline, natural, swing
from theory.fraction import factored, in_lowest_terms
from theory.linear import root
from theory.model import slip, stick
from theory.scaling import stick_frequency
from theory.symbols import a1, a2, b, diff, m1, m2, put, t, u, v1, v2_0, x1, x1_0, x2_0

r_place, r_speed, r_acceleration = Symbol("r", real=True), Symbol(r"\dot{r}", real=True), Symbol(r"\ddot{r}", real=True)
"""A reference for body 2 and its derivatives, m, m/s, m/s^2; here x1 - x2 = 0 at the start."""
r_start = Symbol("r_0", real=True)  # the reference at the time 0, m
path, duration = Symbol("D", positive=True), Symbol("T", positive=True)
"""Distance of a transfer (m) and the time it takes (s)."""
half_time = Symbol("tau", positive=True)  # half the least time of a transfer, s
velocity_gain = Symbol(r"\Delta v_2", real=True)  # of body 2 over a transfer, m/s
strength = Symbol("U", positive=True)  # bound of the force, N
reduced = Symbol("d", positive=True)  # a2 D/U
angle = Symbol("theta", positive=True)
tolerance = Symbol("varepsilon", positive=True)  # width of a tube in the energy distance N, sqrt(J)


def strongest() -> Expr:
    """b/m2, m/s^2: the acceleration of body 2 in slip, which stick cannot exceed."""
    return slip(1).acceleration2


@cache
def followed_start() -> tuple[Expr, Expr]:
    """(r(0), r'(0)), m and m/s, of a reference that is the path of body 2, which starts at x2(0) with v2(0).

    The path is the start and what the acceleration, here a constant, adds in two integrals.
    """
    place, speed = Symbol("p_0", real=True), Symbol("p_1", real=True)
    gained = integrate(integrate(r_acceleration, t), t)
    apart = x2_0 + v2_0 * t + gained - (place + speed * t + r_acceleration * t**2 / 2)
    at_start = {place: root(apart.subs(t, 0), place), speed: root(diff(apart, t).subs(t, 0), speed)}
    return at_start[place], at_start[speed]


def stuck_offset() -> Expr:
    """Place of body 1 less the reference, m, in a pair that always sticks: both move alike."""
    moved = r_place - r_start
    return (x1_0 + moved - r_place).expand()


@cache
def stuck_force() -> Expr:
    """The force, N, under which the stuck pair has a place, velocity and acceleration: that of the reference."""
    along = {x1: r_place, v1: r_speed}
    return root(put(stick().acceleration1, along) - r_acceleration, u).expand()


@cache
def farthest() -> Expr:
    """The farthest place of body 2 at T, m, from rest at 0, for a change of velocity that it can make.

    Full acceleration first, its opposite from the time on at which the change is right.
    """
    turn = Symbol("s", positive=True)
    first = strongest() * t
    second = first.subs(t, turn) - strongest() * (t - turn)
    switch = root(second.subs(t, duration) - velocity_gain, turn)
    place = integrate(first, (t, 0, turn)) + integrate(second, (t, turn, duration))
    return place.subs(turn, switch).expand()


def nearest() -> Expr:
    """The nearest place, m: the mirror image of the farthest one for the opposite change."""
    return -farthest().subs(velocity_gain, -velocity_gain)


def middle() -> Expr:
    """Half way between both, m."""
    return expand((farthest() + nearest()) / 2)


@cache
def spread() -> Expr:
    """How far the place of body 2 at T can be from the middle, m."""
    return factored((farthest() - nearest()) / 2)


@cache
def least_time() -> Expr:
    """The least time of a transfer from rest to rest over D, s."""
    square = Symbol("T^2", positive=True)
    return sqrt(root(spread().subs({velocity_gain: 0, duration: sqrt(square)}) - path, square))


def bang(first_half: bool) -> Expr:
    """The place of body 2 in the least time, m, by the time from the start, in the second half by that to the end."""
    way = strongest() * t**2 / 2
    return way if first_half else path - way


def transfer_force(first_half: bool) -> Expr:
    """The force under which the pair makes that transfer stuck, N, by the same times."""
    place, sign = bang(first_half), 1 if first_half else -1
    known = {r_place: place, r_speed: sign * diff(place, t), r_acceleration: diff(place, t, 2)}
    return put(stuck_force(), known)


@cache
def stuck_amplitudes() -> tuple[Expr, Expr, Expr]:
    """What the stuck transfer needs, N: where it turns, to hold at the end, and the highest point of the second half.

    The third one counts where its time a1/a2 before the end lies in the second half, `late_peak`.
    """
    turn = least_time() / 2
    at_turn = transfer_force(True).subs(t, turn).expand()
    at_rest = stuck_force().subs({r_place: path, r_speed: 0, r_acceleration: 0})
    late = transfer_force(False)
    return at_turn, at_rest, late.subs(t, root(diff(late, t), t)).expand()


@cache
def late_peak() -> Expr:
    """a2^2 D - a1^2 b/m2, (N/s)^2 kg: at least zero where the force of the second half has its highest point inside."""
    before = root(diff(transfer_force(False), t), t)
    return factored(((least_time() / 2) ** 2 - before**2) * a2**2 * strongest()).expand()


@cache
def impulse_response() -> Expr:
    """g, m/(N s): the place of body 1 after a unit impulse, by `decline` and `swing`."""
    return exp(-decline * t) * sin(swing * t) / (m1 * swing)


def response_peak() -> Expr:
    """The angle theta = omega_1 t up to which g rises where a1 = 0."""
    response = put(impulse_response(), {decline: 0, t: angle / swing})
    level = Symbol("c")
    return acos(root(diff(response, angle).subs(cos(angle), level), level))


@cache
def slipping_amplitude() -> Expr:
    """The least amplitude with which body 2 arrives in the least time, N, by g(tau): v1 is v2 at tau."""
    g = Symbol("g", positive=True)
    reached = (strength - b) * g
    return root(reached - strongest() * half_time, strength).expand()


@cache
def undamped_slipping_amplitude() -> Expr:
    """The same for a1 = 0, N, by theta = omega_1 tau."""
    response = impulse_response().subs({decline: 0, swing: natural, t: half_time})
    g = Symbol("g", positive=True)
    return in_lowest_terms(slipping_amplitude().subs(g, response).subs(half_time, angle / natural))


@cache
def switching_cosines() -> tuple[Expr, Expr]:
    """The cosines of the angles `switching`.

    In units of U/a2: about 1 from (0, 0) and about -1 into (d, 0), circles that meet at one place.
    """
    place = Symbol("X", real=True)
    meets = root((1 - (place - 1) ** 2) - ((1 + reduced) ** 2 - (place + 1) ** 2), place)
    return (1 - meets).expand(), together((meets + 1) / (1 + reduced))


def switching() -> tuple[Expr, ...]:
    """The angles Omega t of both arcs of the fastest transfer of the stuck pair by |u| <= U without a damper, by d."""
    return tuple(map(acos, switching_cosines()))


def weak_time() -> Expr:
    """The time of that transfer, s: its arcs at the angular frequency of the stuck pair."""
    return sum(switching()) / stick_frequency()


def pressed() -> Expr:
    """M x1'' at most, N, that any |u| <= U gives the stuck pair from rest on in half a turn, by the angle Omega t."""
    farthest = strength / a2 * (1 - cos(angle))
    return (strength + a2 * farthest).expand()


def ring_ratio() -> Expr:
    """The square of the largest |w| in N <= 1, 1/kg: where m1 v1 + m2 v2 = 0."""
    speed = Symbol("v", positive=True)
    opposite = -m1 * speed / m2
    return factored((speed - opposite) ** 2 / (m1 * speed**2 + m2 * opposite**2))


def ring_radius() -> Expr:
    """The largest |w| in N <= epsilon, m/s: sqrt(c^T G^-1 c) epsilon with w = c^T z and the energy metric G."""
    gradient = ImmutableMatrix([diff(guard(), one) for one in STATE])
    return sqrt((gradient.T * metric().inv() * gradient)[0]) * tolerance


def path_per_energy() -> Expr:
    """|dz/dE| at most, m/J: how far the free pair, z = x1 - x2, slips for its energy where no damper takes a share."""
    return in_lowest_terms(-guard() / slip_rate(1).subs(a1, 0))
