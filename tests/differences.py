"""Derivatives of a scene by differences of solves in balls: no derivative is written down here."""

import re
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from numerics import InvalidScene, Mode, Scene, sensitivities, solve
from numerics.arithmetic.ball import Ball
from numerics.scene.model import parameters

STEP, DIGITS = Fraction(1, 10**75), 180
"""So far numbers are moved: nearer than whatever decides a start that is nearly a tie. What a difference is off by is
of that size, too."""
SMALLEST = arb("1e-20")
"""A derivative that is smaller beside the others may be 0."""


class Deviation(NamedTuple):
    """The largest deviation in one direction, of the sum of what the numbers bring about; whether of events, too."""

    size: float
    events_compared: bool


def moved(scene: Scene, by: Mapping[str, Fraction]) -> Scene | None:
    """The scene with some numbers changed, if it is one."""
    values = parameters(scene)
    try:
        for name, change in by.items():
            value = values[name] + change
            scene = put(scene, place_of(name), value) if "." in name else scene.replace(**{name: value})
    except (InvalidScene, IndexError):  # what is 0 all along has no coefficient
        return None
    return scene


def place_of(name: str) -> list[Any]:
    """Where a number stands in a scene, from attribute to attribute."""
    match [int(one) if one.isdigit() else one for one in re.findall(r"\w+", name)]:
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
    changed = {first: put(getattr(of, first), rest, value)}
    return of.replace(**changed) if isinstance(of, Scene) else replace(of, **changed)  # body 2 goes with another belt


def everything(base: Any) -> dict[str, Fraction]:
    """A direction that moves all numbers at once, no two alike, to the side on which one-sided derivatives are.

    Not a start at t = 0 where the pair slips from v1 = v2: before it the pair may stick, but not if v1 - v2 moves too;
    nor that of a belt, which is another velocity of body 2.
    """
    mode, scene = base.modes[0].sign, base.scene
    weights = {name: Fraction(k + 3, 12) for k, name in enumerate(parameters(scene))}
    weights |= {"x1": Fraction(-1), "v1": Fraction(3 * mode or 2)}
    weights |= {"a2": Fraction(-1, 3)} if scene.pair.a2 else {}
    weights |= {} if scene.pair.is_fixed else {"v2": Fraction(mode or 2)}
    if scene.pair.is_fixed or (mode and scene.initial.v1 == scene.initial.v2):
        weights = {name: one for name, one in weights.items() if not is_first_start(scene, name)}
    return {name: one for name, one in weights.items() if moved(scene, {name: one * STEP})}


def is_first_start(scene: Scene, name: str) -> bool:
    """Whether this is the start of a piece, at t = 0."""
    return name.endswith("from") and parameters(scene)[name] == 0


def numbers(run: Any, events: int, t: Fraction) -> list[arb]:
    """The final state, its energy, the state at a time and the last so many events."""
    found = [*run.final_state, run.final_energy, *run.sol(t)]
    for event in run.events[len(run.events) - events :]:
        found += [event.t, *event.y]
    return found


def neighbour(base: Any, scene: Scene | None) -> Any:
    """The solution of a neighbour, up to the same event; it may start with one short slip or stick more."""
    if scene is None:
        return None
    most = len(base.events) + (1000 if base.reached else 0)
    found = solve(scene, digits=DIGITS, arithmetic="ball", max_events=most)
    if not base.reached and found.modes[0] != base.modes[0]:
        found = solve(scene, digits=DIGITS, arithmetic="ball", max_events=most + 1)
    return found


def same(base: Any, near: Any) -> bool:
    """Whether a neighbour has the events of a run."""
    more = near is not None and base.modes[0] is Mode.STICK and near.modes[1:] == base.modes
    return near is not None and (more or near.modes == base.modes)


def deviation(base: Any, direction: Mapping[str, Fraction], sides: tuple[int, ...] = (1, -1)) -> Deviation:
    """Compare derivatives in a direction with a difference, to the first side that has the same events, if one does."""
    scene, names, middle = base.scene, list(direction), Fraction(3 * float(base.end_time)) / 8
    found, within = sensitivities(base, wrt=names), sensitivities(base, middle, wrt=names)
    way = {name: one * (abs(parameters(scene)[name]) or 1) for name, one in direction.items()}
    solved = ((k, neighbour(base, moved(scene, {name: k * STEP * one for name, one in way.items()}))) for k in sides)
    nears = [one for one in solved if one[1] is not None]
    side, near = next((one for one in nears if same(base, one[1])), nears[0])
    events = len(base.events) if same(base, near) else 0
    with base.context():
        rows = [*found.final, found.energy, *within]
        for t, y in list(zip(found.t, found.y, strict=True))[len(found.t) - events :]:
            rows += [t, *y]
        terms = [[slope * Ball.number(one) for slope, one in zip(row, way.values(), strict=True)] for row in rows]
        sizes = [sum(map(abs, row), arb(0)) for row in terms]
        ends = zip(numbers(near, events, middle), numbers(base, events, middle), strict=True)
        off = [
            sum(row, arb(0)) - (one - two) * Ball.number(side / STEP)
            for row, (one, two) in zip(terms, ends, strict=True)
        ]
        least = SMALLEST * max(*sizes, SMALLEST)
        size = max(float((abs(one) / (all_of_it + least)).upper()) for one, all_of_it in zip(off, sizes, strict=True))
    return Deviation(size, same(base, near))
