"""Checks `critical_ratio.json`: every cell again, in balls, with nothing taken from the program that wrote it.

The certificate has four parts. Half angles phi are between 0 and pi, s = sin phi, k = cos phi.

    turning    cells that tell the sign of K = phi - s k - sqrt(2)(s - phi k) or of its slope s (2 s - sqrt(2) phi):
               K is above 0, then falling, then below 0, so it has one zero phi* in (0, pi)
    constants  bounds of phi*, of m2/M = 1/(2 s^2), of m1/m2 = -cos 2 phi and of its inverse there
    surface    one share r = m2/M and cells on which every slip that starts on S, d >= 0, ends above E_cr: on the ray
               (phi - s k)^2 - 4 r s^2 (s - phi k)^2 > 0, beyond the edge phi^2 - s^2 - r (s - phi k)^2/(1 - r s^2) > 0
    bands      shares m2/M and excesses w on a ray, with a bracket of the angle of each slip up to what is claimed
    outcomes   how many bands merge, and how many creep

Run it with `python -m paper_checks.certificates.checker [FILE]`: it prints what it objects to, and exits 1 if it does.
"""

from __future__ import annotations

import itertools
import json
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
from flint import arb, fmpq

CERTIFICATE = Path(__file__).with_name("critical_ratio.json")
_BITS = 400
_TURNING_ORDER = ["above", "falling", "below"]


def objections(text: str) -> list[str]:
    """Return what is wrong with a certificate; an empty list means that all it states is proved."""
    try:
        certificate = json.loads(text)
        with _precision():
            parts = (_turning, _constants, _surface, _bands)
            return [objection for part in parts for objection in part(certificate)]
    except (KeyError, TypeError, ValueError, IndexError, ZeroDivisionError) as error:
        return [f"not a certificate: {type(error).__name__}: {error}"]


@contextmanager
def _precision() -> Iterator[None]:
    before, flint.ctx.prec = flint.ctx.prec, _BITS
    try:
        yield
    finally:
        flint.ctx.prec = before


def _ball(low: str, high: str) -> arb:
    """Return a ball around the interval between two exact rationals."""
    ends = [Fraction(low), Fraction(high)]
    if ends[0] > ends[1]:
        raise ValueError(f"the interval [{low}, {high}] is empty")
    first, last = (arb(fmpq(end.numerator, end.denominator)) for end in ends)
    return first.union(last)


def _cover(name: str, cells: Sequence[Any]) -> Iterator[str]:
    """Object where the cells do not run on from 1/4 to 22/7 > pi without a gap."""
    if Fraction(cells[0][0]) != Fraction(1, 4):
        yield f"{name}: the first cell must begin at 1/4, where the expansion at 0 ends"
    if Fraction(cells[-1][1]) != Fraction(22, 7):
        yield f"{name}: the last cell must end at 22/7, just beyond pi"
    for before, after in itertools.pairwise(cells):
        if Fraction(before[1]) != Fraction(after[0]):
            yield f"{name}: gap or overlap at {before[1]}, {after[0]}"


def _turning(certificate: Any) -> Iterator[str]:
    """K rises on (0, 1/4], as 2 sin x > sqrt(2) x there (sin x/x falls); the cells say the rest."""
    cells = certificate["turning"]
    yield from _cover("turning", cells)
    kinds = [cell[2] for cell in cells]
    if set(kinds) != set(_TURNING_ORDER) or kinds != sorted(kinds, key=_TURNING_ORDER.index):
        yield "turning: the kinds must be above, falling, below, in this order"
    for low, high, kind, bound in cells:
        x, least = _ball(low, high), _ball(bound, bound)
        value = -_turning_slope(x) if kind == "falling" else _turning_value(x) * (1 if kind == "above" else -1)
        if not (least > 0 and value > least):
            yield f"turning: [{low}, {high}] is not proved {kind}"


def _turning_value(x: arb) -> arb:
    """Return K in mean value form: tight where the terms cancel."""
    middle = x.mid()
    sine, cosine = middle.sin_cos()
    value = middle - sine * cosine - arb(2).sqrt() * (sine - middle * cosine)
    return value + arb(0, (x.rad() * abs(_turning_slope(x))).upper())


def _turning_slope(x: arb) -> arb:
    return x.sin() * (2 * x.sin() - arb(2).sqrt() * x)


def _constants(certificate: Any) -> Iterator[str]:
    """K changes its sign inside the bounds of phi*, and the other bounds contain what follows from them."""
    bounds = certificate["constants"]
    low, high = bounds["half_angle"]
    if not (_turning_value(_ball(low, low)) > 0 and _turning_value(_ball(high, high)) < 0):
        yield "constants: K does not change its sign between the bounds of the half angle"
    x = _ball(low, high)
    values = {
        "share": 1 / (2 * x.sin() ** 2),
        "m1_over_m2": -(2 * x).cos(),
        "m2_over_m1": -1 / (2 * x).cos(),
    }
    for name, value in values.items():
        claimed = [_ball(end, end) for end in bounds[name]]
        if not (claimed[0] < value < claimed[1]):
            yield f"constants: {name} is not within its bounds"


def _surface(certificate: Any) -> Iterator[str]:
    """At half angles up to 1/4 the ray is the worst start, and there h^2 - r c^2 >= h^2 (1 - theta^2) > 0 as c <= theta h."""
    part = certificate["surface"]
    share = _ball(part["share"], part["share"])
    yield from _cover("surface", part["cells"])
    if not (share > 0 and share < 1 and 2 * share * arb("0.5").sin() ** 2 < 1):
        yield "surface: the share must lie in (0, 1)"
    for low, high, kind, bound in part["cells"]:
        x, least = _ball(low, high), _ball(bound, bound)
        on_ray, anywhere, ray_is_worst = _surface_values(share, x)
        proved = {"ray": ray_is_worst and on_ray > least, "any": anywhere > least}[kind]
        if not (least > 0 and proved):
            yield f"surface: [{low}, {high}] is not proved for {kind}"


def _surface_values(share: arb, x: arb) -> tuple[arb, arb, bool]:
    """Return sin^4 w'/q on the ray, sin^2 of its least value at any d, and whether no d > 0 is worse than the ray."""
    sine, cosine = x.sin_cos()
    lag, loaded = sine - x * cosine, share * sine**2
    on_ray = (x - sine * cosine) ** 2 - 4 * loaded * lag**2
    anywhere = x**2 - sine**2 - share * lag**2 / (1 - loaded)
    return on_ray, anywhere, bool(2 * loaded <= 1)


def _bands(certificate: Any) -> Iterator[str]:
    for band in certificate["bands"]:
        place = f"bands: m2/M in {band['share']}, w in {band['excess']}"
        share, excess = _ball(*band["share"]), _ball(*band["excess"])
        if not (share > 0 and share < 1 and excess > 0):
            yield f"{place}: outside the parameters"
        elif (failure := _follow(share, excess, band["slips"])) is not None:
            yield f"{place}: {failure}"
    last = [band["slips"][-1][2] for band in certificate["bands"] if band["slips"]]
    if certificate["outcomes"] != {one: last.count(one) for one in ("merges", "creeps")}:
        yield "bands: there are not as many as stated"


def _follow(share: arb, excess: arb, slips: Sequence[Any]) -> str | None:
    """Follow the slips from a ray; return the first step that is not proved, None if all are and the last one ends it."""
    q = 1 - share
    gap, push = arb(0), (excess / q).sqrt()
    for number, (low, high, outcome) in enumerate(slips, start=1):
        ends = [_contact(_ball(end, end), gap, push) for end in (low, high)]
        theta = _ball(low, high)
        if not (theta > 0 and theta < 2 * arb.pi() and ends[0] < 0 and ends[1] > 0):
            return f"slip {number} does not end in [{low}, {high}]"
        depth = _depth(_ball(low, low)).union(_depth(_ball(high, high)))  # it rises with theta
        excess = excess - q * share * depth * (depth + 2 * gap)
        gap, push = -(gap + depth), push - theta
        failure, last = _outcome(outcome, q, gap, push, excess)
        if failure or last != (number == len(slips)):
            return f"slip {number}: {failure or 'more slips, or fewer, than the outcome allows'}"
        gap, push = (-(gap + 2 / q), -push) if outcome == "crosses" else (arb(0), (excess / q).sqrt())
    return None if slips else "no slip"


def _contact(theta: arb, gap: arb, push: arb) -> arb:
    """Return h - d cot(theta/2) - u, which rises with theta if d >= 0 and is 0 where the slip ends."""
    half = theta / 2
    return (theta - theta.sin()) / (1 - theta.cos()) - gap * half.cot() - push


def _depth(theta: arb) -> arb:
    """Return c = 2 - theta cot(theta/2)."""
    return 2 - theta * (theta / 2).cot()


def _outcome(outcome: str, q: arb, gap: arb, push: arb, excess: arb) -> tuple[str | None, bool]:
    """Return why an outcome is not proved, or None, and whether it is final."""
    position = 1 + q * gap
    inside = position > -1 and position < 1
    level = q * (arb.pi() / 2 - 1) ** 2
    proved = {
        "merges": excess < 0,
        "creeps": inside and excess > 0 and excess < level,
        "opposite": inside and excess > 0 and push < 0,
        "same": inside and excess > 0 and push > 0,
        "crosses": position < -1,
    }[outcome]
    return None if proved else f"{outcome} is not proved", outcome in ("merges", "creeps")


def main(arguments: Sequence[str]) -> int:
    """Check a file and print what there is to object."""
    path = Path(arguments[0]) if arguments else CERTIFICATE
    found = objections(path.read_text("utf-8"))
    print("\n".join(found) or f"{path.name}: all of it is proved")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
