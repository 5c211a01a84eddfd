"""`python -m numerics map` and `response-map`: a window cut into cells, each with what is proved of it."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from numerics.exits import INTERRUPTED, OK, refuse
from numerics.shown import write_figure

if TYPE_CHECKING:
    from fractions import Fraction

    from numerics.free.quadtree import CellMap


def chart_merging(options: argparse.Namespace) -> int:
    """Compute the merging map of a window; print its summary or its cells, draw it."""
    from numerics.free.merging_map import Window, draw_map, merging_cells

    window = Window(_side(options, "ratio"), _side(options, "energy"))
    return _chart(options, partial(merging_cells, window, options.depth), draw_map)


def chart_response(options: argparse.Namespace) -> int:
    """Compute the response map of a scene's pair; print its summary or its cells, draw it."""
    from numerics.control.response_map import response_map
    from numerics.scene.file import load_line

    scene = load_line(options.scene)
    scene.require_one_b("a map of responses")
    compute = partial(response_map, scene.pair, options.amplitude, options.omega, options.depth)
    return _chart(options, compute, _drawn_response)


def _drawn_response(found: CellMap) -> Any:
    from numerics.control.pictures import draw_response_map

    return draw_response_map(found)


def _side(options: argparse.Namespace, name: str) -> tuple[Fraction, Fraction]:
    """Return the two ends of a side of the window, exactly. Raises InvalidScene."""
    from numerics.scene.decimals import exact_decimal

    low, high = (exact_decimal(one, name) for one in getattr(options, name))
    return low, high


def _chart(options: argparse.Namespace, compute: Callable[..., CellMap], draw: Callable[[Any], Any]) -> int:
    """Compute a map by the roads that were asked for, draw it, and print its cells or a summary."""
    progress = _show_blocks if sys.stderr.isatty() else None
    try:
        found = compute(jobs=options.jobs, dask=options.dask, resume=options.resume, progress=progress)
    except KeyboardInterrupt:
        if options.resume is None:
            raise
        return refuse(f"interrupted; finished blocks are in {options.resume}, the same command goes on", INTERRUPTED)
    if options.out is not None:
        write_figure(draw(found), options.out)
    if options.json:
        print(json.dumps(found.as_record()))
        return OK
    for verdict, share in found.shares().items():
        print(f"{verdict.name.lower().replace('_', '-'):10}{share:8.2%} of the window (logarithmic axes)")
    print(f"{len(found.leaves)} cells, sides down to 2^-{found.depth} of the window")
    return OK


def _show_blocks(done: int, blocks: int) -> None:
    """Show on stderr how many blocks of a map are done."""
    end = "\n" if done == blocks else ""
    print(f"\r{done} of {blocks} blocks ", end=end, file=sys.stderr, flush=True)
