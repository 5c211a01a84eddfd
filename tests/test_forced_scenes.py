"""The scenes of tests/forced in every arithmetic: right to the digits asked, or refused where that is right.

The answers come from tests/forced_reference.py, which shares nothing with the solver.
"""

import json
import math
from dataclasses import replace
from decimal import Decimal, localcontext
from fractions import Fraction

import pytest
from control_scenes import referred
from flint import arb, ctx
from forced.catalogue import ANSWER, SIGNS, UNDECIDABLE, itinerary
from forced.catalogue import scene as scene_of
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import KINDS, MODERATE, pairs, states

from numerics import EventUndecided, Force, Friction, NumericsError, OutOfRange, Pair, Piece, Scene, Sine, State, solve
from numerics.arithmetic.ball import precision
from numerics.solver.truth import record as as_record

WAYS = {
    "ball": {"arithmetic": "ball", "digits": 40},
    "mpmath": {"arithmetic": "mpmath", "digits": 40},
    "float64": {"arithmetic": "float64"},
}
DIGITS = {"ball": 38, "mpmath": 30, "float64": 9}
EVENTS = {"ball": 51, "mpmath": 13, "float64": 10_000}
"""Under which caps: of the scenes with very many events the first ones will do."""
NAMES = ("t", "x1", "v1", "x2", "v2")
# a touch that only exact numbers tell from a crossing
TOUCHES = {UNDECIDABLE, "load-touches-the-edge", "load-touches-to-fourth-order"}
# neighbours of a tie or of a contact, nearer than the bounds of float64; solve(scene) climbs there
NEAR = {"jump-just-before-contact", "reversal-just-before-contact", "sine-barely-above-threshold", "mass-ratio-1e-6"}
BEYOND = {"ball": {UNDECIDABLE}, "mpmath": TOUCHES, "float64": {UNDECIDABLE, *NEAR}}
FEWER = {("sine-just-above-threshold", "float64"): 7, ("soft-spring", "float64"): 8}
"""Right digits where a slip is so short that its end keeps fewer."""


def outcome(name, way):
    """The trajectory and its record, or the typed error."""
    try:
        return solved(name, way)
    except NumericsError as error:
        return error


def solved(name, way):
    most = {"max_digits": 120} if name == UNDECIDABLE else {}
    found = solve(scene_of(name), max_events=EVENTS[way], **WAYS[way], **most)
    return found, as_record(found)


def compare(found, record, truth, digits, way):
    """Every event and, if it was reached, the end, right to so many digits of its scale.

    What is printed lies within the radius of a ball, and is right up to its last digit, and to so many, in float64.
    """
    got = [*record["events"], record["final"]]
    right = [(one["n"], one["row"], one["cause"]) for one in truth["events"] if one["n"] < len(record["events"])]
    if found.reached:
        right.append((len(got) - 1, truth["final"], None))
    numbers = [(event.t, *event.y) for event in found.events] + [(found.end_time, *found.final_state)]
    with localcontext() as context:
        context.prec, context.Emin, context.Emax = 120, -(10**6), 10**6
        columns = list(zip(*([Decimal(one) for one in row] for _, row, _ in right), strict=True))
        sizes = [max(map(abs, column)) for column in columns]
        far, fast = max(sizes[1], sizes[3]), max(sizes[2], sizes[4])
        for n, row, cause in right:
            assert cause in {None, "both", got[n].get("cause")}
            for k, (name, text, scale) in enumerate(zip(NAMES, row, (0, far, fast, far, fast), strict=True)):
                printed, two = Decimal(got[n][name]), Decimal(text)
                size = max(abs(two), scale)
                one = Decimal(float(numbers[n][k])) if way == "float64" else printed
                assert abs(one - two) <= Decimal(10) ** -digits * size, (n, name, one, two)
                off, slack = abs(printed - two), Decimal("1e-59") * size
                if way == "ball":
                    assert off <= Decimal(got[n][f"{name}_radius"]) + slack, (n, name, printed, two)
                if way == "float64":
                    assert len(got) > 1000 or off <= Decimal(10) ** -digits * size, (n, name, printed, two)
                    assert off <= Decimal((0, (1, 5), printed.as_tuple().exponent - 1)) + slack, (n, name, printed, two)


SLOW = pytest.param(UNDECIDABLE, "mpmath", marks=pytest.mark.long)
CASES = [(name, way) for name in ANSWER for way in WAYS if (name, way) != (UNDECIDABLE, "mpmath")]


@pytest.mark.parametrize(("name", "way"), [*CASES, SLOW])
def test_right_to_the_digits_asked_or_refused(name, way):
    answer = outcome(name, way)
    if isinstance(answer, NumericsError):
        assert type(answer) is EventUndecided
        assert name in BEYOND[way]
        assert str(answer).isprintable()
        return
    found, record = answer
    last = record["events"][-1]["to"] if record["events"] else record["final"]["mode"]
    modes = "".join(SIGNS[event["from"]] for event in record["events"]) + SIGNS[last]
    assert modes == ANSWER[name]["modes"][: len(modes)]
    assert found.reached == (len(modes) == len(ANSWER[name]["modes"]))
    compare(found, record, ANSWER[name], FEWER.get((name, way), DIGITS[way]), way)


@pytest.mark.parametrize("name", ["sine-stick-slip", "many-causes", "tie-by-second-derivative-slips"])
def test_a_wrong_answer_is_seen(name):
    """The comparison can fail: by one unit in the 37th digit, by a radius too small, by an exchanged cause."""
    found, record = solved(name, "ball")
    truth = json.loads(json.dumps(ANSWER[name]))
    truth["final"][1] = str(Decimal(truth["final"][1]) * (1 + Decimal("1e-37")))
    with pytest.raises(AssertionError):
        compare(found, record, truth, DIGITS["ball"], "ball")
    record["final"]["x1_radius"] = "0"
    record["final"]["x1"] = record["final"]["x1"][:45]
    with pytest.raises(AssertionError):
        compare(found, record, ANSWER[name], 30, "ball")


def in_other_seconds(scene, factor):
    """The same scene with another unit of time: everything scales, nothing else changes."""
    pair, at, square = scene.pair, scene.initial, factor**2
    pieces = [
        Piece(
            one.start * factor,
            [c / factor ** (k + 2) for k, c in enumerate(one.polynomial)],
            [Sine(s.amplitude / square, s.omega / factor, s.phase) for s in one.sines],
        )
        for one in scene.force.pieces
    ]
    return Scene(
        Pair(pair.m1, pair.m2, pair.a2 / square, pair.b / square, pair.a1 / factor),
        State(at.x1, at.v1 / factor, at.x2, at.v2 / factor),
        scene.until * factor,
        force=Force(pieces),
        friction=Friction([(t * factor, b / square) for t, b in scene.friction.pieces]),
    )


@pytest.mark.parametrize("exponent", [9, 20, 60, -9, -20, -60])
@pytest.mark.parametrize(
    "name", ["tie-by-second-derivative-slips", "contact-to-third-order", "sine-at-threshold", "polynomial-of-degree-8"]
)
def test_the_unit_of_time_does_not_matter(name, exponent):
    """@example of found faults: a time below 1e-15 s was rounded to 0 at a tie; tau^20 left the range of floats."""
    scene, factor = scene_of(name), Fraction(10) ** exponent
    one, two = (solve(each, **WAYS["ball"]) for each in (scene, in_other_seconds(scene, factor)))
    assert one.modes == two.modes
    with two.arithmetic.context():
        for a, b in zip(one.events, two.events, strict=True):
            assert (a.t * two.arithmetic.number(factor)).overlaps(b.t)
            assert a.y[0].overlaps(b.y[0])
        assert two.ledger.residual.contains(0)


@pytest.mark.parametrize("exponent", [9, 20, 100, -9, -20, -100])
@pytest.mark.parametrize("name", ["triangular-wave", "sine-stick-slip", "damping-heavy"])
def test_the_unit_of_time_does_not_matter_in_floats(name, exponent):
    """Events, states between them, bounds and ledger. @example of found faults: refusals, a bare ZeroDivisionError."""
    scene, factor = scene_of(name), Fraction(10) ** exponent
    one, two = solve(scene), solve(in_other_seconds(scene, factor))
    assert one.modes == two.modes
    assert two.event_times / float(factor) == pytest.approx(one.event_times, rel=1e-14)
    assert two.accuracy.digits == pytest.approx(one.accuracy.digits, abs=1)
    early, there = one.sol(scene.until / 3), two.sol(two.scene.until / 3)
    assert there[:2] * [1, float(factor)] == pytest.approx(early[:2], rel=1e-13)
    assert abs(two.ledger.residual) <= 1e-12 * (two.ledger.friction + two.ledger.viscous)


@pytest.mark.parametrize(("a2", "way"), [("1e-900", "float64"), ("1e900", "float64"), ("1e900", "ball")])
def test_rates_out_of_all_proportion_are_refused_in_one_line(a2, way):
    """@example of a found fault: ZeroDivisionError."""
    scene = Scene(Pair(1, 1, a2, "0.05", a1=1), State(), 3, force=Force.sine("0.45", 5))
    with pytest.raises(NumericsError) as refused:
        solve(scene, arithmetic=way)
    assert len(str(refused.value).splitlines()) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_any_scene_agrees_with_the_reference(kind):
    """For six hundred radians of the fastest motion, 300 steps of the reference; or it is refused at a touch."""

    @reaching
    @settings(max_examples=6)
    @given(KINDS[kind])
    def agree(scene):
        pair, omegas = scene.pair, [one.omega for piece in scene.force.pieces for one in piece.sines]
        fastest = Fraction(max(float(pair.a1 / pair.m1) + math.sqrt(pair.a2 / pair.m1), *map(float, omegas), 0.0))
        try:
            require_agreement(replace(scene, until=min(scene.until, 600 / fastest)))
        except EventUndecided:
            raise LeftOut from None

    agree()


def require_agreement(scene):
    """In balls: the same modes, and every event and the end to 28 digits of their scale."""
    found = solve(scene, arithmetic="ball", digits=30, max_digits=300)
    truth = referred(scene, digits=110)
    with ctx.workdps(110):
        rows = [(event.t, *event.y) for event in found.events] + [(found.end_time, *found.final_state)]
        right = [(event.t, *event.y) for event in truth.events] + [(truth.t, *truth.state())]
        assert [mode.value for mode in found.modes] == truth.modes
        far, fast = truth.far, truth.fast
        for got, true in zip(rows, right, strict=True):
            for one, two, scale in zip(got, true, (abs(true[0]), far, fast, far, fast), strict=True):
                assert one.overlaps(two + scale * arb(0, 1e-50))
                assert abs(one.mid() - two) <= scale * arb(10) ** -28


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath"])
def test_more_digits_than_a_float_has_decades_are_reached_at_once(arithmetic):
    """Beyond 308 digits what is rough is 0: it once ended Newton's method early, and no precision was enough."""
    scene = scene_of("sine-stick-slip")
    few, many = (solve(scene, digits=n, arithmetic=arithmetic, max_digits=500) for n in (360, 400))
    with precision(2000):
        for one, two in zip(few.event_times, many.event_times, strict=True):
            texts = (run.arithmetic.text(t, 380) for run, t in ((few, one), (many, two)))
            assert abs(arb(next(texts)) - arb(next(texts))) < arb("1e-355")


@reaching
@given(pairs(MODERATE, damped=None), st.data())
def test_a_force_of_zero_is_no_force(pair, data):
    """Two engines answer: that of the free pair, and that of every scene."""
    free = Scene(pair, data.draw(states(pair)), 2)
    nothing = Scene(pair, free.initial, 2, force=Force((Piece(0), Piece(1))))
    try:
        one, two = (
            solve(each, digits=15, arithmetic="ball", max_events=30, max_digits=100) for each in (free, nothing)
        )
    except (EventUndecided, OutOfRange):
        raise LeftOut from None
    assert one.modes == two.modes
    assert all(a.overlaps(b) for a, b in zip(one.y.ravel(), two.y.ravel(), strict=True))


def test_what_begins_at_a_tie_of_high_order_may_end_soon():
    """With u = 2 b + c t^2/2 - d t^3/6 and a soft spring a slip begins at once and ends at 4 c/d, nearly."""
    force = Force((Piece(0, (2, 0, Fraction(1, 2), -10)),))
    for arithmetic in ("ball", "float64"):
        found = solve(Scene(Pair(1, 1, "1e-6", 1), State(), 1, force=force), arithmetic=arithmetic)
        assert itinerary(found) == "+0-"
        assert abs(float(found.event_times[0]) - 4 / 60) < 1e-7


def test_friction_that_drops_lets_go_and_says_why():
    load = Force((Piece(0, (0, "0.1", 0, "5/3")),))  # x1 = 0.05 t^3/6, load 0.05 t
    scene = Scene(Pair(1, 1, 200, "0.05"), State(), 1, force=load, friction=Friction((("0.5", "0.02"),)))
    assert [(str(event.t), event.cause) for event in solve(scene).events] == [("0.5", "jump")]
