"""What `python -m numerics trade` does; all heavy imports happen here, when it runs."""

from __future__ import annotations

import argparse
from statistics import median
from typing import Any

from numerics.exits import OK, USAGE, refuse
from numerics.shown import print_table, shown_steps, write_figure


def measure_trade(options: argparse.Namespace) -> int:
    """Measure speed against accuracy, or only the public functions against heyoka; print, write the figure."""
    from numerics.trade.contenders import CONTENDERS
    from numerics.trade.figure import draw_trade
    from numerics.trade.measure import NoSuchContender, trade

    some = [one for one in CONTENDERS if not options.interface or one.label.startswith(("solve", "ball", "heyoka"))]
    try:
        with shown_steps() as say:
            measured = trade(options.size, options.only, say, some)
    except NoSuchContender as error:
        return refuse(str(error), USAGE)
    if options.out is not None:
        write_figure(draw_trade(measured), options.out)
    if options.json:
        print(measured.text(), end="")
        return OK
    if not options.interface:
        print_trade(measured)
    print_ratios(measured)
    return OK


def print_ratios(trade: Any) -> None:
    """Print the speed relative to heyoka: minimum and median over the scenes, then each scene."""
    found = {what.replace("`", ""): ratios for what, ratios in trade.ratios().items()}
    lines = [
        (what, str(len(some)), f"{min(some.values()):.3g}", f"{median(some.values()):.3g}", min(some, key=some.get))
        for what, some in found.items()
    ]
    print_table(("speed relative to heyoka", "scenes", "minimum", "median", "minimum on"), lines)
    for what, some in found.items():
        print(f"{what}: {', '.join(f'{scene} {ratio:.3g}' for scene, ratio in some.items())}")
    for one in trade.sweeps:
        digits = f"{one.digits:.0f} digits; heyoka {one.peer_digits:.1f} digits, {one.peer_wrong} scenes wrong"
        print(f"{one.scene}, {one.size} scenes in one call: {one.ratio:.3g}, {digits}")


def print_trade(trade: Any) -> None:
    """Print one table per scene, the machine, and the integrators left out."""
    for scene, why in trade.scenes.items():
        lines = []
        for one in trade.of(scene):
            digits = "-" if one.digits is None else f"{one.digits:.1f}"
            lines.append((one.who, f"{one.setting:g}", seconds_text(one.seconds), digits, one.note or "right"))
        print(f"{scene}: {why}")
        print_table(("method", "setting", "time", "digits", "events"), lines)
        print()
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    print(f"{of['processor']}, {of['cores']} cores, load {of['load']}; Python {of['python']}, {versions}")
    print(
        "Times are CPU times of calls after a warm-up, alternating with solve(scene) in one process. Digits are those "
        "of the largest error: of the state at the horizon relative to L and L Omega, of the event times and, on a "
        "line, of the dissipated energy relative to themselves."
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
