"""Faults to plant in theory, in the steps of an argument or in what is printed: each takes the original."""

import importlib
import itertools
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import sympy as sp

from paper_checks.claims import SUBJECTS
from paper_checks.claims.section_5 import points
from paper_checks.decide.polynomial import RELATIONAL
from theory import symbols

HOMES = {name.rpartition(".")[2]: name for name in SUBJECTS}
"""The module of each subject, by its last name."""


def target(place):
    """The full name of a place, which begins with a subject or with theory."""
    subject, _, rest = place.partition(".")
    return place if subject == "theory" else f"{HOMES.get(subject, f'paper_checks.claims.{subject}')}.{rest}"


def changed(change: Callable[[Any], Any]) -> Callable[..., Any]:
    """Return a fault that changes what is returned."""
    return lambda original: lambda *arguments, **named: change(original(*arguments, **named))


def minus(value):
    """The other sign."""
    return -value


def twice(value):
    """Double."""
    return 2 * value


def half(value):
    """Half."""
    return value / 2


negated, doubled, halved, squared = map(changed, (minus, twice, half, lambda one: one**2))


def replaced(other: Any) -> Callable[..., Any]:
    """Return a fault that puts something else in the place of a value."""
    return lambda _: other


def at(values: dict[Any, Any]) -> Callable[..., Any]:
    """Return a fault that moves a point."""
    return lambda point: {**point, **values}


def plus(term: Any) -> Callable[..., Any]:
    """Return a fault that adds a term."""
    return changed(lambda one: one + term)


def other_sign(original: Callable[..., Any]) -> Callable[..., Any]:
    """The field, rate or branch of the other half-space."""
    return lambda sign, *arguments, **named: original(-sign, *arguments, **named)


def confused(relation: str, read_as: str, *uses: int) -> Callable[..., Any]:
    """Return the fault for a name `prove` or `signed`: a relation is another one, in these of its uses or in all.

    They are counted from the first call on, in each proof the assumptions before the conclusion.
    """

    def planted(original: Any) -> Any:
        seen = itertools.count()

        def read(given: Any) -> Any:
            if isinstance(given, sp.And):
                return sp.And(*map(read, given.args))
            if isinstance(given, list):
                return [*map(read, given)]
            named = given == relation if isinstance(given, str) else isinstance(given, RELATIONAL[relation])
            if not named or (uses and next(seen) not in uses):
                return given
            return read_as if isinstance(given, str) else RELATIONAL[read_as](given.lhs, given.rhs, evaluate=False)

        return lambda *given: original(*map(read, given))

    return planted


def entry(index, change):
    """Change one of several expressions."""
    return changed(lambda several: tuple(change(one) if n == index else one for n, one in enumerate(several)))


def part(name, change):
    """Change one of the parts of a record: of an excursion, of the limits along a trajectory to the critical orbit."""
    return changed(lambda whole: replace(whole, **{name: change(getattr(whole, name))}))


def raised(value):
    """One per cent of 1 more."""
    return value + sp.Rational(1, 100)


def planted() -> Iterator[tuple[str, str, Callable[..., Any]]]:
    """Each claim, the place of a fault and the fault, as faults.toml lists them."""
    homes = {name: name for name in ("flint", "fractions", "numerics", "theory", "types")} | HOMES
    known = vars(symbols) | vars(points) | {name: importlib.import_module(home) for name, home in homes.items()}
    for row, places in tomllib.loads(Path(__file__).with_name("faults.toml").read_text("utf-8")).items():
        for place, faults in places.items():
            for fault in faults if isinstance(faults, list) else [faults]:
                yield row, target(place), eval(fault, known | globals())
