"""The chapter on speed and accuracy. Times come from a recorded trade; forward Euler's runs are computed, the same each time.

A sentence that other numbers would make false says what the numbers say: who is faster is counted, not remembered.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from statistics import median

from matplotlib.figure import Figure

from numerics.trade.command import error_text, seconds_text
from numerics.trade.contenders import BALLS, FLOAT64
from numerics.trade.figure import draw_trade
from numerics.trade.recorded import Trade
from paper_checks.drawing.style import Figures, house_style
from paper_checks.report.content import euler_lessons
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Picture, Points, Section, Table
from paper_checks.report.content.phrases import listed

ID, TITLE, WORK_PRECISION = "speed-and-accuracy", "Speed and accuracy", "work-precision"
PEER = "heyoka"
"""Whom ours is measured against."""


def section(trade: Trade) -> Section:
    """Return the whole chapter; who is faster comes first."""
    blocks: list[Block] = [
        Points((*answers(trade), *events(trade))),
        Picture(
            WORK_PRECISION,
            "All scenes in one picture: the further up and to the left, the better. A small mark is a method with a setting on a scene, a large "
            "one the median over all scenes. Hollow: an event is wrong, however many digits agree.",
            "Right digits against time",
        ),
        Table(
            ("scene", "events", "float64", "error", PEER, "error", "its time by ours"),
            tuple(lines(trade)),
            f"float64 and the fastest run of {PEER} that is as accurate, or else its most accurate one, in double or long double",
        ),
        *provenance(trade),
        Heading("Where forward Euler misleads"),
        *euler_lessons.blocks(),
    ]  # fmt: skip
    return Section(ID, TITLE, tuple(blocks))


def answers(trade: Trade) -> Iterator[str]:
    """Say who is faster in float64, and what more digits cost."""
    leads = {scene: lead for scene in trade.scenes if (lead := trade.lead(scene))}
    yield told({scene: lead.ratio for scene, lead in leads.items()})
    refused = [one.scene for one in trade.rows if one.method == FLOAT64 and one.seconds is None]
    if refused:
        yield f"On {listed(refused)} float64 has no answer: its bound does not tell the next event, and balls follow."
    balls = [one for one in trade.rows if one.method == BALLS and one.right and one.ratio]
    costs = [
        f"{digits:g} cost {median(one.ratio or 0 for one in balls if one.setting == digits):,.0f} times"
        for digits in dict.fromkeys(one.setting for one in balls)
    ]
    if costs:
        yield f"Digits that are proved, in balls, by the time of float64 in the median: {listed(costs)}."


def told(ratios: Mapping[str, float]) -> str:
    """Say who wins, from the ratios of scenes: how many times as fast as the peer ours is."""
    if not ratios:
        return "No other program was measured."
    least, middle = min(ratios, key=lambda name: ratios[name]), median(ratios.values())
    typical = f"in the median {'float64' if middle >= 1 else PEER} is {max(middle, 1 / middle):.3g} times as fast"
    low, lost, every = ratios[least], sum(one < 1 for one in ratios.values()), len(ratios)
    if not lost:
        return (
            f"On all {every} scenes float64 is faster than {PEER}, by at least {low:.3g} times (on {least}); {typical}."
        )
    return f"On {lost} of {every} scenes {PEER} is faster than float64, by up to {1 / low:.3g} times (on {least}); {typical}."


def lines(trade: Trade) -> Iterator[tuple[str, ...]]:
    """Yield a line for each scene."""
    for scene, what in trade.scenes.items():
        if lead := trade.lead(scene):
            cells = (text for one in lead[2:0:-1] for text in (seconds_text(one.seconds), error_text(one.digits)))
            yield f"{scene}: {what}", str(lead.ours.found), *cells, f"{lead.ratio:.3g}"


def figures(trade: Trade) -> Figures:
    """Return how the figure of a trade is drawn in the house style."""

    @house_style()
    def draw() -> Figure:
        return draw_trade(trade)

    return {WORK_PRECISION: draw}


def events(trade: Trade) -> Iterator[str]:
    """Say who has the event sequence right in every run."""
    ended = [one for one in trade.rows if one.seconds is not None]
    wrong = [one for one in ended if not one.right]
    good = [name for name in dict.fromkeys(one.method for one in ended) if name not in {one.method for one in wrong}]
    yield f"Of {len(ended)} runs that ended {len(wrong)} have an event wrong; never one of {listed(good)}."
    for one in (one for one in wrong if one.ours):
        yield f"Ours is wrong: {one.method} with {one.setting:g} digits on {one.scene} ({one.note})."


def provenance(trade: Trade) -> Iterator[Block]:
    """Yield on what it was measured, how errors are judged, and how to measure another machine."""
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    missing = "; ".join(f"{name} ({why})" for name, why in trade.left_out.items())
    busy = " Other programs ran at the same time: ratios hold, times are too long." if of.get("busy") else ""
    yield Paragraph(
        f"Measured once: {of['processor']}, {of['cores']} cores, load {of.get('load')}, Python {of['python']}, {versions}.{busy}"
        f"{f' Left out: {missing}.' if missing else ''} Times are medians of warm runs, compilation apart, in turns with float64; the answer is read. "
        "Errors are the worst against a proved run: of event times relative to the last one, of states at events and horizon relative to the largest "
        "position and velocity. An integrator is used at its best: restarted at every event and jump, in coordinates that lose nothing."
    )
    yield Paragraph(
        "`python -m numerics trade SCENE` measures a scene of yours, on your machine, and `--plot F` draws it; `python -m numerics trade --json > F`, then "
        "`python -m paper_checks report --trade F`, puts your measurement here."
    )
