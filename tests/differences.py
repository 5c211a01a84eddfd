"""Derivatives of a scene by differences of solves in balls: no derivative is written down here."""

import re
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb, fmpq

from numerics import InvalidScene, Mode, Scene, sensitivities, solve
from numerics.scene.model import parameters

SMALLEST = 1e-9
"""Derivatives that are all smaller, in the scene's own units, are compared absolutely: they may be 0."""
CENTRAL = {-2: Fraction(1, 12), -1: Fraction(-2, 3), 1: Fraction(2, 3), 2: Fraction(-1, 12)}
FORWARD = {0: Fraction(-11, 6), 1: Fraction(3), 2: Fraction(-3, 2), 3: Fraction(1, 3)}
"""Differences with Richardson's extrapolation: errors of the fourth and the third power of the step."""


class Deviation(NamedTuple):
    """The largest deviation in one direction, relative to the largest derivative; whether events were compared."""

    size: float
    events_compared: bool


def moved(scene: Scene, by: Mapping[str, Fraction]) -> Scene | None:
    """The scene with some numbers changed, if it is one."""
    values = parameters(scene)
    try:
        for name, change in by.items():
            scene = put(scene, place_of(name), values[name] + change)
    except InvalidScene:
        return None
    return scene


def place_of(name: str) -> list[Any]:
    """Where a number stands in a scene, from attribute to attribute."""
    match [int(one) if one.isdigit() else one for one in re.findall(r"\w+", name)]:
        case ["until"]:
            return ["until"]
        case [one]:
            return ["initial" if one[0] in "xv" else "pair", one]
        case [("force" | "force_2" | "belt" | "wall" | "friction") as signal, k, *rest]:
            within = {"from": ["start"], "b": ["polynomial", 0]}
            return [signal, "pieces", k, *(found for one in rest for found in within.get(one, [one]))]
        case ["weakening", table, *point]:
            return ["friction", "weakening", table, *point[:1], *("wbzc".index(one) % 2 for one in point[1:])]
    raise AssertionError(name)


def put(of: Any, place: list[Any], value: Fraction) -> Any:
    """What somebody gave, with another number in one place."""
    if not place:
        return value
    first, *rest = place
    if isinstance(first, int):
        return (*of[:first], put(of[first], rest, value), *of[first + 1 :])
    return replace(of, **{first: put(getattr(of, first), rest, value)})


def natural_scale(scene: Scene, name: str) -> Fraction:
    """The size of a number, or what it would be for this pair: L, L Omega, b, b Omega^k, 1/Omega, ..."""
    pair, value = scene.pair, abs(parameters(scene)[name])
    rate = Fraction(float(pair.a2 / pair.mass) ** 0.5)
    power = re.search(r"polynomial\[(\d+)\]", name)
    if power:
        return max(value, pair.b * rate ** int(power[1]) / 10)
    sizes = {"x1": pair.half_width, "x2": pair.half_width, "a1": rate * pair.mass, "until": 1 / rate}
    sizes |= {"v1": pair.half_width * rate, "v2": pair.half_width * rate}
    if name.endswith(("from", "phase")):
        return 1 / rate if name.endswith("from") else Fraction(1)
    return sizes.get(name, value)


def everything(base: Any) -> dict[str, Fraction]:
    """A direction that moves all numbers at once, no two alike, to the side on which one-sided derivatives are.

    Not a start at t = 0 where the pair slips from v1 = v2: before it the pair may stick, but not if v1 - v2 moves too.
    """
    mode, scene = base.modes[0].sign, base.scene
    weights = {name: Fraction(1 + k * k % 7, 4) for k, name in enumerate(parameters(scene))}
    if mode and scene.initial.v1 == scene.initial.v2:
        weights = {name: one for name, one in weights.items() if not is_first_start(scene, name)}
    return weights | {
        "x1": Fraction(-1),
        "a2": Fraction(-1, 3),
        "v1": Fraction(3 * mode or 2),
        "v2": Fraction(mode or 2),
    }


def is_first_start(scene: Scene, name: str) -> bool:
    """Whether this is the start of a piece, at t = 0."""
    return name.endswith("from") and parameters(scene)[name] == 0


def numbers(trajectory: Any, events: int) -> list[arb]:
    """The final state, its energy and the last so many events."""
    found = [*trajectory.final_state, trajectory.final_energy]
    for event in trajectory.events[len(trajectory.events) - events :]:
        found += [event.t, *event.y]
    return found


def neighbour(base: Any, scene: Scene | None, digits: int) -> Any:
    """The solution of a neighbour, up to the same event; it may start with one short slip or stick more."""
    if scene is None:
        return None
    most = len(base.events) + (1000 if base.reached else 0)
    found = solve(scene, digits=digits, arithmetic="ball", max_events=most)
    if not base.reached and found.modes[0] != base.modes[0]:
        found = solve(scene, digits=digits, arithmetic="ball", max_events=most + 1)
    return found


def deviation(base: Any, direction: Mapping[str, Fraction], digits: int, step: Fraction) -> Deviation:
    """Compare the derivatives in a direction with differences; one-sided where only that side has the same events."""
    scene, found = base.scene, sensitivities(base, wrt=list(parameters(base.scene)))
    way = {name: weight * natural_scale(scene, name) for name, weight in direction.items()}
    known: dict[int, Any] = {0: base}

    def solved(k: int) -> Any:
        if k not in known:
            known[k] = neighbour(base, moved(scene, {name: k * step * one for name, one in way.items()}), digits)
        return known[k]

    def same(k: int) -> bool:
        more = solved(k) is not None and base.modes[0] is Mode.STICK and solved(k).modes[1:] == base.modes
        return solved(k) is not None and (more or solved(k).modes == base.modes)

    ways = [(CENTRAL, 1), (FORWARD, 1), (FORWARD, -1)]
    chosen = next((one for one in ways if all(same(k * one[1]) for k in one[0])), None)
    weights, side = chosen or next(one for one in ways if all(solved(k * one[1]) is not None for k in one[0]))
    events, frame = len(base.events) if chosen else 0, base.frame
    with base.arithmetic.context():
        state = frame.length, frame.speed, frame.length, frame.speed
        scales = [*state, frame.critical_energy, *(1 / frame.rate, *state) * events]
        rows = [*found.final, found.energy]
        for t, y in list(zip(found.t, found.y, strict=True))[len(found.t) - events :]:
            rows += [t, *y]
        terms = [(found.wrt.index(name), ball(one)) for name, one in way.items()]
        ours = [sum((row[k] * one for k, one in terms), arb(0)) / u for row, u in zip(rows, scales, strict=True)]
        ends = [(ball(w / step * side), numbers(solved(k * side), events)) for k, w in weights.items()]
        theirs = [sum((w * row[i] for w, row in ends), arb(0)) / unit for i, unit in enumerate(scales)]
        largest = max(float(abs(one).upper()) for one in ours)
        size = max(float(abs(one - two).upper()) for one, two in zip(ours, theirs, strict=True))
    return Deviation(size / max(largest, SMALLEST), chosen is not None)


def ball(value: Fraction) -> arb:
    """An exact rational as a ball."""
    return arb(fmpq(value.numerator, value.denominator))
