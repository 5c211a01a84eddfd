"""Which of our arithmetics for which need, and what a right digit costs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from numerics.run.one import MAX_EVENTS
from numerics.solver.solve import solve
from numerics.trade.front import Point
from numerics.trade.growth import Growth
from numerics.trade.ours import BALL, COMPILED, MPMATH, PARTS, PLAIN, READ
from numerics.trade.recorded import RecordedScene, RecordedTrade
from numerics.trade.scenes import Benchmark, benchmarks
from paper_checks.report.content.blocks import Block, Paragraph, Table
from paper_checks.speed.wording import asked, digits, factor_text, groups, headline, listed, spread, time_text

NEEDS = (*range(1, 16), 20, 25, 30, 50, 100, 300, 1000, 3000, 10_000)
"""Right digits that a reader may need."""
BINARY64_DIGITS = 17
"""What binary64 has where nothing was rounded."""


@dataclass(frozen=True)
class Choice:
    """The method that is right to so many digits on all of some scenes, and its longest time on one of them, s."""

    contender: str
    name: str
    """with its setting"""
    seconds: float


def cheapest(trade: RecordedTrade, scenes: Sequence[RecordedScene], need: int) -> Choice | None:
    """Return our fastest call and setting with right events and so many right digits on each of the scenes."""
    slowest: dict[tuple[str, float], list[Point]] = {}
    for scene in scenes:
        for one in trade.points(scene):
            if one.ours and one.contender not in PARTS and one.right and digits(one.error) >= need:
                slowest.setdefault((one.contender, one.setting), []).append(one)
    enough = [max(some, key=lambda one: one.seconds) for some in slowest.values() if len(some) == len(scenes)]
    best = min(enough, key=lambda one: one.seconds, default=None)
    return None if best is None else Choice(best.contender, asked(trade, best), best.seconds)


def choices(trade: RecordedTrade) -> list[tuple[int, dict[str, Choice | None]]]:
    """Return, up to how many digits which methods are cheapest: needs with the same answer are one row."""
    answers = [
        (need, {name: cheapest(trade, scenes, need) for name, scenes in groups(trade).items()}) for need in NEEDS
    ]
    rows = [list(some) for _, some in groupby(answers, key=lambda one: one[1])]
    return [row[-1] for row in rows if any(row[-1][1].values())]


def needs(trade: RecordedTrade) -> Iterator[Block]:
    """Yield the table of choices, and what mpmath and the balls add to speed."""
    head = ("right digits", *groups(trade))
    lines = tuple(
        (f"up to {need:,}", *("none measured" if one is None else f"{one.name}: {time_text(one.seconds)}"
                              for one in row.values()))
        for need, row in choices(trade)
    )  # fmt: skip
    yield Table(
        head,
        lines,
        "The cheapest call for the right events and so many right digits on each scene of a kind; its time on the slowest of them, warm, the answer read",
    )
    best = max(
        (one for one in trade.points(headline(trade)) if one.ours and one.right), key=lambda p: -p.error, default=None
    )
    if best is not None:
        yield Paragraph(
            "`solve(scene, digits=N)` goes from one arithmetic to the next by error bounds, not by such measurements; "
            f"`.tried` says why. The most that was measured on {headline(trade).name} is {digits(best.error):,} right "
            f"digits in {time_text(best.seconds)} "
            f"({asked(trade, best)}). Whoever needs a proof takes balls: only there is every radius proved."
        )
    yield from _independent_check(trade)


def _independent_check(trade: RecordedTrade) -> Iterator[Paragraph]:
    """Say what the second opinion of mpmath costs, at each setting that both have."""
    points = {(one.contender, one.setting): one for one in trade.points(headline(trade)) if one.right}
    both = [setting for name, setting in points if name == MPMATH and (BALL, setting) in points]
    if both:
        costs = [points[MPMATH, one].seconds / points[BALL, one].seconds for one in both]
        yield Paragraph(
            "mpmath shares no arithmetic with the balls, so it is the independent check: at "
            f"{spread(f'{min(both):,.0f}', f'{max(both):,.0f}')} digits it takes "
            f"{spread(factor_text(min(costs)), factor_text(max(costs)))} times as long."
        )


@dataclass(frozen=True)
class Bounded:
    """What float64 says of itself on a scene: digits of each number, and on the yardstick of the trade."""

    scene: str
    each: int
    worst: int
    certain: bool


def bounded(name: str) -> Bounded | None:
    """Return the digits that float64's own error bounds leave on a scene of the trade; None where it has none."""
    benchmark = _benchmark(name)
    if benchmark is None:
        return None
    record = solve(benchmark.scene, max_events=4 * MAX_EVENTS).record
    x, place, v1, v2, spent = (record.end_code(f"{one}_error") for one in ("x", "place", "v1", "v2", "spent"))
    taken = record.end("spent")
    worst = max(x + place, v1, v2, spent / taken if taken else 0.0)  # in L and L Omega, as the trade has it
    return Bounded(name, int(record.end_code("digits")), _digits_of(worst), record.end_code("certain") == 1)


def _digits_of(error: float) -> int:
    return digits(math.log10(error)) if error > 0 else BINARY64_DIGITS


def _benchmark(name: str) -> Benchmark | None:
    """Return the scene that a trade calls by this name."""
    start, _, count = name.rpartition("-")
    excursions = int(count) if start == "long" and count.isdigit() else 1
    return next((one for one in benchmarks(excursions) if one.name == name), None)


def float64_is_enough(trade: RecordedTrade) -> Iterator[Block]:
    """Yield up to how many digits float64 is enough, by its own bounds and as measured."""
    found = [one for scene in trade.scenes if (one := bounded(scene.name)) is not None]
    measured = {one.scene: _measured(trade, one.scene) for one in found}
    lines = tuple((one.scene, str(one.each), str(one.worst), measured[one.scene]) for one in found)
    if not lines:
        return
    some = {title: [one for one in found if one.scene in {scene.name for scene in scenes}]
            for title, scenes in groups(trade).items()}  # fmt: skip
    least = [f"{min(one.worst for one in few)} on {title}" for title, few in some.items() if few]
    open_ones = [one.scene for one in found if not one.certain]
    doubt = f" They leave the sequence of events open on {listed(open_ones)}." if open_ones else ""
    yield Paragraph(
        "float64 bounds its own errors. By these bounds the final state, in units of $L$ and $L\\Omega$, and the "
        f"dissipated energy have this many right digits at least: {listed(least)}.{doubt}"
    )
    yield Table(
        ("scene", "of each number by itself, by its bounds", "of the worst, by its bounds", "of the worst, measured"),
        lines,
        "Right digits of float64. The first column counts relative to each number, event by event, and is what "
        "`digits=N` goes by: a number close to 0 has few digits of its own",
    )


def _measured(trade: RecordedTrade, scene: str) -> str:
    errors = [
        one.error
        for one in trade.runs
        if one.scene == scene
        and one.ours
        and one.right
        and one.error is not None
        and one.contender in (COMPILED, PLAIN, READ)
    ]
    return str(digits(max(errors))) if errors else "not measured"


def price_of_digits(trade: RecordedTrade) -> Iterator[Block]:
    """Yield what an event costs at more and more digits, beside one arb.sin_cos."""
    curve = [one for one in trade.growth if one.axis == "digits" and one.seconds_per_event]
    names = list(dict.fromkeys(one.contender for one in curve))
    balls = sorted((one for one in curve if one.contender == BALL), key=lambda one: one.x)
    if len(balls) > 1 and balls[0].seconds_per_event and balls[-1].seconds_per_event:
        first, last = balls[0], balls[-1]
        more = (last.seconds_per_event or 0.0) - (first.seconds_per_event or 0.0)
        yield Paragraph(
            f"In balls an event costs {time_text(first.seconds_per_event or 0.0)} at {first.x:,.0f} digits and "
            f"{time_text(last.seconds_per_event or 0.0)} at {last.x:,.0f}: {_each(more / (last.x - first.x))} "
            "for each further digit of every number."
        )
    rows = tuple(
        (f"{x:,.0f}", *_price_row([one for one in curve if one.x == x], names))
        for x in sorted({one.x for one in curve})
    )
    if rows:
        head = ("digits", "one arb.sin_cos", *(f"{name}, an event (in sin_cos)" for name in names))
        yield Table(head, rows, "What digits cost, on the headline scene")


def _each(seconds: float) -> str:
    return time_text(seconds) if seconds > 0 else "nothing that could be measured"


def _price_row(here: Sequence[Growth], names: Sequence[str]) -> Iterator[str]:
    sine = next((one.sine_cosine_seconds for one in here if one.sine_cosine_seconds), None)
    yield "–" if sine is None else time_text(sine)
    for name in names:
        each = next((one.seconds_per_event for one in here if one.contender == name), None)
        if each is None:
            yield "–"
        else:
            yield time_text(each) + (f" ({factor_text(each / sine)})" if sine else "")
