"""What one cycle adds to both sides of the $1/t$ law, enclosed."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple

from flint import acb, arb, arb_series, fmpq

from numerics.arithmetic.precision import series_terms
from paper_checks.decide.balls import point, precision

Quotient = Callable[["SlipByAngle", Any], tuple[Any, Any]]


SPLIT, RIM = Fraction(4, 5), Fraction(7, 5)
ORDER = 20
"""Powers of the slip angle in the Taylor polynomials."""


ARCS = 64
RIMS, NEAR, WIDE, LONG = 25, 8, 16, 48
"""Boxes of p on the rim, parts of each near 0, and boxes of p and of the angle beyond."""


TERMS = 48
"""Terms of ln(1 - x)/x."""


REACH, FIXED, WEIGHT = fmpq(4, 5), fmpq(2, 5), fmpq(4, 9)
"""Up to where that series is taken, and two numbers of the map."""


def logarithm(x: Any) -> Any:
    """Return ln(1 - x)/x = -(1 + x/2 + x^2/3 + ...) for |x| < 4/5, its tail and that of its derivative enclosed.

    Also where x may be 0. Raises ArithmeticError where x is not proved to be that small.
    """
    size = abs(x[0] if isinstance(x, arb_series) else x).upper()
    if not size < REACH:
        raise ArithmeticError(f"the series of the logarithm is not proved to converge: |x| = {size.str(5)}")
    total = x * 0
    for n in range(TERMS, 0, -1):
        total = total * x - arb(1) / n
    # what is left out is at most |x|^N/(N (1 - |x|)), its derivative at most |x|^(N-1)/(1 - |x|)
    slope = 5 * size ** (TERMS - 1)
    tail = arb(0, (slope * size).upper())
    if isinstance(x, arb_series):
        return total + arb_series([tail, arb(0, slope.upper()) * x[1]])
    return total + (acb(tail, tail) if isinstance(x, acb) else tail)


@dataclass(frozen=True)
class SlipByAngle:
    """A slip from a ray by its angle: theta, h and c, as numbers, balls or series; what no mass ratio changes, once."""

    theta: Any
    height: Any
    depth: Any

    @cached_property
    def lost(self) -> Any:
        """s = c^2/h^2."""
        return (self.depth / self.height) ** 2

    @cached_property
    def first(self) -> Any:
        """4 s/(9 y)."""
        return (self.depth / (self.height * self.height)) ** 2 * WEIGHT


def of_map(slip: SlipByAngle, p: Any) -> tuple[Any, Any]:
    """Return G and c^2: pi times their quotient is what pi G is of (y - y')/r, as y - y' = r c^2."""
    r = 1 - p * p
    share = r * slip.lost
    gain = slip.first / (1 - share) - 1
    return gain + (r - FIXED) * slip.lost * logarithm(share), slip.depth * slip.depth


def of_time(slip: SlipByAngle, p: Any) -> tuple[Any, Any]:
    """Return F (1 + sqrt(1 - r s)) and h s: their quotient is F r/(sqrt y - sqrt y')."""
    square = p * p
    root = (1 - (1 - square) * slip.lost).sqrt()
    inward = p * (slip.theta - slip.height) / (1 - square * slip.depth)
    more = p * slip.theta - (p * slip.height * root).atan() - inward.atan()
    return more * (1 + root), slip.height * slip.lost


def plain(theta: Any) -> SlipByAngle:
    """Return the slip with its closed forms evaluated as they stand."""
    sine, cosine = (theta / 2).sin(), (theta / 2).cos()
    return SlipByAngle(theta, (theta - theta.sin()) / (2 * sine * sine), 2 - theta * cosine / sine)


def on_box(theta: arb) -> SlipByAngle:
    """Return the slip on a box of angles with its slope: h and c rise, c' = h and h' = c/(1 - cos theta)."""
    low, high = plain(theta.lower()), plain(theta.upper())
    height, deep = low.height.union(high.height), low.depth.union(high.depth)
    slope = deep / (2 * (theta / 2).sin() ** 2)
    return SlipByAngle(arb_series([theta, 1]), arb_series([height, slope]), arb_series([deep, height]))


def on_rim(theta: acb) -> SlipByAngle:
    """Return the slip on a box of complex angles by the values in its middle and c' = h, h' = c/(1 - cos theta)."""
    middle = acb(theta.real.mid(), theta.imag.mid())
    rough, centre = plain(theta), plain(middle)
    slope = rough.depth / (2 * (theta / 2).sin() ** 2)
    off = theta - middle
    return SlipByAngle(theta, centre.height + slope * off, centre.depth + rough.height * off)


class Near(NamedTuple):
    """The slips near theta = 0, whatever the mass ratio: as a power series, and on the boxes of the rim."""

    series: SlipByAngle
    rim: tuple[SlipByAngle, ...]


def near() -> Near:
    """Return them, at the precision that is set."""
    with series_terms(ORDER + 12):
        return Near(plain(arb_series([0, 1])), tuple(on_rim(theta) for theta in _rim()))


def rest(quotient: Quotient, slips: Near, p: arb) -> arb:
    """Bound what a quotient's Taylor polynomial leaves out for slip angles up to SPLIT: Cauchy's estimate on the rim."""
    top = arb(0)
    for slip in slips.rim:
        over, under = quotient(slip, acb(p))
        top = top.max(abs(over / under).upper())
    share = (point(SPLIT) / point(RIM)) ** 2
    return (top * share ** (ORDER // 2) / (1 - share)).upper()


def near_zero(quotient: Quotient, slips: Near, p: arb, missed: arb) -> arb:
    """Enclose a quotient for slip angles up to SPLIT: its Taylor polynomial, and what that leaves out."""
    with series_terms(ORDER + 12):
        above, below = quotient(slips.series, arb_series([p]))
        series = _shifted(above, ZEROS[quotient]) / _shifted(below, ZEROS[quotient])
        coefficients = [series[n] for n in range(0, ORDER, 2)]
    square = arb(0).union(point(SPLIT) ** 2)
    value = arb(0)
    for one in reversed(coefficients):
        value = value * square + one
    return value + arb(0, missed)


class Beyond(NamedTuple):
    """The slips on a box of angles, whatever the mass ratio: with their slopes, without, and in the middle."""

    theta: arb
    along: SlipByAngle
    fixed: SlipByAngle
    middle: SlipByAngle


def slips_on(theta: arb) -> Beyond:
    """Return them, at the precision that is set."""
    with series_terms(2):
        along = on_box(theta)
        return Beyond(
            theta,
            along,
            SlipByAngle(*(arb_series([one[0]]) for one in (along.theta, along.height, along.depth))),
            plain(theta.mid()),
        )


def beyond(quotient: Quotient, slips: Beyond, p: arb) -> arb:
    """Enclose a quotient on a box by its value in the middle and its slopes on the box."""
    centre = p.mid()
    with series_terms(2):
        along = _ratio(quotient(slips.along, arb_series([p])))[1]
        across = _ratio(quotient(slips.fixed, arb_series([p, 1])))[1]
    value = _ratio(quotient(slips.middle, centre))
    return value + along * (slips.theta - slips.middle.theta) + across * (p - centre)


def _ratio(pair: tuple[Any, Any]) -> Any:
    return pair[0] / pair[1]


def _shifted(series: arb_series, zeros: int) -> arb_series:
    """Return a series without its first coefficients, which are 0: raises ArithmeticError where one is proved not to be."""
    for n in range(zeros):
        if not series[n].contains(0):
            raise ArithmeticError(f"the coefficient {n} is {series[n].str(5)}, not 0")
    return arb_series([series[n] for n in range(zeros, ORDER + 6)])


ZEROS: dict[Quotient, int] = {of_map: 4, of_time: 3}
"""Order of the zero of numerator and denominator at theta = 0: the Abel equation to leading order, and the time of a cycle."""


TARGETS: dict[Quotient, Callable[[arb], tuple[arb, arb]]] = {
    of_map: lambda share: (point(Fraction(-14, 100)), share * point(Fraction(155, 100))),
    of_time: lambda _: (point(Fraction(-9, 100)), point(Fraction(43, 100))),
}
"""What the quotients are to be found within for a least r: boxes on which they are not are cut."""


@cache
def ranges() -> tuple[arb, arb, arb]:
    """Return bounds for all slip angles up to pi/2 and all mass ratios.

    The lower one of pi G r/(y - y'), the upper one of pi G/(y - y'), and the upper one of F r/(sqrt y - sqrt y').
    """
    with precision(5):
        maps = [(arb.pi() * value, share) for value, share in _values(of_map)]
        # where a value is negative, r may be as small as it likes
        gains = (value.upper() / share if not value < 0 else arb(0) for value, share in maps)
        times = [value.upper() for value, _ in _values(of_time)]
        return _least([-value.lower() for value, _ in maps], -1), _least(gains, 1), _least(times, 1)


def _values(quotient: Quotient) -> Iterator[tuple[arb, arb]]:
    """Yield enclosures of a quotient on boxes, each with the least r there."""
    slips = near()
    for wide in _pieces(arb(0), arb(1), RIMS):  # what is left out is small: wider boxes do for it
        missed = rest(quotient, slips, wide)
        for p in _pieces(wide.lower(), wide.upper(), NEAR):
            yield near_zero(quotient, slips, p, missed), _least_share(p)
    for theta in _pieces(point(SPLIT), arb.pi() / 2, LONG):
        yield from _refined(quotient, theta, list(_pieces(arb(0), arb(1), WIDE)), 4)


def _least_share(p: arb) -> arb:
    """Return a lower bound of r = 1 - p^2 on a box."""
    return (1 - p * p).lower().max(arb(0))


def _refined(quotient: Quotient, theta: arb, ratios: Sequence[arb], times: int) -> Iterator[tuple[arb, arb]]:
    """Enclose a quotient on boxes, each cut in four as long as it is not within what is looked for."""
    slips = slips_on(theta)
    open_still: list[arb] = []
    for p in ratios:
        value, share = beyond(quotient, slips, p), _least_share(p)
        low, high = TARGETS[quotient](share)
        if not times or (value > low and value < high):
            yield value, share
        else:
            open_still += _pieces(p.lower(), p.upper(), 2)
    if open_still:
        for part in _pieces(theta.lower(), theta.upper(), 2):
            yield from _refined(quotient, part, open_still, times - 1)


def _pieces(low: arb, high: arb, number: int) -> Iterator[arb]:
    """Yield balls that cover an interval."""
    for n in range(number):
        yield (low + (high - low) * n / number).union(low + (high - low) * (n + 1) / number)


def _least(values: Iterable[arb], sign: int) -> arb:
    """Return sign times the largest of some upper bounds."""
    found = arb(0)
    for value in values:
        if not value.is_finite():
            raise ArithmeticError("a quotient is not enclosed")
        found = found.max(value)
    return sign * found


def _rim() -> Iterator[acb]:
    """Yield boxes that cover a quarter of the rim; the quotients are even, and real on the real axis."""
    step = arb.pi() / (2 * ARCS)
    for k in range(ARCS):
        argument = step * (k + point(Fraction(1, 2))) + arb(0, (step / 2).upper())
        yield acb(point(RIM) * argument.cos(), point(RIM) * argument.sin())
