"""The error of every stable float64 formula, in units in the last place, by decades of its argument."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from random import Random
from typing import Any

import flint
from flint import arb

from numerics.audit.table import Progress, Row

MOST_ULP = 4.0
TRUTH_BITS = 300
_SETTLED_BITS = 100
"""The truth must have this many right bits; where its definition cancels, more than 300 working bits are spent."""
_MOST_BITS = 40_000
_DENSE = range(-3, 3)
"""Decades in which the formulas change shape, not only scale: they get more cases."""
_DENSER = 20

Arguments = tuple[float, ...]


@dataclass(frozen=True)
class Formula:
    """A float64 formula and, in balls, the definition it is held against; both take the same exact arguments.

    `spread` turns the leading argument, in [lowest, highest], into all of them. `cost` divides the number of cases.
    """

    name: str
    value: Callable[..., Any]
    truth: Callable[..., arb]
    lowest: float
    highest: float
    spread: Callable[[Random, float], Arguments] = lambda _, x: (x,)
    cost: int = 1

    @property
    def decades(self) -> range:
        """Return the decades d with arguments in [10^d, 10^(d+1))."""
        return range(math.floor(math.log10(self.lowest)), math.ceil(math.log10(self.highest)))

    def draw(self, random: Random, decade: int) -> Arguments:
        """Return arguments of one decade: half of them next to multiples of pi/2 from 1 on, where angles are worst."""
        while True:
            x = 10.0 ** (decade + random.random())
            if decade >= 0 and random.random() < 0.5:
                quarter = math.pi / 2
                x = max(1, round(x / quarter)) * quarter * (1 + random.choice((-1, 1)) * 2.0 ** -random.randint(2, 52))
            if self.lowest <= x <= self.highest:
                return self.spread(random, x)


def ulps(computed: float, truth: arb) -> float:
    """Return the error of a float in units in the last place of the true value; inf if it is not finite."""
    if not math.isfinite(computed):
        return math.inf
    mantissa, exponent = truth.mid().man_exp()
    place = int(abs(mantissa)).bit_length() + int(exponent) - 53
    return float(abs(arb(computed) - truth).upper() / arb(2) ** place)


def audit_formulas(formulas: Sequence[Formula], seed: int, cases: int, progress: Progress) -> Iterator[Row]:
    """Yield one row a formula; `cases` is the number of arguments in a decade."""
    for formula in formulas:
        yield _measured(formula, Random(f"{seed} {formula.name}"), max(4, cases // formula.cost), progress)


def _measured(formula: Formula, random: Random, cases: int, progress: Progress) -> Row:
    decades = []
    for decade in formula.decades:
        progress(f"error of {formula.name} at 1e{decade}")
        decades.append(_decade(formula, random, decade, cases))
    tried, worst = sum(one["tried"] for one in decades), max(decades, key=lambda one: float(one["max_ulp"]))
    mean = sum(one["mean_ulp"] * one["tried"] for one in decades) / tried
    measured = {"max ulp": worst["max_ulp"], "mean ulp": mean, "worst at": float(worst["worst_at"].split()[0])}
    required = f"max <= {MOST_ULP:g} ulp on [{formula.lowest:.3g}, {formula.highest:.3g}]"
    return Row("formulas", formula.name, tried, measured, required, worst["max_ulp"] <= MOST_ULP, decades)


def _decade(formula: Formula, random: Random, decade: int, cases: int) -> dict[str, Any]:
    tried = cases * _DENSER if decade in _DENSE else cases
    total = worst = 0.0
    where: Arguments = ()
    truth = _Truth(formula.truth)
    for _ in range(tried):
        arguments = formula.draw(random, decade)
        error = ulps(formula.value(*arguments), truth(arguments))
        total += error
        if not error <= worst or not where:
            worst, where = error, arguments
    shown = " ".join(f"{x:.17g}" for x in where)
    return {"decade": decade, "tried": tried, "max_ulp": worst, "mean_ulp": total / tried, "worst_at": shown}


class _Truth:
    """A definition evaluated in balls, from 300 bits up to as many as leave 100 right ones; it remembers how many."""

    def __init__(self, definition: Callable[..., arb]) -> None:
        self.definition, self.bits = definition, TRUTH_BITS

    def __call__(self, arguments: Arguments) -> arb:
        before = flint.ctx.prec
        try:
            while True:
                flint.ctx.prec = self.bits
                value = self.definition(*(arb(x) for x in arguments))
                if value.rel_accuracy_bits() >= _SETTLED_BITS:
                    return value
                if self.bits > _MOST_BITS:
                    raise ArithmeticError(f"the truth at {arguments} is not settled by {self.bits} bits")
                self.bits *= 2
        finally:
            flint.ctx.prec = before
