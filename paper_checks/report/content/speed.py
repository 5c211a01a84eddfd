"""The chapter on speed and accuracy. Times come from a recorded trade; forward Euler's runs are computed, the same each time.

A sentence that other numbers would make false says what the numbers say: who is faster is counted, not remembered.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from statistics import median

from matplotlib.figure import Figure

from numerics.scene.file import load_scene
from numerics.trade.euler import STEPS, EulerFigure, euler_figure, stick_energy
from numerics.trade.figure import draw_trade
from numerics.trade.recorded import ASKED, Trade
from numerics.trade.scenes import KINDS, LINE
from paper_checks.drawing.style import Figures, house_style
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Picture, Points, Section, Table
from paper_checks.report.content.phrases import listed

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


PEER = "heyoka"
"""Whom ours is measured against."""


def section(trade: Trade) -> Section:
    """Return the whole chapter; who is faster comes first."""
    blocks: list[Block] = [
        Points((*answers(trade), *events(trade))),
        Table(
            ("ours", "scenes", "as fast as heyoka: least", "median", "heyoka is faster on"),
            tuple(lines(trade)),
            "How many times as fast as heyoka, at its coarsest setting that is as accurate (or at its most accurate one, where none is), in double or long double, whichever is faster",
        ),
        Picture(
            WORK_PRECISION,
            "One panel for each scene: the further up and to the left, the better. Filled: the events are right; hollow: they are wrong, "
            "however many digits agree.",
            "Right digits against time",
        ),
        *provenance(trade),
        Heading("Where forward Euler misleads"),
        *misled(euler_figures()),
    ]  # fmt: skip
    return Section(ID, TITLE, tuple(blocks))


def answers(trade: Trade) -> Iterator[str]:
    """Say for each kind of scene on a line who is faster where no digits are asked for, and where that turns."""
    ratios = trade.ratios()
    for words in (KINDS[which] for which in LINE):
        free, *asked = (ratios.get(f"{setting}, {words}", {}) for setting in ASKED.values())
        said = [f"{words.capitalize()}, {told(free)}"]
        for digits, some in zip([*ASKED][1:], asked, strict=True):
            if lost := sum(one < 1 for one in some.values()):
                scenes = f"{lost} of {len(some)} scenes"
                said.append(f"Asked for {digits} digits, {PEER} wins on {scenes}; {_typical(some)}.")
        yield " ".join(said)


def _typical(ratios: Mapping[str, float]) -> str:
    middle = median(ratios.values())
    return f"in the median {'ours' if middle >= 1 else PEER} is {max(middle, 1 / middle):.3g} times as fast"


def told(ratios: Mapping[str, float]) -> str:
    """Say who wins, from the ratios of scenes: how many times as fast as the peer ours is."""
    if not ratios:
        return "no other program was measured."
    ordered = sorted(ratios, key=lambda name: ratios[name])
    (least, low), high, typical = (ordered[0], ratios[ordered[0]]), ratios[ordered[-1]], _typical(ratios)
    lost, every = sum(one < 1 for one in ratios.values()), len(ratios)
    if every == 1:
        return f"{_typical(ratios).removeprefix('in the median ')} on the one scene, {least}."
    if not lost:
        return f"ours wins on all {every} scenes, by at least {low:.3g} times (on {least}); {typical}."
    won = f"ours wins on {every - lost}, by up to {high:.3g} times; " if lost < every else ""
    return f"{PEER} wins on {lost} of {every} scenes, by up to {1 / low:.3g} times (on {least}); {won}{typical}."


def lines(trade: Trade) -> Iterator[tuple[str, ...]]:
    """Yield a line for each setting of ours and kind of scene, and for many scenes at once."""
    for name, ratios in trade.ratios().items():
        lost = listed([scene for scene, one in ratios.items() if one < 1])
        yield name, str(len(ratios)), f"{min(ratios.values()):.3g}", f"{median(ratios.values()):.3g}", lost


def figures(trade: Trade) -> Figures:
    """Return how the figure of a trade is drawn in the house style, two panels a row."""

    @house_style()
    def draw() -> Figure:
        return draw_trade(trade, columns=2, panel_size=(4.1, 2.5))

    return {WORK_PRECISION: draw}


def events(trade: Trade) -> Iterator[str]:
    """Say who has the event sequence right in every run."""
    judged = [one for one in trade.runs if one.right is not None]
    wrong = [one for one in judged if not one.right]
    bad = {one.who for one in wrong}
    good = list(dict.fromkeys(one.who for one in judged if one.who not in bad))
    yield f"Of {len(judged)} runs that ended {len(wrong)} have the events wrong; never one of {listed(good)}."
    for one in (one for one in wrong if one.ours):
        yield f"Ours is wrong: {one.who} with {one.setting:g} digits on {one.scene} ({one.note})."


def provenance(trade: Trade) -> Iterator[Block]:
    """Yield on what it was measured, how errors are judged, and how to measure another machine."""
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    missing = "; ".join(f"{name} (needs {what})" for name, what in trade.left_out.items())
    yield Paragraph(
        f"Measured once: {of['processor']}, {of['cores']} cores, load {of.get('load')}, Python {of['python']}, {versions}."
        f"{f' Left out: {missing}.' if missing else ''} Times are medians of warm runs, compilation apart; the answer is read. Digits are those of the "
        "worst error against balls: of the final state in units of $L$ and $L\\Omega$, of the events' times, of the dissipated energy. "
        "An integrator is used at its best: restarted at every event and jump, in coordinates that lose nothing; on a surface, and where "
        "friction depends on the state, ours was measured alone. The shipped record is older than the removal of double-double: `solve` with 12 "
        "and 20 digits, and on a surface, is slower today than it says."
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
        "A stuck pair conserves its energy exactly. Where forward Euler holds $v_1=v_2$, each step $h$ multiplies it by $1+(h\\Omega)^2$: in Fig. 4 (a), "
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
