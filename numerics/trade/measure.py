"""The whole trade at one of three sizes, in one process: each run is judged, then timed in turns with `solve(scene)`.

Times are processor times, so other work on the machine counts little, and two that were taken in turns share the rest:
only their ratio is kept. Everything is warm, and an answer is read as a user reads it.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import NumericsError
from numerics.scene import Scene, State
from numerics.solver.many import solve_many
from numerics.trade.comparisons.heyoka_peer import heyoka_arcs
from numerics.trade.comparisons.peer import PeerRun
from numerics.trade.comparisons.switched import SwitchedPair, run
from numerics.trade.contenders import CONTENDERS, Call, Contender, answer_of, contender
from numerics.trade.judge import judge, proved
from numerics.trade.recorded import NONE, OURS, Run, Sweep, Trade, machine, short
from numerics.trade.scenes import HEADLINE, LONG, NAMES, benchmark, kind, why


class Size(NamedTuple):
    """How much is measured: processor time for a ratio (s), and scenes that are solved at once."""

    scenes: Sequence[str]
    budget: float
    sweep: int


SIZES = {
    "small": Size((HEADLINE, "near-critical-1e-6", "forced-stick-slip"), 0.1, 20),
    "default": Size(NAMES, 0.2, 100),
    "large": Size(NAMES, 5.0, 1000),
}
SWEPT = ("velocities", "relative-motion-b02", HEADLINE, "forced-stick-slip", "forced-friction")
DIGITS = 10_000
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
    size, of = SIZES[size_name], machine()
    solve_many(1, 1, 200, 0.5, v1=[0.15], until=1, jobs=1)  # brings up what is compiled
    everyone, scenes = selected(only, size.scenes, contenders)
    left_out = {one.label: missing for one in everyone if (missing := one.missing()) is not None}
    runs, sweeps = list[Run](), list[Sweep]()
    for scene in scenes:
        slow = {one.who for one in runs if one.scene.startswith(LONG) and (one.seconds or 0) > SLOW}
        some = [one for one in everyone if one.label not in left_out and kind(scene) in one.kinds]
        some = [one for one in some if not (scene.startswith(LONG) and one.label in slow)]
        runs += runs_on(scene, some, size.budget, progress)
    if contender("heyoka") in everyone and "heyoka" not in left_out:
        for scene in (one for one in SWEPT if one in scenes):
            progress(f"{scene}: {size.sweep} at once")
            sweeps.append(swept(scene, size.sweep, size.budget))
    return Trade(of, left_out, {name: why(name) for name in scenes}, tuple(runs), tuple(sweeps))


def selected(
    only: Sequence[str], scenes: Sequence[str], contenders: Sequence[Contender]
) -> tuple[list[Contender], list[str]]:
    """Return the contenders and the scenes that `only` names, all of a kind of which it names none."""
    names = [one.label for one in contenders] + [f"{kind(name)}: {name}" for name in scenes]
    kept: set[str] = set()
    for word in only:
        fits = {name for name in names if word.strip() and word.lower() in name.lower()}
        if not fits:
            raise NoSuchContender(f"--only {word[:40]!r} fits no contender and no scene; they are: {'; '.join(names)}")
        kept |= fits
    some = [one for one in contenders if one.label in kept] or list(contenders)
    return some, [name for name in scenes if f"{kind(name)}: {name}" in kept] or list(scenes)


def runs_on(
    name: str, everyone: Sequence[Contender], budget: float, progress: Callable[[str], None] = lambda _: None
) -> Iterator[Run]:
    """Yield a run at every setting of each contender, from coarse to fine; on a long scene none after a slow one."""
    scene, most = benchmark(name), 100 if kind(name) == "forced" or name.startswith(LONG) else DIGITS
    truth, base = proved(scene), contender("solve").prepare(scene, 0)
    base()  # compiles what is not compiled yet
    unit = total_time(base, 1)
    unit = unit if unit > SLOW / 10 else total_time(base, 5) / 5
    for one in everyone:
        for setting in (one for one in one.settings if one <= most):
            progress(f"{name}: {one.label} {setting:g}")
            ratio, digits, note = judged_and_timed(one, setting, scene, truth, base, budget)
            yield Run(name, one.label, setting, ratio and ratio * unit, digits, note)
            if name.startswith(LONG) and ratio and ratio * unit > SLOW:
                break


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
    start = time.process_time()
    for _ in range(loops):
        call()
    return time.process_time() - start


def in_turns(ours: Call, theirs: Call, budget: float) -> float:
    """Return the median time of a call of `theirs` by that of `ours`, both warm and in turns: they share the noise."""
    taken, spent = ([], []), 0.0  # type: tuple[list[float], list[float]], float
    once = [max(total_time(call, 1), 1e-9) for call in (ours, theirs)]
    loops = [max(1, round(BATCH / one)) for one in once]
    least = 1 if max(once) > SLOW else 3 if max(once) > budget else 5
    while len(taken[0]) < least or spent < budget:
        for call, count, times in zip((ours, theirs), loops, taken, strict=True):
            spent += (found := total_time(call, count))
            times.append(found / count)
    mine, other = map(statistics.median, taken)
    return other / mine


def swept(name: str, size: int, budget: float) -> Sweep:
    """Compare `solve_many` with heyoka on a scene with so many amplitudes of its force, or speeds at its start."""
    scene, scenes = benchmark(name), list[Scene]()
    pair, at = scene.pair, scene.initial
    for factor in (Fraction(size + k, 2 * size) for k in range(1, size + 1)):
        start = at if scene.is_forced else State(at.x1, factor * at.v1, at.x2, at.v2)
        scenes.append(replace(scene, force=factor * scene.force, initial=start))
    numbers: Any = {name: float(getattr(pair, name)) for name in ("m1", "m2", "a1", "a2", "b")}
    numbers |= {name: [float(getattr(one.initial, name)) for one in scenes] for name in ("x1", "v1", "x2", "v2")}
    if scene.friction.pieces:
        numbers["friction"] = scene.friction
    if scene.is_forced:
        waves = [[(s.amplitude, s.omega, s.phase) for s in one.force.pieces[0].sines] for one in scenes]
        numbers["sines"] = np.array(waves, dtype=float).transpose(1, 2, 0)
    pairs = [SwitchedPair(one) for one in scenes]
    arc, until = heyoka_arcs(pairs[0], 1e-15), float(scene.until)

    def ours() -> Any:
        found = solve_many(**numbers, until=until, jobs=1)
        return found if found.y is not None else None

    def theirs() -> list[PeerRun]:
        return [run(one, arc) for one in pairs]

    batch, others = ours(), np.array([one.final for one in theirs()], dtype=float).T
    length = float(pair.half_width)
    sizes = np.array([[length], [length * float(pair.a2 / pair.mass) ** 0.5]] * 2)
    apart = np.max(np.abs(others - batch.y) / sizes, axis=0)
    wrong = apart > 1e-3
    reached = -np.log10(max(apart[~wrong].max(initial=0.0), 1e-16))
    ratio, digits = short(in_turns(ours, theirs, budget)), float(batch.digits.min())
    return Sweep(name, ratio or 0.0, size, digits, short(reached) or 0.0, int(wrong.sum()))
