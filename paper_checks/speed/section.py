"""The chapter on speed and accuracy. Times come from a recorded trade; forward Euler's runs are computed, the same each time.

A sentence that other numbers would make false says what the numbers say: who is faster is counted, not remembered.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from matplotlib.figure import Figure

from numerics.scene.file import load_scene
from numerics.trade.command import seconds_text
from numerics.trade.euler import STEPS, EulerFigure, euler_figure, stick_energy
from numerics.trade.figure import draw_trade
from numerics.trade.recorded import Lead, Run, Trade
from numerics.trade.scenes import HEADLINE, LONG
from paper_checks.drawing.style import Figures, house_style
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Picture, Points, Section, Table

ID, TITLE, WORK_PRECISION = "speed-and-accuracy", "Speed and accuracy", "work-precision"
EULER_SCENES = {
    "4 (a)": "start-at-6mm",
    "4 (b), and 5 (b) with b = 0.5 N": "start-with-speed",
    "5 (a), and 5 (b) with b = 0.05 N": "velocities",
    "5 (b) with b = 0.2 N": "relative-motion-b02",
    "3 (a)": "itinerary-that-merges",
    "3 (b)": "itinerary-that-creeps",
}
"""The shipped scene that a figure of the paper shows."""


def section(trade: Trade) -> Section:
    """Return the whole chapter; who is faster comes first."""
    free, forced = (trade.names(forced=one) for one in (False, True))
    blocks: list[Block] = [
        Points((
            f"Without a force, {race(trade, free, beyond=False)}",
            f"Under a force, {race(trade, forced, beyond=False)}",
            f"With more digits than float64 has, {race(trade, [*free, *forced], beyond=True)}",
            *events(trade),
            *costs(trade),
        )),
        *(table(trade, names, what) for names, what in ((free, "without a force"), (forced, "under a force")) if names),
        Picture(
            WORK_PRECISION,
            "One panel for each scene: the further up and to the left, the better. Filled: the events are right; hollow: they are wrong, "
            "however many digits agree. The last panel: time for an excursion on longer and longer horizons; flat is good.",
            "Right digits against time",
        ),
        *provenance(trade),
        Heading("Where forward Euler misleads"),
        *misled(euler_figures()),
    ]  # fmt: skip
    return Section(ID, TITLE, tuple(blocks))


def figures(trade: Trade) -> Figures:
    """Return how the figure of a trade is drawn in the house style, two panels a row."""

    @house_style()
    def draw() -> Figure:
        return draw_trade(trade, columns=2, panel_size=(4.1, 2.5))

    return {WORK_PRECISION: draw}


def race(trade: Trade, names: Sequence[str], *, beyond: bool) -> str:
    """Say who is faster at equal or better accuracy, among runs that are no finer than our float64, or finer."""
    found: dict[str, Lead] = {}
    for name in names:
        own = max((one.digits or 0.0 for one in trade.of(name, "solve") if one.setting == 0), default=0.0)
        some = [one for one in trade.leads(name) if ((one.peer.digits or 0.0) > own) is beyond]
        found |= {name: some[0]} if some else {}
    lost = {name: one for name, one in found.items() if one.ratio < 1}
    count = f"{len(found)} scenes where a peer has the events right"
    if not found:
        return "no peer was measured that has the events right."
    if not lost:
        name, least = min(found.items(), key=lambda item: item[1].ratio)
        return f"ours is the fastest on all {count}: at least {least.ratio:.3g} times as fast as {least.peer.who}, on {name}."
    who = listed(dict.fromkeys(one.peer.who for one in lost.values()))
    most = max((1 / one.ratio for one in lost.values() if one.ratio), default=0.0)
    finer = [name for name, one in lost.items() if one.ours is None]
    factor = f", by a factor of up to {most:.3g}" if most else ""
    more = f"; on {listed(finer)} nobody of ours is as accurate" if finer else ""
    return f"ours is beaten on {len(lost)} of {count}, by {who}{factor}{more}."


def events(trade: Trade) -> Iterator[str]:
    """Say who has the event sequence right in every run."""
    judged = [one for one in trade.runs if one.right is not None]
    wrong = [one for one in judged if not one.right]
    bad = {one.who for one in wrong}
    good = list(dict.fromkeys(one.who for one in judged if one.who not in bad))
    yield f"Of {len(judged)} runs that ended {len(wrong)} have the events wrong; never one of {listed(good)}."
    for one in (one for one in wrong if one.ours):
        yield f"Ours is wrong: {one.who} with {one.setting:g} digits on {one.scene} ({one.note})."


def costs(trade: Trade) -> Iterator[str]:
    """Say what our digits cost, and long horizons."""
    balls = [one for one in trade.of(HEADLINE, "ball") if one.right and one.seconds]
    plain = [one for one in trade.of(HEADLINE, "solve") if one.right and one.seconds]
    if plain and balls:
        first, last = plain[0], balls[-1]
        yield (
            f"On {HEADLINE} `solve(scene)` takes {time(first)} and has {first.digits or 0:.0f} digits right; balls take "
            f"{time(balls[0])} with {balls[0].setting:,.0f} digits asked for, and {time(last)} with {last.setting:,.0f}, every radius proved."
        )
    far = [
        one
        for one in trade.runs
        if one.who == "solve" and one.setting == 0 and one.scene.startswith(LONG) and one.seconds
    ]
    each = sorted((int(one.scene.removeprefix(LONG)), one.seconds or 0.0) for one in far)
    if len(each) > 1:
        (few, short), *_, (many, long) = each
        yield f"An excursion costs {seconds_text(short / few)} where there are {few:,}, and {seconds_text(long / many)} where there are {many:,}."


def table(trade: Trade, names: Sequence[str], what: str) -> Table:
    """Return who has the events right where, with how many digits and how fast beside ours."""
    shown = [name for name in names if len({one.who for one in trade.of(name)}) > 1]
    who = dict.fromkeys(one.who for name in shown for one in trade.of(name))
    rows = tuple((one, *(cell(trade, name, one) for name in shown)) for one in who)
    caption = (
        f"Scenes {what}: runs with the right events, of those measured; the most right digits of these; and the time of that run, "
        "of a peer as a multiple of our fastest one that is as accurate (– if none is)"
    )
    return Table(("who", *shown), rows, caption)


def cell(trade: Trade, scene: str, who: str) -> str:
    """Return how many runs are right, and of the best of them its digits and its time, of a peer beside ours."""
    runs = trade.of(scene, who)
    right = [one for one in runs if one.right and one.digits is not None]
    judged = [one for one in runs if one.right is not None]
    if not right:
        return f"0/{len(judged)}" if judged else next((one.note.partition(" ")[0] for one in runs), "–")
    best = max(right, key=lambda one: one.digits or 0.0)
    ratios = {one.peer: one for one in trade.leads(scene)}
    lead = ratios.get(best)
    took = time(best) if best.ours else f"{lead.ratio:.3g}×" if lead and lead.ours else "–"
    return f"{len(right)}/{len(judged)}: {best.digits:,.0f}, {took}"


def provenance(trade: Trade) -> Iterator[Block]:
    """Yield on what it was measured, how errors are judged, and how to measure another machine."""
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    missing = "; ".join(f"{name} (needs {what})" for name, what in trade.left_out.items())
    yield Paragraph(
        f"Measured once: {of['processor']}, {of['cores']} cores, load {of.get('load')}, Python {of['python']}, {versions}."
        f"{f' Left out: {missing}.' if missing else ''} Times are medians of warm runs, compilation apart; the answer is read. Digits are those of the "
        "worst error against balls: of the final state in units of $L$ and $L\\Omega$, of the events' times, of the dissipated energy. "
        "An integrator is used at its best: restarted at every event and jump, in coordinates that lose nothing."
    )
    yield Paragraph(
        "`python -m numerics trade --out F` measures your machine and draws the figure; `python -m numerics trade --json > F`, then "
        "`python -m paper_checks report --trade F`, puts it here."
    )


@cache
def euler_figures() -> dict[str, EulerFigure]:
    """Return what forward Euler makes of every figure; takes seconds, once a process."""
    return {figure: euler_figure(load_scene(name)) for figure, name in EULER_SCENES.items()}


def misled(found: dict[str, EulerFigure]) -> Iterator[Block]:
    """Yield the energy that forward Euler makes in stick, and the steps that each figure needs."""
    energies = [
        f"{stick_energy(step)[0]:.4g} (by theory {stick_energy(step)[1]:.4g}) with {step:g} s"
        for step in (1e-2, 1e-3, 1e-4)
    ]
    yield Paragraph(
        "Exactly, a stuck pair keeps its energy. Where forward Euler holds $v_1=v_2$, each step $h$ multiplies it by $1+(h\\Omega)^2$: in Fig. 4 (a), "
        f"over the whole run, by {listed(energies)}. Elsewhere it does not stick but chatters: $v_1-v_2$ changes its sign back and forth within the "
        f"sliding region. Steps from {STEPS[0]:g} to {STEPS[-1]:g} s were tried; a step counts only if all finer ones are right too."
    )
    rows = tuple(
        (f"Fig. {name}", str(one.events), *(step(one.right_from(digits)) for digits in (-1e9, 2, 3)),
         *(f"{one.outcomes[k].chatter:,}" for k in (0, -1)))
        for name, one in found.items()
    )  # fmt: skip
    head = (
        "figure",
        "events",
        "right events from",
        "error of 1 %",
        "error of $10^{-3}$",
        "sign changes, coarsest",
        "finest",
    )
    yield Table(head, rows, "The step (s) that forward Euler needs, and its sign changes within the sliding region")


def step(found: float | None) -> str:
    """Return a step, or that none of those tried is fine enough."""
    return "finer than tried" if found is None else f"{found:g}"


def time(one: Run) -> str:
    """Return the time of a run with its unit."""
    return seconds_text(one.seconds).replace(" us", " µs")


def listed(names: Sequence[str] | dict[str, None]) -> str:
    """Return names as a sentence has them.

    >>> listed(["a", "b", "c"]), listed(["a"]), listed([])
    ('a, b and c', 'a', 'none')
    """
    *most, last = [*names] or ["none"]
    return f"{', '.join(most)} and {last}" if most else last
