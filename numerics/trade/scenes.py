"""The scenes on which everything is measured: the paper's, near-critical ones, a long one, and some under a force."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from numerics.scene import Force, Friction, Pair, Scene, State
from numerics.scene.file import load_scene, parse_scene
from numerics.scene.writing import scene_text

HEADLINE = "relative-motion-b05"
"""The scene of the headline ratios."""
FORCED = "forced-"
"""How the names of the scenes under a force begin."""
EXCURSIONS = 16
"""Horizon of the near-critical scenes, in excursions."""


@dataclass(frozen=True)
class Benchmark:
    """A scene with its name, and why it is measured."""

    name: str
    why: str
    scene: Scene


def paper_scenes() -> list[Benchmark]:
    """Return the three pairs of the paper's Section IV, as shipped, 5 s each; b = 0.5 is figure 4 (b) as well."""
    return [
        Benchmark("velocities", "the paper's b = 0.05: first crossings, then excursions", load_scene("velocities")),
        Benchmark("relative-motion-b02", "the paper's b = 0.2", load_scene("relative-motion-b02")),
        Benchmark(HEADLINE, "the paper's b = 0.5, also its figure 4 (b): the headline ratios", load_scene(HEADLINE)),
    ]


def near_critical(speed: str, excess: str) -> Benchmark:
    """Return the pair on its exit ray x1 = L with v1 = v2 = `speed` (m/s), so w = speed^2/0.0025, for 16 excursions."""
    pair = Pair(m1=1, m2=1, a2=200, b="0.5")
    start = State(x1=pair.half_width, v1=speed, v2=speed)
    why = f"close above E_cr: slips of about {3 * math.sqrt(float(excess)) / 10:.0e} s, {EXCURSIONS} times"
    # half an excursion past the sixteenth, so that no event falls on the horizon
    horizon = Fraction(round((EXCURSIONS + 0.5) * math.pi / 10 * 1000), 1000)
    return Benchmark(f"near-critical-{excess}", why, Scene(pair, start, until=horizon))


def long_scene(excursions: int) -> Benchmark:
    """Return figure 5 (b)'s pair and start until it has made about this many excursions, pi/10 s each."""
    why = f"about {excursions} excursions: whether errors, and costs, pile up"
    return Benchmark(f"long-{excursions}", why, _headline_until(math.ceil(excursions * math.pi / 10)))


def forced_scenes() -> list[Benchmark]:
    """Return scenes with a force or a friction in time; their names begin with FORCED."""
    pair, damped = Pair(m1=1, m2=1, a2=200, b="0.05"), Pair(m1=1, m2=1, a2=200, b="0.05", a1=1)
    stuck = State(v1="0.01000001", v2="0.01000001")
    steps = Force.step("0.1", "0.3") + Force.trapezoid("0.6", "0.2", "0.3", "0.1", "-0.5")
    pieces = Friction([("0.9", "0.02"), ("1.7", "0.2"), ("3.1", "0.05")])
    sums = Force.sine("0.35", 5) + Force.sine("0.25", "7.3")
    return [
        _forced("stick-slip", "stick and slip twice a period, between U* and U**", damped, Force.sine("0.45", 5), 10),
        _forced(
            "touch", "1e-6 above U*: the load leaves its edge for 8e-4 s", pair, Force.sine("0.3000003", 5), 6, stuck
        ),
        _forced("jumps", "a step that breaks adhesion, then a trapezoid", pair, steps, 3),
        _forced("friction", "b in four pieces under a sine", damped, Force.sine("0.5", 5), 6, friction=pieces),
        _forced("two-sines", "two incommensurate sines for 100 s: whether errors pile up", damped, sums, 100),
    ]


def _forced(
    name: str,
    why: str,
    pair: Pair,
    force: Force,
    until: int,
    start: State | None = None,
    friction: Friction | None = None,
) -> Benchmark:
    scene = Scene(pair, start or State(), until, force=force, friction=friction or Friction())
    return Benchmark(f"{FORCED}{name}", why, scene)


def benchmarks(excursions: int) -> list[Benchmark]:
    """Return every scene; the long one with so many excursions. Those under a force come last."""
    near = [near_critical("0.00158", "1e-3"), near_critical("5e-5", "1e-6"), near_critical("5e-8", "1e-12")]
    return [*paper_scenes(), *near, long_scene(excursions), *forced_scenes()]


def of_mass_ratio(ratio: Fraction) -> Benchmark:
    """Return a pair with m1/m2 = `ratio` and M = 2 kg, started on its exit ray with w = 1, for 20 events or so.

    A light body 1 makes slips of about 2 pi sqrt(m1/M)/Omega one after another, so its horizon is shorter.
    """
    pair = Pair(m1=2 * ratio / (1 + ratio), m2=2 / (1 + ratio), a2=200, b="0.5")
    speed = 10 * pair.half_width  # L Omega with Omega = sqrt(200/2) s^-1, exactly
    start = State(x1=pair.half_width, v1=speed, v2=speed)
    horizon = 3.3 * min(1.0, 2.2 * math.sqrt(pair.m1 / pair.mass))
    name = f"m1/m2={float(ratio):.0e}"
    return Benchmark(name, "how cost depends on the masses", Scene(pair, start, until=f"{horizon:.3g}"))


def of_length(excursions: int) -> Benchmark:
    """Return the headline scene with about this many excursions."""
    return Benchmark(f"{excursions} excursions", "how cost grows with the events", long_scene(excursions).scene)


def _headline_until(until: int) -> Scene:
    shipped = load_scene(HEADLINE)
    return Scene(shipped.pair, shipped.initial, until, shipped.law)


def scene_as_record(scene: Scene) -> dict[str, Any]:
    """Return a scene as plain text that loses nothing, for another process."""
    return {"toml": scene_text(scene)}


def scene_from_record(record: dict[str, Any]) -> Scene:
    """Return the scene that `scene_as_record` wrote down."""
    return parse_scene(record["toml"])
