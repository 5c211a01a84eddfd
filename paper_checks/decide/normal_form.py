"""Whether an expression is 0, by a normal form: a fraction of polynomials in letters, reduced by their relations.

A letter stands for a symbol, a square root, the sine or cosine of an angle, or for anything else as a whole. All that is
used are the rules of a field, sqrt(x)^2 = x, sin^2 + cos^2 = 1, |x/y| = |x|/|y|, and sine and cosine of sums and
multiples of angles.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

import sympy as sp
from flint import fmpz_mpoly
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from theory.fraction import Fraction, letters_in, value, written

_CIRCULAR = (sp.sin, sp.cos, sp.tan, sp.cot)


@lru_cache(maxsize=1000)
def is_zero(expression: sp.Expr) -> bool:
    """Say whether the normal form is 0: then so is the expression, wherever it is defined. False decides nothing."""
    try:
        split = expression.replace(sp.Abs, _absolute)
        form = _Form(split)
        return form.vanishes(form.value(split).top, len(form.squares))
    except ZeroDivisionError:
        return False


def fraction(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator of the normal form, expanded, with whole coefficients.

    Raises ZeroDivisionError where the expression divides by 0.

    >>> x = sp.Symbol("x")
    >>> fraction((x**2 - 1) / (x - 1) + sp.sin(3 * x) / 2)
    (2*x + sin(3*x) + 2, 2)
    """
    form = _Form(expression)
    top, bottom = form.value(expression)
    return written(top, form.letters), written(bottom, form.letters)


def _absolute(inside: sp.Expr) -> sp.Expr:
    top, bottom = fraction(inside)
    return sp.Abs(top) / sp.Abs(bottom)


class _Form:
    """The letters of an expression, and its value in them."""

    def __init__(self, expression: sp.Expr) -> None:
        """Find the letters; those that a square root is made of come before it."""
        self.units = _units(expression)
        names = list(dict.fromkeys(self._letters(expression)))
        self.letters = [self._written(kind, part) for kind, part in names]
        self.context = letters_in(len(names))
        self.one, self.zero = self._constant(1), self._constant(0)
        self.place = {name: n for n, name in enumerate(names)}
        self.squares: list[tuple[int, Fraction]] = []
        """Letters, by their places, whose squares are fractions of the letters before them."""
        for kind, part in names:
            if kind == "root":
                self.squares.append((self.place[kind, part], self.value(part)))
            elif kind == "sine":
                cosine = self._letter("cosine", part)
                self.squares.append((self.place[kind, part], self.one + -(cosine * cosine)))

    def value(self, part: sp.Expr) -> Fraction:
        """Return an expression as a fraction. Raises ZeroDivisionError where it divides by 0."""
        return value(part, self.context, self._of)

    def _of(self, part: sp.Expr) -> Fraction:
        if _is_root(part):
            return self._letter("root", part.base) ** int(part.exp.p)
        if isinstance(part, _CIRCULAR):
            cosine, sine = self._turned(part.args[0])
            quotients = {
                sp.sin: (sine, self.one),
                sp.cos: (cosine, self.one),
                sp.tan: (sine, cosine),
                sp.cot: (cosine, sine),
            }
            top, bottom = quotients[part.func]
            return top * bottom**-1
        return self._letter("whole", part)

    def vanishes(self, polynomial: fmpz_mpoly, relations: int) -> bool:
        """Say whether a polynomial is 0 by the first of the relations; the last letter's even and odd powers part."""
        if polynomial == 0 or not relations:
            return bool(polynomial == 0)
        place, square = self.squares[relations - 1]
        powers: tuple[dict[int, Any], dict[int, Any]] = (defaultdict(dict), defaultdict(dict))
        for exponents, coefficient in polynomial.to_dict().items():
            half, odd = divmod(exponents[place], 2)
            powers[odd][half][(*exponents[:place], 0, *exponents[place + 1 :])] = coefficient
        for of_one_parity in powers:
            highest = max(of_one_parity, default=0)
            total = self.context.constant(0)
            for half, terms in of_one_parity.items():
                total += self.context.from_dict(terms) * square.top**half * square.bottom ** (highest - half)
            if not self.vanishes(total, relations - 1):
                return False
        return True

    def _letters(self, part: sp.Expr) -> Iterator[tuple[str, sp.Expr]]:
        if part.is_Rational:
            return
        if part.is_Add or part.is_Mul or (part.is_Pow and part.exp.is_Integer):
            for one in part.args:
                yield from self._letters(one)
        elif _is_root(part):
            yield from self._letters(part.base)
            yield "root", part.base
        elif isinstance(part, _CIRCULAR):
            for _, rest in _terms(part.args[0]):
                yield "cosine", rest
                yield "sine", rest
        else:
            yield "whole", part

    def _turned(self, angle: sp.Expr) -> tuple[Fraction, Fraction]:
        """Return cosine and sine of an angle, a sum of whole multiples of units."""
        cosine, sine = self.one, self.zero
        for factor, rest in _terms(angle):
            times = factor / self.units[rest]
            along, across = self._letter("cosine", rest), self._letter("sine", rest)
            across = across if times > 0 else -across
            for _ in range(abs(int(times))):
                cosine, sine = cosine * along + -(sine * across), cosine * across + sine * along
        return cosine, sine

    def _letter(self, kind: str, part: sp.Expr) -> Fraction:
        return Fraction(self.context.gen(self.place[kind, part]), self.context.constant(1))

    def _written(self, kind: str, part: sp.Expr) -> sp.Expr:
        if kind == "root":
            return sp.sqrt(part)
        return part if kind == "whole" else {"sine": sp.sin, "cosine": sp.cos}[kind](self.units[part] * part)

    def _constant(self, whole: int) -> Fraction:
        return Fraction(self.context.constant(whole), self.context.constant(1))


def _is_root(part: sp.Expr) -> bool:
    return bool(part.is_Pow and part.exp.is_Rational and part.exp.q == 2)


def _terms(angle: sp.Expr) -> list[tuple[sp.Rational, sp.Expr]]:
    """Return an angle as a sum of rational multiples."""
    return [one.as_coeff_Mul(rational=True) for one in sp.Add.make_args(angle)]


def _units(expression: sp.Expr) -> dict[sp.Expr, sp.Rational]:
    """Return by angle the largest rational of which all its factors in the expression are whole multiples."""
    factors = defaultdict(list)
    for function in expression.atoms(TrigonometricFunction):
        for factor, rest in _terms(function.args[0]):
            factors[rest].append(factor)
    return {
        rest: sp.Rational(math.gcd(*(int(one.p) for one in all)), math.lcm(*(int(one.q) for one in all)))
        for rest, all in factors.items()
    }
