"""The advice in a few sentences, each computed from what the rest of the section shows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from numerics.trade.euler import EulerFigure, StickEnergy
from numerics.trade.recorded import RecordedTrade
from paper_checks.report.content.blocks import Block, Points
from paper_checks.speed.needs import NEEDS, cheapest
from paper_checks.speed.peers import beaten, closest_peer
from paper_checks.speed.waiting import waiting_in_short
from paper_checks.speed.wording import factor_text, headline, listed, step_text, time_text


def in_short(trade: RecordedTrade, figures: Sequence[EulerFigure], energies: Sequence[StickEnergy]) -> Iterator[Block]:
    """Yield one list: which arithmetic, how far ahead, who has the events right, what forward Euler needs."""
    sentences = (
        *_arithmetic(trade),
        *waiting_in_short(trade),
        *_lead(trade),
        *_events(trade),
        *_steps(figures),
        *_energy(energies),
    )
    if sentences:
        yield Points(sentences)


def _arithmetic(trade: RecordedTrade) -> Iterator[str]:
    scene = headline(trade)
    found = [(need, one) for need in NEEDS if (one := cheapest(trade, [scene], need)) is not None]
    parts = []
    for contender, some in groupby(found, key=lambda item: item[1].contender):
        need, one = list(some)[-1]
        parts.append(f"{contender} up to {need:,} ({time_text(one.seconds)})")
    if parts:
        yield f"The cheapest call for so many right digits, warm and with its answer read, on the one scene {scene.name}: {listed(parts)}."


def _lead(trade: RecordedTrade) -> Iterator[str]:
    closest = [(scene.name, lead) for scene in trade.scenes if (lead := closest_peer(trade, scene)) is not None]
    if not closest:
        return
    lost = [scene.name for scene in trade.scenes if beaten(trade, scene)]
    ratios = [lead.ratio for name, lead in closest if name not in lost and lead.ratio is not None]
    if ratios:
        yield (
            "At equal or better accuracy ours is faster than every peer with the right events, by a factor of at least "
            f"{factor_text(min(ratios))}, on {len(ratios)} of {len(closest)} scenes where a peer has them right."
        )
    if lost:
        yield f"Some peer beats ours on {listed(lost)}: see below by how much."


def _events(trade: RecordedTrade) -> Iterator[str]:
    peers = [one.label for one in trade.contenders if not one.ours]
    verdicts = {peer: [one.right for one in trade.runs if one.contender == peer] for peer in peers}
    always = [peer for peer in peers if all(verdicts[peer])]
    if peers:
        which = f"only {listed(always)}" if always else "none of the other tools"
        yield (
            f"Of {len(peers)} ways to use other tools, " if always else "Of all scenes and settings that were tried, "
        ) + f"{which} {'has' if len(always) < 2 else 'have'} the events right everywhere."


def _steps(figures: Sequence[EulerFigure]) -> Iterator[str]:
    for one in sorted(figures, key=lambda one: one.right_from or 0.0)[:1]:
        right = "finer than all that were tried" if one.right_from is None else f"{step_text(one.right_from)} s"
        step, tried = one.step_for(1e-2)
        percent = "" if step is None else f", for 1 % {'' if tried else 'about '}{step_text(step)} s"
        yield f"Forward Euler needs the finest step for Fig. {one.figure}: for the right events {right}{percent}."


def _energy(energies: Sequence[StickEnergy]) -> Iterator[str]:
    if energies:
        texts = [f"{one.held:.4g} (step {step_text(one.step)} s)" for one in energies]
        yield f"In {energies[0].until:g} s forward Euler multiplies the energy of a stuck pair, a constant, by {listed(texts)}."
