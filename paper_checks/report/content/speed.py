"""What the chapter on speed says of a recorded trade: who is faster is counted, not remembered."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from statistics import median
from typing import Any

from matplotlib.figure import Figure

from numerics.trade.command import error_text, seconds_text
from numerics.trade.contenders import BALLS, FLOAT64
from numerics.trade.figure import draw_trade
from numerics.trade.recorded import Trade
from paper_checks.drawing.style import Figures, house_style
from paper_checks.report.content import phrases
from paper_checks.report.content.blocks import chapter
from paper_checks.report.content.phrases import listed

PEER = "heyoka"
"""Whom ours is measured against."""


def given(trade: Trade) -> dict[str, Any]:
    """Return what the chapter needs."""
    ended = [one for one in trade.rows if one.seconds is not None]
    wrong = [one for one in ended if not one.right]
    return {
        "answers": [*answers(trade)],
        "trade": trade,
        "leads": {scene: lead for scene in trade.scenes if (lead := trade.lead(scene))},
        "ended": ended,
        "wrong": wrong,
        "never_wrong": dict.fromkeys(one.method for one in ended if one.method not in {bad.method for bad in wrong}),
        "seconds": seconds_text,
        "error": error_text,
    }


def text(trade: Trade) -> str:
    """Return the chapter, by itself."""
    return chapter("speed-and-accuracy", say=phrases, **given(trade))


def answers(trade: Trade) -> Iterator[str]:
    """Say who is faster in float64, and what more digits cost."""
    yield told({scene: lead.ratio for scene in trade.scenes if (lead := trade.lead(scene))})
    refused = [one.scene for one in trade.rows if one.method == FLOAT64 and one.seconds is None]
    if refused:
        yield f"On {listed(refused)} float64 has no answer: its bound does not tell the next event, and balls follow."
    costs: dict[float, list[float]] = {}
    for one in trade.rows:
        if one.method == BALLS and one.right and one.ratio:
            costs.setdefault(one.setting, []).append(one.ratio)
    if costs:
        said = [f"{digits:g} cost {median(ratios):,.0f} times" for digits, ratios in costs.items()]
        yield f"Digits that are proved, in balls, by the time of float64 in the median: {listed(said)}."


def told(ratios: Mapping[str, float]) -> str:
    """Say who wins, from the ratios of scenes: how many times as long as ours the peer takes."""
    if not ratios:
        return "No other program was measured."
    won, least = sum(one > 1 for one in ratios.values()), min(ratios, key=lambda name: ratios[name])
    return (
        f"float64 is faster than {PEER} on {won} of {len(ratios)} scenes: {PEER} takes {median(ratios.values()):.3g} times as "
        f"long in the median, and {ratios[least]:.3g} times where it is best (on {least})."
    )


def figures(trade: Trade) -> Figures:
    """Return how the figure of a trade is drawn in the house style."""

    @house_style()
    def draw() -> Figure:
        return draw_trade(trade)

    return {"work-precision": draw}
