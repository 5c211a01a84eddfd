"""The elementary functions of arithmetic/, each beside its definition in balls, over all decades of the argument.

In binary64 and double-double the relative error is counted in units of 2^-52 and 2^-103. In balls the enclosure over a
ball of few digits must contain the value at any point of it: a failure counts as an infinite error.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import Any, NamedTuple

from flint import arb

from numerics.arithmetic import functions
from numerics.arithmetic.ball import precision
from numerics.arithmetic.pair import Pair, as_pair
from numerics.audit.rows import Progress, Row
from numerics.errors import NumericsError

ARITHMETICS = {"binary64": 4.0, "double-double": 8.0, "ball": 0.0}
"""By name: how many units an error may have."""
_TRUTH_BITS = 3000
"""The definitions lose up to 1,300 of them to cancellation."""


class Formula(NamedTuple):
    """A function of one number and its definition in balls, from 10^lowest to 10^highest, where its value is normal."""

    name: str
    value: Callable[[Any], Any]
    truth: Callable[[arb], arb]
    lowest: float
    highest: float

    def draw(self, random: Random) -> float:
        """Return an argument: half of them where formulas change shape, many next to multiples of pi/2."""
        low, high = random.choice(((self.lowest, self.highest), (-3, min(3, self.highest))))
        x: float = 10.0 ** random.uniform(low, high)
        if x >= 1 and random.random() < 0.5:
            x = round(x / (math.pi / 2)) * (math.pi / 2) * (1 + random.choice((-1, 1)) * 2.0 ** -random.randint(2, 52))
        return x if 0 < x <= 10.0**self.highest else self.draw(random)


FORMULAS = (
    Formula("sqrt x", functions.sqrt, lambda x: x.sqrt(), -250, 250),
    Formula("sin x", functions.sin, lambda x: x.sin(), -250, 9),
    Formula("cos x", lambda x: functions.sine_cosine(x)[1], lambda x: x.cos(), -250, 9),
    Formula("atan2(x, 1)", lambda x: functions.atan2(x, functions.like(x, 1.0)), lambda x: x.atan(), -200, 200),
    Formula("versine: 1 - cos x", functions.versine, lambda x: 1 - x.cos(), -120, 9),
    Formula("sine deficit: x - sin x", functions.sine_deficit, lambda x: x - x.sin(), -80, 9),
    Formula("cosine deficit", functions.cosine_deficit, lambda x: x * x / 2 - 1 + x.cos(), -60, 9),
    Formula(
        "depth: 2 - x cot(x/2)",
        lambda x: functions.depth_and_cotangent(x)[0],
        lambda x: 2 - x * (x / 2).cot(),
        -120,
        math.log10(5),
    ),
)


def audit_formulas(seed: int, cases: int, progress: Progress, tried: Sequence[Formula] = FORMULAS) -> Iterator[Row]:
    """Yield a row for each formula and arithmetic, `cases` arguments each."""
    for formula in tried:
        for arithmetic, most in ARITHMETICS.items():
            progress(f"error of {formula.name}, {arithmetic}")
            random = Random(f"{seed} {formula.name}")
            points = [formula.draw(random) for _ in range(cases)]
            worst, where = max((_error(formula, arithmetic, random, x), x) for x in points)
            found = {"max units": worst, "worst at": repr(where)}
            yield Row("formulas", f"{formula.name}, {arithmetic}", cases, found, f"max <= {most:g}", worst <= most)


def _error(formula: Formula, arithmetic: str, random: Random, x: float) -> float:
    """Return the relative error in units; inf for what is no number, or an enclosure without the value at a point."""
    argument: Any = x
    if arithmetic == "double-double":
        argument = as_pair(x) + x * random.uniform(-1, 1) * 2.0**-54
    with precision(_TRUTH_BITS):
        exact = _sum(argument)
        truth = formula.truth(exact)
    if arithmetic == "ball":
        with precision(random.randint(40, 200)):
            radius = arb(x) * arb(10) ** -random.randint(2, 50) * random.randint(0, 1)
            around = exact + radius * (arb(random.uniform(-0.9, 0.9)) + arb(0, 1))
            try:
                enclosure = formula.value(around)
            except NumericsError:  # no value over a wide ball
                return math.inf if around.is_exact() else 0.0
        holds = enclosure.overlaps(truth) if enclosure.is_finite() else not around.is_exact()
        return 0.0 if holds else math.inf
    value = formula.value(argument)
    with precision(_TRUTH_BITS):
        error = abs((_sum(value) - truth) / truth).upper()
    return float(error * 2 ** (52 if arithmetic == "binary64" else 103)) if error.is_finite() else math.inf


def _sum(value: float | Pair) -> arb:
    return arb(value.high) + arb(value.low) if isinstance(value, Pair) else arb(value)
