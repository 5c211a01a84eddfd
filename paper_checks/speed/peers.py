"""Which peers get the event sequence right where, and by what factor ours is faster at equal or better accuracy."""

from __future__ import annotations

from collections.abc import Iterator

from numerics.trade.front import Lead
from numerics.trade.recorded import RecordedRun, RecordedScene, RecordedTrade
from paper_checks.report.content.blocks import Block, Paragraph, Points, Table
from paper_checks.speed.wording import asked, counted, digits, factor_text, listed, spread, time_text


def leading(trade: RecordedTrade) -> Iterator[Block]:
    """Yield by how much ours leads on each scene, and where a peer beats it."""
    closest = {scene: closest_peer(trade, scene) for scene in trade.scenes}
    lost = [text for scene in trade.scenes for text in losses(trade, scene)]
    held = [(one.ratio, scene, one) for scene, one in closest.items() if one is not None and one.ratio is not None]
    if not any(not one.ours for one in trade.runs):
        yield Paragraph("No peer took part: nothing can be said about others.")
        return
    if lost:
        yield Points(tuple(lost))
    elif held:
        ratio, scene, one = min(held, key=lambda item: item[0])
        yield Paragraph(
            "No peer with the right events beats ours at equal or better accuracy on any scene. The closest is "
            f"{asked(trade, one.peer)} on {scene.name}: ours is {factor_text(ratio)} times as fast."
        )
    rows = tuple(_lead_row(trade, scene, one) for scene, one in closest.items())
    head = ("scene", "closest peer", "its digits, time", "our call", "times as fast", "run inside", "over all peers")
    yield Table(
        head,
        rows,
        "Our lead at equal or better accuracy over the closest peer with the right events: by what a user calls, and "
        "how many times as fast the run inside is",
    )


def losses(trade: RecordedTrade, scene: RecordedScene) -> list[str]:
    """Return a sentence for each right peer that beats ours on a scene, at the setting where it does most."""
    by_peer = sorted(beaten(trade, scene), key=lambda one: one.ratio or 0.0, reverse=True)
    worst = {one.peer.contender: one for one in by_peer}
    return [_loss(trade, scene, one) for one in worst.values()]


def closest_peer(trade: RecordedTrade, scene: RecordedScene) -> Lead | None:
    """Return the right peer's point over which we lead least; one that none of ours is as accurate as comes first."""
    return min(trade.leads(scene), key=lambda one: one.ratio or 0.0, default=None)


def beaten(trade: RecordedTrade, scene: RecordedScene) -> list[Lead]:
    """Return the points of right peers that are faster than ours at their accuracy, or more accurate than all of ours."""
    return [one for one in trade.leads(scene) if one.ratio is None or one.ratio < 1]


def _loss(trade: RecordedTrade, scene: RecordedScene, one: Lead) -> str:
    peer = f"{asked(trade, one.peer)} ({counted(digits(one.peer.error), 'digit', 'digits')}, {time_text(one.peer.seconds)})"
    if one.ours is None or one.ratio is None:
        return f"On {scene.name} no run of ours is as accurate as {peer}."
    return (
        f"On {scene.name} {peer} beats ours: it is {factor_text(1 / one.ratio)} times as fast as "
        f"{asked(trade, one.ours)}."
    )


def _lead_row(trade: RecordedTrade, scene: RecordedScene, one: Lead | None) -> tuple[str, ...]:
    if one is None:
        return scene.name, "none is right", "–", "–", "–", "–", "–"
    peer = f"{digits(one.peer.error)}, {time_text(one.peer.seconds)}"
    ratios = [lead.ratio for lead in trade.leads(scene) if lead.ratio is not None]
    factors = spread(factor_text(min(ratios)), factor_text(max(ratios))) if ratios else "–"
    inside = "–" if one.ratio_inside is None else factor_text(one.ratio_inside)
    if one.ours is None or one.ratio is None:
        return scene.name, asked(trade, one.peer), peer, "none", "–", inside, factors
    ours = f"{asked(trade, one.ours)}: {time_text(one.ours.seconds)}"
    return scene.name, asked(trade, one.peer), peer, ours, factor_text(one.ratio), inside, factors


def sequences(trade: RecordedTrade) -> Iterator[Block]:
    """Yield who has the event sequence right where, as one table."""
    yield Paragraph(our_sequences(trade))
    head = ("who", *(scene.name for scene in trade.scenes))
    rows = tuple(
        (one.label, *(_cell(_runs(trade, one.label, scene.name)) for scene in trade.scenes)) for one in trade.contenders
    )
    caption = (
        "Who has the events right: 2/3 says that two of three settings have them; the number after the colon is the most right "
        "digits. Stopped: by the time limit of the measurement. Failed: gave up by itself"
    )
    yield Table(head, rows, caption)


def _runs(trade: RecordedTrade, contender: str, scene: str) -> list[RecordedRun]:
    return [one for one in trade.runs if (one.contender, one.scene) == (contender, scene)]


def _cell(runs: list[RecordedRun]) -> str:
    judged = [one for one in runs if one.right is not None]
    if not judged:
        return next((one.status for one in runs if one.status != "measured"), "–")
    right = [one.error for one in judged if one.right and one.error is not None]
    return f"{len(right)}/{len(judged)}" + (f": {digits(min(right)):,}" if right else "")


def our_sequences(trade: RecordedTrade) -> str:
    """Return in how many runs ours have the events right."""
    runs = [one for one in trade.runs if one.ours and one.right is not None]
    wrong = [f"{one.contender} on {one.scene} ({one.difference})" for one in runs if not one.right]
    if wrong:
        return f"Ours are wrong in {counted(len(wrong), 'run', 'runs')} of {len(runs)}: {listed(wrong)}."
    return f"Ours have the right event sequence in all {len(runs)} runs."
