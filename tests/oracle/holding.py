"""One answer of the package held against the frozen one, through the public interface."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from flint import acb, arb

from numerics import EventUndecided, NumericsError, OutOfRange, solve
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.trajectory.comparison import as_ball
from oracle.reading import scene_of

WAYS: dict[str, dict[str, Any]] = {
    "ball": {"arithmetic": "ball", "digits": 30, "max_digits": 1500},
    "float64": {"arithmetic": "float64"},
    "mpmath": {"arithmetic": "mpmath", "digits": 40},
    "default": {},
    "digits=12": {"digits": 12, "max_digits": 1500},
    "digits=20": {"digits": 20, "max_digits": 1500},
}
"""What solve is asked for."""
RIGHT = {"ball": 29, "digits=12": 11, "digits=20": 19, "default": 6}
"""How many digits a ball must have, of its scale."""
FIXED = {"float64", "mpmath"}
"""Those that do not climb: they may say that they are in doubt."""
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
BITS = 5000
"""Of what is compared."""
NAMES = ("t", "x1", "v1", "x2", "v2")
FROZEN, FROZEN_LEDGER = arb("1e-23"), arb("1e-19")
"""By how much of itself a frozen number may be off: it is rounded."""
NOTHING, NOTHING_IN_FLOATS = arb("1e-100"), arb("1e-30")
"""A frozen 0 is less than this of its scale; points are not asked for more."""


@dataclass
class Outcome:
    """What came of one scene: its differences, in words, or why there is nothing to compare."""

    name: str
    differences: list[str] = field(default_factory=list)
    left_open: str = ""


def near(value: Any, off: Any) -> arb:
    """A ball about a number of any arithmetic; what has no bound may be anything."""
    return as_ball(value) + arb(0, off if off < math.inf else math.inf)


def differing(what: str, got: arb, true: arb, off: arb) -> Iterator[str]:
    """A sentence, if a number cannot be within so much of the frozen one."""
    if not got.overlaps(near(true, off.upper())):
        yield f"{what}: {got.str(6)}, not {true.str(6)}"


def held(answer: dict[str, Any], way: str) -> Outcome:
    """Solve the scene of a frozen answer and compare all that is frozen."""
    outcome = Outcome(answer["name"])
    try:
        found = solve(scene_of(answer), max_events=answer["max_events"], **WAYS[way])
    except NumericsError as error:
        refused(outcome, answer, way, error)
        return outcome
    if "refused" in answer:
        outcome.left_open = f"answered where {answer['refused']} was raised"
    elif way in FIXED and not found.certain:
        outcome.left_open = "the sequence is left open"
    else:
        outcome.differences += compared(answer, found, RIGHT.get(way, 0))
    return outcome


def refused(outcome: Outcome, answer: dict[str, Any], way: str, error: NumericsError) -> None:
    """A refusal is right where today refuses, in doubt for one that does not climb, and where a number does not fit."""
    kind = type(error).__name__
    may_refuse = (EventUndecided, OutOfRange) if way in FIXED else OutOfRange if way == "default" else ()
    if "refused" in answer or isinstance(error, may_refuse):
        outcome.left_open = kind
    else:
        outcome.differences.append(f"refused: {kind}: {str(error)[:150]}")


def compared(answer: dict[str, Any], found: Any, right: int) -> Iterator[str]:
    """What differs: sequence first; then, if it is the same, every number."""
    scene, events = found.scene, list(found.events)
    modes = "".join(SIGNS[one.before.value] for one in events) + SIGNS[found.final_mode.value]
    if modes != answer["modes"]:
        yield f"modes {shown(modes, answer['modes'])}"
        return
    causes = "".join(one.cause[0] for one in events)
    if any(two not in (one, "b") for one, two in zip(causes, answer["causes"], strict=True)):
        yield f"causes {shown(causes, answer['causes'])}"
    status, frozen = found.status.name, answer["status"]
    may_differ = {("REACHED_HORIZON", "STUCK_FOR_EVER")} if found.arithmetic.name != "ball" else set()
    if modes[-1] == "0" and (scene.is_forced or scene.force.pieces):
        may_differ.add(("STUCK_FOR_EVER", "REACHED_HORIZON"))
    if found.without_digits:  # such an answer says so first, since it is no success
        may_differ |= {("NO_RIGHT_DIGIT", one) for one in ("STUCK_FOR_EVER", "REACHED_HORIZON")}
    if status != frozen and (status, frozen) not in may_differ:
        yield f"status {status}, not {frozen}"
    if (status, frozen) == ("STUCK_FOR_EVER", "REACHED_HORIZON") and not stays(scene, len(events)):
        yield "said to be stuck for ever, and slips later"
    with precision(BITS):
        yield from compared_numbers(answer, found, events, right)
        yield from compared_energies(answer, found)


def stays(scene: Any, events: int) -> bool:
    """Whether balls find no further event until four times the horizon; what they leave open they do not find."""
    try:
        later = solve(replace(scene, until=4 * scene.until), arithmetic="ball", max_events=events + 1)
    except NumericsError:
        return True
    return len(later.events) <= events


def shown(one: str, two: str) -> str:
    """Two strings where they part."""
    at = next((k for k, (a, b) in enumerate(zip(one, two, strict=False)) if a != b), min(len(one), len(two)))
    return f"{one[: at + 3]!r} ({len(one)}), not {two[: at + 3]!r} ({len(two)}), from {at} on"


def compared_numbers(answer: dict[str, Any], found: Any, events: list[Any], right: int) -> Iterator[str]:
    rows = [(f"event {k}", int(k), numbers(row)) for k, row in answer["events"].items()]
    rows.append(("end", -1, numbers(answer["final"])))
    tops = [max(abs(row[k]) for _, _, row in rows) for k in range(5)]
    scales = [tops[0], *(max(tops[k], tops[k + 2 if k < 3 else k - 2]) for k in range(1, 5))]
    is_ball = found.arithmetic.name == "ball"
    for where, index, row in rows:
        got = (events[index].t, *events[index].y) if index >= 0 else (found.end_time, *found.final_state)
        bounds = [0.0] * 5 if is_ball else bounds_of(found, index, scales)
        for name, value, true, bound, scale in zip(NAMES, got, row, bounds, scales, strict=True):
            if as_ball(value).rad() > scale / 10**right:
                yield f"{name} at {where}: {value.str(6)}, of a scale of {scale.str(6)}"
            nothing = NOTHING if is_ball else NOTHING_IN_FLOATS
            yield from differing(f"{name} at {where}", near(value, bound), true, abs(true) * FROZEN + scale * nothing)


def numbers(texts: list[str]) -> list[arb]:
    return [Ball.number(Fraction(one)) for one in texts]


def bounds_of(found: Any, index: int, scales: list[arb]) -> list[Any]:
    """The stated bounds of points t, x1, v1, x2, v2."""
    accuracy = found.accuracy if found.bounded else None
    if accuracy is None:
        return [(scale / 10**25).upper() for scale in scales]
    if index >= 0:
        return [accuracy.t[index], *accuracy.y[index]]
    last = accuracy.t[-1] if not found.reached else 0.0
    rounding = 2.0**-50
    return [(scales[0] * rounding + last).upper(), *accuracy.final]


def compared_energies(answer: dict[str, Any], found: Any) -> Iterator[str]:
    """E/E_cr - 1 at the end, and the ledger; points have a bound of both."""
    accuracy, kind = found.accuracy if found.bounded else None, found.arithmetic.name
    with found.arithmetic.context():
        ledger, excess = found.ledger, found.reduced.final.w
    is_ball, (true, *truths) = kind == "ball", numbers([answer["excess"], *answer["ledger"]])
    slack = 0.0 if is_ball else 1e-25 if accuracy is None else accuracy.energy_excess
    yield from differing("excess", near(excess, slack), true, abs(true) * FROZEN + NOTHING * (1 + abs(true)))
    parts, size = [as_ball(one) for one in (ledger.friction, ledger.viscous, ledger.work)], sum(map(abs, truths))
    if is_ball:
        for name, got, true in zip(("friction", "viscous", "work"), parts, truths, strict=True):
            yield from differing(name, got, true, abs(true) * FROZEN_LEDGER + size * NOTHING)
        return
    points = size / 10 ** (9 if kind == "float64" else 17) + (arb("1e-50") if kind == "mpmath" else 0)
    known = accuracy.dissipated + accuracy.energy if accuracy is not None else 0.0
    lost, true = (one[0] + one[1] - one[2] for one in (parts, truths))
    yield from differing("ledger", near(lost, known), true, points)


def same(frozen: Any, got: Any) -> bool:
    """An answer of control against the frozen one: numbers within their radius, all else equal."""
    if isinstance(got, acb):  # of two conjugates either was frozen first
        return any(same(frozen, [got.real, imag]) for imag in (got.imag, -got.imag))
    if isinstance(got, arb):
        with precision(BITS):
            (true,) = numbers([frozen])
            return not [*differing("", got, true, abs(true) * FROZEN_LEDGER + NOTHING)]
    if isinstance(got, dict):
        return set(got) == set(frozen) and all(same(frozen[key], one) for key, one in got.items())
    if isinstance(got, list | tuple):
        return len(frozen) == len(got) and all(map(same, frozen, got))
    return bool(frozen == got)
