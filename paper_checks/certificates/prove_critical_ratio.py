"""Writes `critical_ratio.json`: a search by bisection for cells that prove the threshold of the mass ratio, and bands.

What it finds is not evidence; `checker.py`, which shares no code with this file, decides. Run it with
`python -m paper_checks.certificates.prove_critical_ratio`; two runs write the same bytes.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from flint import arb

from numerics.arithmetic.ball import Ball, depth_and_cotangent, sine_deficit, versine
from numerics.free.contact import contact
from paper_checks import atomic
from paper_checks.engines.balls import point, precision
from paper_checks.engines.roots import enclosed_root

CERTIFICATE = Path(__file__).with_name("critical_ratio.json")
SHARE = Fraction(557, 1000)
"""A share just below the threshold 0.55784 at which every slip from S is shown to stay above E_cr, cell by cell."""
START, END = Fraction(1, 4), Fraction(22, 7)
SMALLEST = Fraction(1, 2**20)
SHARES = (Fraction(3, 5), Fraction(7, 10), Fraction(4, 5), Fraction(9, 10))
EXCESSES = tuple(Fraction(n, 4) for n in (1, 2, *range(4, 24, 4), *range(24, 160, 8)))
WIDTH = Fraction(1, 10**4)
LONGEST = 12
"""Slips followed in a band before it is given up."""
DIGITS = 60

Cell = list[str]


def turning_value(phi: arb) -> arb:
    """K = phi - sin cos - sqrt(2)(sin - phi cos), as a Taylor polynomial of first order about the middle."""
    middle, slope = phi.mid(), turning_slope(phi)
    value = middle - (2 * middle).sin() / 2 - arb(2).sqrt() * (middle.sin() - middle * middle.cos())
    return value + slope * (phi - middle)


def turning_slope(phi: arb) -> arb:
    """K' = 2 sin^2 phi - sqrt(2) phi sin phi."""
    return 2 * phi.sin() ** 2 - arb(2).sqrt() * phi * phi.sin()


def turning_kind(phi: arb) -> tuple[str, arb] | None:
    """Return what is proved of K on a cell, with a lower bound of it; None where nothing is."""
    value, slope = turning_value(phi), turning_slope(phi)
    found = {"above": value, "below": -value, "falling": -slope}
    # where K falls anyway, next to its zero, no sign is looked for
    near = phi > arb("1.85") and phi < arb("1.95")
    for kind in ("falling",) if near else ("above", "below"):
        if found[kind] > 0:
            return kind, found[kind]
    return None


def surface_kind(phi: arb) -> tuple[str, arb] | None:
    """Return for which starts every slip with this half angle is proved to end above E_cr, with a lower bound."""
    share, sine, cosine = point(SHARE), phi.sin(), phi.cos()
    loaded, lag = share * sine * sine, sine - phi * cosine
    ray = (phi - sine * cosine) ** 2 - 4 * loaded * lag * lag
    anywhere = phi * phi - sine * sine - share * lag * lag / (1 - loaded)
    if 2 * loaded < 1 and ray > 0:
        return "ray", ray
    return ("any", anywhere) if anywhere > 0 else None


def cells(kind_of: Callable[[arb], tuple[str, arb] | None], low: Fraction, high: Fraction) -> list[Cell]:
    """Bisect [low, high] until each cell is of some kind; raises ArithmeticError where that takes too small cells."""
    found = kind_of(point(low).union(point(high)))
    if found:
        bound = Fraction(str(float(found[1].lower()) / 2)).limit_denominator(10**6)
        if bound > 0:
            return [[str(low), str(high), found[0], str(bound)]]
    if high - low < SMALLEST:
        raise ArithmeticError(f"nothing is proved between {float(low)} and {float(high)}")
    middle = (low + high) / 2
    return cells(kind_of, low, middle) + cells(kind_of, middle, high)


def constants() -> dict[str, list[str]]:
    """Return bounds, decimal ends as fractions, of the half angle, the share and both mass ratios at the threshold."""
    root = enclosed_root(turning_value, Fraction(3, 2), Fraction(5, 2), DIGITS)
    values = {
        "share": 1 / (2 * root.sin() ** 2),
        "m1_over_m2": -(2 * root).cos(),
        "m2_over_m1": -1 / (2 * root).cos(),
    }
    inner = _decimal_ends(root, DIGITS)
    return {"half_angle": inner} | {name: _decimal_ends(value, DIGITS - 4) for name, value in values.items()}


def _decimal_ends(value: arb, digits: int) -> list[str]:
    scale = 10**digits
    low, high = ((one * scale).floor().unique_fmpz() for one in (value.lower(), value.upper()))
    return [str(Fraction(int(low), scale)), str(Fraction(int(high) + 1, scale))]


def band(share: Fraction, excess: Fraction) -> dict[str, Any] | None:
    """Follow a small box of shares and excesses from the ray; None where it is neither shown to merge nor to creep."""
    arithmetic = Ball(30)
    box = [share - WIDTH, share + WIDTH], [excess - WIDTH, excess + WIDTH]
    with arithmetic.context():
        r, w = (point(low).union(point(high)) for low, high in box)
        q, gap, slips = 1 - r, arb(0), []
        push = (w / q).sqrt()
        for _ in range(LONGEST):
            bracket = _bracket(gap, push)
            if bracket is None:
                return None
            theta = point(bracket[0]).union(point(bracket[1]))
            deep = depth_and_cotangent(theta)[0]
            w = w - q * r * deep * (deep + 2 * gap)
            gap, push = -(gap + deep), push - theta
            outcome = _outcome(q, gap, push, w)
            if outcome is None:
                return None
            slips.append([str(bracket[0]), str(bracket[1]), outcome])
            if outcome in ("merges", "creeps"):
                return {"share": [str(one) for one in box[0]], "excess": [str(one) for one in box[1]], "slips": slips}
            gap, push = (-(gap + 2 / q), -push) if outcome == "crosses" else (arb(0), (w / q).sqrt())
    return None


def _bracket(gap: arb, push: arb) -> tuple[Fraction, Fraction] | None:
    """Return two angles that the end of every slip in the box is proved to lie between."""
    middle = Fraction(str(round(float(contact(gap.mid().max(arb(0)), push.mid())[0].mid()), 9)))
    for exponent in range(20, 4, -1):
        width = Fraction(1, 2**exponent).limit_denominator(10**7)
        low, high = middle - width, middle + width
        lead = [_lead(point(end), gap, push) for end in (low, high)]
        if lead[0] < 0 and lead[1] > 0:
            return low, high
    return None


def _lead(theta: arb, gap: arb, push: arb) -> arb:
    return sine_deficit(theta) / versine(theta) - gap * (theta / 2).cot() - push


def _outcome(q: arb, gap: arb, push: arb, w: arb) -> str | None:
    position = 1 + q * gap
    if w < 0:
        return "merges"
    if position < -1:
        return "crosses"
    if not (position > -1 and position < 1 and w > 0):
        return None
    if w < q * (arb.pi() / 2 - 1) ** 2:
        return "creeps"
    return "opposite" if push < 0 else "same" if push > 0 else None


def certificate() -> dict[str, Any]:
    """Return the certificate as data."""
    with precision(DIGITS):
        bands = [found for share in SHARES for excess in EXCESSES if (found := band(share, excess))]
        return {
            "turning": cells(turning_kind, START, END),
            "constants": constants(),
            "surface": {"share": str(SHARE), "cells": cells(surface_kind, START, END)},
            "outcomes": {one: sum(band["slips"][-1][2] == one for band in bands) for one in ("merges", "creeps")},
            "bands": bands,
        }


def main() -> None:
    """Write the file, whole or not at all; one cell a line."""
    text = json.dumps(certificate(), separators=(",", ":"))
    for opening in ('"constants"', '"surface"', '"bands"', '{"share":["', '["'):
        text = text.replace(f",{opening}", f",\n{opening}")
    atomic.write(CERTIFICATE, text + "\n")
    print(CERTIFICATE.name)


if __name__ == "__main__":
    main()
