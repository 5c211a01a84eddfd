"""Every closed form of a slip from S against the solved slip ODE in 50 digits, and faults that must show."""

import random
from collections.abc import Iterator

import mpmath
import pytest
from sympy import Float, Rational, S, cot, diff, expand, limit, oo, pi, sin

from theory import return_map
from theory.symbols import q, theta

DIGITS = 50
TOLERANCE = 10.0 ** (8 - DIGITS)
CACHED = [member for member in vars(return_map).values() if hasattr(member, "cache_clear")]


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mpmath.workdps(DIGITS + 10):
        yield


def number(value) -> mpmath.mpf:
    """A sympy number, in more digits than the comparison needs."""
    return mpmath.mpf(str(S(value).evalf(DIGITS + 8)))


def at(expression, **values) -> mpmath.mpf:
    """An expression of theory.return_map at numbers for q, d, u, theta, y."""
    symbols = {symbol.name: symbol for symbol in (q, return_map.gap, return_map.push, return_map.scaled_excess, theta)}
    point = {symbols[name]: Float(mpmath.nstr(value, DIGITS + 10), DIGITS + 10) for name, value in values.items()}
    return number(S(expression).subs(point))


class SlipByHand:
    """The slip with v1 < v2 from X = 1 + q d, V1 = V2 = sqrt(q) u, solved from q V1' = -(X - r), V2' = -1 by hand."""

    def __init__(self, fraction, gap, push):
        self.rationals = fraction, gap, push

    @property
    def numbers(self):
        """q, d, u in the precision of the moment."""
        return [mpmath.mpf(value.p) / value.q for value in self.rationals]

    @property
    def q(self):
        return self.numbers[0]

    @property
    def d(self):
        return self.numbers[1]

    @property
    def u(self):
        return self.numbers[2]

    @property
    def r(self):
        return 1 - self.q

    @property
    def root(self):
        return mpmath.sqrt(self.q)

    @property
    def start(self):
        return 1 + self.q * self.d, self.root * self.u, self.root * self.u

    def state(self, angle):
        """(X, V1, V2) at tau = sqrt(q) angle: body 1 turns about X = r, body 2 is slowed at the rate 1."""
        reach, speed = self.start[0] - self.r, self.start[1]
        cosine, sine = mpmath.cos(angle), mpmath.sin(angle)
        return (
            self.r + reach * cosine + self.root * speed * sine,
            speed * cosine - reach / self.root * sine,
            self.start[2] - self.root * angle,
        )

    def guard(self, angle):
        """(V1 - V2)/sqrt(q)."""
        _, v1, v2 = self.state(angle)
        return (v1 - v2) / self.root

    def end(self):
        """The first zero of the guard after its start: scanned for in steps of 1/200, then bisected."""
        step = mpmath.mpf(1) / 200
        angle = step
        assert self.guard(angle) < 0, "the slip is over before the scan begins: draw it longer"
        while self.guard(angle) < 0:
            angle += step
        return mpmath.findroot(self.guard, (angle - step, angle), solver="anderson", tol=mpmath.mpf(10) ** -105)

    def excess(self, angle):
        """w = X^2 + q V1^2 + r V2^2 - 1."""
        x, v1, v2 = self.state(angle)
        return x**2 + self.q * v1**2 + self.r * v2**2 - 1


def slips(cases, gaps=(0, 300)):
    """Random slips; every third one is from a ray (d = 0)."""
    source = random.Random(5)
    for case in range(cases):
        gap = Rational(source.randint(*gaps), 100) if case % 3 else Rational(0)
        push = Rational(source.randint(20, 300), 100)
        if case % 2 and gap > 0:
            push = -push  # beyond the edge the pair may move inwards at the start
        yield SlipByHand(Rational(source.randint(2, 98), 100), gap, push)


SLIPS = list(slips(9))


def test_the_slip_by_hand_solves_its_equations():
    """Against a Taylor integrator, so that the yardstick itself does not rest on the closed form."""
    with mpmath.workdps(25):
        slip = SlipByHand(Rational(1, 3), Rational(2, 5), Rational(3, 4))

        def field(_, y):
            return [y[1], -(y[0] - slip.r) / slip.q, mpmath.mpf(-1)]

        integrated = mpmath.odefun(field, 0, list(slip.start))(slip.root)
        assert all(abs(one - other) < 1e-20 for one, other in zip(integrated, slip.state(1), strict=True))


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_ends_where_the_contact_condition_vanishes(slip):
    end = slip.end()
    assert 0 < end < 2 * mpmath.pi
    assert abs(at(return_map.contact_condition(), d=slip.d, u=slip.u, theta=end)) < TOLERANCE
    wrong = return_map.contact_condition() + 2 * return_map.gap * cot(theta / 2)
    assert slip.d == 0 or abs(at(wrong, d=slip.d, u=slip.u, theta=end)) > 1e-6


@pytest.mark.parametrize("slip", SLIPS)
def test_the_guard_on_the_way(slip):
    for angle in (mpmath.mpf(1) / 7, mpmath.mpf(2), slip.end()):
        found = at(return_map.reduced_guard(), q=slip.q, d=slip.d, u=slip.u, theta=angle)
        assert abs(found - slip.guard(angle)) < TOLERANCE


def landed(slip, landing, end):
    """(gap, push, change of the excess) by the closed forms minus those of the slip by hand."""
    x, _, v2 = slip.state(end)
    known = {"q": slip.q, "d": slip.d, "u": slip.u, "theta": end}
    return (
        at(landing.gap, **known) - (x - 1) / slip.q,
        at(landing.push, **known) - v2 / slip.root,
        at(landing.excess_change, **known) - (slip.excess(end) - slip.excess(mpmath.mpf(0))),
    )


@pytest.mark.parametrize("slip", SLIPS)
def test_where_a_slip_lands(slip):
    assert all(abs(difference) < TOLERANCE for difference in landed(slip, return_map.landing(), slip.end()))


def wrong_landings():
    """Landings with one sign, factor or term wrong, and which of the three entries that is."""
    depth, gap, push, fraction = return_map.depth(), return_map.gap, return_map.push, 1 - q
    right = return_map.landing()
    yield 0, return_map.Landing(gap + depth, right.push, right.excess_change)
    yield 0, return_map.Landing(-depth - 2 * gap, right.push, right.excess_change)
    yield 0, return_map.Landing(-gap - depth / 2, right.push, right.excess_change)
    yield 1, return_map.Landing(right.gap, push + theta, right.excess_change)
    yield 1, return_map.Landing(right.gap, push - 2 * theta, right.excess_change)
    yield 2, return_map.Landing(right.gap, right.push, -q * fraction * depth * (depth + gap))
    yield 2, return_map.Landing(right.gap, right.push, q * fraction * depth * (depth + 2 * gap))
    yield 2, return_map.Landing(right.gap, right.push, -q * q * depth * (depth + 2 * gap))
    yield 2, return_map.Landing(right.gap, right.push, -fraction * depth * (depth + 2 * gap))
    yield 2, return_map.Landing(right.gap, right.push, -2 * q * fraction * depth * (depth + 2 * gap))


def test_a_wrong_landing_shows_in_its_entry_only():
    slip = SLIPS[2]
    assert slip.d > 0
    end = slip.end()
    for entry, wrong in wrong_landings():
        differences = [abs(difference) > TOLERANCE for difference in landed(slip, wrong, end)]
        assert differences == [position == entry for position in range(3)]


@pytest.mark.parametrize("slip", [one for one in SLIPS if one.d == 0])
def test_the_return_map_of_a_ray(slip):
    end = slip.end()
    before, after = (at(one, q=slip.q, theta=end) for one in return_map.return_map_of_angle())
    assert abs(before - slip.excess(0) / slip.q) < TOLERANCE
    assert abs(after - slip.excess(end) / slip.q) < TOLERANCE
    assert abs(before - 2 * (before - after) - slip.excess(end) / slip.q) > 1e-6


def test_the_slope_of_the_return_map_is_its_derivative():
    """(y'(theta + s) - y'(theta - s))/(y(theta + s) - y(theta - s)) is 1 - r (1 - cos theta) up to s^2."""
    step, fraction, angle = mpmath.mpf(10) ** -12, mpmath.mpf(1) / 3, mpmath.mpf(2)
    ends = [[at(one, q=fraction, theta=angle + s) for one in return_map.return_map_of_angle()] for s in (step, -step)]
    slope = (ends[0][1] - ends[1][1]) / (ends[0][0] - ends[1][0])
    assert abs(slope - (1 - (1 - fraction) * (1 - mpmath.cos(angle)))) < 1e-20
    assert abs(slope - (1 - (1 - fraction) * (1 + mpmath.cos(angle)))) > 0.1


def test_both_terms_of_the_contact_slope_are_its_derivative_and_positive():
    first, second = return_map.contact_slope()
    for slip in SLIPS:
        for angle in map(mpmath.mpf, ("0.01", "1", "3", "5", "6.28")):
            known = {"d": slip.d, "u": slip.u, "theta": angle}
            terms = at(first, **known), at(second, **known)
            assert terms[0] > 0
            assert terms[1] >= 0
            assert abs(at(diff(return_map.contact_condition(), theta), **known) - sum(terms)) < TOLERANCE * 10**9


def test_the_depth():
    depth = return_map.depth()
    assert limit(depth, theta, 0) == 0
    assert limit(depth / theta**2, theta, 0) == Rational(1, 6)
    assert depth.subs(theta, pi) == 2
    assert limit(depth, theta, 2 * pi, "-") == oo
    for angle in (Rational(1, 9), S(2), S(5)):
        assert abs(number((diff(depth, theta) - return_map.depth_slope()).subs(theta, angle))) < TOLERANCE
        assert abs(number((return_map.half_cotangent() - cot(theta / 2)).subs(theta, angle))) < TOLERANCE
        assert abs(number((return_map.in_trigonometry(depth) - depth).subs(theta, angle))) < TOLERANCE
    assert not return_map.in_trigonometry(depth).has(cot)


def depth_by_inversion(excess):
    """c at y: h(theta) = sqrt(y) solved by Newton's method from theta = 3 sqrt(y), to the working precision."""
    root = mpmath.sqrt(excess)
    angle = mpmath.findroot(
        lambda a: (a - mpmath.sin(a)) / (1 - mpmath.cos(a)) - root,
        3 * root,
        tol=mpmath.mpf(10) ** (-1.5 * mpmath.mp.dps),
    )
    return 2 - angle * mpmath.cot(angle / 2)


def remainders(coefficients, excess):
    """(c - the terms before y^n)/y^n - c_n for each n: of the size of the next term, c_(n+1) y."""
    left = depth_by_inversion(excess)
    for power, coefficient in enumerate(coefficients, 1):
        value = mpmath.mpf(coefficient.p) / coefficient.q
        yield left / excess**power - value
        left -= value * excess**power


def test_the_series_of_the_depth_is_that_of_the_inverted_map():
    coefficients = return_map.depth_series(7)
    assert all(isinstance(coefficient, Rational) for coefficient in coefficients)
    assert coefficients[0] == Rational(3, 2)
    with mpmath.workdps(160):
        small = mpmath.mpf(10) ** -12
        assert all(abs(remainder) < 1e-11 for remainder in remainders(coefficients, small))
        for power in range(len(coefficients)):
            wrong = list(coefficients)
            wrong[power] *= Rational(1001, 1000)
            assert max(abs(remainder) for remainder in remainders(wrong, small)) > 1e-9


def test_a_longer_series_starts_with_the_shorter_one():
    assert return_map.depth_series(7)[:3] == return_map.depth_series(3)


@pytest.mark.parametrize("order", [2, 3, 8])
def test_the_series_of_the_return_map_errs_by_its_first_dropped_term(order):
    series, fraction = return_map.return_map_series(order), mpmath.mpf(1) / 4
    quadratic = expand(series).coeff(return_map.scaled_excess, 2)
    assert expand(quadratic + Rational(9, 4) * (1 - q)) == 0
    with mpmath.workdps(DIGITS + 10):
        small = mpmath.mpf(10) ** -4
        exact = small - (1 - fraction) * depth_by_inversion(small) ** 2
        error = abs(at(series, q=fraction, y=small) - exact)
    assert 0.25 < error / small ** (order + 1) < 4  # the coefficient that was dropped is of the size of 1


def test_an_excursion_of_a_heavy_driven_body_may_merge_and_of_a_light_one_not():
    _, after = return_map.return_map_of_angle()
    assert at(after, q=mpmath.mpf("0.3"), theta=mpmath.pi) < 0
    assert at(after, q=mpmath.mpf("0.5"), theta=mpmath.pi) > 0
    assert at(after, q=mpmath.mpf("0.3"), theta=mpmath.pi / 2) > 0


RESIDUALS = [
    "guard_residual",
    "contact_slope_residual",
    "landing_residuals",
    "depth_slope_residual",
    "return_map_residuals",
    "return_map_slope_residual",
]


def nonzero():
    """The names of the residuals that are not all zero."""
    values = {name: getattr(return_map, name)() for name in RESIDUALS}
    return {name for name, value in values.items() if value not in (0, (0, 0), (0, 0, 0))}


def test_all_residuals_are_zero():
    assert nonzero() == set()


@pytest.fixture
def plant(monkeypatch):
    """Replace a name of theory.return_map, with nothing remembered before or after."""

    def planted(name, fault):
        monkeypatch.setattr(return_map, name, fault(getattr(return_map, name)))
        forget()

    yield planted
    monkeypatch.undo()
    forget()


def forget():
    for member in CACHED:
        member.cache_clear()


FAULTS = [
    ("depth", lambda depth: lambda: -depth(), {"landing_residuals", "depth_slope_residual"}),
    ("depth", lambda depth: lambda: depth() - 2, {"landing_residuals", "return_map_residuals"}),
    ("depth", lambda depth: lambda: depth() + sin(theta), set(RESIDUALS[2:])),
    ("h", lambda h: lambda: 2 * h(), {"guard_residual", "landing_residuals", *RESIDUALS[3:]}),
    ("half_cotangent", lambda half: lambda: -half(), {*RESIDUALS[:3], "return_map_residuals", "depth_slope_residual"}),
    ("half_cotangent", lambda half: lambda: 1 / half(), set(RESIDUALS)),
    ("r", lambda share: -share, {"landing_residuals", "return_map_residuals"}),
    ("r", lambda share: q, {"landing_residuals", "return_map_residuals"}),
    ("excess", lambda excess: lambda: 2 * excess(), {"landing_residuals"}),
    ("contact_slope", lambda slope: lambda: (slope()[0], -slope()[1]), {"contact_slope_residual"}),
    ("contact_slope", lambda slope: lambda: (2 * slope()[0], slope()[1]), {"contact_slope_residual"}),
    ("contact_condition", lambda contact: lambda: contact() + 1, {"guard_residual"}),
    ("return_map_of_angle", lambda both: lambda: (both()[0], both()[1] ** 2), set(RESIDUALS[4:])),
]


@pytest.mark.parametrize(("name", "fault", "shown"), FAULTS)
def test_a_fault_leaves_a_residual(plant, name, fault, shown):
    plant(name, fault)
    assert shown <= nonzero()
