"""`python -m numerics solve`, `energy` and `scenes`: solve one scene, and print, draw or write the result."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from itertools import chain
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, number_lines, write_text
from numerics.exits import FAILED, OK, USAGE, refuse
from numerics.meter import meter, shown_steps
from numerics.shown import write_figure

if TYPE_CHECKING:
    from numerics.trajectory.trajectory import Trajectory

LABELS = {"energy_excess": "energy excess E/E_cr - 1"}
SHOWN = 20
"""Number of events printed at the beginning, and at the end, on a terminal."""


def solve_scene(options: argparse.Namespace) -> int:
    """Solve one scene and print or write what was asked for."""
    from numerics.scene.file import load_scene
    from numerics.scene.plane import PlaneScene
    from numerics.solver.solve import solve

    for wrong in _wrong_use(options):
        return refuse(wrong, USAGE)
    scene: Any = load_scene(options.scene)
    on_surface = isinstance(scene, PlaneScene)
    for flag in ("proof", "sensitivity", "check") if on_surface else ():
        if getattr(options, flag):
            others = "on a surface use --json, --csv, --npz, --plot or the table"
            return refuse(f"--{flag} is available on a line only; {others}", USAGE)
    with shown_steps():
        trajectory: Any = solve(
            scene,
            digits=options.digits,
            arithmetic=options.arithmetic
            or (None if (options.digits or options.check) and not options.times else "ball"),
            max_events=options.max_events,
            max_digits=options.max_digits,
        )
    if options.times:
        try:
            trajectory = trajectory.but(t_eval=options.times)
        except ValueError as error:
            return refuse(f"--times: {error}", USAGE)
    if options.explain:
        print(_explained(trajectory, on_surface=on_surface), file=sys.stderr)
    if options.check:
        return _print_check(trajectory, options)
    if options.npz is not None:
        from numerics.trajectory.export import write_npz
        from numerics.trajectory.sensitivity import sensitivity_arrays

        write_npz(trajectory, options.npz, sensitivity_arrays(trajectory) if options.sensitivity else None)
    elif options.proof is not None:
        from numerics.trajectory.theorem import theorem

        write_text(theorem(trajectory), options.proof)
    elif options.plot is not None:
        with meter("drawing"):
            write_figure(trajectory.pictures.overview(trajectory), options.plot)
    else:
        _print(trajectory, options)
    return OK if trajectory.success else refuse(trajectory.message, FAILED)


def _print_check(trajectory: Trajectory, options: argparse.Namespace) -> int:
    """Print what every number of a trajectory is really off by; exit code 1 where one is beyond its bound."""
    found = trajectory.check()
    answer(options, found.to_dict(), [str(found)])
    return OK if found.right else FAILED


_NOT_TOGETHER = {
    "times": (("plot", "proof", "check"), "prints rows, as CSV, JSON or an archive"),
    "sensitivity": (("csv", "plot", "proof"), "needs --json, --npz or the table"),
    "check": (("csv", "npz", "plot", "proof", "sensitivity"), "prints lines, or --json"),
}
"""What an option rules out, and why."""


def _wrong_use(options: argparse.Namespace) -> Iterator[str]:
    """Yield what is wrong with the options of a solve, before anything is computed."""
    if options.arithmetic == "float64" and options.digits is not None:
        yield f"--digits {options.digits} needs ball or mpmath, not float64; leave one of both out"
    for name, (others, why) in _NOT_TOGETHER.items():
        for other in others:
            if getattr(options, name) and getattr(options, other):
                yield f"--{name} {why}; leave --{other} out"
    if options.times and options.arithmetic not in {None, "ball"}:
        yield "--times prints proved digits of balls; leave --arithmetic out"
    if options.npz is not None and options.npz.suffix != ".npz":
        yield f"--npz {options.npz.name}: the name must end in .npz; for a table use --csv"


def _print(trajectory: Any, options: argparse.Namespace) -> None:
    """Print a trajectory as JSON, as CSV or as a table, with its derivatives if they are wanted."""
    from numerics.trajectory.export import as_csv, as_record, at_times, table

    if options.times and not options.json:
        print(table(at_times(trajectory)).rstrip("\n"))
    elif options.csv:
        print(as_csv(as_record(trajectory)).rstrip("\n"))
    elif options.json:
        found = as_record(trajectory)
        if options.times:
            found["times"] = at_times(trajectory)
        if options.sensitivity:
            from numerics.trajectory.sensitivity import add_sensitivities

            add_sensitivities(found, trajectory)
        print(json.dumps(found, indent=1))
    else:
        whole = options.all or not sys.stdout.isatty()
        print("\n".join(_table(trajectory, whole=whole)))
        if options.sensitivity:
            from numerics.trajectory.sensitivity import sensitivity_table

            print(sensitivity_table(trajectory))


def _table(trajectory: Any, *, whole: bool) -> list[str]:
    """Return the events, all or the first and the last, and the final state as lines; no digit is ever cut."""
    from numerics.scene.plane import AXES
    from numerics.trajectory.export import END_NAMES, as_record, by_axes
    from numerics.trajectory.units import unit

    count = len(trajectory.event_times)
    left_out = 0 if whole else max(0, count - 2 * SHOWN)
    found = as_record(trajectory, [*range(SHOWN), *range(count - SHOWN, count)] if left_out else None)
    events = [{"event": f"{one['from']} to {one['to']}", **by_axes(one)} for one in found["events"]]
    speed = "v1 = v2 (m/s)" if all(one["v1"] == one["v2"] for one in found["events"]) else "v1 (m/s)"
    head = {"event": "event", "t": "t (s)", "x1": "x1 (m)", "v1": speed, "x2": "x2 (m)"}
    head |= {f"direction_{axis}": f"direction {axis}" for axis in AXES}
    names = [name for name in head if name in {*chain(*events)}]
    rows = [[one[name] for name in names] for one in (head, *events)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["  ".join(map(str.ljust, row, widths)).rstrip() for row in rows[: len(rows) * bool(events)]]
    if left_out:
        lines.insert(len(lines) - SHOWN, f"... {left_out} more events; --all prints them")
    final = found["final"]
    lines.append(f"at t = {final['t']} s, {final['mode']}; {found['message']}")
    for name in END_NAMES:
        if name not in final or (name == "energy_excess" and trajectory.scene.is_forced):
            continue  # E_cr is that of [pair] b at rest: under a force, or another friction, it decides nothing
        value, of = final[name], unit(name)
        if isinstance(value, list):
            units = [unit(f"{name}_{axis}") for axis, _ in zip(AXES, value, strict=False)]
            value, of = ", ".join(value), ", ".join(units if len(set(units)) > 1 else units[:1])
        lines.append(f"  {LABELS.get(name, name)} = {value} {of}".rstrip())
    return [*lines, f"{found['arithmetic']}, at least {found['digits']} right digits"]


def _explained(trajectory: Any, *, on_surface: bool) -> str:
    """Return how a scene was solved: arithmetic, digits, what was tried, events, and why no more were needed."""
    from numerics.trajectory.run import free_scene

    located, arithmetic = len(trajectory.event_times), trajectory.arithmetic
    why = f"{located} events located one by one"
    if not on_surface and free_scene(trajectory.scene):
        why += ", as all of them were requested (`energy` skips most of them)"
    if "permanently" in trajectory.message:
        why = f"after {located} events the pair sticks permanently: a later horizon takes no longer"
    tried = f" ({trajectory.tried})" if trajectory.tried else ""
    how = "the largest position, velocity or energy along the run, those of a time to that time"
    how = "each number, or near 0 to the largest of its axis along the run" if on_surface else how
    return f"{arithmetic.name} with {arithmetic.digits} working digits{tried}; {why}; digits are relative to {how}"


def list_scenes(_: argparse.Namespace) -> int:
    """Print the short name and a description of each shipped scene, one per line."""
    from numerics.scene.file import described_scenes

    for name, what in described_scenes().items():
        print(f"{name:28}{what}")
    return OK


def print_energy(options: argparse.Namespace) -> int:
    """Print the energy of a scene at one time, however late."""
    from numerics.free.energy import energy_at
    from numerics.scene.file import load_line
    from numerics.trajectory.rendering import with_radius

    found = energy_at(
        load_line(options.scene),
        options.at,
        digits=options.digits,
        max_steps=options.max_steps,
        max_digits=options.max_digits,
    )
    x1, v1, _, v2 = found.si_state
    values = {"energy": found.energy, "energy_excess": found.energy_excess, "x1": x1, "v1": v1, "v2": v2}
    shown = {"t": options.at, "mode": found.mode.value}
    with found.frame.arithmetic.context():
        for name, value in values.items():
            shown |= with_radius(name, value, options.digits)
    road = found.road.name.lower().replace("_", "-")
    way = {"excursions": str(found.excursions), "road": road, "stepped": found.stepped, "digits": options.digits}
    lines = [
        f"at t = {options.at} s, {found.mode.value}, after {found.excursions} excursions",
        f"  energy = {shown['energy']} J\n  {LABELS['energy_excess']} = {shown['energy_excess']}",
        *number_lines({name: shown[name] for name in shown if "energy" not in name}),
        f"{options.digits} right digits of the energy and its excess, proved",
        *([f"{found.road.value} ({found.stepped} events computed one by one)"] if options.explain else []),
    ]
    answer(options, shown | way, lines)
    return OK
