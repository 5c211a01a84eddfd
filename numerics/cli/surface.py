"""`python -m numerics solve` of a scene on a surface: as JSON, as a table, or drawn."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING, Any

from numerics.exits import FAILED, OK, USAGE, refuse
from numerics.scene.plane import AXES

if TYPE_CHECKING:
    from numerics.plane.answer import PlaneTrajectory

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
