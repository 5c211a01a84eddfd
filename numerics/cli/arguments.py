"""The subcommands as argparse knows them, a table; building them imports nothing heavy."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from numerics.cli import commands, control, solving
from numerics.exits import OneLineParser, Version, path, program_name
from numerics.scene.decimals import MOST_DIGITS
from numerics.trade.command import measure_trade

Option = tuple[str, dict[str, Any]]
"""A flag or a place, and what argparse is told of it."""


def natural(text: str, least: int = 0, most: int = 999_999_999) -> int:
    """Return a whole number of a flag, >= 0 or another least one."""
    if not (text.isascii() and text.isdigit() and len(text) < 10 and least <= int(text) <= most):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from {least} to {most}")
    return int(text)


def positive(text: str) -> int:
    """Return a whole number > 0 of a flag."""
    return natural(text, 1)


def digits(text: str) -> int:
    """Return so many digits of a flag."""
    return natural(text, 1, MOST_DIGITS)


def _option(name: str, what: str, **how: Any) -> Option:
    return name, {"help": what, **how}


def _switch(name: str, what: str) -> Option:
    return _option(name, what, action="store_true")


def _count(name: str, default: int | None, what: str) -> Option:
    shown = what if default is None else f"{what} (%(default)s)"
    kind = digits if name.endswith("digits") else positive
    return _option(name, shown, type=kind, default=default, metavar="N")


def _file(name: str, what: str, metavar: str = "F") -> Option:
    return _option(name, what, type=path, metavar=metavar)


def _range(name: str, what: str, **how: Any) -> Option:
    return _option(name, what, nargs=2, metavar=("A", "B"), **how)


def _size(how_long: str) -> Option:
    sizes = ["small", "default", "large"]
    return _option("--size", f"{how_long} (%(default)s)", choices=sizes, default="default")


_IN_PLACE, _ALSO = "in place of the scene's; with", "also for a scene without a force"
_FIGURE = "write a figure: .svg, .pdf or .png"
_PLOT, _CHART = _file("--plot", _FIGURE), _file("--out", _FIGURE, "FIGURE")
_SCENE = _option("scene", "TOML file, - for standard input, or the short name of a shipped scene", metavar="SCENE")
_JSON, _DIGITS = _switch("--json", "print the answer as JSON"), _count("--digits", 15, "right digits wanted")
_WORKING = _count("--max-digits", 20_000, "cap on the working digits")
_ASKED = (
    _SCENE,
    _DIGITS,
    _count(
        "--max-digits",
        None,
        "cap on the working digits (16 times the right digits wanted; 2000 where that takes milliseconds)",
    ),
    _JSON,
    _PLOT,
)
"""What a question about one scene takes: it is answered to some digits, printed or drawn."""
_PLAN = _file("--out", "write the scene to F instead of printing it")
_CELLS = (
    _count("--depth", 10, "cells down to 2^-N of each side"),
    _count("--jobs", 1, "processes that share the work"),
    _option("--dask", "compute on the Dask cluster of this scheduler instead", metavar="ADDRESS"),
    _file("--resume", "keep finished blocks in F, and go on from there"),
    _CHART,
    _switch("--json", "print all cells as JSON"),
)
"""What all maps take: depth, roads, checkpoint, output."""
_SOLVE = (
    _SCENE,
    _count("--digits", None, "right digits wanted, in the cheapest arithmetic that has them"),
    _option(
        "--arithmetic",
        "one for all; without --digits ball proves 15 digits, float64 and double-double bound their errors",
        choices=["float64", "double-double", "mpmath", "ball"],
    ),
    _count("--max-events", 250_000, "stop after N events"),
    _WORKING,
    _switch("--all", "print all events on a terminal, not the first and the last"),
    _switch("--explain", "say on stderr which arithmetic was used, and why"),
    _switch("--sensitivity", "add the derivatives by initial state, parameters and numbers of the force (SI units)"),
)
_OUTPUT = [
    _switch("--json", "print the trajectory as JSON"),
    _switch("--csv", "print events and final state as CSV, with units"),
    _file("--npz", "write a NumPy archive"),
    _PLOT,
    _file("--proof", "write a theorem for `python -m paper_checks.proofs F`, which checks it"),
]
"""Of these a solve takes one."""


Command = tuple[str, Callable[[argparse.Namespace], int], str, tuple[Option | list[Option], ...]]
"""Its name, what runs it, what it does, and its options; of those in a list it takes one."""
_COMMANDS: tuple[Command, ...] = (
    ("solve", solving.solve_scene, "solve one scene", (*_SOLVE, _OUTPUT)),
    ("scenes", commands.list_scenes, "list the shipped scenes, a line each", ()),
    (
        "energy",
        commands.print_energy,
        "the energy at one time, however late, without stepping there",
        (
            _SCENE,
            _option("--at", "time in s, a decimal such as 1e100", required=True, metavar="T"),
            _DIGITS,
            _JSON,
            _switch("--explain", "say which method was used, and why"),
            _count("--max-steps", 200_000, "cap on stepped events"),
            _WORKING,
        ),
    ),
    (
        "map",
        commands.chart_merging,
        "which mass ratios merge from which energies on S0, in proved cells",
        (
            _range("--ratio", "range of m2/m1", default=["0.8", "100"]),
            _range("--energy", "range of E/E_cr", default=["1.01", "101"]),
            *_CELLS,
        ),
    ),
    (
        "response",
        control.print_response,
        "what the pair does in the long run under its periodic force: thresholds, periodic motion, multipliers",
        (
            *_ASKED,
            _option("--amplitude", f"amplitude of the sine, N, {_IN_PLACE} --omega {_ALSO}", metavar="U"),
            _option("--omega", f"frequency of the sine, rad/s, {_IN_PLACE} --amplitude {_ALSO}", metavar="W"),
            _count("--max-events", 10_000, "cap on events: a period of the motion may have a fifth"),
        ),
    ),
    (
        "response-map",
        commands.chart_response,
        "which regime a sine brings, over frequency and amplitude, in proved cells",
        (
            _option("scene", "scene whose pair is taken; its force is ignored", metavar="SCENE"),
            _range("--amplitude", "range of the amplitude, N", required=True),
            _range("--omega", "range of the frequency, rad/s", required=True),
            *_CELLS,
        ),
    ),
    (
        "track",
        control.print_tracking,
        "the force under which body 2 follows a reference, as a scene",
        (
            *_ASKED,
            _option("--reference", "TOML file of [[reference]] pieces, in m", required=True, metavar="FILE"),
            _PLAN,
        ),
    ),
    (
        "move",
        control.print_transfer,
        "the fastest transfer from rest to rest, its force as a scene",
        (
            *_ASKED,
            _option("--distance", "how far body 2 goes, m; below 0: backwards", required=True, metavar="D"),
            _option("--amplitude", "the force stays within -U and U, N", metavar="U"),
            _option("--margin", "the load stays within (1 - E) b (%(default)s)", default="0", metavar="E"),
            _PLAN,
        ),
    ),
    (
        "ring",
        control.print_ring,
        "when the relative motion enters its tolerance ring for good",
        (
            *_ASKED,
            _option("--radius", "radius of the ring about the limit of x1 - x2, m", required=True, metavar="R"),
            _option("--rate", "divides v1 - v2, to make metres of it, 1/s (%(default)s)", default="1", metavar="W"),
        ),
    ),
    (
        "audit",
        commands.audit_numerics,
        "measure what this package claims of its own numbers",
        (
            _option("--seed", "other cases (%(default)s)", type=natural, default=0, metavar="N"),
            _size("about 10 s, 4 min, or longer"),
            _switch("--json", "print every figure as JSON, and the scenes that fail"),
        ),
    ),
    (
        "trade",
        measure_trade,
        "measure speed against accuracy, ours and other integrators'",
        (
            _size("half a minute, some minutes or half an hour"),
            _option(
                "--only",
                "free, forced, surface or state scenes, or contenders and scenes whose names contain NAME",
                nargs="+",
                default=[],
                metavar="NAME",
            ),
            _switch("--interface", "only the public interface beside heyoka"),
            _switch("--json", "print every measurement as JSON"),
            _CHART,
        ),
    ),
)
_BELOW: dict[str, dict[str, Any]] = {
    "solve": {
        "epilog": "exit codes: 0 solved; 1 undecided or out of reach (the message says what to do); 2 usage, or "
        "invalid scene\nSCENE is a TOML file, - for standard input, or a shipped scene; the command `scenes` lists "
        "them.",
        "formatter_class": argparse.RawDescriptionHelpFormatter,
    },
    "audit": {"epilog": "exit codes: 0 every row is as required; 1 some is not"},
    "trade": {
        "epilog": "what is not installed is left out and named; a run that hangs or fails is stopped and shown as such"
    },
}
"""What stands below the help of some commands."""


def parser() -> argparse.ArgumentParser:
    """Return the argument parser; `figure` is the option that names one, None if a command draws none."""
    top: argparse.ArgumentParser = OneLineParser(
        prog=program_name("inertial-pair", "numerics"),
        description="Solve scenes of the inertial pair exactly.",
        allow_abbrev=False,
    )
    top.add_argument("--version", action=Version, nargs=0, help="print the version and exit")
    subcommands = top.add_subparsers(dest="command", required=True)
    for name, run, what, options in _COMMANDS:
        made = subcommands.add_parser(name, help=what, allow_abbrev=False, **_BELOW.get(name, {}))
        made.set_defaults(run=run, figure=None)
        for one in options:
            group = made.add_mutually_exclusive_group() if isinstance(one, list) else made
            for flag, how in one if isinstance(one, list) else [one]:
                added = group.add_argument(flag, **how)
                if flag == "scene":
                    added.completer = _names  # type: ignore[attr-defined]
                if added.help == _FIGURE:
                    made.set_defaults(figure=added.dest)
    return top


def _names(**_: Any) -> tuple[str, ...]:
    """Return the names of the shipped scenes, with which a shell completes one."""
    from numerics.scene.file import shipped_scenes

    return shipped_scenes()
