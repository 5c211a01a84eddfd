"""`python -m numerics solve`: solve one scene, and print, draw or write what was asked for."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING, Any

from numerics.exits import FAILED, OK, USAGE, refuse, wrong_path
from numerics.faces.flags import in_flags

if TYPE_CHECKING:
    from numerics.trajectory.trajectory import Trajectory

LABELS = {"energy_excess": "energy excess E/E_cr - 1"}
UNITS = {"x1": "m", "v1": "m/s", "x2": "m", "v2": "m/s", "energy": "J", "energy_excess": ""}
SHOWN = 20
"""On a terminal so many events are printed at the beginning, and as many at the end."""


def solve_scene(options: argparse.Namespace) -> int:
    """Solve one scene and print or write what was asked for."""
    from numerics.scene.file import load_scene
    from numerics.solver.solve import solve

    wrong = _wrong_use(options)
    if wrong is not None:
        return refuse(wrong, USAGE)
    trajectory = solve(
        load_scene(options.scene),
        digits=options.digits,
        arithmetic=options.arithmetic or (None if options.digits else "ball"),
        max_events=options.max_events,
        max_digits=options.max_digits,
        progress=_progress if sys.stderr.isatty() else None,
    )
    if options.explain:
        print(explanation(trajectory), file=sys.stderr)
    _tell(trajectory, options)
    return OK if trajectory.success else refuse(in_flags(trajectory.message), FAILED)


def _wrong_use(options: argparse.Namespace) -> str | None:
    """Return what is wrong with the options of a solve, before anything is computed."""
    if options.arithmetic in {"float64", "double-double"} and options.digits is not None:
        return f"--digits goes with ball or mpmath; {options.arithmetic} prints the digits it has right"
    if options.sensitivity and (options.csv or options.plot is not None):
        return "--sensitivity goes with --json, --npz or the table; leave --csv or --plot out"
    return wrong_path(options.npz) or wrong_path(options.plot, "--plot")


def _progress(events: int, fraction: float) -> None:
    print(f"\r{events} events, {100 * fraction:.0f} % of the horizon ", end="", file=sys.stderr, flush=True)


def _tell(trajectory: Trajectory, options: argparse.Namespace) -> None:
    from numerics.trajectory import export

    if options.npz is not None:
        export.write_npz(trajectory, options.npz, _derivatives(trajectory) if options.sensitivity else None)
    elif options.plot is not None:
        from numerics.faces.plot import write_plot

        write_plot(trajectory, options.plot)
    elif options.json or options.csv:
        from numerics.solver.truth import record

        found = record(trajectory)
        found["message"] = in_flags(found["message"])
        if options.sensitivity:
            _add_derivatives(found, trajectory)
        print(json.dumps(found, indent=1) if options.json else export.as_csv(found).rstrip("\n"))
    else:
        _print_table(trajectory, whole=options.all or not sys.stdout.isatty())
        if options.sensitivity:
            _print_derivatives(trajectory)


def _derivatives(trajectory: Trajectory) -> dict[str, Any]:
    from numerics.sensitivity.export import sensitivity_arrays

    return sensitivity_arrays(trajectory)


def _add_derivatives(found: dict[str, Any], trajectory: Trajectory) -> None:
    from numerics.sensitivity.export import add_sensitivities, record_digits

    add_sensitivities(found, trajectory, _in_balls(trajectory, record_digits(trajectory)))


def _print_derivatives(trajectory: Trajectory) -> None:
    from numerics.sensitivity.export import TABLE_DIGITS, sensitivity_table

    print(sensitivity_table(trajectory, _in_balls(trajectory, TABLE_DIGITS)))


def _in_balls(trajectory: Trajectory, digits: int) -> Trajectory:
    from numerics.solver.truth import proved

    return trajectory if trajectory.arithmetic.name == "ball" else proved(trajectory, digits)


def _print_table(trajectory: Trajectory, *, whole: bool) -> None:
    """Print the events (where v1 = v2), all or the first and the last, and the final state; no digit is ever cut."""
    from numerics.solver.truth import record

    count = len(trajectory.events)
    left_out = 0 if whole else max(0, count - 2 * SHOWN)
    found = record(trajectory, [*range(SHOWN), *range(count - SHOWN, count)] if left_out else None)
    rows = [("event", "t (s)", "x1 (m)", "v1 = v2 (m/s)", "x2 (m)")]
    for event in found["events"]:
        rows.append((f"{event['from']} to {event['to']}", event["t"], event["x1"], event["v1"], event["x2"]))
    widths = [max(len(row[column]) for row in rows) for column in range(5)]
    for number, row in enumerate(rows if count else ()):
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())
        if left_out and number == SHOWN:
            print(f"... {left_out} events more; --all prints them too")
    final = found["final"]
    print(f"at t = {final['t']} s, {final['mode']}; {in_flags(found['message'])}")
    for name, unit in UNITS.items():
        if name == "energy_excess" and trajectory.scene.is_forced:
            continue  # E_cr is that of [pair] b at rest: under a force, or another friction, it decides nothing
        print(f"  {LABELS.get(name, name)} = {final[name]} {unit}".rstrip())
    print(f"{found['arithmetic']}, {found['digits']} digits")


def explanation(trajectory: Trajectory) -> str:
    """Return which road a solve took: arithmetic, working digits, events located, and why no more were needed."""
    from numerics.motion.modes import Mode
    from numerics.trajectory.status import Status

    located = len(trajectory.events)
    arithmetic = trajectory.arithmetic
    if not located and trajectory.modes == (Mode.STICK,):
        why = "the pair never slips: one rotation, whatever the horizon"
    elif trajectory.status is Status.STUCK_FOR_EVER:
        why = f"after {located} events the pair sticks for ever: a later horizon costs nothing more"
    else:
        why = f"{located} events located one by one, as all of them were asked for (`energy` jumps over them)"
    tried = f" ({in_flags(trajectory.tried)})" if trajectory.tried else ""
    return f"{arithmetic.name} with {arithmetic.digits} working digits{tried}; {why}"
