"""What a user waits for at the public interface, beside the run inside and two peers."""

from __future__ import annotations

from collections.abc import Iterator

from numerics.trade.interface import RUN, SOLVE, Wait
from numerics.trade.ours import COMPILED, READ
from numerics.trade.recorded import RecordedTrade
from paper_checks.report.content.blocks import Block, Paragraph, Table
from paper_checks.speed.wording import factor_text, headline, time_text


def waiting(trade: RecordedTrade) -> Iterator[Block]:
    """Yield a row for every call, with what is asked of it; a sentence where the record has none."""
    rows = tuple((f"`{one.call}`", time_text(one.seconds), _compared(one), _asked(one)) for one in trade.interface)
    if not rows:
        yield Paragraph("This record does not say; `python -m numerics trade --interface` measures it.")
        return
    caption = f"What a user waits for on {headline(trade).name}, every call warm, in turn with the others in one process; nothing of an answer is read but where the call says so"
    yield Table(("call", "time", "compared", "asked for"), rows, caption)


def waiting_in_short(trade: RecordedTrade) -> Iterator[str]:
    """Yield one sentence: what a user gets, and the run inside."""
    took = {one.call: one.seconds for one in trade.interface}
    times = {one.contender: one.seconds for one in trade.runs if one.scene == headline(trade).name}
    call, run, read = took.get(SOLVE), took.get(RUN) or times.get(COMPILED), times.get(READ)
    parts = [f"`solve(scene)` takes {time_text(call)}"] if call else []
    parts += [f"with times, states and itinerary read {time_text(read)}"] if read else []
    if parts and run:
        yield f"What a user waits for on {headline(trade).name}: {', '.join(parts)}; the run inside takes {time_text(run)}."


def _compared(one: Wait) -> str:
    return "–" if one.ratio is None else f"{factor_text(one.ratio)} times {one.by}"


def _asked(one: Wait) -> str:
    if one.most is None:
        return "–"
    most = f"{factor_text(one.most)} ×" if one.ratio is not None else time_text(one.most)
    return f"≤ {most}: {'kept' if one.kept else 'missed'}"
