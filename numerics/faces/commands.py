"""What each subcommand of `python -m numerics` does; all heavy imports happen here, when a command runs."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numerics.trajectory.trajectory import Trajectory

OK, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
LABELS = {"energy_excess": "energy excess E/E_cr - 1"}


def refuse(message: str, code: int) -> int:
    """Print one error line and return the exit code."""
    print(f"error: {' '.join(message.split())}", file=sys.stderr)
    return code


def list_scenes(_: argparse.Namespace) -> int:
    """Print the short names of the shipped scenes."""
    from numerics.scene.file import shipped_scenes

    print("\n".join(shipped_scenes()))
    return OK


def solve_scene(options: argparse.Namespace) -> int:
    """Solve one scene and print or write what was asked for."""
    from numerics.scene.file import load_scene
    from numerics.solver.solve import solve

    wrong = _wrong_use(options)
    if wrong is not None:
        return refuse(wrong, USAGE)
    scene = load_scene(options.scene)
    trajectory = solve(
        scene,
        digits=options.digits,
        arithmetic=options.arithmetic or (None if options.digits else "ball"),
        max_events=options.max_events,
        max_digits=options.max_digits,
        progress=_progress if sys.stderr.isatty() else None,
    )
    if options.explain:
        print(explanation(trajectory), file=sys.stderr)
    if options.sensitivity:
        _tell_sensitivities(trajectory, options)
    else:
        _tell(trajectory, options)
    if not trajectory.success:
        return refuse(trajectory.message, FAILED)
    return OK


def _wrong_use(options: argparse.Namespace) -> str | None:
    """Return what is wrong with the options of a solve, before anything is computed."""
    from numerics.faces import plot

    for path in (options.npz, options.plot):
        if path is not None and not path.parent.is_dir():
            return f"folder {str(path.parent)!r} does not exist; make it, or write elsewhere"
    if options.plot is not None and options.plot.suffix not in plot.FORMATS:
        return f"--plot {options.plot.name}: the name must end in one of {', '.join(plot.FORMATS)}"
    if options.arithmetic in {"float64", "double-double"} and options.digits is not None:
        return f"--digits goes with ball or mpmath; {options.arithmetic} prints the digits it has right"
    if options.sensitivity and (options.csv or options.plot is not None):
        return "--sensitivity goes with --json, --npz or the table; leave --csv or --plot out"
    return None


def _tell(trajectory: Trajectory, options: argparse.Namespace) -> None:
    from numerics.faces import plot
    from numerics.trajectory import export

    if options.json:
        print(json.dumps(export.as_record(trajectory), indent=1))
    elif options.csv:
        print(export.as_csv(trajectory), end="")
    elif options.npz is not None:
        export.write_npz(trajectory, options.npz)
    elif options.plot is not None:
        plot.write_plot(trajectory, options.plot)
    else:
        _print_table(trajectory)


def _tell_sensitivities(trajectory: Trajectory, options: argparse.Namespace) -> None:
    """Print or write a trajectory with its derivatives."""
    from numerics.sensitivity import export as sensitivity_export
    from numerics.trajectory import export

    if options.json:
        record = export.as_record(trajectory)
        sensitivity_export.add_sensitivities(record, trajectory)
        print(json.dumps(record, indent=1))
    elif options.npz is not None:
        export.write_npz(trajectory, options.npz, sensitivity_export.sensitivity_arrays(trajectory))
    else:
        _print_table(trajectory)
        print(sensitivity_export.sensitivity_table(trajectory))


def _progress(events: int, fraction: float) -> None:
    print(f"\r{events} events, {100 * fraction:.0f} % of the horizon ", end="", file=sys.stderr, flush=True)


def _print_table(trajectory: Trajectory) -> None:
    """Print the events (where v1 = v2) and the final state; no digit is ever cut to fit a screen."""
    from numerics.trajectory.export import as_record

    record = as_record(trajectory)
    rows = [("event", "t (s)", "x1 (m)", "v1 = v2 (m/s)", "x2 (m)")]
    for event in record["events"]:
        rows.append((f"{event['from']} to {event['to']}", event["t"], event["x1"], event["v1"], event["x2"]))
    widths = [max(len(row[column]) for row in rows) for column in range(5)]
    for row in rows if len(rows) > 1 else ():
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())
    final = record["final"]
    print(f"at t = {final['t']} s, {final['mode']}; {record['message']}")
    for name, unit in (("x1", "m"), ("v1", "m/s"), ("x2", "m"), ("v2", "m/s"), ("energy", "J"), ("energy_excess", "")):
        print(f"  {LABELS.get(name, name)} = {final[name]} {unit}".rstrip())
    print(f"{record['arithmetic']}, {record['digits']} digits")


def explanation(trajectory: Trajectory) -> str:
    """Return which road a solve took: arithmetic, working digits, events located, and why no more were needed."""
    from numerics.motion.modes import Mode
    from numerics.trajectory.trajectory import Status

    located = len(trajectory.events)
    arithmetic = trajectory.arithmetic
    if not located and trajectory.modes == (Mode.STICK,):
        why = "the pair never slips: one rotation, whatever the horizon"
    elif trajectory.status is Status.STUCK_FOR_EVER:
        why = f"after {located} events the pair sticks for ever: a later horizon costs nothing more"
    else:
        why = f"{located} events located one by one, as all of them were asked for (`energy` jumps over them)"
    tried = f" ({trajectory.tried})" if trajectory.tried else ""
    return f"{arithmetic.name} with {arithmetic.digits} working digits{tried}; {why}"


def tell_energy(options: argparse.Namespace) -> int:
    """Print the energy of a scene at one time, however late."""
    from numerics.long_time.energy import energy_at
    from numerics.scene.file import load_scene
    from numerics.trajectory.rendering import ball_text

    found = energy_at(
        load_scene(options.scene),
        options.at,
        digits=options.digits,
        max_steps=options.max_steps,
        max_digits=options.max_digits,
    )
    x1, v1, _, v2 = found.si_state
    values = {"energy": found.energy, "energy_excess": found.energy_excess, "x1": x1, "v1": v1, "v2": v2}
    record = {"t": options.at, "mode": found.mode.value}
    with found.frame.arithmetic.context():
        for name, value in values.items():
            record[name], record[f"{name}_radius"] = ball_text(value, options.digits)
    road = found.road.name.lower().replace("_", "-")
    if options.json:
        told = {"excursions": str(found.excursions), "road": road, "stepped": found.stepped, "digits": options.digits}
        print(json.dumps(record | told, indent=1))
        return OK
    print(f"at t = {options.at} s, {found.mode.value}, after {found.excursions} excursions")
    print(f"  energy = {record['energy']} J\n  {LABELS['energy_excess']} = {record['energy_excess']}")
    for name, unit in (("x1", "m"), ("v1", "m/s"), ("v2", "m/s")):
        print(f"  {name} = {record[name]} {unit}, within {record[f'{name}_radius']}")
    print(f"{options.digits} right digits of the energy and its excess, proved")
    if options.explain:
        print(f"{found.road.value} ({found.stepped} events stepped)")
    return OK


def chart_merging(options: argparse.Namespace) -> int:
    """Compute the merging map of a window; print its summary or its cells, draw it."""
    from numerics.faces import plot
    from numerics.merging import figure as map_figure
    from numerics.merging.map import Window, merging_cells
    from numerics.scene.decimals import exact_decimal

    for path in (options.resume, options.out):
        if path is not None and not path.parent.is_dir():
            return refuse(f"folder {str(path.parent)!r} does not exist; make it, or write elsewhere", USAGE)
    if options.out is not None and options.out.suffix not in plot.FORMATS:
        return refuse(f"--out {options.out.name}: the name must end in one of {', '.join(plot.FORMATS)}", USAGE)
    ratio, energy = ([exact_decimal(one, name) for one in getattr(options, name)] for name in ("ratio", "energy"))
    try:
        found = merging_cells(
            Window((ratio[0], ratio[1]), (energy[0], energy[1])),
            options.depth,
            jobs=options.jobs,
            dask=options.dask,
            resume=options.resume,
            progress=_map_progress if sys.stderr.isatty() else None,
        )
    except KeyboardInterrupt:
        if options.resume is None:
            raise
        return refuse(f"interrupted; finished blocks are in {options.resume}, the same command goes on", INTERRUPTED)
    if options.out is not None:
        map_figure.write_map(found, options.out)
    if options.json:
        print(json.dumps(found.as_record()))
        return OK
    for name, share in found.shares().items():
        print(f"{name.name.lower():10}{share:8.2%} of the window (logarithmic axes)")
    print(f"{len(found.cells)} cells, sides down to 2^-{found.depth} of the window")
    return OK


def _map_progress(done: int, blocks: int) -> None:
    end = "\n" if done == blocks else ""
    print(f"\r{done} of {blocks} blocks ", end=end, file=sys.stderr, flush=True)


def audit_numerics(options: argparse.Namespace) -> int:
    """Measure what the package claims of its numbers; FAILED if a row is not as required."""
    from numerics.audit.plan import SIZES, audit
    from numerics.audit.table import as_record, print_decades, print_reasons, print_table

    shown = sys.stderr.isatty()
    try:
        rows = list(audit(SIZES[options.size], options.seed, _told if shown else lambda _: None))
    finally:
        if shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    if options.json:
        print(json.dumps(as_record(rows, options.seed, options.size), indent=1))
    else:
        width = None if sys.stdout.isatty() else 200
        if options.decades:
            print_decades(rows, width)
        print_reasons(rows, width)
        print_table(rows, width)
    return OK if all(row.passed for row in rows) else FAILED


def measure_trade(options: argparse.Namespace) -> int:
    """Measure speed against accuracy, ours and other integrators'."""
    from numerics.trade.command import measure_trade as measure

    return measure(options)


def _told(what: str) -> None:
    print(f"\r\033[K{what}", end="", file=sys.stderr, flush=True)
