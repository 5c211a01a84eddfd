"""Answers of the package held against frozen ones, through the public interface."""

from collections.abc import Callable, Iterator
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from typing import Any, NamedTuple

from flint import acb, arb

from numerics import NumericsError, Scene, solve
from numerics.arithmetic.ball import Ball
from numerics.arithmetic.precision import precision
from numerics.trajectory.comparison import as_ball
from numerics.trajectory.export import as_record
from oracle.reading import scene_of

BITS = 5000
"""Of what is compared."""
NAMES = ("t", "x1", "v1", "x2", "v2", "energy", "energy_excess")


class Case(NamedTuple):
    """A frozen answer: its scene, what `solve` is asked for, what may come of it, and what must come out."""

    scene: Scene
    asked: dict[str, Any]
    right: set[str]
    """Names of errors, "open" for a run in doubt, and "right" where an answer is."""
    digits: int | None
    """How many must be right of each number, or of its scale where that is larger."""
    scales: list[Fraction]
    modes: str
    causes: dict[int, str]
    rows: dict[int, list[str | None]]
    """The numbers of events, and of the end, which is -1."""
    rounding: str
    """By how much of itself a frozen number may be off."""
    nothing: str
    """A frozen 0 is less than this of its scale."""
    ledger: tuple[str, ...] = ()
    status: str = ""


def frozen_case(answer: dict[str, Any], way: str) -> Case:
    """A scene of tests/oracle; `way` is an arithmetic, a number of digits, or "default"."""
    fixed = way in {"float64", "mpmath"}  # they do not climb: they may say that they are in doubt
    digits = {"ball": 30, "mpmath": 40, "digits=12": 12, "digits=20": 20}.get(way)
    asked = {"arithmetic": way} if fixed or way == "ball" else {}
    asked |= {"max_events": answer["max_events"]} | ({"digits": digits} if digits else {})
    asked |= {} if fixed or way == "default" else {"max_digits": 1500}
    may = {"OutOfRange"} if fixed or way == "default" else set()
    if fixed:
        may |= {"EventUndecided", "SequenceDiffers", "open"}
    if "refused" in answer:
        return Case(scene_of(answer), asked, {*may, answer["refused"], "open"}, None, [], "", {}, {}, "0", "0")
    rows = {int(n): row for n, row in answer["events"].items()}
    rows[-1] = [*answer["final"], None, answer["excess"]]
    scales = [*largest(rows), Fraction(0), Fraction(1)]
    right = None if fixed else 6 if way == "default" else digits - 1
    rest = "1e-23", "1e-100" if way == "ball" else "1e-30", tuple(answer["ledger"]), answer["status"]
    causes = dict(enumerate(answer["causes"]))
    return Case(scene_of(answer), asked, {*may, "right"}, right, scales, answer["modes"], causes, rows, *rest)


def largest(rows: dict[int, Any]) -> list[Fraction]:
    """The largest time, and of both places and of both velocities the largest, as scales of t, x1, v1, x2 and v2."""
    last, x1, v1, x2, v2 = (max(abs(Fraction(row[k])) for row in rows.values()) for k in range(5))
    return [last, *[max(x1, x2), max(v1, v2)] * 2]


def outcome(case: Case) -> tuple[str, list[str]]:
    """What came of a case: an error, "open" where there is nothing to compare, or "right"; and what differs."""
    try:
        run = solve(case.scene, **case.asked)
        as_record(run, [])  # what has no bounds is held against balls before it is printed
    except NumericsError as error:
        return type(error).__name__, [] if type(error).__name__ in case.right else [str(error)]
    if "right" not in case.right or ("open" in case.right and not run.certain):
        return "open", []
    return "right", [*differences(case, run)]


def differences(case: Case, run: Any) -> Iterator[str]:
    """Sentences on what differs: the sequence first; then, if it is the same, every number."""
    modes = "".join("0+-"[sign] for sign in run.signs)
    if modes != case.modes:
        yield f"modes {modes}, not {case.modes}"
        return
    for n, cause in case.causes.items():
        if cause not in {"b", run.events[n].cause[0]}:
            yield f"cause {run.events[n].cause} of event {n}"
    yield from differences_of_status(case, run)
    with precision(BITS):
        yield from differences_of_numbers(case, run)


def differences_of_status(case: Case, run: Any) -> Iterator[str]:
    """A stick at the horizon may be found to last for ever, if it does, and without balls it may be left open."""
    found, right = run.status.name, case.status
    if (found, right) == ("STUCK_FOR_EVER", "REACHED_HORIZON"):
        if not stays(case.scene, len(run.events)):
            yield "said to be stuck for ever, and slips later"
        return
    may = {right, "NO_RIGHT_DIGIT"}  # such an answer says so first, since it is no success
    if right == "STUCK_FOR_EVER" and run.arithmetic.name != "ball":
        may.add("REACHED_HORIZON")
    if right and found not in may:
        yield f"status {found}, not {right}"


def stays(scene: Scene, events: int) -> bool:
    """Whether balls find no further event until four times the horizon; what they leave open they do not find."""
    try:
        later = solve(scene.replace(until=4 * scene.until), arithmetic="ball", max_events=events + 1)
    except NumericsError:
        return True
    return len(later.events) <= events


def differences_of_numbers(case: Case, run: Any) -> Iterator[str]:
    """Of numbers that their radius, or their bound, does not explain, or that have fewer digits than they must."""
    rounding, nothing, scales = arb(case.rounding), arb(case.nothing), [*map(Ball.number, case.scales)]
    numbers, rows = given(run), []
    for n, row in case.rows.items():
        rows += [(f"{name} at {n}", *four) for name, *four in zip(NAMES, row, scales, *numbers(n), strict=False)]
    if case.ledger:
        size = sum((abs(number(one)) for one in case.ledger), arb(0))
        with run.context():
            parts = run.ledger.friction, run.ledger.viscous, run.ledger.work
        # mpmath has no bounds: of an energy that stays it subtracts one that is nearly the same
        near = size / 10**17 + as_ball(run.ledger.initial) / 10**40
        off = [near if run.arithmetic.name == "mpmath" else run.ledger.error] * 3
        rows += [("ledger", *four) for four in zip(case.ledger, [size] * 3, parts, off, strict=True)]
    for name, text, scale, value, bound in rows:
        if text is None:
            continue
        true = number(text)
        off, size = as_ball(value) - true, abs(true).max(scale)
        slack = abs(true) * (arb("1e-19") if name == "ledger" else rounding) + scale * nothing
        if not off.abs_lower() <= as_ball(bound) + slack:
            yield f"{name}: {as_ball(value).str(12)}, not {text}, and a bound of {as_ball(bound).str(3)}"
        if case.digits and name != "ledger" and not off.abs_upper() <= size / arb(10) ** case.digits + slack:
            yield f"{name} has too few digits: {as_ball(value).str(60)}"


def given(run: Any) -> Callable[[int], tuple[Any, Any]]:
    """The numbers of an event, or of the end, which is -1, and their bounds: of balls 0.

    What nothing bounds is taken as it is printed.
    """
    printed = None if run.bounded else as_record(run)

    def numbers(n: int) -> tuple[Any, Any]:
        if printed is not None:
            row = printed["final"] if n < 0 else printed["events"][n]
            return tuple(zip(*(as_printed(row, name) for name in NAMES if name in row), strict=True))
        values = (run.end_time, *run.end_numbers()) if n < 0 else (run.events[n].t, *run.events[n].y)
        if run.arithmetic.name == "ball":
            return values, [0.0] * len(values)
        return values, run.end_bounds() if n < 0 else (run.accuracy.t[n], *run.accuracy.y[n])

    return numbers


def as_printed(row: dict[str, str], name: str) -> tuple[Fraction, Fraction]:
    """A number of a record, and how far it may be off: its radius, or one in its last place."""
    place = int(Decimal(row[name]).as_tuple().exponent)
    return Fraction(row[name]), Fraction(row.get(f"{name}_radius", Fraction(10) ** place))


def number(text: str) -> arb:
    return Ball.number(Fraction(text))


def same(frozen: Any, got: Any) -> bool:
    """An answer of control, by the names of its attributes: numbers within their radius, all else equal."""
    if isinstance(frozen, dict):
        return all(same(one, getattr(got, name)) for name, one in frozen.items())
    if isinstance(got, acb):  # of two conjugates either was frozen first
        return any(same(frozen, [got.real, imag]) for imag in (got.imag, -got.imag))
    if isinstance(got, arb):
        with precision(BITS):
            true = number(frozen)
            return not (got - true).abs_lower() > abs(true) * arb("1e-19") + arb("1e-100")
    if isinstance(got, list | tuple):
        return len(frozen) == len(got) and all(map(same, frozen, got))
    return bool(frozen == (got.name if isinstance(got, Enum) else got))
