"""Under a force: who has the events right, how many digits, and how long it takes beside ours, as one table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from numerics.trade.front import Lead, leads
from numerics.trade.ours import PARTS
from numerics.trade.recorded import Participant, RecordedScene, RecordedTrade
from paper_checks.report.content.blocks import Block, Paragraph, Points, Table
from paper_checks.speed.peers import beaten, our_sequences
from paper_checks.speed.wording import digits, factor_text, listed, time_text


def under_a_force(trade: RecordedTrade) -> Iterator[Block]:
    """Yield what is compared, the one table, and where a peer beats ours."""
    yield Paragraph(
        "Integrators are restarted at every jump of $u$ or $b$ and at every event. Karnopp's dead zone and smoothing by "
        "$\\tanh$ are one call of SciPy without events, as engineers write them; their setting is the width of the zone "
        "in units of $L\\Omega$. Where float64 cannot tell a touch from a slip, it says so, and balls decide."
    )
    yield Points(tuple(f"{scene.name}: {scene.why}." for scene in trade.scenes))
    yield Paragraph(our_sequences(trade))
    called = [one for one in trade.contenders if one.label not in PARTS]
    rows = tuple((one.label, *(_cell(trade, one, scene) for scene in trade.scenes)) for one in called)
    yield Table(
        ("who", *(scene.name for scene in trade.scenes)),
        rows,
        "Scenes under a force: settings with the right events, of those measured; the most right digits of these; and the time of that run, of a "
        "peer as a multiple of our fastest call that is as accurate (– if none is). Wrong: no setting has the events, the digits are those of the best",
    )
    yield Paragraph(_beaten(trade))
    yield Paragraph(_machine(trade))


def _beaten(trade: RecordedTrade) -> str:
    """Return which peers with the right events are faster or more accurate than ours, and on how many scenes."""
    where = Counter(
        peer for scene in trade.scenes for peer in sorted({one.peer.contender for one in beaten(trade, scene)})
    )
    if not where:
        return "No peer with the right events beats ours at equal or better accuracy."
    each = listed([f"{peer} on {count}" for peer, count in where.items()])
    return f"At some setting with the right events these beat ours at equal or better accuracy, of {len(trade.scenes)} scenes: {each}."


def _cell(trade: RecordedTrade, who: Participant, scene: RecordedScene) -> str:
    """Return how many settings have the events right, and of the best run its digits and its time beside ours."""
    runs = [one for one in trade.runs if (one.contender, one.scene) == (who.label, scene.name)]
    judged = [one for one in runs if one.right is not None]
    if not judged:
        return next((one.status for one in runs if one.status != "measured"), "–")
    right = sum(bool(one.right) for one in judged)
    candidates = [one for one in trade.points(scene) if one.contender == who.label and one.right == (right > 0)]
    if not candidates:
        return f"{right}/{len(judged)}"
    best = min(candidates, key=lambda one: (one.error, one.seconds))
    if who.ours:
        took = time_text(best.seconds)
    else:
        lead: Lead = next(one for one in leads(trade.points(scene)) if one.peer == best)
        took = "–" if lead.ratio is None else f"{factor_text(lead.ratio)}×"
    events = f"{right}/{len(judged)}" if right else "wrong"
    return f"{events}: {digits(best.error):,}, {took}"


def _machine(trade: RecordedTrade) -> str:
    of = trade.machine
    load = of.get("load")
    text = f"Measured on {of['processor']}, {of['cores']} cores"
    if load is not None:
        text += f", at a load of {load:g} (0 is idle)"
    if (load or 0) > of["cores"] / 2:
        text += (
            ": the machine did other work, so a time alone is good for its order of magnitude, and so is a ratio, whose two "
            "times are not of one moment"
        )
    return f"{text}."
