"""What an audit finds, row by row: what was tried, what came out, what is required of it, and whether it is so."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, TypeAlias

from numerics.shown import print_table

Progress: TypeAlias = Callable[[str], None]
"""Hears now and then, in a few words, what is being tried."""


@dataclass(frozen=True)
class Row:
    """One property: how many cases were tried, the figures that came out, the requirement, and the answer to it.

    `passed` is computed where the row is made; a row for which nothing was tried has not passed. `details` are finer
    figures for --json: decades, reasons, the first few failures.
    """

    section: str
    name: str
    tried: int
    measured: Mapping[str, float | int | str]
    required: str
    passed: bool
    details: Sequence[Mapping[str, Any]] = ()


def counted(cases: int, what: str, progress: Progress) -> Iterator[int]:
    """Yield 0, ..., cases - 1, and say now and then how many of what were tried."""
    for case in range(cases):
        if case % 100 == 0:
            progress(f"{what}, {case + 1} of {cases}")
        yield case


def as_record(rows: Sequence[Row], seed: int, size: str) -> dict[str, Any]:
    """Return the audit as the JSON object of the interface; `passed` is whether every row has."""
    passed = all(row.passed for row in rows)
    return {"seed": seed, "size": size, "passed": passed, "rows": [_finite(asdict(row)) for row in rows]}


def _finite(value: Any) -> Any:
    """Return figures with infinities and nan as text, which JSON has no numbers for."""
    if isinstance(value, dict):
        return {name: _finite(one) for name, one in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(one) for one in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def print_rows(rows: Sequence[Row]) -> None:
    """Print one line a row, grouped by section."""
    lines, before = [], ""
    for row in rows:
        found = ", ".join(f"{name} {_figure(value)}" for name, value in row.measured.items())
        section, before = "" if row.section == before else row.section, row.section
        lines.append((section, row.name, str(row.tried), found, row.required, "pass" if row.passed else "FAIL"))
    print_table(("section", "what", "tried", "found", "required", ""), lines)


def print_decades(rows: Sequence[Row]) -> None:
    """Print the errors of every formula by the decade of its argument."""
    decades = [(row.name, one) for row in rows for one in row.details if "decade" in one]
    names = ("tried", "max ulp", "mean ulp", "worst at")
    lines = [(name, f"1e{one['decade']}", *(_figure(one[key]) for key in names)) for name, one in decades]
    print_table(("formula", "decade", *names), lines)


def print_reasons(rows: Sequence[Row]) -> None:
    """Print how often each reason for a refusal was given."""
    reasons = [(row.name, one["reasons"]) for row in rows for one in row.details if "reasons" in one]
    lines = [(name, str(count), reason) for name, found in reasons for reason, count in found.items()]
    print_table(("invalid scenes", "refused", "because"), lines)


def _figure(value: float | int | str) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
