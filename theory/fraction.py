"""Rational expressions as quotients of polynomials without a common factor: exact, much quicker than sympy's `cancel`.

Sympy expands whole numerators and denominators before it looks for common factors; here every sum and product on the
way is reduced at once, with polynomials of python-flint.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

from flint import fmpz_mpoly, fmpz_mpoly_ctx
from sympy import Add, Expr, Integer, Mul, Pow, Rational


class Fraction(NamedTuple):
    """A fraction of two polynomials with whole coefficients."""

    top: fmpz_mpoly
    bottom: fmpz_mpoly

    def __add__(self, other: Any) -> "Fraction":
        """The sum, over the least common denominator."""
        mine, theirs = lowest(self.bottom, other.bottom)
        return lowest(self.top * theirs + other.top * mine, self.bottom * theirs)

    def __mul__(self, other: Any) -> "Fraction":
        """The product; what one has above and the other below is left out."""
        left, right = lowest(self.top, other.bottom), lowest(other.top, self.bottom)
        return Fraction(left.top * right.top, left.bottom * right.bottom)

    def __neg__(self) -> "Fraction":
        """The fraction with its sign turned."""
        return Fraction(-self.top, self.bottom)

    def __pow__(self, exponent: int) -> "Fraction":
        """A whole power. Raises ZeroDivisionError where the fraction is 0 and the exponent negative."""
        if exponent >= 0:
            return Fraction(self.top**exponent, self.bottom**exponent)
        if self.top == 0:
            raise ZeroDivisionError("0 has no inverse")
        return Fraction(self.bottom**-exponent, self.top**-exponent)


def lowest(top: fmpz_mpoly, bottom: fmpz_mpoly) -> Fraction:
    """The fraction of two polynomials without their common factor."""
    common = top.gcd(bottom)
    return Fraction(top, bottom) if common == 1 else Fraction(top / common, bottom / common)


def letters_in(number: int) -> fmpz_mpoly_ctx:
    """The polynomials in so many letters."""
    return fmpz_mpoly_ctx.get([f"l{n}" for n in range(max(1, number))])


def value(part: Expr, context: fmpz_mpoly_ctx, letter: Callable[[Expr], Fraction]) -> Fraction:
    """An expression as a fraction; `letter` is that of what is no sum, product or whole power.

    Raises ZeroDivisionError where it divides by 0.
    """
    if part.is_Rational:
        return Fraction(context.constant(int(part.p)), context.constant(int(part.q)))
    if part.is_Add or part.is_Mul:
        total, *others = (value(one, context, letter) for one in part.args)
        for other in others:
            total = total + other if part.is_Add else total * other
        return total
    if part.is_Pow and part.exp.is_Integer:
        return value(part.base, context, letter) ** int(part.exp)
    return letter(part)


def written(polynomial: fmpz_mpoly, letters: Sequence[Expr]) -> Expr:
    """A polynomial as an expression in these letters."""
    terms = polynomial.to_dict().items()
    return Add(*(Mul(Integer(int(factor)), *map(Pow, letters, powers)) for powers, factor in terms))


@cache
def in_lowest_terms(expression: Expr) -> Expr:
    """The expression as `cancel` writes it, a quotient of expanded polynomials; exact.

    Its letters are what is no sum, product or whole power: symbols, roots, sines. Nothing is known of these but that
    each is another one. Raises ZeroDivisionError where the expression divides by 0.
    """
    (top, bottom), letters = _reduced(expression)
    return written(top, letters) / written(bottom, letters)


@cache
def factored(expression: Expr) -> Expr:
    """The expression in lowest terms, numerator and denominator as products; exact."""
    (top, bottom), letters = _reduced(expression)
    (above, parts), (below, others) = top.factor(), bottom.factor()
    powers = [*parts, *((part, -power) for part, power in others)]
    return Mul(Rational(int(above), int(below)), *(written(part, letters) ** power for part, power in powers))


def _reduced(expression: Expr) -> tuple[Fraction, Sequence[Expr]]:
    """The fraction, with a denominator that begins with a positive term, and its letters."""
    letters = sorted(set(_letters(expression)), key=str)
    context = letters_in(len(letters))
    letter = dict(zip(letters, context.gens(), strict=False))
    one = context.constant(1)

    def power_of_letter(part: Expr) -> Fraction:
        return Fraction(letter[_root(part)], one) ** (int(part.exp.p) if part.is_Pow and part.exp.is_Rational else 1)

    found = value(expression, context, power_of_letter)
    if found.bottom.leading_coefficient() < 0:
        found = Fraction(-found.top, -found.bottom)
    return found, letters


def _letters(part: Expr) -> Iterator[Expr]:
    if part.is_Add or part.is_Mul:
        for one in part.args:
            yield from _letters(one)
    elif part.is_Pow and part.exp.is_Integer:
        yield from _letters(part.base)
    elif not part.is_Rational:
        yield _root(part)


def _root(part: Expr) -> Expr:
    """The root of which a fractional power is a whole one; anything else itself."""
    return part.base ** Rational(1, part.exp.q) if part.is_Pow and part.exp.is_Rational else part
