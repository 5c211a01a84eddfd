"""The whole trade at one of three sizes, in one process: each run is judged, then timed in turns with `solve(scene)`.

Times are processor times, so other work on the machine counts little, and two that were taken in turns share the rest:
only their ratio is kept. Everything is warm, and an answer is read as a user reads it.
"""

from __future__ import annotations

import math
import statistics
import time
import timeit
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np

from numerics.errors import NumericsError
from numerics.scene import State
from numerics.solver.many import solve_many
from numerics.trade.comparisons.integrators import heyoka_arcs
from numerics.trade.comparisons.switched import Call, PeerRun, SwitchedPair, run
from numerics.trade.contenders import CONTENDERS, Contender, answer_of, contender
from numerics.trade.judge import judge, proved, scales
from numerics.trade.recorded import NONE, OURS, Sweep, TimedRun, Trade, machine, short
from numerics.trade.scenes import HEADLINE, LONG, NAMES, benchmark, kind, why

SIZES: dict[str, tuple[Sequence[str], float, int]] = {
    "small": ((HEADLINE, "near-critical-1e-6", "forced-stick-slip"), 0.1, 20),
    "default": (NAMES, 0.2, 100),
    "large": (NAMES, 5.0, 1000),
}
"""How much is measured: scenes, processor time for a ratio (s), and how many scenes are solved at once."""
SWEPT = ("velocities", "relative-motion-b02", HEADLINE, "forced-stick-slip", "forced-friction")
SLOW, BATCH = 2.0, 0.01
"""One call that takes so long (s) is timed once; quick ones are timed in batches that last at least so long.

Whoever takes over finds the caches full of the other one: with 2 ms ratios spread by half, with these by a tenth.
"""


class NoSuchContender(NumericsError):
    """A name that fits no contender and no scene; the message lists them."""


def trade(
    size_name: str,
    only: Sequence[str] = (),
    progress: Callable[[str], None] = lambda _: None,
    contenders: Sequence[Contender] = CONTENDERS,
) -> Trade:
    """Measure everybody on every scene; `only` keeps those whose names contain one of its words.

    "free", "forced", "surface" and "state" name kinds of scenes. Raises NoSuchContender if a word fits no name.
    """
    (names, budget, at_once), of = SIZES[size_name], machine()
    solve_many(1, 1, 200, 0.5, v1=[0.15], until=1, jobs=1)  # brings up what is compiled
    everyone, scenes = selected(only, contenders, names)
    left_out = {one.label: missing for one in everyone if (missing := one.missing()) is not None}
    runs, sweeps, slow = list[TimedRun](), list[Sweep](), set[str]()
    for name in scenes:
        scene, is_long = benchmark(name), name.startswith(LONG)
        truth, base = proved(scene), contender("solve").prepare(scene, 0)
        base()  # compiles what is not compiled yet
        unit = min(total_time(base, 1) for _ in range(3))
        for one in everyone:
            for setting in one.settings if one.label not in left_out and kind(name) in one.kinds else ():
                if (is_long and one.label in slow) or (setting > 100 and (is_long or kind(name) == "forced")):
                    break  # coarse to fine: the next one is slower
                progress(f"{name}: {one.label} {setting:g}")
                ratio, digits, note = judged_and_timed(one, setting, scene, truth, base, budget)
                runs.append(TimedRun(name, one.label, setting, short(ratio and ratio * unit), short(digits), note))
                if is_long and ratio and ratio * unit > SLOW:
                    slow.add(one.label)
        if name in SWEPT and contender("heyoka") in everyone and "heyoka" not in left_out:
            progress(f"{name}: {at_once} at once")
            sweeps.append(swept(name, at_once, budget))
    return Trade(of, left_out, {name: why(name) for name in scenes}, tuple(runs), tuple(sweeps))


def selected(
    only: Sequence[str], contenders: Sequence[Contender], scenes: Sequence[str]
) -> tuple[list[Contender], list[str]]:
    """Return the contenders and the scenes that `only` names, all of a kind of which it names none."""
    labels, titles = {one.label: one for one in contenders}, {f"{kind(name)}: {name}": name for name in scenes}
    for word in only:
        if word.lower() not in (known := "; ".join([*labels, *titles])).lower():
            raise NoSuchContender(f"--only {word[:40]!r} matches no method and no scene; available: {known}")

    def fitting(named: dict[str, Any]) -> list[Any]:
        some = [one for name, one in named.items() if any(word.lower() in name.lower() for word in only)]
        return some or [*named.values()]

    return fitting(labels), fitting(titles)


def judged_and_timed(
    one: Contender, setting: float, scene: Any, truth: PeerRun, base: Call, budget: float
) -> tuple[float | None, float | None, str]:
    """Judge a contender and time it in turns with `base`: its time by that, its digits, and what is wrong with it."""
    digits = int(setting) if one.label in OURS else 0
    try:
        call = one.prepare(scene, setting)
        found = answer_of(call())
    except NumericsError as error:
        return None, None, f"{NONE}{error}"
    verdict = judge(found, proved(scene, digits) if digits > 20 else truth, scene, digits)
    ratio = 1.0 if (one.label, setting) == ("solve", 0) else in_turns(base, call, budget)
    return ratio, verdict.digits, verdict.difference or ""


def total_time(call: Call, loops: int) -> float:
    """Return the processor time of so many calls, s, of all threads of this process."""
    return timeit.timeit(call, timer=time.process_time, number=loops)


def in_turns(ours: Call, theirs: Call, budget: float) -> float:
    """Return the median time of a call of `theirs` by that of `ours`, both warm and in turns: they share the noise."""
    once = [max(total_time(call, 1), 1e-9) for call in (ours, theirs)]
    loops = [max(1, round(BATCH / one)) for one in once]
    turn = sum(one * count for one, count in zip(once, loops, strict=True))
    turns = max(1 if max(once) > SLOW else 5, math.ceil(budget / turn))
    taken = [[total_time(*one) / one[1] for one in zip((ours, theirs), loops, strict=True)] for _ in range(turns)]
    mine, other = map(statistics.median, zip(*taken, strict=True))
    return other / mine


def swept(name: str, size: int, budget: float) -> Sweep:
    """Compare `solve_many` with heyoka on a scene with so many amplitudes of its sine, or speeds at its start."""
    scene, factors = benchmark(name), [Fraction(size + k, 2 * size) for k in range(1, size + 1)]
    pair = scene.pair
    numbers: dict[str, Any] = {part: float(one) for part, one in asdict(pair).items()}
    if scene.is_forced:
        scenes = [replace(scene, force=factor * scene.force) for factor in factors]
        waves = [one.force.pieces[0].sines[0] for one in scenes]
        numbers["sines"] = [tuple(np.array([(one.amplitude, one.omega, one.phase) for one in waves], dtype=float).T)]
        numbers |= {"friction": scene.friction} if scene.friction.steps else {}
    else:
        scenes = [replace(scene, initial=State(v1=factor * scene.initial.v1)) for factor in factors]
        numbers["v1"] = [float(one.initial.v1) for one in scenes]
    solved, pairs = partial(solve_many, **numbers, until=float(scene.until), jobs=1), [*map(SwitchedPair, scenes)]
    arc = heyoka_arcs(pairs[0], 1e-15)

    def theirs() -> Any:
        return [run(one, arc).final for one in pairs]

    batch, sizes = solved(), np.array([[float(one.mid())] for one in scales(pair)])
    apart = np.max(np.abs(np.array(theirs(), dtype=float).T - batch.y) / sizes, axis=0)
    right = apart <= 1e-3
    reached = -np.log10(max(apart[right].max(initial=0.0), 1e-16))
    ratio = short(in_turns(lambda: solved().y, theirs, budget))
    return Sweep(name, ratio, size, float(batch.digits.min()), short(float(reached)), int(np.sum(~right)))
