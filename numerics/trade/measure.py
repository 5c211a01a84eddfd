"""The trade: on each scene every contender is judged, then timed in turns with `float64`.

Times are processor times, so other work on the machine counts little, and two that were taken in turns share the rest.
Everything is warm, and an answer is read as a user reads it.
"""

from __future__ import annotations

import math
import statistics
import time
import timeit
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from numerics.errors import NumericsError
from numerics.scene.file import load_scene
from numerics.solver.many import solve_many
from numerics.trade.contenders import BALLS, CONTENDERS, FLOAT64
from numerics.trade.judge import Call, Judgement, Outcome, judge, proved
from numerics.trade.recorded import Row, Trade, machine

FOLDER = Path(__file__).with_name("benchmarks")
SLOW, BATCH, BUDGET = 0.5, 0.01, 0.1
"""One call that takes so long (s) is timed once; quick ones are timed in batches that last at least so long.

Whoever takes over finds the caches full of the other one: with 2 ms ratios spread by half, with these by a tenth.
"""


def benchmarks() -> dict[str, tuple[Any, str]]:
    """Return the scenes that are measured where none is named, each with what it is: the first line of its file."""
    files = sorted(FOLDER.glob("*.toml"), key=lambda one: (one.stem.startswith("forced"), one.stem))
    return {one.stem: (load_scene(one), one.read_text("utf-8").partition("\n")[0].removeprefix("# ")) for one in files}


def trade(
    scenes: Mapping[str, tuple[Any, str]], digits: int, progress: Callable[[str], None] = lambda _: None
) -> Trade:
    """Measure everybody on scenes, each with what it is, in balls with up to so many digits."""
    of, left_out, rows = machine(), dict[str, str](), list[Row]()
    solve_many(1, 1, 200, 0.5, v1=[0.15], until=1, jobs=1)  # brings up what is compiled
    for name, (scene, _) in scenes.items():
        progress(f"{name}: the proved run")
        truth, base = proved(scene, digits), None
        for one in CONTENDERS:
            if why := one.left_out(scene):
                left_out[one.name] = why
                continue
            lower = [few for few in one.settings if few < digits]
            for setting in (*lower, digits) if one.name == BALLS else one.settings:
                progress(f"{name}: {one.name} {setting:g}")
                call, verdict = judged(partial(one.prepare, scene, setting), truth, digits)
                base = call if one.name == FLOAT64 else base
                rows.append(Row._make((name, one.name, setting, *timed(base, call), *verdict)))
    return Trade(of, left_out, {name: what for name, (_, what) in scenes.items()}, tuple(rows))


def judged(prepare: Callable[[], Call], truth: Outcome, digits: int) -> tuple[Call | None, Judgement]:
    """Return what to time, None where there is no answer, and how right it is."""
    try:
        call = prepare()
        return call, judge(call(), truth, digits)
    except NumericsError as error:
        return None, Judgement(0, None, str(error))


def timed(base: Call | None, call: Call | None) -> tuple[float | None, float | None]:
    """Return the time of a call, s, and its ratio to that of `base`; None where there is nothing to time."""
    if call is None:
        return None, None
    ours, theirs = in_turns(base or call, call)
    ratio = 1.0 if call is base else theirs / ours
    return float(f"{theirs:.3g}"), float(f"{ratio:.3g}") if base else None


def in_turns(*calls: Call) -> list[float]:
    """Return the median times of some calls, s, warm and in turns: they share the noise."""

    def taken(call: Call, loops: int) -> float:
        return timeit.timeit(call, timer=time.process_time, number=loops) / loops

    once = [max(taken(call, 1), 1e-9) for call in calls]
    if max(once) > SLOW:
        return once
    loops = [max(1, round(BATCH / one)) for one in once]
    turns = max(5, math.ceil(BUDGET / sum(one * count for one, count in zip(once, loops, strict=True))))
    return [statistics.median(one) for one in zip(*[map(taken, calls, loops) for _ in range(turns)], strict=True)]
