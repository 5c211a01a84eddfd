"""What `python -m numerics trade` does; all heavy imports happen here, when it runs."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import Any

from numerics.exits import OK
from numerics.meter import shown_steps
from numerics.shown import print_table, write_figure

MEANING = """Settings are digits, steps or tolerances. Times are processor times of warm calls, in turns with float64.
Errors are the largest, against a proved run: of event times relative to the last one, of states at events and horizon
relative to the largest position and velocity. Where an event is wrong they count for nothing."""


def measure_trade(options: argparse.Namespace) -> int:
    """Measure time against accuracy on a scene, or on those that are shipped for it; print, write the figure."""
    from numerics.scene.file import load_scene
    from numerics.trade.figure import draw_trade
    from numerics.trade.measure import benchmarks, trade

    scenes = {Path(options.scene).stem: (load_scene(options.scene), "")} if options.scene else benchmarks()
    with shown_steps() as say:
        measured = trade(scenes, options.digits, say)
    if options.plot is not None:
        write_figure(draw_trade(measured), options.plot)
    if options.json:
        print(measured.text(), end="")
    else:
        print_trade(measured)
    return OK


def print_trade(trade: Any) -> None:
    """Print one table per scene, the machine, and the contenders left out."""
    for scene, what in trade.scenes.items():
        print(f"{scene}: {what}".removesuffix(": "))
        print_table(
            ("method", "setting", "time", "by float64", "off", "events", ""),
            [
                (
                    one.method,
                    f"{one.setting:g}" if one.setting else "",
                    seconds_text(one.seconds),
                    "-" if one.ratio is None else f"{one.ratio:.3g}",
                    error_text(one.digits),
                    str(one.events),
                    one.note,
                )
                for one in trade.of(scene)
            ],
        )
        if lead := trade.lead(scene):
            ours, peer = (f"{one.method}, off by {error_text(one.digits)}" for one in (lead.ours, lead.peer))
            print(f"{ours}, is {lead.ratio:.3g} times as fast as {peer}")
        print()
    for name, why in trade.left_out.items():
        print(f"left out: {name}: {why}")
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    print(f"{of['processor']}, {of['cores']} cores, load {of['load']}; Python {of['python']}, {versions}")
    print(MEANING)


def error_text(digits: float | None) -> str:
    """Return the error of so many digits, however small.

    >>> error_text(12.3), error_text(1003.9), error_text(-0.2), error_text(None), error_text(1e6)
    ('5.0e-13', '1.3e-1004', '1.6e+00', '-', '0')
    """
    from numerics.trade.judge import NO_ERROR

    if digits is None:
        return "-"
    if digits > NO_ERROR - 1:
        return "0"
    return f"{10 ** (math.ceil(digits) - digits):.1f}e{-math.ceil(digits):+03d}"


def seconds_text(seconds: float | None) -> str:
    """Return a time with its unit.

    >>> seconds_text(0.00123), seconds_text(4.5e-6), seconds_text(12.3), seconds_text(None)
    ('1.23 ms', '4.5 us', '12.3 s', '-')
    """
    if seconds is None:
        return "-"
    unit, size = next((pair for pair in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)) if seconds >= pair[1]), ("ns", 1e-9))
    return f"{seconds / size:.3g} {unit}"
