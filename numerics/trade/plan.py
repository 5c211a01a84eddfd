"""The whole trade at one of three sizes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from numerics.errors import NumericsError
from numerics.trade.child import Child, Deadline
from numerics.trade.contender import Contender, all_contenders
from numerics.trade.front import Point, points
from numerics.trade.growth import Extent, Growth, growth
from numerics.trade.interface import Wait, interface
from numerics.trade.machine import machine
from numerics.trade.measure import SOURCE, Limits, Measurement, References, measure, not_tried, run
from numerics.trade.reference import POINT_DIGITS
from numerics.trade.scenes import Benchmark, benchmarks

Progress = Callable[[str], None]
_COMPILING = Limits(prepare=300, run=60, budget=0)
TIME_IS_UP = "the time for this size was up; a larger --size, or --only"


@dataclass(frozen=True)
class Size:
    """How much is measured."""

    settings: int
    """of each peer at most, spread from its coarsest to its finest"""
    digits: dict[str, float]
    """the most digits of mpmath and of balls"""
    excursions: int
    """of the long scene"""
    scenes: tuple[str, ...]
    """the beginnings of the names of the scenes"""
    limits: Limits
    long_run: float
    """how long the parent waits for one run of the long scene, s"""
    extent: Extent
    reference_limit: float = 900.0
    forced_digits: float = 1000
    """the most digits of both under a force, where a reference takes longer"""
    whole: float = math.inf
    """after so many seconds, compiling our own code apart, nothing more is begun, s; ours come first"""


_DECADES = (10.0, 30.0, 50.0, 100.0, 300.0, 1000.0, 3000.0, 10_000.0)
SIZES = {
    "small": Size(
        settings=2,
        digits={"mpmath": 100, "ball": 100},
        excursions=300,
        scenes=("relative-motion-b05", "near-critical-1e-6", "long", "forced-stick-slip"),
        limits=Limits(prepare=30, run=0.5, budget=0.02),
        long_run=0.5,
        extent=Extent((10, 100), (10, 100), (1, 100), (-12, 0, 12)),
        whole=50,
    ),
    "default": Size(
        settings=3,
        digits={"mpmath": 1000, "ball": 10_000},
        excursions=100_000,
        scenes=("",),
        limits=Limits(prepare=40, run=3, budget=0.1),
        long_run=10,
        extent=Extent(_DECADES, (10, 100, 1000, 10_000), (1, 10, 100, 1000, 10_000), (-12, -6, -3, 0, 3, 6, 12)),
    ),
    "large": Size(
        settings=100,
        digits={"mpmath": 10_000, "ball": 10_000},
        excursions=100_000,
        scenes=("",),
        limits=Limits(prepare=90, run=60, budget=0.5),
        long_run=300,
        extent=Extent(
            _DECADES, (10, 100, 1000, 10_000, 100_000), (1, 10, 100, 1000, 10_000, 100_000), tuple(range(-12, 13))
        ),
    ),
}


@dataclass(frozen=True)
class Trade:
    """Everything that one run found."""

    size: str
    machine: dict[str, Any]
    scenes: list[Benchmark]
    contenders: list[Contender]
    """Who took part."""
    left_out: dict[str, str]
    """Contenders that are not installed, with what is missing."""
    measurements: list[Measurement]
    references: list[dict[str, Any]]
    growth: list[Growth]
    interface: list[Wait]
    """What a user waits for; empty where only some were asked for."""

    def points(self, scene: Benchmark) -> list[Point]:
        """Return the measured points of one scene."""
        return points(one for one in self.measurements if one.scene == scene.name)


def trade(
    size_name: str,
    only: Sequence[str] = (),
    progress: Progress = lambda _: None,
    contenders: Sequence[Contender] | None = None,
    source: str = SOURCE,
) -> Trade:
    """Measure everybody on every scene; `only` keeps those whose names contain one of its texts.

    Raises NoSuchContender if a text fits no name. `source` names the function that a child gets its contenders from.
    """
    size = SIZES[size_name]
    everyone = list(contenders) if contenders is not None else all_contenders()
    scenes = [one for one in benchmarks(size.excursions) if one.name.startswith(size.scenes)]
    everyone, scenes = selected(everyone, scenes, only)
    left_out = {one.label: missing for one in everyone if (missing := one.missing()) is not None}
    present = [one for one in everyone if one.label not in left_out and taken(one, scenes)]
    found: list[Measurement] = []
    of = machine()  # before it has work to do for us
    with Child() as child, Child() as prover:
        references = References(prover, size.reference_limit)
        for scene in scenes:
            progress(f"{scene.name}: the proved reference")
            references.get(scene, POINT_DIGITS)
        for contender in present if size.whole < math.inf else ():
            for scene in taken(contender, scenes) if contender.ours and contender.knob == "bits" else ():
                progress(f"{contender.label}: compiling, if it was not before")
                run(child, source, contender.label, scene, contender.settings[0], _COMPILING)
        deadline = Deadline(size.whole)
        for contender in present:
            if not contender.ours and size.whole == math.inf:
                child.end()  # a new one for each, which imports once for all scenes; one for all where time is short
            for scene in taken(contender, scenes):
                limits = replace(size.limits, run=size.long_run) if scene.name.startswith("long") else size.limits
                progress(f"{contender.label}: {scene.name}")
                if deadline.left() == 0:
                    found += [not_tried(contender, scene, one, TIME_IS_UP) for one in settings(contender, size, scene)]
                    continue
                limits = replace(limits, prepare=min(limits.prepare, deadline.left()))
                found += measure(child, references, contender, scene, settings(contender, size, scene), limits, source)
        curves = growth(child, references, present, size.extent, size.limits, progress, source, deadline)
        grown = [] if all(one.scene.is_forced for one in scenes) else list(curves)
    waits = []
    if not only and contenders is None and deadline.left() > 0:
        progress("what a user waits for")
        waits = interface(size.limits.budget, size_name != "small")
    return Trade(size_name, of, scenes, present, left_out, found, references.as_records(), grown, waits)


def taken(contender: Contender, scenes: Sequence[Benchmark]) -> list[Benchmark]:
    """Return the scenes that a contender is made for."""
    return [one for one in scenes if contender.takes(one.scene)]


class NoSuchContender(NumericsError):
    """A name that fits no contender and no scene; the message lists them."""


def selected(
    everyone: list[Contender], scenes: list[Benchmark], only: Sequence[str]
) -> tuple[list[Contender], list[Benchmark]]:
    """Return the contenders and the scenes that `only` names, all of a kind of which it names none."""
    for text in only:
        if not text.strip() or not any(
            text.lower() in name.lower() for name in [one.label for one in everyone] + [s.name for s in scenes]
        ):
            known = "; ".join([one.label for one in everyone] + [one.name for one in scenes])
            raise NoSuchContender(f"--only {text[:40]!r} fits no contender and no scene; they are: {known}")
    some = [one for one in everyone if _named(one.label, only)]
    few = [one for one in scenes if _named(one.name, only)]
    return some or everyone, few or scenes


def _named(name: str, only: Sequence[str]) -> bool:
    return any(text.lower() in name.lower() for text in only)


def settings(contender: Contender, size: Size, scene: Benchmark) -> tuple[float, ...]:
    """Return the settings of a contender that this size measures on a scene."""
    if contender.name in size.digits and contender.ours:
        most = size.digits[contender.name]
        most = min(most, size.forced_digits) if scene.scene.is_forced else most
        return tuple(one for one in contender.settings if one <= most)
    return thinned(contender.settings, size.settings)


def thinned(values: Sequence[float], most: int) -> tuple[float, ...]:
    """Return at most so many values, spread evenly over their order, the last among them.

    >>> thinned((1.0, 2.0, 3.0, 4.0, 5.0), 3), thinned((1.0, 2.0), 5)
    ((1.0, 3.0, 5.0), (1.0, 2.0))
    """
    if len(values) <= most:
        return tuple(values)
    last = len(values) - 1
    return tuple(values[round(index * last / (most - 1)) if most > 1 else last] for index in range(most))
