"""The subcommands as argparse knows them; building them imports nothing heavy."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from numerics.cli import commands, control, solving
from numerics.exits import OneLineParser, Version, path, program_name
from numerics.trade.command import measure_trade

_EPILOG = """exit codes: 0 solved; 1 undecided or out of reach (the message says what to do); 2 usage, or invalid scene
SCENE is a TOML file, - for standard input, or a shipped scene; the command `scenes` lists them."""
_SCENE = "TOML file, - for standard input, or the short name of a shipped scene"
_FIGURE: dict[str, Any] = {"type": path, "help": "write a figure: .svg, .pdf or .png"}


def parser() -> argparse.ArgumentParser:
    """Return the argument parser; `figures` are the options that name a figure."""
    top: argparse.ArgumentParser = OneLineParser(
        prog=program_name("inertial-pair", "numerics"),
        description="Solve scenes of the inertial pair exactly.",
        allow_abbrev=False,
    )
    top.add_argument("--version", action=Version, nargs=0, help="print the version and exit")
    top.set_defaults(figures=("plot",), needs=())
    subcommands = top.add_subparsers(dest="command", required=True)

    def command(name: str, run: Callable[[argparse.Namespace], int], what: str, **more: Any) -> argparse.ArgumentParser:
        made: argparse.ArgumentParser = subcommands.add_parser(name, help=what, allow_abbrev=False, **more)
        made.set_defaults(run=run)
        return made

    shown: dict[str, Any] = {"epilog": _EPILOG, "formatter_class": argparse.RawDescriptionHelpFormatter}
    _solve(command("solve", solving.solve_scene, "solve one scene", **shown))
    command("scenes", commands.list_scenes, "list the shipped scenes, a line each")
    _energy(command("energy", commands.print_energy, "the energy at one time, however late, without stepping there"))
    chart = command("map", commands.chart_merging, "which mass ratios merge from which energies on S0, in proved cells")
    chart.add_argument("--ratio", nargs=2, metavar=("A", "B"), default=["0.8", "100"], help="range of m2/m1")
    chart.add_argument("--energy", nargs=2, metavar=("A", "B"), default=["1.01", "101"], help="range of E/E_cr")
    _of_a_map(chart)
    what = "what the pair does in the long run under its periodic force: thresholds, periodic motion, multipliers"
    _response(command("response", control.print_response, what))
    what = "which regime a sine brings, over frequency and amplitude, in proved cells"
    chart = command("response-map", commands.chart_response, what)
    _scene(chart, "scene whose pair is taken; its force is ignored")
    chart.add_argument("--amplitude", nargs=2, required=True, metavar=("A", "B"), help="range of the amplitude, N")
    chart.add_argument("--omega", nargs=2, required=True, metavar=("A", "B"), help="range of the frequency, rad/s")
    _of_a_map(chart)
    _plans(command)
    what = "measure what this package claims of its own numbers"
    _audit(
        command("audit", commands.audit_numerics, what, epilog="exit codes: 0 every row is as required; 1 some is not")
    )
    what, left_out = "measure speed against accuracy, ours and other integrators'", "what is not installed is left out"
    epilog = f"{left_out} and named; a run that hangs or fails is stopped and shown as such"
    _trade(command("trade", measure_trade, what, epilog=epilog))
    return top


def _scene(asked: argparse.ArgumentParser, what: str = _SCENE) -> None:
    """Add the scene; a shell completes the names of shipped ones."""
    asked.add_argument("scene", metavar="SCENE", help=what).completer = _names  # type: ignore[attr-defined]


def _names(**_: Any) -> tuple[str, ...]:
    from numerics.scene.file import shipped_scenes

    return shipped_scenes()


def _solve(asked: argparse.ArgumentParser) -> None:
    _scene(asked)
    _count(asked, "--digits", None, "right digits wanted, in the cheapest arithmetic that has them")
    asked.add_argument(
        "--arithmetic",
        choices=["float64", "double-double", "mpmath", "ball"],
        help="one for all; without --digits ball proves 15 digits, float64 and double-double bound their errors",
    )
    _count(asked, "--max-events", 250_000, "stop after N events")
    _count(asked, "--max-digits", 20_000, "cap on the working digits")
    asked.add_argument("--all", action="store_true", help="print all events on a terminal, not the first and the last")
    asked.add_argument("--explain", action="store_true", help="say on stderr which arithmetic was used, and why")
    derivatives = "add the derivatives by initial state, parameters and numbers of the force (SI units)"
    asked.add_argument("--sensitivity", action="store_true", help=derivatives)
    output = asked.add_mutually_exclusive_group()
    output.add_argument("--json", action="store_true", help="print the trajectory as JSON")
    output.add_argument("--csv", action="store_true", help="print events and final state as CSV, with units")
    output.add_argument("--npz", type=path, metavar="F", help="write a NumPy archive")
    output.add_argument("--plot", metavar="F", **_FIGURE)
    proof = "write a theorem for `python -m paper_checks.proofs F`, which checks it"
    output.add_argument("--proof", type=path, metavar="F", help=proof)


def _count(asked: argparse.ArgumentParser, flag: str, default: int | None, what: str) -> None:
    """Add a flag for a whole number."""
    shown = what if default is None else f"{what} (%(default)s)"
    asked.add_argument(flag, type=positive, default=default, metavar="N", help=shown)


def _energy(asked: argparse.ArgumentParser) -> None:
    _scene(asked)
    asked.add_argument("--at", required=True, metavar="T", help="time in s, a decimal such as 1e100")
    _count(asked, "--digits", 15, "right digits wanted")
    asked.add_argument("--json", action="store_true", help="print the answer as JSON")
    asked.add_argument("--explain", action="store_true", help="say which method was used, and why")
    _count(asked, "--max-steps", 200_000, "cap on stepped events")
    _count(asked, "--max-digits", 20_000, "cap on the working digits")


def _of_a_map(chart: argparse.ArgumentParser) -> None:
    """Add what all maps take: depth, roads, checkpoint, output."""
    _count(chart, "--depth", 10, "cells down to 2^-N of each side")
    _count(chart, "--jobs", 1, "processes that share the work")
    chart.add_argument("--dask", metavar="ADDRESS", help="compute on the Dask cluster of this scheduler instead")
    chart.add_argument("--resume", type=path, metavar="F", help="keep finished blocks in F, and go on from there")
    chart.add_argument("--out", metavar="FIGURE", **_FIGURE)
    chart.add_argument("--json", action="store_true", help="print all cells as JSON")
    chart.set_defaults(figures=("out",))


def _of_a_scene(asked: argparse.ArgumentParser) -> None:
    """Add what a question about one scene takes: it is answered to some digits, printed or drawn."""
    _scene(asked)
    _count(asked, "--digits", 15, "right digits wanted")
    most = "cap on the working digits (16 times the right digits wanted; 2000 where that takes milliseconds)"
    _count(asked, "--max-digits", None, most)
    asked.add_argument("--json", action="store_true", help="print the answer as JSON")
    asked.add_argument("--plot", metavar="F", **_FIGURE)


def _response(asked: argparse.ArgumentParser) -> None:
    _of_a_scene(asked)
    for flag, metavar, what, other in (
        ("--amplitude", "U", "amplitude of the sine, N", "--omega"),
        ("--omega", "W", "frequency of the sine, rad/s", "--amplitude"),
    ):
        text = f"{what}, in place of the scene's; with {other} also for a scene without a force"
        asked.add_argument(flag, metavar=metavar, help=text)
    what = "cap on events: a period of the motion may have a fifth"
    _count(asked, "--max-events", 10_000, what)


def _plans(command: Callable[..., argparse.ArgumentParser]) -> None:
    """Add track, move and ring."""
    track = command("track", control.print_tracking, "the force under which body 2 follows a reference, as a scene")
    move = command("move", control.print_transfer, "the fastest transfer from rest to rest, its force as a scene")
    ring = command("ring", control.print_ring, "when the relative motion enters its tolerance ring for good")
    for one in (track, move, ring):
        _of_a_scene(one)
    track.add_argument("--reference", required=True, metavar="FILE", help="TOML file of [[reference]] pieces, in m")
    move.add_argument("--distance", required=True, metavar="D", help="how far body 2 goes, m; below 0: backwards")
    move.add_argument("--amplitude", metavar="U", help="the force stays within -U and U, N")
    move.add_argument("--margin", default="0", metavar="E", help="the load stays within (1 - E) b (%(default)s)")
    for one in (track, move):
        one.add_argument("--out", type=path, metavar="F", help="write the scene to F instead of printing it")
    ring.add_argument("--radius", required=True, metavar="R", help="radius of the ring about the limit of x1 - x2, m")
    what = "divides v1 - v2, to make metres of it, 1/s (%(default)s)"
    ring.add_argument("--rate", default="1", metavar="W", help=what)


def _audit(audit: argparse.ArgumentParser) -> None:
    audit.add_argument("--seed", type=natural, default=0, metavar="N", help="other cases (%(default)s)")
    _size(audit, "about 10 s, 2 min or 10 min")
    audit.set_defaults(needs=("rich",))
    audit.add_argument("--json", action="store_true", help="print every figure as JSON, and the scenes that fail")


def _size(measured: argparse.ArgumentParser, how_long: str) -> None:
    sizes = ["small", "default", "large"]
    measured.add_argument("--size", choices=sizes, default="default", help=f"{how_long} (%(default)s)")


def _trade(trade: argparse.ArgumentParser) -> None:
    _size(trade, "half a minute, some minutes or half an hour")
    what = "free, forced, surface or state scenes, or contenders and scenes whose names contain NAME"
    trade.add_argument("--only", nargs="+", default=[], metavar="NAME", help=what)
    what = "only the public interface beside heyoka"
    trade.add_argument("--interface", action="store_true", help=what)
    trade.add_argument("--json", action="store_true", help="print every measurement as JSON")
    trade.add_argument("--out", metavar="FIGURE", **_FIGURE)
    trade.set_defaults(figures=("out",), needs=("rich",))


def natural(text: str) -> int:
    """Return a whole number >= 0 of a flag."""
    return _whole(text, 0)


def positive(text: str) -> int:
    """Return a whole number > 0 of a flag."""
    return _whole(text, 1)


def _whole(text: str, least: int) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10 and int(text) >= least):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from {least} to 999999999")
    return int(text)
