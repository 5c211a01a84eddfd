"""`python -m numerics solve` and `response` of a scene on a surface: as JSON, as a table, or drawn."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, number_lines, numbers
from numerics.exits import FAILED, OK, USAGE, refuse
from numerics.scene.plane import AXES

if TYPE_CHECKING:
    from numerics.plane.answer import PlaneTrajectory
    from numerics.plane.rotating import RotatingResponse

_UNITS = {"x1": "m", "v1": "m/s", "x2": "m", "v2": "m/s"}


def wrong_use(options: argparse.Namespace) -> str | None:
    """Return what is not offered for a surface."""
    for flag, given in (
        ("csv", options.csv),
        ("npz", options.npz),
        ("proof", options.proof),
        ("sensitivity", options.sensitivity),
    ):
        if given:
            return f"--{flag} does not know a surface yet; take --json, --plot or the table"
    return None


def print_surface(trajectory: PlaneTrajectory, options: argparse.Namespace) -> int:
    """Print the answer of a scene on a surface."""
    wrong = wrong_use(options)
    if wrong is not None:
        return refuse(wrong, USAGE)
    if options.plot is not None:
        from numerics.plane.pictures import overview
        from numerics.shown import write_figure

        write_figure(overview(trajectory), options.plot)
    elif options.json:
        print(json.dumps(trajectory.record(), indent=1))
    else:
        print("\n".join(_lines(trajectory.record())))
    return OK if trajectory.success else refuse(trajectory.message, FAILED)


def _lines(found: dict[str, Any]) -> list[str]:
    lines = []
    for one in found["events"]:
        along = ", ".join(f"{axis} {x}" for axis, x in zip(AXES, one["direction"], strict=False))
        lines.append(f"t = {one['t']} s: {one['from']} to {one['to']}" + (f", direction {along}" if along else ""))
    final = found["final"]
    lines.append(f"at t = {final['t']} s, {final['mode']}; {found['message']}")
    for name, unit in _UNITS.items():
        lines.append(f"  {name} = {', '.join(final[name])} {unit}")
    return [*lines, f"  energy = {final['energy']} J", f"{found['arithmetic']}, {found['digits']} digits"]


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
    every = "every motion tends to it" if found.attracts else "not every motion tends to it"
    lines = [f"{found.sentence}; {every}", *number_lines(record, _ROUND)]
    lines += [f"  exponent {real} + {imaginary} i 1/s" for real, imaginary in record["exponents"]]
    answer(options, record, [*lines, f"{found.digits} right digits, proved"])


_ROUND = {
    "threshold": ("U* = U**", "N"),
    "speed": ("slip speed", "m/s"),
    "friction_along": ("friction along the force", "N"),
    "friction_across": ("friction across it", "N"),
}
