"""The operators of double-double numbers in compiled code: numba's own leave named tuples alone, or join them."""

from __future__ import annotations

import operator
from functools import cache
from typing import Any

from numerics.arithmetic.double_double import Double, add, divide, negative, product, scaled, subtract, times
from numerics.arithmetic.telling import compiled_word


@cache
def declare_operators() -> None:
    """Tell numba what + - * / and the negative of these numbers are, with whole numbers too."""
    from numba import types
    from numba.extending import overload

    plus, minus, multiply, over, turned, whole, exact = (
        compiled_word(one) for one in (add, subtract, product, divide, negative, times, scaled)
    )

    def is_double(kind: Any) -> bool:
        return isinstance(kind, types.NamedUniTuple) and kind.instance_class is Double

    def is_whole(kind: Any) -> bool:
        return isinstance(kind, (types.Integer, types.IntegerLiteral))

    def declare(function: Any, both: Any) -> None:
        """Declare a binary operator: of two of these numbers, or of one and a whole number."""

        @overload(function, prefer_literal=True)
        def _implementation(a, b):  # type: ignore[no-untyped-def]
            if is_double(a) and is_double(b):
                return lambda a, b: both(a, b)  # noqa: PLW0108 - numba wants these names
            if is_double(a) and is_whole(b):
                return lambda a, b: both(a, Double(float(b), 0.0))
            if is_whole(a) and is_double(b):
                return lambda a, b: both(Double(float(a), 0.0), b)
            return None

    declare(operator.add, plus)
    declare(operator.sub, minus)

    @overload(operator.mul, prefer_literal=True)
    def _times(a, b):  # type: ignore[no-untyped-def]
        if is_double(a) and is_double(b):
            return lambda a, b: multiply(a, b)  # noqa: PLW0108
        if is_whole(a) and is_double(b):
            if _is_power_of_two(a):
                return lambda a, b: exact(b, float(a))
            return lambda a, b: whole(b, float(a))
        if is_double(a) and is_whole(b):
            return lambda a, b: whole(a, float(b))
        return None

    @overload(operator.truediv, prefer_literal=True)
    def _over(a, b):  # type: ignore[no-untyped-def]
        if is_double(a) and is_double(b):
            return lambda a, b: over(a, b)  # noqa: PLW0108
        if is_double(a) and is_whole(b):
            if _is_power_of_two(b):
                return lambda a, b: exact(a, 1.0 / float(b))
            return lambda a, b: over(a, Double(float(b), 0.0))
        if is_whole(a) and is_double(b):
            return lambda a, b: over(Double(float(a), 0.0), b)
        return None

    @overload(operator.neg)
    def _negative(a):  # type: ignore[no-untyped-def]
        return (lambda a: turned(a)) if is_double(a) else None  # noqa: PLW0108


def _is_power_of_two(kind: Any) -> bool:
    """Return whether a type stands for a power of two written in the text: then the product is exact."""
    value = getattr(kind, "literal_value", 0)
    return isinstance(value, int) and value > 0 and value & (value - 1) == 0
