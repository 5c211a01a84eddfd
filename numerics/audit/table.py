"""What an audit finds, row by row: what was tried, what came out, what is required of it, and whether it is so."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

Progress: TypeAlias = Callable[[str], None]
"""Is told now and then, in a few words, what is being tried."""


_EVERY = 100


def counted(cases: int, what: str, progress: Progress) -> Iterator[int]:
    """Yield 0, ..., cases - 1, and say now and then how many of what were tried."""
    for case in range(cases):
        if case % _EVERY == 0:
            progress(f"{what}, {case + 1} of {cases}")
        yield case


@dataclass(frozen=True)
class Row:
    """One property: how many cases were tried, the figures that came out, the requirement, and the answer to it.

    `passed` is computed where the row is made; a row for which nothing was tried has not passed.
    """

    section: str
    name: str
    tried: int
    measured: Mapping[str, float | int | str]
    required: str
    passed: bool
    details: Sequence[Mapping[str, Any]] = field(default=())
    """Finer figures for --json: decades, counts by type, the first few failures."""


def as_record(rows: Sequence[Row], seed: int, size: str) -> dict[str, Any]:
    """Return the audit as the JSON object of the interface; `passed` is whether every row has."""
    return {
        "seed": seed,
        "size": size,
        "passed": all(row.passed for row in rows),
        "rows": [
            {
                "section": row.section,
                "name": row.name,
                "tried": row.tried,
                "measured": _finite(row.measured),
                "required": row.required,
                "passed": row.passed,
                "details": [_finite(one) for one in row.details],
            }
            for row in rows
        ],
    }


def _finite(figures: Mapping[str, Any]) -> dict[str, Any]:
    """Return figures with infinities and nan as text, which JSON has no numbers for."""
    return {
        name: str(value) if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in figures.items()
    }


def print_table(rows: Sequence[Row], width: int | None) -> None:
    """Print one line a row, grouped by section."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table("section", "what", "tried", "found", "required", "", box=None, pad_edge=False)
    before = ""
    for row in rows:
        found = ", ".join(f"{name} {_figure(value)}" for name, value in row.measured.items())
        cells = ("" if row.section == before else row.section, row.name, str(row.tried), found, row.required)
        table.add_row(*(escape(cell) for cell in cells), "pass" if row.passed else "FAIL")
        before = row.section
    Console(width=width, highlight=False).print(table)


def print_decades(rows: Sequence[Row], width: int | None) -> None:
    """Print the errors of every formula by the decade of its argument."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table("formula", "decade", "tried", "max ulp", "mean ulp", "worst at", box=None, pad_edge=False)
    for row in rows:
        for one in row.details if row.section == "formulas" else ():
            if "decade" in one:
                figures = (f"1e{one['decade']}", str(one["tried"]), f"{one['max_ulp']:.3f}", f"{one['mean_ulp']:.3f}")
                table.add_row(escape(row.name), *figures, str(one["worst_at"]))
    Console(width=width, highlight=False).print(table)


def print_reasons(rows: Sequence[Row], width: int | None) -> None:
    """Print how often each reason for a refusal was given."""
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    table = Table("invalid scenes", "refused", "because", box=None, pad_edge=False)
    for row in rows:
        for one in row.details:
            for reason, count in one.get("reasons", {}).items():
                table.add_row(escape(row.name), str(count), escape(reason))
    Console(width=width, highlight=False).print(table)


def _figure(value: float | int | str) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
