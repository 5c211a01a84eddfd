"""A slip from S solved by hand, in 50 digits: the yardstick of the closed forms in theory/return_map.py."""

import random

import mpmath
from sympy import Float, Rational, S

from theory import return_map
from theory.symbols import q, theta

DIGITS = 50
TOLERANCE = 10.0 ** (8 - DIGITS)


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
