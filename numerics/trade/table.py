"""What the trade found: as tables for a reader, and as plain records for JSON."""

from __future__ import annotations

from typing import Any

from numerics.trade.front import Lead, best_front, leads
from numerics.trade.growth import Growth
from numerics.trade.interface import Wait
from numerics.trade.measure import Measurement, Status
from numerics.trade.plan import Trade
from numerics.trade.scenes import HEADLINE, Benchmark


def as_record(trade: Trade) -> dict[str, Any]:
    """Return the trade as the JSON object of the interface."""
    return {
        "size": trade.size,
        "machine": trade.machine,
        "left_out": [{"contender": name, "missing": missing} for name, missing in trade.left_out.items()],
        "scenes": [{"scene": one.name, "why": one.why} for one in trade.scenes],
        "references": trade.references,
        "runs": [one.as_record() for one in trade.measurements],
        "front": [
            {"scene": scene.name, "contender": one.contender, "setting": one.setting, "seconds": one.seconds}
            | {"log10_error": one.error}
            for scene in trade.scenes
            for one in best_front(trade.points(scene))
        ],
        "leads": [one.as_record(scene.name) for scene in trade.scenes for one in leads(trade.points(scene))],
        "growth": [one.as_record() for one in trade.growth],
        "interface": [one.as_record() for one in trade.interface],
    }


def print_trade(trade: Trade, width: int | None) -> None:
    """Print a table a scene, the growth of the cost, and what was left out."""
    from rich.console import Console

    console = Console(width=width, highlight=False, markup=False)
    for scene in trade.scenes:
        _print_scene(console, trade, scene)
    if trade.growth:
        _print_growth(console, trade.growth)
    if trade.interface:
        _print_interface(console, trade.interface)
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    console.print(f"{of['processor']}, {of['cores']} cores; Python {of['python']}, {versions}")
    console.print(
        "Times are medians of warm runs; compilation and the exact conversion of the scene come before the clock, and "
        "so does making room for as many events as there will be in our runs inside, and loading what is compiled. "
        '"Ours faster" is said of what a user calls, and then of what runs inside. Errors are upper bounds: of the '
        "final state relative to L and L Omega, of the last event's time and of the dissipated energy relative to "
        "themselves. A star marks the front: right event sequences that no other right one beats in time and error."
    )
    for one in trade.contenders:
        if one.use:
            console.print(f"{one.label}: {one.use}")
    for name, missing in trade.left_out.items():
        console.print(f"left out: {name}: needs {missing}")


def _print_scene(console: Any, trade: Trade, scene: Benchmark) -> None:
    from rich.table import Table

    candidates = trade.points(scene)
    best = {(one.contender, one.setting) for one in best_front(candidates)}
    # how fast a run loses events is no comparison; --json has these ratios, too
    ahead = {(one.peer.contender, one.peer.setting): one for one in leads(candidates) if one.peer.right}
    console.print(f"{scene.name}: {scene.why}")
    proofs = [row for row in trade.references if row["scene"] == scene.name]
    took = ", ".join(
        f"{row['digits']} in {row['note'] if row['seconds'] is None else seconds_text(row['seconds'])}"
        for row in proofs
    )
    console.print(f"proved reference: {proofs[0]['events']} events; digits {took}")
    names = ("contender", "setting", "time", "state", "last event", "energy", "events", "ours faster", "inside", "", "")
    table = Table(*names, box=None, pad_edge=False)
    before = ""
    for one in (one for one in trade.measurements if one.scene == scene.name):
        if one.ran.status is Status.NOT_TRIED and before == one.contender:
            continue  # the line before says why; --json lists them
        key = (one.contender, one.setting)
        cells = _cells(one)
        name = "" if one.contender == before else one.contender
        table.add_row(name, *cells[:-1], *_faster(ahead.get(key)), "*" if key in best else "", cells[-1])
        before = one.contender
    console.print(table)
    console.print()


def _faster(lead: Lead | None) -> tuple[str, str]:
    ratios = (None, None) if lead is None else (lead.ratio, lead.ratio_inside)
    return tuple("" if one is None else f"{one:.3g} x" for one in ratios)  # type: ignore[return-value]


def _cells(one: Measurement) -> tuple[str, ...]:
    """Return setting, time, three errors, the word on the event sequence, and a note."""
    setting = f"{one.knob} {one.setting:g}"
    time = "" if one.ran.seconds is None else seconds_text(one.ran.seconds)
    if one.verdict is None:
        return setting, time, "", "", "", one.ran.status.value, one.ran.note
    errors = (error_text(part) for part in (one.verdict.state, one.verdict.last_event, one.verdict.energy))
    return setting, time, *errors, "right" if one.verdict.right else "WRONG", one.verdict.difference or one.ran.note


def seconds_text(seconds: float) -> str:
    """Return a time with its unit.

    >>> seconds_text(0.00123), seconds_text(4.5e-6), seconds_text(12.3)
    ('1.23 ms', '4.5 us', '12.3 s')
    """
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def error_text(log10: float | None) -> str:
    """Return an error from its decimal logarithm, which may be far below the range of a float.

    >>> error_text(-2.0), error_text(-1000.3), error_text(None), error_text(float("inf"))
    ('1e-2', '5e-1001', '-', 'no number')
    """
    if log10 is None:
        return "-"
    if log10 == float("inf"):
        return "no number"
    exponent = int(log10 // 1)
    mantissa = round(10 ** (log10 - exponent))
    return f"1e{exponent + 1}" if mantissa == 10 else f"{mantissa}e{exponent}"


def print_interface(waits: list[Wait], width: int | None) -> None:
    """Print what a user waits for at the public interface."""
    from rich.console import Console

    _print_interface(Console(width=width, highlight=False, markup=False), waits)


def _print_interface(console: Any, waits: list[Wait]) -> None:
    from rich.table import Table

    table = Table(f"on {HEADLINE}", "time", "by", "ratio", "at most", "", box=None, pad_edge=False)
    for one in waits:
        ratio = "" if one.ratio is None else f"{one.ratio:.3g}"
        most = "" if one.most is None else f"{one.most:g}" if one.ratio is not None else seconds_text(one.most)
        word = {None: "", True: "kept", False: "OVER"}[one.kept]
        table.add_row(one.call, seconds_text(one.seconds), one.by, ratio, most, word)
    console.print(table)
    console.print()


def _print_growth(console: Any, growth: list[Growth]) -> None:
    from rich.table import Table

    table = Table(
        "cost along", "contender", "at", "events", "per event", "sin_cos", "ratio", "", box=None, pad_edge=False
    )
    before = ("", "")
    for one in growth:
        record = one.as_record()
        here = (one.axis, one.contender)
        names = ("" if one.axis == before[0] else one.axis, "" if here == before else one.contender)
        ratio = record.get("sine_cosines_per_event")
        each, sine = (
            "" if part is None else seconds_text(part) for part in (one.seconds_per_event, one.sine_cosine_seconds)
        )
        events = "" if one.events is None else str(one.events)
        table.add_row(*names, f"{one.x:g}", events, each, sine, "" if ratio is None else f"{ratio:.3g}", one.note)
        before = here
    console.print(table)
    console.print()
