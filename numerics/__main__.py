"""Command line: python -m numerics solve SCENE [--digits N] [--arithmetic A] [--json | --csv | --npz F | --plot F]."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numerics.trajectory import Trajectory

OK, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
_EPILOG = """exit codes: 0 solved; 1 undecided or out of reach (the message says what to do); 2 usage, or invalid scene
SCENE is a TOML file or a shipped scene; `python -m numerics scenes` lists them."""


def parser() -> argparse.ArgumentParser:
    """Return the argument parser; building it imports nothing heavy."""
    top = argparse.ArgumentParser(
        prog="python -m numerics", description="Solve scenes of the inertial pair exactly.", allow_abbrev=False
    )
    commands = top.add_subparsers(dest="command", required=True)
    commands.add_parser("scenes", help="list the shipped scenes")
    solve = commands.add_parser(
        "solve",
        help="solve one scene",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    solve.add_argument("scene", metavar="SCENE", help="TOML file, or the short name of a shipped scene")
    solve.add_argument("--digits", type=_positive, metavar="N", help="right digits wanted (default 15)")
    solve.add_argument("--arithmetic", choices=["float64", "mpmath", "ball"], help="default: ball, which proves them")
    solve.add_argument(
        "--max-events", type=_positive, default=250_000, metavar="N", help="stop after N events (%(default)s)"
    )
    solve.add_argument(
        "--max-digits", type=_positive, default=20_000, metavar="N", help="cap on the working digits (%(default)s)"
    )
    output = solve.add_mutually_exclusive_group()
    output.add_argument("--json", action="store_true", help="print the trajectory as JSON")
    output.add_argument("--csv", action="store_true", help="print events and final state as CSV")
    output.add_argument("--npz", type=Path, metavar="F", help="write a NumPy archive")
    output.add_argument("--plot", type=Path, metavar="F", help="write a figure: .svg, .pdf or .png")
    return top


def _positive(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10 and int(text) > 0):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from 1 to 999999999")
    return int(text)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    options = parser().parse_args(arguments)
    from numerics.errors import InvalidScene, NumericsError

    try:
        code = _list_scenes() if options.command == "scenes" else _solve(options)
        sys.stdout.flush()  # here a full disk or a reader that left can still be answered
        return code
    except InvalidScene as error:
        return _refuse(str(error), USAGE)
    except NumericsError as error:
        return _refuse(str(error), FAILED)
    except BrokenPipeError:
        _drop_output()  # the reader left; nothing more can be said
        return OK
    except OSError as error:
        file = error.filename2 or error.filename
        if file is None:
            _drop_output()
        return _refuse(f"cannot write {file or 'the output'}: {error.strerror}", FAILED if file is None else USAGE)
    except KeyboardInterrupt:
        return _refuse("interrupted; nothing was written", INTERRUPTED)


def _refuse(message: str, code: int) -> int:
    print(f"error: {' '.join(message.split())}", file=sys.stderr)
    return code


def _drop_output() -> None:
    """Send what is still buffered for stdout nowhere, so that the interpreter's last flush does not fail again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _list_scenes() -> int:
    from numerics.scene_file import shipped_scenes

    print("\n".join(shipped_scenes()))
    return OK


def _solve(options: argparse.Namespace) -> int:
    from numerics import export, plot
    from numerics.scene_file import load_scene
    from numerics.solve import solve

    for path in (options.npz, options.plot):
        if path is not None and not path.parent.is_dir():
            return _refuse(f"folder {str(path.parent)!r} does not exist; make it, or write elsewhere", USAGE)
    if options.plot is not None and options.plot.suffix not in plot.FORMATS:
        return _refuse(f"--plot {options.plot.name}: the name must end in one of {', '.join(plot.FORMATS)}", USAGE)
    if options.arithmetic == "float64" and options.digits is not None:
        return _refuse("--digits goes with ball or mpmath; float64 prints the digits it has right", USAGE)
    scene = load_scene(options.scene)
    trajectory = solve(
        scene,
        digits=options.digits,
        arithmetic=options.arithmetic or "ball",
        max_events=options.max_events,
        max_digits=options.max_digits,
        progress=_progress if sys.stderr.isatty() else None,
    )
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
    return OK


def _progress(events: int, fraction: float) -> None:
    print(f"\r{events} events, {100 * fraction:.0f} % of the horizon ", end="", file=sys.stderr, flush=True)


def _print_table(trajectory: Trajectory) -> None:
    """Print the events (where v1 = v2) and the final state with the digits asked for."""
    from rich.console import Console
    from rich.table import Table

    from numerics.export import as_record

    record = as_record(trajectory)
    table = Table("event", "t (s)", "x1 (m)", "v1 = v2 (m/s)", "x2 (m)", box=None, pad_edge=False)
    for event in record["events"]:
        table.add_row(f"{event['from']} to {event['to']}", *(event[name] for name in ("t", "x1", "v1", "x2")))
    console = Console(width=None if sys.stdout.isatty() else 160, highlight=False)
    if record["events"]:
        console.print(table)
    final = record["final"]
    console.print(f"at t = {final['t']} s, {final['mode']}; {record['message']}")
    for name, unit in (("x1", "m"), ("v1", "m/s"), ("x2", "m"), ("v2", "m/s"), ("energy", "J"), ("energy_excess", "")):
        console.print(f"  {name.replace('_', ' ')} = {final[name]} {unit}".rstrip())
    console.print(f"{record['arithmetic']}, {record['digits']} digits")


if __name__ == "__main__":
    sys.exit(main())
