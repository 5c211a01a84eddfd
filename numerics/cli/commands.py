"""What the other subcommands of `python -m numerics` do; all heavy imports happen here, when a command runs."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from numerics.cli.printing import answer, number_lines
from numerics.cli.solving import LABELS
from numerics.exits import INTERRUPTED, OK, refuse
from numerics.shown import shown_steps, write_figure

if TYPE_CHECKING:
    from numerics.free.quadtree import CellMap


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
        *number_lines(shown),
        f"{options.digits} right digits of the energy and its excess, proved",
        *([f"{found.road.value} ({found.stepped} events computed one by one)"] if options.explain else []),
    ]
    answer(options, shown | way, lines)
    return OK


def chart_merging(options: argparse.Namespace) -> int:
    """Compute the merging map of a window; print its summary or its cells, draw it."""
    from numerics.free.merging_map import draw_map, merging_cells

    return _chart(options, partial(merging_cells, options.depth, options.ratio, options.energy), draw_map)


def chart_response(options: argparse.Namespace) -> int:
    """Compute the response map of a scene's pair; print its summary or its cells, draw it."""
    from numerics.control.response_map import response_map
    from numerics.scene.file import load_line

    scene = load_line(options.scene)
    scene.require_one_b("a response map")
    compute = partial(response_map, scene.pair, options.amplitude, options.omega, options.depth)
    code = _chart(options, compute, _drawn_response)
    if code == OK and scene.pair.a1 == 0 and not options.json:
        print("a1 = 0: entrained and non-stop say that some motion does so; other motions may differ")
    return code


def _drawn_response(found: CellMap) -> Any:
    from numerics.control.pictures import draw_response_map

    return draw_response_map(found)


def _chart(options: argparse.Namespace, compute: Callable[..., CellMap], draw: Callable[[Any], Any]) -> int:
    """Compute a map as the options say, draw it, and print its cells or a summary."""
    try:
        with shown_steps() as say:
            found = compute(
                jobs=options.jobs,
                dask=options.dask,
                resume=options.resume,
                progress=lambda done, blocks: say(f"{done} of {blocks} blocks"),
            )
    except KeyboardInterrupt:
        if options.resume is None:
            raise
        return refuse(f"interrupted; finished blocks are in {options.resume}, the same command resumes", INTERRUPTED)
    if options.out is not None:
        write_figure(draw(found), options.out)
    if options.json:
        print(json.dumps(found.as_record()))
        return OK
    for verdict, share in found.shares().items():
        print(f"{verdict.name.lower().replace('_', '-'):10}{share:8.2%} of the window (logarithmic axes)")
    print(f"{len(found.leaves)} cells, the smallest 2^-{found.depth} of the window")
    return OK
