"""Command line: python -m numerics solve SCENE [--digits N] [--arithmetic A] [--json | --csv | --npz F | --plot F |
--proof F]."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from numerics.cli import commands, maps, solving
from numerics.cli.control_commands import add_control, add_map_roads
from numerics.cli.flags import natural, positive
from numerics.exits import FAILED, INTERRUPTED, OK, USAGE, OneLineParser, drop_output, refuse

_EPILOG = """exit codes: 0 solved; 1 undecided or out of reach (the message says what to do); 2 usage, or invalid scene
SCENE is a TOML file or a shipped scene; `python -m numerics scenes` lists them."""
_SCENE = "TOML file, or the short name of a shipped scene"
_Subcommands = argparse._SubParsersAction  # what add_subparsers returns has no public name


def parser() -> argparse.ArgumentParser:
    """Return the argument parser; building it imports nothing heavy."""
    top: argparse.ArgumentParser = OneLineParser(
        prog="python -m numerics", description="Solve scenes of the inertial pair exactly.", allow_abbrev=False
    )
    subcommands = top.add_subparsers(dest="command", required=True)
    scenes = subcommands.add_parser("scenes", help="list the shipped scenes", allow_abbrev=False)
    scenes.set_defaults(run=commands.list_scenes)
    _add_energy(subcommands)
    chart = subcommands.add_parser(
        "map", help="which mass ratios merge from which energies on S0, in proved cells", allow_abbrev=False
    )
    chart.set_defaults(run=maps.chart_merging)
    chart.add_argument("--ratio", nargs=2, metavar=("A", "B"), default=["0.8", "100"], help="range of m2/m1")
    chart.add_argument("--energy", nargs=2, metavar=("A", "B"), default=["1.01", "101"], help="range of E/E_cr")
    add_map_roads(chart)
    add_control(subcommands)
    _add_audit(subcommands)
    _add_trade(subcommands)
    _add_solve(subcommands)
    return top


def _add_solve(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    solve = subcommands.add_parser(
        "solve",
        help="solve one scene",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    solve.set_defaults(run=solving.solve_scene)
    solve.add_argument("scene", metavar="SCENE", help=_SCENE)
    solve.add_argument(
        "--digits", type=positive, metavar="N", help="right digits wanted, in the cheapest arithmetic that has them"
    )
    solve.add_argument(
        "--arithmetic",
        choices=["float64", "double-double", "mpmath", "ball"],
        help="one for all; without --digits ball proves 15 digits, float64 and double-double bound their errors",
    )
    _add_caps(solve, "--max-events", 250_000, "stop after N events")
    solve.add_argument("--all", action="store_true", help="print all events on a terminal, not the first and the last")
    solve.add_argument("--explain", action="store_true", help="say on stderr which road was taken, and why")
    solve.add_argument(
        "--sensitivity",
        action="store_true",
        help="add the derivatives by initial state, parameters and numbers of the force (SI units)",
    )
    output = solve.add_mutually_exclusive_group()
    output.add_argument("--json", action="store_true", help="print the trajectory as JSON")
    output.add_argument("--csv", action="store_true", help="print events and final state as CSV")
    output.add_argument("--npz", type=Path, metavar="F", help="write a NumPy archive")
    output.add_argument("--plot", type=Path, metavar="F", help="write a figure: .svg, .pdf or .png")
    output.add_argument(
        "--proof", type=Path, metavar="F", help="write a theorem for `python -m paper_checks.proofs F`, which checks it"
    )


def _add_caps(asked: argparse.ArgumentParser, flag: str, most: int, what: str) -> None:
    """Add the cap on events or steps, and that on digits."""
    asked.add_argument(flag, type=positive, default=most, metavar="N", help=f"{what} (%(default)s)")
    asked.add_argument(
        "--max-digits", type=positive, default=20_000, metavar="N", help="cap on the working digits (%(default)s)"
    )


def _add_energy(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    energy = subcommands.add_parser(
        "energy", help="the energy at one time, however late, without stepping there", allow_abbrev=False
    )
    energy.set_defaults(run=commands.print_energy)
    energy.add_argument("scene", metavar="SCENE", help=_SCENE)
    energy.add_argument("--at", required=True, metavar="T", help="time in s, a decimal such as 1e100")
    energy.add_argument("--digits", type=positive, default=15, metavar="N", help="right digits wanted (%(default)s)")
    energy.add_argument("--json", action="store_true", help="print the answer as JSON")
    energy.add_argument("--explain", action="store_true", help="say which method was used, and why")
    _add_caps(energy, "--max-steps", 200_000, "cap on stepped events")


def _add_audit(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    audit = subcommands.add_parser(
        "audit",
        help="measure what this package claims of its own numbers",
        epilog="exit codes: 0 every row is as required; 1 some row is not",
        allow_abbrev=False,
    )
    audit.set_defaults(run=commands.audit_numerics)
    audit.add_argument("--seed", type=natural, default=0, metavar="N", help="other cases (%(default)s)")
    _add_size(audit, "about 10 s, 2 min or 10 min")
    audit.add_argument("--json", action="store_true", help="print every figure as JSON, also by decade and by reason")
    audit.add_argument("--decades", action="store_true", help="print the errors of each formula by decade as well")


def _add_size(measured: argparse.ArgumentParser, how_long: str) -> None:
    sizes = ["small", "default", "large"]
    measured.add_argument("--size", choices=sizes, default="default", help=f"{how_long} (%(default)s)")


def _add_trade(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    trade = subcommands.add_parser(
        "trade",
        help="measure speed against accuracy, ours and other integrators'",
        epilog="what is not installed is left out and named; a run that hangs or fails is stopped and shown as such",
        allow_abbrev=False,
    )
    trade.set_defaults(run=commands.measure_trade)
    _add_size(trade, "a few minutes, half an hour or some hours")
    trade.add_argument(
        "--only",
        nargs="+",
        default=[],
        metavar="NAME",
        help="free or forced scenes, or contenders and scenes whose names contain NAME",
    )
    trade.add_argument(
        "--interface",
        action="store_true",
        help="only the public interface beside heyoka, in one process and in turns",
    )
    trade.add_argument("--json", action="store_true", help="print every measurement as JSON")
    trade.add_argument("--out", type=Path, metavar="FIGURE", help="write the figure, .svg, .pdf or .png")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code."""
    options = parser().parse_args(arguments)
    from numerics.errors import InvalidScene, NoForceHere, NumericsError

    try:
        code: int = options.run(options)
        sys.stdout.flush()  # here a full disk or a reader that left can still be answered
        return code
    except (InvalidScene, NoForceHere) as error:
        return refuse(str(error), USAGE)
    except NumericsError as error:
        return refuse(str(error), FAILED)
    except BrokenPipeError:
        drop_output()  # the reader left; nothing more can be said
        return OK
    except OSError as error:
        file = error.filename2 or error.filename
        if file is None:
            drop_output()
        code = FAILED if file is None else USAGE
        return refuse(f"cannot write {file or 'the output'}: {error.strerror}", code)
    except KeyboardInterrupt:
        return refuse("interrupted; nothing was written", INTERRUPTED)


if __name__ == "__main__":
    sys.exit(main())
