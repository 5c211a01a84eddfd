"""Exact decimals: the only way a number enters a scene.

`0.005` means 1/200 here, not the nearest binary64 number. That difference decides whether a pair at rest on the
edge of the sliding region sticks for ever. The grammar and the limits are checked on the text, before anything
is converted, so a hostile exponent costs nothing.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Collection, Iterable, Mapping, Sequence, Set
from decimal import Context, Decimal, Inexact
from fractions import Fraction
from numbers import Rational, Real
from typing import TYPE_CHECKING, Any, TypeAlias

from numerics.errors import InvalidScene

Exact = int | float | str | Decimal | Rational
"""What can be read as an exact decimal."""
if TYPE_CHECKING:
    from flint import arb
    from mpmath import mpf
    from numpy.typing import ArrayLike

    Quantity: TypeAlias = "float | mpf | arb"
    """A number of a result: a float, or where more digits were asked for a ball, or what mpmath has."""
    Exacts: TypeAlias = Exact | ArrayLike | Sequence[object]
    """One number or several."""
    Times: TypeAlias = Exacts | Quantity
    """One time or several, s."""

MAX_EXPONENT = 1000
MAX_CHARACTERS = 1000
_TOO_LONG = 10 ** (MAX_EXPONENT + MAX_CHARACTERS)
_WIDE = Context(prec=2 * (MAX_EXPONENT + MAX_CHARACTERS), traps=[Inexact])
_SIX_DIGITS = Context(prec=6)
_DECIMAL = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE]([+-]?[0-9]+))?", re.ASCII)


def exact_decimal(value: object, name: str) -> Fraction:
    """Return `value` as the exact rational number that its decimal text denotes.

    Accepts int (NumPy's too), Fraction, Decimal, decimal text, a ratio of two such as "1/3", and float (read as its
    shortest decimal text, so 0.005 is 1/200).
    Raises InvalidScene naming the quantity `name` for anything else: bool, nan, inf, other text, exponents beyond
    +-1000, texts longer than 1000 characters, and exact numbers that take more than 2000 digits to write.

    >>> exact_decimal("0.005", "x1"), exact_decimal(0.005, "x1"), exact_decimal("-1e-3", "x1")
    (Fraction(1, 200), Fraction(1, 200), Fraction(-1, 1000))
    """
    if getattr(value, "shape", None) == ():  # of NumPy
        value = as_printed(value).item()
    if type(value) is Fraction:  # itself: scenes that share a number can be told to
        return _checked_size(value, name)
    if isinstance(value, str):
        return _from_ratio(value.strip(), name)
    if isinstance(value, Decimal):
        return _from_text(str(value), name)
    if not isinstance(value, bool):
        if isinstance(value, Rational):  # NumPy's whole numbers too
            return _checked_size(Fraction(int(value.numerator), int(value.denominator)), name)
        if isinstance(value, Real):
            return _from_text(repr(float(value)), name)
    remedy = "give one number (solve_many takes arrays)" if isinstance(value, Iterable) else "write it as 0.05 or 5e-2"
    raise InvalidScene(f"{name} must be a decimal number, not {shown(value)}; {remedy}")


def as_printed(given: Any) -> Any:
    """Return short floats of NumPy, which print fewer digits than those of 64 bits, as the texts that they print."""
    return given.astype(str) if getattr(given, "dtype", None) in ("float16", "float32") else given


def positive(value: object, name: str, remedy: str = "") -> Fraction:
    """Return an exact number > 0; raises InvalidScene, with what to do instead."""
    found = exact_decimal(value, name)
    if found <= 0:
        raise InvalidScene(f"{name} = {short(found)} must be > 0; {remedy or f'give a positive {name}'}")
    return found


def nonnegative(value: object, name: str, remedy: str = "") -> Fraction:
    """Return an exact number >= 0; raises InvalidScene, with what to do instead."""
    found = exact_decimal(value, name)
    if found < 0:
        raise InvalidScene(f"{name} = {short(found)} must be >= 0; {remedy or f'give 0 or a positive {name}'}")
    return found


def keep(record: object, **values: Exact) -> None:
    """Store values in a frozen record, as exact rationals."""
    put(record, **{name: exact_decimal(value, name) for name, value in values.items()})


def put(record: object, **values: Any) -> None:
    """Store values in a frozen record."""
    for name, value in values.items():
        object.__setattr__(record, name, value)


def short(value: Fraction) -> str:
    """Return a rational for an error message, to six digits, also one that no float holds.

    >>> short(Fraction(-1, 200)), short(Fraction(10) ** 400 / 3)
    ('-0.005', '3.33333e+399')
    """
    found = _SIX_DIGITS.divide(Decimal(value.numerator), Decimal(value.denominator))
    return f"{float(found):g}" if abs(found.adjusted()) < 308 else f"{found.normalize():e}"


def decimal_text(value: Fraction) -> str:
    """Return a rational as text that `exact_decimal` reads as the same number: a decimal if it has one, else a ratio.

    >>> decimal_text(Fraction(1, 200)), decimal_text(Fraction(50, 3)), decimal_text(Fraction(-1, 10**30))
    ('0.005', '50/3', '-1e-30')
    """
    try:
        found = _WIDE.divide(Decimal(value.numerator), Decimal(value.denominator))
        return f"{found:f}" if abs(found.adjusted()) < 15 else f"{found.normalize(_WIDE):e}"
    except Inexact:
        return f"{value.numerator}/{value.denominator}"


MOST_DIGITS = 1_000_000
"""Working digits that may be asked for: one number takes half a megabyte."""


def require_whole(name: str, value: Any, least: int, most: int = 2**62) -> None:
    """Raise ValueError, naming the argument, unless it is a whole number from `least` to `most`."""
    is_whole = hasattr(value, "__index__") and not isinstance(value, bool)
    if not (is_whole and least <= operator.index(value) <= most):
        bound = "2^62" if most == 2**62 else str(most)
        raise ValueError(f"{name} = {shown(value)} must be a whole number from {least} to {bound}; give one")


def require_digits(digits: Any, max_digits: Any = None, **caps: Any) -> None:
    """Raise ValueError, naming the argument, unless the digits, and every cap that is given, are whole numbers > 0."""
    require_whole("digits", digits, 1, MOST_DIGITS)
    require_whole("max_digits", 1 if max_digits is None else max_digits, 1, MOST_DIGITS)
    for name, cap in caps.items():
        require_whole(name, 1 if cap is None else cap, 1)


def listed(name: str, values: Any, of: str = "") -> Iterable[Any]:
    """Return what an argument lists; raises InvalidScene for a number, a text, and what has no order or two columns."""
    if isinstance(values, str | Mapping | Set) or not isinstance(values, Iterable):
        raise InvalidScene(f"{name} = {shown(values)} must be a list{of}; write [...], also around one")
    return values


def require_one_of(name: str, value: Any, known: Collection[str], error: type[ValueError] = ValueError) -> None:
    """Raise an error, naming the argument, unless it is one of some words."""
    if not isinstance(value, str) or value not in known:
        raise error(f"{name} = {shown(value)} is not one of {', '.join(known)}; choose one")


def require_function(name: str, value: Any, of: str) -> None:
    """Raise TypeError, naming the argument, unless it can be called."""
    if not callable(value):
        raise TypeError(f"{name} = {shown(value)} must be a function of {of}; leave it out for none")


def _from_ratio(text: str, name: str) -> Fraction:
    """Return the number of a decimal text, or of a ratio of two such as "50/3"."""
    above, slash, below = text.partition("/")
    if not slash:
        return _from_text(text, name)
    divisor = _from_text(below.strip(), name)
    if divisor == 0:
        raise InvalidScene(f"{name} = {shown(text)} divides by 0; write a number such as 50/3")
    return _checked_size(_from_text(above.strip(), name) / divisor, name)


def _from_text(text: str, name: str) -> Fraction:
    if len(text) > MAX_CHARACTERS:
        raise InvalidScene(f"{name} has {len(text)} characters; at most {MAX_CHARACTERS} are read; round it")
    match = _DECIMAL.fullmatch(text)
    if match is None:
        raise InvalidScene(f"{name} must be a finite decimal number, not {shown(text)}; write 0.05 or 5e-2")
    exponent = match.group(1) or "0"
    if len(exponent) > 6 or abs(int(exponent)) > MAX_EXPONENT:
        raise InvalidScene(
            f"{name} = {shown(text)} has an exponent beyond +-{MAX_EXPONENT}; choose units that bring it into range"
        )
    return _checked_size(Fraction(text), name)


def _checked_size(value: Fraction, name: str) -> Fraction:
    if max(abs(value.numerator), value.denominator) >= _TOO_LONG:
        raise InvalidScene(
            f"{name} needs more than {MAX_EXPONENT + MAX_CHARACTERS} digits to write down; "
            "round it, or choose units that bring it into range"
        )
    return value


def shown(value: object) -> str:
    """Return a value as text that is safe on one line of an error message."""
    try:
        text = str(value) if isinstance(value, Fraction) else repr(value)
    except ValueError:  # an array that holds an int beyond Python's limit on decimal text
        text = f"<long {type(value).__name__}>"
    text = " ".join(text.split())
    return text if len(text) <= 40 else f"{text[:36]}...{text[-1]}"  # with the quote, or bracket, that closes it
