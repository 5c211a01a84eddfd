"""One answer of the package held against the frozen one, through the public interface."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from flint import acb, arb

from numerics import EventUndecided, NumericsError, OutOfRange, solve
from oracle.reading import scene_of

WAYS: dict[str, dict[str, Any]] = {
    "ball": {"arithmetic": "ball", "digits": 30, "max_digits": 1500},
    "float64": {"arithmetic": "float64"},
    "double-double": {"arithmetic": "double-double"},
    "mpmath": {"arithmetic": "mpmath", "digits": 40},
    "default": {},
    "digits=12": {"digits": 12, "max_digits": 1500},
    "digits=20": {"digits": 20, "max_digits": 1500},
}
"""What solve is asked for."""
RIGHT = {"ball": 29, "digits=12": 11, "digits=20": 19, "default": 6}
"""How many digits a ball must have, of its scale."""
FIXED = {"float64", "double-double", "mpmath"}
"""Those that do not climb: they may say that they are in doubt."""
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
NAMES = ("t", "x1", "v1", "x2", "v2")
FROZEN, FROZEN_LEDGER = Fraction(1, 10**23), Fraction(1, 10**19)
"""By how much of itself a frozen number may be off: it is rounded."""
NOTHING, NOTHING_IN_FLOATS = Fraction(1, 10**100), Fraction(1, 10**30)
"""A frozen 0 is less than this of its scale; points are not asked for more."""


@dataclass
class Outcome:
    """What came of one scene: its differences, in words, or why there is nothing to compare."""

    name: str
    differences: list[str] = field(default_factory=list)
    left_open: str = ""


def exact(value: Any) -> tuple[Fraction, Fraction]:
    """A number of any arithmetic as midpoint and radius."""
    if isinstance(value, arb):
        return dyadic(value.mid()), dyadic(value.rad())
    if hasattr(value, "man_exp"):
        mantissa, exponent = value.man_exp
        return (-1 if value < 0 else 1) * abs(Fraction(int(mantissa))) * Fraction(2) ** int(exponent), Fraction(0)
    if isinstance(value, tuple):  # a sum of floats
        return sum(map(Fraction, value), Fraction(0)), Fraction(0)
    return Fraction(value), Fraction(0)


def dyadic(value: arb) -> Fraction:
    mantissa, exponent = value.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


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
    if status != frozen and (status, frozen) not in may_differ:
        yield f"status {status}, not {frozen}"
    if (status, frozen) == ("STUCK_FOR_EVER", "REACHED_HORIZON") and not stays(scene, len(events)):
        yield "said to be stuck for ever, and slips later"
    yield from compared_numbers(answer, found, events, right)


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
    rows = [(f"event {k}", int(k), [Fraction(one) for one in row]) for k, row in answer["events"].items()]
    rows.append(("end", -1, [Fraction(one) for one in answer["final"]]))
    tops = [max(abs(row[k]) for _, _, row in rows) for k in range(5)]
    scales = [tops[0], *(max(tops[k], tops[k + 2 if k < 3 else k - 2]) for k in range(1, 5))]
    for where, index, row in rows:
        got = (events[index].t, *events[index].y) if index >= 0 else (found.end_time, *found.final_state)
        bounds = bounds_of(found, index, scales)
        for name, value, true, bound, scale in zip(NAMES, got, row, bounds, scales, strict=True):
            middle, radius = exact(value)
            if radius > scale / 10**right:
                yield f"{name} at {where}: radius {short(radius)}, scale {short(scale)}"
            nothing = NOTHING if bound is None else NOTHING_IN_FLOATS
            allowed = (radius if bound is None else bound) + abs(true) * FROZEN + scale * nothing
            if abs(middle - true) > allowed:
                off = short(abs(middle - true))
                yield f"{name} at {where}: off by {off}, allowed {short(allowed)}, of {short(true)}"
    yield from compared_energies(answer, found)


def bounds_of(found: Any, index: int, scales: list[Fraction]) -> list[Fraction | None]:
    """The stated bounds of (t, x1, v1, x2, v2); None for balls, which say it themselves."""
    accuracy = found.accuracy
    if found.arithmetic.name == "ball":
        return [None] * 5
    if accuracy is None:
        return [scale / 10**25 for scale in scales]
    if index >= 0:
        return [bound(accuracy.t[index]), *map(bound, accuracy.y[index])]
    last = bound(accuracy.t[-1]) if not found.reached else Fraction(0)
    rounding = Fraction(1, 2 ** (50 if found.arithmetic.name == "float64" else 100))
    return [last + scales[0] * rounding, *map(bound, accuracy.final)]


def bound(value: float) -> Fraction:
    """A bound as it is; no bound at all is a large one."""
    return Fraction(value) if abs(value) < float("inf") else Fraction(10) ** 400


def short(value: Fraction) -> str:
    try:
        return f"{float(value):.3g}"
    except OverflowError:
        return "more than 1e308"


def compared_energies(answer: dict[str, Any], found: Any) -> Iterator[str]:
    """E/E_cr - 1 at the end, and the ledger; points have a bound of both."""
    accuracy, balls = found.accuracy, found.arithmetic.name == "ball"
    with found.arithmetic.context():
        ledger, excess = found.ledger, found.final.w
        parts = [exact(one) for one in (ledger.friction, ledger.viscous, ledger.work)]
    true, (middle, radius) = Fraction(answer["excess"]), exact(excess)
    slack = radius if balls else Fraction(1, 10**25) if accuracy is None else bound(accuracy.energy_excess)
    if abs(middle - true) > slack + abs(true) * FROZEN + NOTHING * (1 + abs(true)):
        yield f"excess: off by {short(abs(middle - true))}, allowed {short(slack)}, of {short(true)}"
    truths = [Fraction(one) for one in answer["ledger"]]
    size = sum(map(abs, truths))
    if not balls:
        points = size / 10**9 if found.arithmetic.name == "float64" else size / 10**17
        points = max(points, Fraction(1, 10**50)) if found.arithmetic.name == "mpmath" else points
        points += bound(accuracy.dissipated) + bound(accuracy.energy) if accuracy is not None else 0
        got = parts[0][0] + parts[1][0] - parts[2][0]
        if abs(got - (truths[0] + truths[1] - truths[2])) > points:
            yield f"ledger: {short(got)} lost, not {short(truths[0] + truths[1] - truths[2])}"
        return
    for name, (middle, radius), true in zip(("friction", "viscous", "work"), parts, truths, strict=True):
        if abs(middle - true) > radius + abs(true) * FROZEN_LEDGER + size * NOTHING:
            yield f"{name}: off by {short(abs(middle - true))}, radius {short(radius)}, of {short(true)}"


def same(frozen: Any, got: Any) -> bool:
    """An answer of control against the frozen one: numbers within their radius, all else equal."""
    if isinstance(got, acb):  # of two conjugates either was frozen first
        return any(same(frozen, [got.real, imag]) for imag in (got.imag, -got.imag))
    if isinstance(got, arb):
        middle, radius = exact(got)
        true = Fraction(frozen)
        return abs(middle - true) <= radius + abs(true) * FROZEN_LEDGER + NOTHING
    if isinstance(got, dict):
        return set(got) == set(frozen) and all(same(frozen[key], one) for key, one in got.items())
    if isinstance(got, list | tuple):
        return len(frozen) == len(got) and all(map(same, frozen, got))
    return bool(frozen == got)
