"""`python -m numerics solve` and `response` of a scene on a surface: as JSON, as a table, or drawn."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, number_lines, numbers

if TYPE_CHECKING:
    from numerics.plane.rotating import RotatingResponse
    from numerics.plane.trajectory import PlaneTrajectory


def wrong_use(options: argparse.Namespace) -> str | None:
    """Return what is not offered for a surface."""
    for flag, given in (("proof", options.proof), ("sensitivity", options.sensitivity)):
        if given:
            return f"--{flag} knows a line only; of a scene on a surface take --json, --csv, --npz, --plot or the table"
    if options.arithmetic in {"double-double", "mpmath"}:
        return f"--arithmetic {options.arithmetic} knows a line only; on a surface take float64 or ball"
    return None


def explanation(trajectory: PlaneTrajectory) -> str:
    """Return which arithmetic answered, what was tried before, and what its digits mean."""
    tried = f" (before: {trajectory.tried})" if trajectory.tried else ""
    how = "digits count relative to each number, near 0 to the largest of its axis along the run"
    working = f"{trajectory.arithmetic.name}, from a path with {trajectory.arithmetic.digits} working digits"
    return f"{working}{tried}; {len(trajectory.events)} events located one by one; {how}"


def lines(events: list[dict[str, Any]]) -> list[str]:
    """Return a line for each event."""
    from numerics.scene.plane import AXES

    found = []
    for one in events:
        along = ", ".join(f"{axis} {x}" for axis, x in zip(AXES, one["direction"], strict=False))
        found.append(f"t = {one['t']} s: {one['from']} to {one['to']}" + (f", direction {along}" if along else ""))
    return found


def print_rotating(found: RotatingResponse, options: argparse.Namespace) -> None:
    """Print the motion that goes round with a force; vectors are complex, with the force along x at t = 0."""
    values: dict[str, Any] = {"threshold": found.threshold, "speed": found.speed}
    for name in ("friction", "q1", "v1", "v2"):
        value = getattr(found, name)
        values |= {f"{name}_along": value.real, f"{name}_across": value.imag}
    record: dict[str, Any] = {"sentence": found.sentence, "attracts": found.attracts, "digits": found.digits}
    record |= numbers(values, found.digits)
    record["exponents"] = [
        [str(part.mid().str(found.digits, radius=False)) for part in (one.real, one.imag)] for one in found.exponents
    ]
    every = "every motion tends to it" if found.attracts else "other motions need not tend to it"
    lines = [f"{found.sentence}; {every}", *number_lines(record, _ROUND)]
    lines += [f"  exponent {real} + {imaginary} i 1/s" for real, imaginary in record["exponents"]]
    answer(options, record, [*lines, f"{found.digits} right digits, proved"])


_ROUND = {
    "threshold": ("U* = U**", "N"),
    "speed": ("slip speed", "m/s"),
    "friction_along": ("friction along the force", "N"),
    "friction_across": ("friction across it", "N"),
}
