"""What `python -m numerics trade` does; all heavy imports happen here, when it runs."""

from __future__ import annotations

import argparse
import json
from statistics import median
from typing import Any

from numerics.exits import OK, USAGE, refuse
from numerics.shown import print_table, shown_steps, write_figure


def measure_trade(options: argparse.Namespace) -> int:
    """Measure speed against accuracy, or the public interface beside heyoka; print tables or JSON, write the figure."""
    from numerics.trade.figure import draw_trade
    from numerics.trade.interface import ratios
    from numerics.trade.measure import NoSuchContender, trade

    if options.interface:
        found = list(ratios())
        if options.json:
            print(json.dumps([one._asdict() for one in found], indent=1))
        else:
            print_ratios(found)
        return OK
    try:
        with shown_steps() as say:
            measured = trade(options.size, options.only, say)
    except NoSuchContender as error:
        return refuse(str(error), USAGE)
    if options.out is not None:
        write_figure(draw_trade(measured), options.out)
    if options.json:
        print(measured.text(), end="")
    else:
        print_trade(measured)
    return OK


def print_ratios(found: Any) -> None:
    """Print the least and the median ratio of each comparison over its scenes, and what is not that simple."""
    lines = []
    for what in dict.fromkeys(one.what for one in found):
        known = sorted((one.ratio, one.scene) for one in found if one.what == what and one.ratio is not None)
        cells = (f"{known[0][0]:.3g}", f"{median(ratio for ratio, _ in known):.3g}", known[0][1]) if known else ()
        lines.append((what, str(len(known)), *cells))
    print_table(("how many times as fast as heyoka", "scenes", "least", "median", "least on"), lines)
    for one in found:
        print(f"{one.what}, {one.scene}: {one.ratio or 0:.3g} {one.note}")


def print_trade(trade: Any) -> None:
    """Print a table a scene, the machine, and what was left out."""
    for scene, why in trade.scenes.items():
        ahead, lines = {one.peer: one for one in trade.leads(scene)}, []
        for one in trade.of(scene):
            digits = "-" if one.digits is None else f"{one.digits:.1f}"
            ratio = f"{ahead[one].ratio:.3g} x" if one in ahead and ahead[one].ours else ""
            times = (seconds_text(one.seconds), seconds_text(one.deviation))
            lines.append((one.who, f"{one.setting:g}", *times, digits, "right" if one.right else one.note, ratio))
        print(f"{scene}: {why}")
        print_table(("", "setting", "time", "+-", "digits", "events", "ours faster"), lines)
        print()
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    print(f"{of['processor']}, {of['cores']} cores, load {of['load']}; Python {of['python']}, {versions}")
    print(
        "Times are medians of warm calls in fresh processes. Digits are those of the worst error: of the state at the "
        "horizon relative to L and L Omega, of the events' times and of the dissipated energy relative to themselves."
    )
    for name, missing in trade.left_out.items():
        print(f"left out: {name}: needs {missing}")


def seconds_text(seconds: float | None) -> str:
    """Return a time with its unit.

    >>> seconds_text(0.00123), seconds_text(4.5e-6), seconds_text(12.3), seconds_text(None)
    ('1.23 ms', '4.5 us', '12.3 s', '-')
    """
    if seconds is None:
        return "-"
    unit, size = next((pair for pair in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)) if seconds >= pair[1]), ("ns", 1e-9))
    return f"{seconds / size:.3g} {unit}"
