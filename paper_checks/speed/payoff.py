"""When the compiled path and the batch pay, and how cost grows with events and mass ratio."""

from __future__ import annotations

import math
from collections.abc import Iterator

from numerics.trade.growth import Growth
from numerics.trade.ours import COMPILED, PLAIN, READ
from numerics.trade.recorded import RecordedRun, RecordedTrade
from paper_checks.report.content.blocks import Block, Points, Table
from paper_checks.speed.wording import counted, factor_text, headline, time_text


def payoff(trade: RecordedTrade) -> Iterator[Block]:
    """Yield a sentence each on compiling, on batches and on cores; a table on many events and extreme mass ratios."""
    sentences = (*_compiled(trade), *_batch(trade), *_cores(trade))
    if sentences:
        yield Points(sentences)
    yield from _growth(trade)


def _run(trade: RecordedTrade, contender: str) -> RecordedRun | None:
    scene = headline(trade).name
    return next(
        (one for one in trade.runs if (one.contender, one.scene) == (contender, scene) and one.seconds is not None),
        None,
    )


def _compiled(trade: RecordedTrade) -> Iterator[str]:
    compiled, plain = _run(trade, COMPILED), _run(trade, PLAIN)
    if COMPILED in trade.left_out:
        yield f"The compiled path was not measured: it needs {trade.left_out[COMPILED]}."
    elif compiled and plain and compiled.seconds and plain.seconds:
        gain = plain.seconds - compiled.seconds
        yield (
            f"On {headline(trade).name} the run inside takes {time_text(compiled.seconds)} compiled and "
            f"{time_text(plain.seconds)} by Python: {factor_text(plain.seconds / compiled.seconds)} times as long."
        )
        prepared = max((one.prepare_seconds or 0.0) for one in trade.runs if one.contender == compiled.contender)
        if gain > 0:
            solves = math.ceil(prepared / gain)
            yield (
                f"To get ready (numba's import, and compiling or its cache) took up to {time_text(prepared)}: that is paid "
                f"back after {counted(solves, 'such solve', 'such solves')}."
            )
        else:
            yield "Compiling does not pay there."


def _batch(trade: RecordedTrade) -> Iterator[str]:
    alone = sorted(_curve(trade, "batch", cores=1), key=lambda one: one.x)
    call = _run(trade, READ)
    if not alone or call is None or not call.seconds:
        return
    last = alone[-1]
    pays = next((one.x for one in alone if _each(one) < call.seconds), None)
    start = "`solve_many` never undercuts" if pays is None else f"From {_scenes(pays)} on `solve_many` undercuts"
    ratio = call.seconds / _each(last)
    yield (
        f"{start} a loop over `solve(scene)`; with {_scenes(last.x)} it takes {time_text(_each(last))} a scene on one "
        f"core, right digits included, {factor_text(ratio)} times less than `solve(scene)`."
    )


def _cores(trade: RecordedTrade) -> Iterator[str]:
    alone = {one.x: one for one in _curve(trade, "batch", cores=1)}
    many = [one for one in _curve(trade, "batch", cores=None) if one.cores > 1 and one.x in alone]
    if many:
        last = max(many, key=lambda one: one.x)
        gain = _each(alone[last.x]) / _each(last)
        yield f"On {last.cores} cores a batch of {_scenes(last.x)} goes {factor_text(gain)} times as fast as on one."


def _growth(trade: RecordedTrade) -> Iterator[Table]:
    events, masses = dict(_curves(trade, "events")), dict(_curves(trade, "m1/m2"))
    rows = []
    for name in dict.fromkeys([*events, *masses]):
        few, many, spread = "–", "–", "–"
        if name in events:
            few, many = (
                f"{time_text(_each(one))} ({one.x:,.0f} events)" for one in (events[name][0], events[name][-1])
            )
        if name in masses:
            costs = [_each(one) for one in masses[name]]
            spread = f"{factor_text(max(costs) / min(costs))} times"
        rows.append((name, few, many, spread))
    if rows:
        ratios = [one.x for curve in masses.values() for one in curve] or [1.0]
        low, high = (f"$10^{{{round(math.log10(one))}}}$" for one in (min(ratios), max(ratios)))
        head = ("method", "an event of a short run", "an event of a long run", "slowest over fastest mass ratio")
        yield Table(
            head, tuple(rows), f"How cost grows with events, and over mass ratios $m_1/m_2$ from {low} to {high}"
        )


def _curve(trade: RecordedTrade, axis: str, cores: int | None) -> list[Growth]:
    return [one for one in trade.growth if one.axis == axis and one.seconds_per_event and cores in (None, one.cores)]


def _curves(trade: RecordedTrade, axis: str) -> Iterator[tuple[str, list[Growth]]]:
    """Yield the curves of more than one point along an axis, by contender."""
    found = _curve(trade, axis, None)
    for name in dict.fromkeys(one.contender for one in found):
        curve = sorted((one for one in found if one.contender == name), key=lambda one: one.x)
        if len(curve) > 1:
            yield name, curve


def _each(one: Growth) -> float:
    assert one.seconds_per_event is not None
    return one.seconds_per_event


def _scenes(count: float) -> str:
    return "one scene" if count == 1 else f"{count:,.0f} scenes"
