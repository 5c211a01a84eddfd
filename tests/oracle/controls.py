"""Questions about control and their answers, by name: numbers as enclosures. Public interface only."""

from collections.abc import Callable
from functools import partial
from typing import Any

from numerics import (
    Force,
    Pair,
    Scene,
    State,
    fastest_transfer,
    load_reference,
    load_scene,
    response,
    ring_entry,
    thresholds,
    track,
)

DIGITS = 20
PAIR, FREE = Pair(1, 1, 200, "0.5", 3), Pair(1, 1, 200, "0.5")
PAIRS = {
    "readme": PAIR,
    "free": FREE,
    "light": Pair("0.02", "1.5", 40, "0.3", "0.2"),
    "heavy": Pair(3, "0.2", 15, "0.7", 40),
    "weak": Pair("1.1", "0.9", 200, "0.01", 1),
}


def under(pair: Pair, amplitude: object, omega: object) -> Scene:
    return Scene(pair, State(), until=5, force=Force.sine(amplitude, omega))


SHAKEN = {
    "readme": under(PAIR, "0.5", 12),
    **{
        f"amplitude {amplitude} at {omega}": under(PAIR, amplitude, omega)
        for amplitude in ("0.2", "1", "2", "5", "20")
        for omega in (5, 12, 20)
    },
    **{f"free {amplitude} at {omega}": under(FREE, amplitude, omega) for amplitude in (1, 9) for omega in (7, 10, 30)},
    **{
        f"shipped {name}": load_scene(f"forced-{name}")
        for name in ("sine-stick-slip", "sine-entrained", "sine-non-stop", "resonance", "sweep", "friction-by-pieces")
    },
}


def of_response(scene: Scene) -> dict[str, Any]:
    """Regime, events of the period (mode that begins, t, x1, v), multipliers, drift, growth."""
    found = response(scene, digits=DIGITS)
    legs = [] if found.orbit is None else [[one.side, one.start, *one.state[:2]] for one in found.orbit.legs]
    multipliers = None if found.multipliers is None else list(found.multipliers)
    return {
        "regime": found.regime.name,
        "legs": legs,
        "multipliers": multipliers,
        "drift": found.drift,
        "growth": found.growth,
        "attraction": found.attraction,
    }


def of_thresholds(pair: Pair, omega: object) -> list[Any]:
    found = thresholds(pair, omega, digits=DIGITS)
    return [found.entrainment, found.non_stop, found.exception]


def of_transfer(pair: Pair, distance: object, **asked: Any) -> dict[str, Any]:
    found = fastest_transfer(Scene(pair, State(), until=1), distance, digits=DIGITS, **asked)
    numbers = {name: getattr(found, name) for name in ("bound", "time", "stuck_amplitude", "least_amplitude")}
    return {"road": found.road.name, "fastest": found.fastest, **numbers}


def of_track(scene: Scene, reference: str) -> dict[str, Any]:
    found = track(scene, load_reference(reference), digits=DIGITS)
    demands = [[one.number, one.force, one.possible] for one in found.demands]
    return {"share": found.share, "demands": demands, "possible": found.scene is not None}


def of_ring(scene: Scene, radius: object, **asked: Any) -> dict[str, Any]:
    found = ring_entry(scene, radius, digits=DIGITS, **asked)
    return {"centre": found.centre, "entry": found.entry}


def answers() -> dict[str, Callable[[], Any]]:
    """Every question by its name, not yet asked."""
    asked: dict[str, Callable[[], Any]] = {}
    for name, scene in SHAKEN.items():
        asked[f"response: {name}"] = partial(of_response, scene)
    for name, pair in PAIRS.items():
        for omega in (1, "3.7", 12, 20, 55):
            asked[f"thresholds: {name} at {omega}"] = partial(of_thresholds, pair, omega)
        for distance in ("0.001", "0.01", "-0.1"):
            asked[f"transfer: {name} by {distance}"] = partial(of_transfer, pair, distance)
        for amplitude in ("1.08", 3, 40):
            asked[f"transfer: {name} with {amplitude}"] = partial(of_transfer, pair, "0.001", amplitude=amplitude)
        asked[f"transfer: {name} with a margin"] = partial(of_transfer, pair, "0.01", margin="0.05")
        for reference in ("s-curve", "too-fast"):
            asked[f"track: {name} on {reference}"] = partial(of_track, Scene(pair, State(), until=1), reference)
    rings = [("0.001", 1), ("0.001", 20), ("0.02", 5)]
    scenes = {"velocities": rings, "start-with-speed": rings, "relative-motion-b02": rings}
    scenes |= {f"forced-{name}": rings[:1] for name in ("sine-stick-slip", "sine-entrained", "sine-non-stop", "step")}
    for name, questions in scenes.items():
        for radius, rate in questions:
            asked[f"ring: {name} of {radius}, {rate}"] = partial(of_ring, load_scene(name), radius, rate=rate)
    return asked
