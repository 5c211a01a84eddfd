"""The subcommands as argparse knows them, a table; building them imports nothing heavy."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from numerics.cli import control, solving
from numerics.exits import OneLineParser, Version, path, program_name
from numerics.scene.decimals import MOST_DIGITS
from numerics.trade.command import measure_trade

_MOST_TIMES = 1_000_000
Option = tuple[str, dict[str, Any]]
"""A flag or positional argument, and its options for argparse."""


def positive(text: str, most: int = 999_999_999) -> int:
    """Return a whole number > 0 of a flag."""
    if not (text.isascii() and text.isdigit() and len(text) < 10 and 0 < int(text) <= most):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from 1 to {most}")
    return int(text)


def digits(text: str) -> int:
    """Return a number of digits of a flag."""
    return positive(text, MOST_DIGITS)


def times(text: str) -> list[Any]:
    """Return the times A, A + STEP, ... up to B of a flag A:B:STEP, exact."""
    from numerics.errors import InvalidScene
    from numerics.scene.decimals import exact_decimal

    try:
        start, end, step = (exact_decimal(one, "a time") for one in text.split(":"))
    except (ValueError, InvalidScene):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be A:B:STEP in seconds, such as 0:5:0.01") from None
    if not (0 <= start <= end and step > 0 and (end - start) / step < _MOST_TIMES):
        most = f"at most {_MOST_TIMES} times"
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must have 0 <= A <= B, STEP > 0 and {most}")
    return [start + k * step for k in range(int((end - start) / step) + 1)]


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


_IN_PLACE, _ALSO = "instead of the scene's; together with", "also for a scene without a force"
_FIGURE = "write a figure: .svg, .pdf or .png"
_PLOT = _file("--plot", _FIGURE)
_SCENE = _option("scene", "TOML file, - for standard input, or the short name of a shipped scene", metavar="SCENE")
_JSON, _DIGITS = _switch("--json", "print the result as JSON"), _count("--digits", 15, "right digits requested")
_LEAST = ("time", "energy", "peak")
_WORKING = _count("--max-digits", 20_000, "limit on the working digits")
_ASKED = (
    _SCENE,
    _DIGITS,
    _count(
        "--max-digits",
        None,
        "limit on the working digits (16 times the digits requested; 2000 where that takes milliseconds)",
    ),
    _JSON,
    _PLOT,
)
"""Options of a question about one scene: digits of the result, and how it is printed or drawn."""
_PLAN = _file("--out", "write the scene to F instead of printing it")
_SOLVE = (
    _SCENE,
    _count("--digits", None, "right digits requested; the cheapest arithmetic that has them is used"),
    _option(
        "--arithmetic",
        "use only this one (a surface: ball; mpmath: the free pair only); without --digits ball proves 15 digits, "
        "float64 bounds its errors",
        choices=["float64", "mpmath", "ball"],
    ),
    _count("--max-events", 250_000, "stop after N events"),
    _WORKING,
    _option("--times", "print the state at the times A to B (s), as CSV", type=times, metavar="A:B:STEP"),
    _switch("--all", "print all events on a terminal, not only the first and the last 20"),
    _switch("--explain", "print to stderr which arithmetic was used, and why"),
    _switch("--check", "print what every number is really off by: the scene is solved again in balls"),
    _switch("--sensitivity", "add the derivatives by initial state, parameters and force coefficients (SI units)"),
)
_OUTPUT = [
    _switch("--json", "print the trajectory as JSON"),
    _switch("--csv", "print events and final state as CSV, with units"),
    _file("--npz", "write a NumPy archive"),
    _PLOT,
    _file("--proof", "write the events as a theorem; `python -m paper_checks.proofs F` checks it"),
]
"""Mutually exclusive."""


Command = tuple[str, Callable[[argparse.Namespace], int], str, tuple[Option | list[Option], ...]]
"""Its name, its function, its help, and its options; those in a list are mutually exclusive."""
_COMMANDS: tuple[Command, ...] = (
    ("solve", solving.solve_scene, "solve one scene", (*_SOLVE, _OUTPUT)),
    ("scenes", solving.list_scenes, "list the shipped scenes, one per line", ()),
    (
        "energy",
        solving.print_energy,
        "the energy at one time, even a very late one, without computing every event before it",
        (
            _SCENE,
            _option("--at", "time in s, a decimal such as 1e100", required=True, metavar="T"),
            _DIGITS,
            _JSON,
            _switch("--explain", "print which method was used, and why"),
            _count("--max-steps", 200_000, "limit on the events computed one by one"),
            _WORKING,
        ),
    ),
    (
        "response",
        control.print_response,
        "long-time response to the periodic force: regime, thresholds, periodic motion, Floquet multipliers",
        (
            *_ASKED,
            _option("--amplitude", f"amplitude of the sine, N, {_IN_PLACE} --omega {_ALSO}", metavar="U"),
            _option("--omega", f"frequency of the sine, rad/s, {_IN_PLACE} --amplitude {_ALSO}", metavar="W"),
            _count("--max-events", 10_000, "limit on events; one period may have a fifth of them"),
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
        "the transfer from rest to rest with the least time or energy, and its force as a scene",
        (
            *_ASKED,
            _option("--distance", "displacement of body 2, m; negative: backwards", required=True, metavar="D"),
            _option("--least", "energy: int u^2 dt; peak: max |u| (%(default)s)", choices=_LEAST, default="time"),
            _option("--time", "duration, s; for --least energy and peak", metavar="T"),
            _option("--amplitude", "the force stays within -U and U, N; for the least time", metavar="U"),
            _option("--margin", "the load stays within (1 - E) b (%(default)s)", default="0", metavar="E"),
            _PLAN,
        ),
    ),
    (
        "ring",
        control.print_ring,
        "the time from which on the relative motion stays inside its tolerance ring",
        (
            *_ASKED,
            _option("--radius", "radius of the ring about the limit of x1 - x2, m", required=True, metavar="R"),
            _option("--rate", "rate that divides v1 - v2 to give metres, 1/s (%(default)s)", default="1", metavar="W"),
        ),
    ),
    (
        "damping",
        control.print_damping,
        "the time from which the free pair sticks permanently, and that from which it rests; its best damper",
        (*_ASKED, _option("--tolerance", "displacement that counts as rest, m", required=True, metavar="D")),
    ),
    (
        "trade",
        measure_trade,
        "measure time against accuracy, of this package and of other integrators",
        (
            _option(_SCENE[0], f"{_SCENE[1]['help']}; default: nine scenes", nargs="?", metavar="SCENE"),
            _count("--digits", 100, "digits of balls: 15, 30, 100, 300, 1000 up to N"),
            _JSON,
            _PLOT,
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
    "trade": {"epilog": "contenders that are not installed, or do not know the scene, are listed and left out"},
}
"""Text below the help of some commands."""


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
