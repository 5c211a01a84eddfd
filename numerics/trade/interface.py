"""How many times as fast as heyoka ours is at the public interface: in one process, in turns, everything warm.

`python -m numerics trade --interface` prints it, the least and the median over the scenes. Answers are judged first;
heyoka runs at the coarsest tolerance that is as accurate, or at its most accurate one where none is.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.scene import Scene, State
from numerics.solver.many import solve_many
from numerics.trade.comparisons.heyoka_peer import heyoka_arcs
from numerics.trade.comparisons.switched import SwitchedPair, run
from numerics.trade.contenders import answer_of, contender
from numerics.trade.fresh import total_time
from numerics.trade.judge import judge, proved
from numerics.trade.scenes import HEADLINE, LONG, NAMES, benchmark, kind

Call = Callable[[], Any]
SWEPT = ("velocities", "relative-motion-b02", HEADLINE, "forced-stick-slip", "forced-friction")
DIGITS = 10_000
BATCH = 0.002
"""Calls are timed in batches that last at least so long, s."""


class Ratio(NamedTuple):
    """A comparison on one scene: heyoka's time by ours, or what `what` says; `note`: the digits of both."""

    what: str
    scene: str
    ratio: float | None
    note: str = ""


def ratios(budget: float = 0.5, sweep: int = 200) -> Iterator[Ratio]:
    """Yield every comparison, timed for about so many seconds each; `sweep` scenes are solved at once."""
    solve_many(1, 1, 200, 0.5, v1=[0.15], until=1, jobs=1)  # brings up what is compiled
    if missing := contender("heyoka").missing():
        yield Ratio("beside heyoka", "all", None, f"left out: needs {missing}")
    else:
        for name in (one for one in NAMES if not one.startswith(LONG)):
            yield from single(name, budget)
        for name in SWEPT:
            yield Ratio(
                f"solve_many, {kind(name)}, one core each", name, in_turns(*swept(benchmark(name), sweep), budget)
            )
    call = contender("ball").prepare(benchmark(HEADLINE), DIGITS)
    with Ball(DIGITS).context():
        each = 1 / in_turns(call, arb(2).rsqrt().mid().sin_cos, budget) / len(answer_of(call()).times)
    yield Ratio(f"sine-cosines for an event in balls of {DIGITS:,} digits", HEADLINE, each)


def single(name: str, budget: float) -> Iterator[Ratio]:
    """Yield the comparisons on one scene: float64 at the same accuracy, 12 and 20 digits beside long double."""
    scene = benchmark(name)
    truth = proved(scene)
    for digits, peer in ((0, "heyoka"), (12, "heyoka long double"), (20, "heyoka long double")):
        call = contender("solve").prepare(scene, digits)
        own = judge(answer_of(call()), truth, scene)
        other, reached = None, 0.0
        for setting in contender(peer).settings:
            tried = contender(peer).prepare(scene, setting)
            found = judge(answer_of(tried()), truth, scene)
            if found.difference is None and reached < (digits or own.digits or 0) and (found.digits or 0) > reached:
                other, reached = tried, found.digits or 0.0
        what = f"solve({f'digits={digits}' if digits else ''}).t .y .modes, {kind(name)}, beside {peer}"
        note = f"digits {own.digits:.1f} and {reached:.1f} {own.difference or ''}"
        yield Ratio(what, name, None if other is None else in_turns(call, other, budget), note.strip())


def swept(scene: Scene, size: int) -> tuple[Call, Call]:
    """Return the calls that solve a scene with so many amplitudes of its force, or speeds at its start."""
    pair, at, scenes = scene.pair, scene.initial, []  # type: Any, State, list[Scene]
    for factor in (Fraction(size + k, 2 * size) for k in range(1, size + 1)):
        start = at if scene.is_forced else State(at.x1, factor * at.v1, at.x2, at.v2)
        scenes.append(replace(scene, force=factor * scene.force, initial=start))
    numbers: Any = {name: float(getattr(pair, name)) for name in ("m1", "m2", "a1", "a2", "b")}
    numbers |= {name: [float(getattr(one.initial, name)) for one in scenes] for name in ("x1", "v1", "x2", "v2")}
    if scene.friction.pieces:  # jumps are no columns
        numbers |= {"force": [one.force for one in scenes], "friction": scene.friction}
    elif scene.is_forced:
        waves = [[(s.amplitude, s.omega, s.phase) for s in one.force.pieces[0].sines] for one in scenes]
        numbers["sines"] = np.array(waves, dtype=float).transpose(1, 2, 0)
    pairs = [SwitchedPair(one) for one in scenes]
    arc, until = heyoka_arcs(pairs[0], 1e-15), float(scene.until)
    return lambda: solve_many(**numbers, until=until, jobs=1).y, lambda: [run(one, arc) for one in pairs]


def in_turns(ours: Call, theirs: Call, budget: float) -> float:
    """Return the median time of one call by that of the other, both warm and in turn, so that they share the noise."""
    taken, end = ([], []), time.perf_counter() + budget  # type: tuple[list[float], list[float]], float
    loops = [max(1, round(BATCH / max(total_time(call, 2) / 2, 1e-9))) for call in (ours, theirs)]
    while len(taken[0]) < 3 or time.perf_counter() < end:
        for call, count, times in zip((ours, theirs), loops, taken, strict=True):
            times.append(total_time(call, count) / count)
    mine, other = map(statistics.median, taken)
    return other / mine
