"""The subcommands for control engineers, as argparse knows them; building them imports nothing heavy."""

from __future__ import annotations

import argparse
from pathlib import Path

from numerics.cli import maps, plans, responses
from numerics.cli.flags import positive

_Subcommands = argparse._SubParsersAction  # what add_subparsers returns has no public name


def add_control(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    """Add response, response-map, track, move and ring."""
    _add_response(subcommands)
    _add_response_map(subcommands)
    track = _of_a_scene(subcommands, "track", "the force under which body 2 follows a reference, as a scene")
    track.set_defaults(run=plans.print_tracking)
    track.add_argument("--reference", required=True, metavar="FILE", help="TOML file of [[reference]] pieces, in m")
    track.add_argument("--out", type=Path, metavar="F", help="write the scene to F instead of printing it")
    move = _of_a_scene(subcommands, "move", "the fastest transfer from rest to rest, its force as a scene")
    move.set_defaults(run=plans.print_transfer)
    move.add_argument("--distance", required=True, metavar="D", help="how far body 2 goes, m; below 0: backwards")
    move.add_argument("--amplitude", metavar="U", help="the force stays within -U and U, N")
    move.add_argument("--margin", default="0", metavar="E", help="the load stays within (1 - E) b (%(default)s)")
    move.add_argument("--out", type=Path, metavar="F", help="write the scene to F instead of printing it")
    ring = _of_a_scene(subcommands, "ring", "when the relative motion enters its tolerance ring for good")
    ring.set_defaults(run=plans.print_ring)
    ring.add_argument("--radius", required=True, metavar="R", help="radius of the ring about the limit of x1 - x2, m")
    ring.add_argument(
        "--rate", default="1", metavar="W", help="divides v1 - v2, to make metres of it, 1/s (%(default)s)"
    )


def _of_a_scene(subcommands: _Subcommands[argparse.ArgumentParser], name: str, what: str) -> argparse.ArgumentParser:
    """Return the parser of a question about one scene, answered to some digits, printed or drawn."""
    asked = subcommands.add_parser(name, help=what, allow_abbrev=False)
    asked.add_argument("scene", metavar="SCENE", help="TOML file, or the short name of a shipped scene")
    asked.add_argument("--digits", type=positive, default=15, metavar="N", help="right digits wanted (%(default)s)")
    asked.add_argument(
        "--max-digits",
        type=positive,
        metavar="N",
        help="cap on the working digits (16 times the right digits wanted; 2000 where that takes milliseconds)",
    )
    asked.add_argument("--json", action="store_true", help="print the answer as JSON")
    asked.add_argument("--plot", type=Path, metavar="F", help="write a figure: .svg, .pdf or .png")
    return asked


def _add_response(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    what = "what the pair does in the long run under its periodic force: thresholds, periodic motion, multipliers"
    asked = _of_a_scene(subcommands, "response", what)
    asked.set_defaults(run=responses.print_response)
    asked.add_argument(
        "--amplitude",
        metavar="U",
        help="amplitude of the sine, N, in place of the scene's; with --omega also for a scene without a force",
    )
    asked.add_argument(
        "--omega",
        metavar="W",
        help="frequency of the sine, rad/s, in place of the scene's; with --amplitude also for a scene without a force",
    )
    asked.add_argument(
        "--max-events",
        type=positive,
        default=10_000,
        metavar="N",
        help="cap on the events in the search for the periodic motion; a period may have a fifth (%(default)s)",
    )


def _add_response_map(subcommands: _Subcommands[argparse.ArgumentParser]) -> None:
    chart = subcommands.add_parser(
        "response-map",
        help="which regime a sine brings, over frequency and amplitude, in proved cells",
        allow_abbrev=False,
    )
    chart.set_defaults(run=maps.chart_response)
    chart.add_argument("scene", metavar="SCENE", help="scene whose pair is taken; its force is ignored")
    chart.add_argument("--amplitude", nargs=2, required=True, metavar=("A", "B"), help="range of the amplitude, N")
    chart.add_argument("--omega", nargs=2, required=True, metavar=("A", "B"), help="range of the frequency, rad/s")
    add_map_roads(chart)


def add_map_roads(chart: argparse.ArgumentParser) -> None:
    """Add what all maps take: depth, roads, checkpoint, output."""
    chart.add_argument(
        "--depth", type=positive, default=10, metavar="N", help="cells down to 2^-N of each side (%(default)s)"
    )
    chart.add_argument(
        "--jobs", type=positive, default=1, metavar="N", help="processes that share the work (%(default)s)"
    )
    chart.add_argument("--dask", metavar="ADDRESS", help="compute on the Dask cluster of this scheduler instead")
    chart.add_argument("--resume", type=Path, metavar="F", help="keep finished blocks in F, and go on from there")
    chart.add_argument("--out", type=Path, metavar="FIGURE", help="write a figure: .svg, .pdf or .png")
    chart.add_argument("--json", action="store_true", help="print all cells as JSON")
