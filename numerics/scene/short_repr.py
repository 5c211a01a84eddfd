"""One short line for every record that somebody looks at: exact numbers as decimals, others to six digits."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from enum import Enum
from fractions import Fraction
from html import escape
from inspect import signature
from typing import Any, TypeVar, dataclass_transform

from numerics.habits import Helpful
from numerics.scene.decimals import decimal_text, short

_LONGEST = 60
"""Characters of one value; tuples of more than four show two."""
_Record = TypeVar("_Record")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(kind: type[_Record]) -> type[_Record]:
    """Return a class as a frozen dataclass, which may read its parts itself, with the repr that it inherits."""
    return dataclass(frozen=True, slots=True, repr=False)(kind)


class ShortRepr(Helpful):
    """Gives a dataclass a repr of one short line: fields that have their default value are left out.

    >>> from numerics import Pair, State
    >>> Pair(m1=1, m2="1/3", a2=200, b="0.05"), State(v1=0.15)
    (Pair(m1=1, m2='1/3', a2=200, b=0.05), State(v1=0.15))
    """

    __slots__ = ()

    def __repr__(self) -> str:
        """Return the record as it would be built, but for what is too long."""
        shown = (f"{name}={shortly(value)}" for name, value in self._shown_fields())
        return f"{type(self).__name__}({', '.join(shown)})"

    def _repr_html_(self) -> str:
        """Return the record as a table of a notebook."""
        return html_table(type(self).__name__, ((name, shortly(value)) for name, value in self._shown_fields()))

    def _shown_fields(self) -> list[tuple[str, Any]]:
        defaults = {name: one.default for name, one in signature(type(self)).parameters.items()}
        shown = [one.name for one in fields(self) if one.repr]  # type: ignore[arg-type]
        values = [(name, getattr(self, name)) for name in shown]
        return [(name, one) for name, one in values if not _is(one, defaults.get(name))]


def _is(value: Any, default: Any) -> bool:
    """Return whether a value is the default one; arrays and balls are none."""
    return value is default or bool(isinstance(value, str | Fraction | Enum | tuple | ShortRepr) and value == default)


def html_table(caption: str, rows: Iterable[tuple[str, object]]) -> str:
    """Return names and values as a table in HTML.

    >>> html_table("Pair", [("m1", 1)])
    '<table><caption>Pair</caption><tr><th>m1</th><td>1</td></tr></table>'
    """
    lines = (f"<tr><th>{escape(name)}</th><td>{escape(str(value))}</td></tr>" for name, value in rows)
    return f"<table><caption>{escape(caption)}</caption>{''.join(lines)}</table>"


def shortly(value: Any) -> str:
    """Return a value in a few characters.

    >>> shortly(Fraction(1, 3)), shortly(Fraction(1, 7**40)), shortly((1, 2.5, 3, 4, 5)), shortly(1 / 3)
    ("'1/3'", '1.57065e-34', '(1, 2.5, ... 5 in all)', '0.333333')
    """
    if isinstance(value, Fraction):
        text = decimal_text(value)
        return (f"'{text}'" if "/" in text else text) if len(text) <= 24 else short(value)
    if isinstance(value, Enum):
        text = str(value.value)
        return f"'{text}'" if len(text) < 20 else value.name
    if isinstance(value, tuple | list):
        parts = [shortly(one) for one in (value if len(value) <= 4 else value[:2])]
        more = f", ... {len(value)} in all" if len(value) > 4 else "," if len(value) == 1 else ""
        return f"({', '.join(parts)}{more})"
    if hasattr(value, "dtype"):
        return f"array of shape {value.shape}" if value.shape else shortly(value.item())
    if hasattr(value, "rel_accuracy_bits"):  # a ball, real or complex
        return str(value.str(6, radius=False))
    text = f"{float(value):.6g}" if hasattr(value, "__float__") and not isinstance(value, int) else repr(value)
    cut = f"{type(value).__name__}(...)" if isinstance(value, ShortRepr) else f"{text[: _LONGEST - 3]}..."
    return text if len(text) <= _LONGEST else cut
