"""The elementary functions of arithmetic/, each beside its definition in balls, by decades of the argument.

In binary64 and double-double the error is counted in units in the last place. In balls the enclosure over a ball of few
digits must contain the value at any point of it: a failure counts as an infinite error.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random
from typing import Any

from flint import arb

from numerics.arithmetic import functions
from numerics.arithmetic.ball import precision
from numerics.arithmetic.pair import Pair, as_pair
from numerics.audit.table import Progress, Row
from numerics.errors import NumericsError

ARITHMETICS = {"binary64": (53, 4.0), "double-double": (104, 8.0), "ball": (53, 0.0)}
"""By name: the bits of a unit in the last place, and how many such units an error may have."""
_TRUTH_BITS, _SETTLED_BITS, _MOST_BITS = 600, 200, 40_000
_DENSE, _DENSER = range(-3, 3), 10
"""Decades in which the formulas change shape, not only scale, get so many times the cases."""


@dataclass(frozen=True)
class Formula:
    """A function of one number and its definition in balls, for lowest <= x <= highest, where its value is normal."""

    name: str
    value: Callable[[Any], Any]
    truth: Callable[[arb], arb]
    lowest: float
    highest: float

    def draw(self, random: Random, decade: int) -> float:
        """Return an argument of one decade: half of them next to multiples of pi/2 from 1 on."""
        while True:
            x: float = 10.0 ** (decade + random.random())
            quarter = math.pi / 2
            if decade >= 0 and random.random() < 0.5:
                x = max(1, round(x / quarter)) * quarter * (1 + random.choice((-1, 1)) * 2.0 ** -random.randint(2, 52))
            if self.lowest <= x <= self.highest:
                return x

    def exactly(self, x: arb) -> arb:
        """Return the truth at an exact point; where the definition cancels, more bits are spent."""
        bits = _TRUTH_BITS
        while bits <= _MOST_BITS:
            with precision(bits):
                found = self.truth(x)
            if found.rel_accuracy_bits() >= _SETTLED_BITS:
                return found
            bits *= 2
        raise ArithmeticError(f"{self.name} at {x} is not settled by {bits} bits")


FORMULAS = (
    Formula("sqrt x", functions.sqrt, lambda x: x.sqrt(), 1e-250, 1e250),
    Formula("sin x", functions.sin, lambda x: x.sin(), 1e-250, 1e9),
    Formula("cos x", lambda x: functions.sine_cosine(x)[1], lambda x: x.cos(), 1e-250, 1e9),
    Formula("atan2(x, 1)", lambda x: functions.atan2(x, functions.like(x, 1.0)), lambda x: x.atan(), 1e-200, 1e200),
    Formula("versine: 1 - cos x", functions.versine, lambda x: 1 - x.cos(), 1e-120, 1e9),
    Formula("sine deficit: x - sin x", functions.sine_deficit, lambda x: x - x.sin(), 1e-80, 1e9),
    Formula("cosine deficit", functions.cosine_deficit, lambda x: x * x / 2 - 1 + x.cos(), 1e-60, 1e9),
    Formula(
        "depth: 2 - x cot(x/2)",
        lambda x: functions.depth_and_cotangent(x)[0],
        lambda x: 2 - x * (x / 2).cot(),
        1e-120,
        5,
    ),
)


def audit_formulas(seed: int, cases: int, progress: Progress, tried: tuple[Formula, ...] = FORMULAS) -> Iterator[Row]:
    """Yield a row for each formula and arithmetic, `cases` arguments in each decade."""
    for formula in tried:
        for arithmetic, (_, most) in ARITHMETICS.items():
            random, decades = Random(f"{seed} {formula.name}"), list[dict[str, Any]]()
            for decade in range(math.floor(math.log10(formula.lowest)), math.ceil(math.log10(formula.highest))):
                progress(f"error of {formula.name} at 1e{decade}")
                points = [formula.draw(random, decade) for _ in range(cases * (_DENSER if decade in _DENSE else 1))]
                errors = [_error(formula, arithmetic, random, x) for x in points]
                worst, mean = max(errors), sum(errors) / len(errors)
                figures = {"max ulp": worst, "mean ulp": mean, "worst at": repr(points[errors.index(worst)])}
                decades.append({"decade": decade, "tried": len(points), **figures})
            largest, total = max(decades, key=lambda one: one["max ulp"]), sum(one["tried"] for one in decades)
            measured = {name: largest[name] for name in ("max ulp", "worst at")}
            passed, required = largest["max ulp"] <= most, f"max <= {most:g} ulp"
            yield Row("formulas", f"{formula.name}, {arithmetic}", total, measured, required, passed, decades)


def _error(formula: Formula, arithmetic: str, random: Random, x: float) -> float:
    """Return the error in units in the last place of the true value; inf for what is not a number."""
    bits, _ = ARITHMETICS[arithmetic]
    if arithmetic == "ball":
        return _escaped(formula, random, x)
    argument = as_pair(x) + x * random.uniform(-1, 1) * 2.0**-54 if arithmetic == "double-double" else x
    value = formula.value(argument)
    if not math.isfinite(functions.as_float(value)):
        return math.inf
    truth = formula.exactly(_sum(argument))
    with precision(_TRUTH_BITS):
        mantissa, exponent = truth.mid().man_exp()
        place = int(abs(mantissa)).bit_length() + int(exponent) - bits
        return float(abs(_sum(value) - truth).upper() / arb(2) ** place)


def _sum(value: float | Pair) -> arb:
    with precision(_TRUTH_BITS):
        return arb(value.high) + arb(value.low) if isinstance(value, Pair) else arb(value)


def _escaped(formula: Formula, random: Random, x: float) -> float:
    """Return inf if the value at a point is not in the enclosure over a ball around it, or a point has none; else 0."""
    with precision(random.randint(40, 200)):
        radius = arb(x) * arb(10) ** -random.randint(2, 50) * random.randint(0, 1)
        argument = arb(x) + radius * (arb(random.uniform(-0.9, 0.9)) + arb(0, 1))
        try:
            enclosure = formula.value(argument)
        except NumericsError:
            return math.inf if argument.is_exact() else 0.0
        settled = enclosure.is_finite() or not argument.is_exact()
    return 0.0 if settled and (not enclosure.is_finite() or enclosure.overlaps(formula.exactly(arb(x)))) else math.inf
