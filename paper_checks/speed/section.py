"""The report's section on speed and accuracy: words on a recorded trade, forward Euler's runs, float64's bounds.

Nothing in it is timed anew; forward Euler's runs and float64's bounds are computed, the same each time.
"""

from __future__ import annotations

from collections.abc import Iterator

from matplotlib.figure import Figure

from numerics.trade.euler import stick_energies
from numerics.trade.figure import draw_growth, draw_trade
from numerics.trade.recorded import RecordedTrade, divided
from paper_checks.drawing.style import Figures, house_style
from paper_checks.report.content.blocks import Block, Heading, Paragraph, Picture, Section
from paper_checks.speed.euler_figures import euler_figures
from paper_checks.speed.forced import under_a_force
from paper_checks.speed.in_short import in_short
from paper_checks.speed.misleading import forward_euler
from paper_checks.speed.needs import float64_is_enough, needs, price_of_digits
from paper_checks.speed.payoff import payoff
from paper_checks.speed.peers import leading, sequences
from paper_checks.speed.waiting import waiting

ID, TITLE = "speed-and-accuracy", "Speed and accuracy"
WORK_PRECISION, GROWTH = "work-precision", "growth-of-cost"


def section(trade: RecordedTrade) -> Section:
    """Return the whole section: provenance, advice (first in short), curves, and where forward Euler misleads."""
    free, forced = divided(trade)
    blocks = [*provenance(free), *summary(free), *advice(free), *curves(free), *forced_part(forced), *euler_advice()]
    return Section(ID, TITLE, tuple(blocks))


def advice_alone(trade: RecordedTrade) -> Section:
    """Return the advice without the figures, for a notebook that draws them itself."""
    trade, _ = divided(trade)
    return Section(ID, "Advice", (*summary(trade), *advice(trade), *euler_advice()))


def summary(trade: RecordedTrade) -> Iterator[Block]:
    """Yield the advice in a few sentences."""
    yield Heading("In short")
    yield from in_short(trade, euler_figures(), stick_energies())


def provenance(trade: RecordedTrade) -> Iterator[Block]:
    """Yield on what it was measured, and how to measure another machine."""
    of = trade.machine
    versions = ", ".join(f"{name} {version}" for name, version in of["packages"].items())
    yield Paragraph(
        f"Measured once: {of['processor']}, {of['cores']} cores, Python {of['python']}, {versions}; "
        f"`--size {trade.size}`. `python -m numerics trade --out F` measures your machine and draws its figures; "
        "`python -m numerics trade --json > F`, then `python -m paper_checks report --trade F`, puts it here."
    )
    yield Paragraph(
        "Times are medians of warm runs, compilation apart. An error is the largest of that of the final state (in "
        "units of $L$ and $L\\Omega$), the last event's time and the dissipated energy, against balls. An event "
        "sequence is right if its kinds are and each time lies within half the gap to the neighbours."
    )
    if trade.left_out:
        missing = "; ".join(f"{name} (needs {what})" for name, what in trade.left_out.items())
        yield Paragraph(f"Left out, as not installed: {missing}.")


def advice(trade: RecordedTrade) -> Iterator[Block]:
    """Yield the page of advice."""
    yield Heading("Which arithmetic for which need")
    yield from needs(trade)
    yield Heading("What a user waits for")
    yield from waiting(trade)
    yield Heading("How far float64 goes")
    yield from float64_is_enough(trade)
    yield Heading("What a right digit costs")
    yield from price_of_digits(trade)
    yield Heading("When compiling pays, and when a batch does")
    yield from payoff(trade)
    yield Heading("Ours and others at equal accuracy")
    yield from leading(trade)
    yield Heading("Who has the events right")
    yield from sequences(trade)


def curves(trade: RecordedTrade) -> Iterator[Block]:
    """Yield the figures that `figures` draws."""
    names = figures(trade)
    captions = {
        WORK_PRECISION: "One panel for each scene: the further up and to the left, the better. A mark stands for a family of methods and "
        "shows its best settings. Filled: the events are right; hollow: they are wrong, however many digits agree.",
        GROWTH: "Time for one event as the digits, the events and the mass ratio grow, beside one sine and cosine; and time for one scene "
        "of a batch. Flat is good.",
    }
    titles = {WORK_PRECISION: "Right digits against time", GROWTH: "How our cost grows"}
    yield Heading("The curves")
    for name in names:
        yield Picture(name, captions[name], titles[name])


def forced_part(trade: RecordedTrade) -> Iterator[Block]:
    """Yield who is right under a force and how fast, hand-written friction among them."""
    yield Heading("Under a force")
    yield from under_a_force(trade)


def euler_advice() -> Iterator[Block]:
    """Yield where forward Euler misleads; nothing of it is timed."""
    yield Heading("Where forward Euler misleads")
    yield from forward_euler(euler_figures(), stick_energies())


def figures(trade: RecordedTrade) -> Figures:
    """Return how the figures of a trade are drawn in the house style, two panels a row, by name; of free scenes."""
    trade, _ = divided(trade)

    @house_style()
    def work_precision() -> Figure:
        return draw_trade(trade, columns=2, panel_size=(4.1, 2.5))

    @house_style()
    def growth() -> Figure:
        return draw_growth(trade, columns=2, panel_size=(4.1, 3.0))

    grows = any(one.seconds_per_event for one in trade.growth)
    return {WORK_PRECISION: work_precision, GROWTH: growth} if grows else {WORK_PRECISION: work_precision}
