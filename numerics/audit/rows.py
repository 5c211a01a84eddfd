"""What an audit finds, row by row: what was tried, what came out, what is required of it, and whether it is so."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

from numerics.shown import print_table

Progress: TypeAlias = Callable[[str], None]
"""Hears now and then, in a few words, what is being tried."""


class Row(NamedTuple):
    """One property: how many cases were tried, the figures that came out, the requirement, and the answer to it.

    `passed` is computed where the row is made; a row for which nothing was tried has not passed. `details` are the
    first few failures, for --json.
    """

    name: str
    tried: int
    measured: Mapping[str, Any]
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
    """Return the audit as the JSON object of the interface; `passed` is whether every row has. JSON has no infinity."""
    finite = [{name: str(x) if x in {math.inf} else x for name, x in row.measured.items()} for row in rows]
    shown = [row._asdict() | {"measured": measured} for row, measured in zip(rows, finite, strict=True)]
    return {"seed": seed, "size": size, "passed": all(row.passed for row in rows), "rows": shown}


def print_rows(rows: Sequence[Row]) -> None:
    """Print one line a row."""
    lines = []
    for row in rows:
        found = ", ".join(f"{k} {x:.3g}" if isinstance(x, float) else f"{k} {x}" for k, x in row.measured.items())
        lines.append((row.name, str(row.tried), found, row.required, "pass" if row.passed else "FAIL"))
    print_table(("what", "tried", "found", "required", ""), lines)
