"""The scenes of tests/forced in every arithmetic: right to the digits asked, or refused where that is right.

The answers come from tests/forced_reference.py, which shares nothing with the solver.
"""

import json
import tomllib
from decimal import Decimal, localcontext
from fractions import Fraction
from time import process_time

import pytest
from flint import arb, ctx
from forced.catalogue import ANSWER, SIGNS, UNDECIDABLE
from forced.catalogue import scene as scene_of
from forced_reference import Reference
from hypothesis import given
from reaching import LeftOut, reaching
from strategies import driven_scenes

from numerics import Force, Friction, Pair, Piece, Scene, Sine, State
from numerics.errors import EventUndecided, NumericsError
from numerics.scene.writing import scene_text
from numerics.solver.solve import solve
from numerics.solver.truth import record as as_record

WAYS = {
    "ball": {"arithmetic": "ball", "digits": 40},
    "mpmath": {"arithmetic": "mpmath", "digits": 40},
    "float64": {"arithmetic": "float64"},
}
DIGITS = {"ball": 38, "mpmath": 30, "float64": 9}
EVENTS = {"ball": 151, "mpmath": 51, "float64": 10_000}
"""Under which caps: of the scenes with very many events the first ones will do."""
NAMES = ("t", "x1", "v1", "x2", "v2")
SECONDS = 30
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
    found = solve(scene_of(name), max_events=EVENTS[way], **WAYS[way])
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


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ANSWER)
def test_right_to_the_digits_asked_or_refused(name, way):
    began = process_time()
    answer = outcome(name, way)
    if isinstance(answer, NumericsError):
        assert type(answer) is EventUndecided
        assert name in BEYOND[way]
        assert str(answer).isprintable()
        return
    found, record = answer
    assert process_time() - began < SECONDS
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
    "name",
    [
        "tie-by-second-derivative-slips",
        "tie-on-the-lower-edge",
        "contact-to-third-order",
        "sine-at-threshold",
        "polynomial-of-degree-8",
    ],
)
def test_the_unit_of_time_does_not_matter(name, exponent):
    """@example of found faults: a time below 1e-15 s was rounded to 0 at a tie; tau^20 left the range of floats."""
    scene, factor = scene_of(name), Fraction(10) ** exponent
    one = solve(scene, arithmetic="ball", digits=25)
    two = solve(in_other_seconds(scene, factor), arithmetic="ball", digits=25)
    assert one.modes == two.modes
    for a, b in zip(one.events, two.events, strict=True):
        assert (a.t * factor.numerator / factor.denominator).overlaps(b.t)
        assert a.y[0].overlaps(b.y[0])
    assert two.ledger.residual.contains(0)


@pytest.mark.parametrize("exponent", [9, 16, 20, 60, 100, -9, -16, -20, -60, -100])
@pytest.mark.parametrize("name", ["triangular-wave", "polynomial-of-degree-8", "sine-stick-slip", "damping-heavy"])
def test_the_unit_of_time_does_not_matter_in_floats(name, exponent):
    """Events, states between them, bounds and ledger. @example of found faults: refusals, a bare ZeroDivisionError."""
    if name == "polynomial-of-degree-8":  # coefficients of t^8 in units of 10^20 s are all that a float can hold
        exponent = max(-20, min(20, exponent))
    scene, factor = scene_of(name), Fraction(10) ** exponent
    one, two = solve(scene), solve(in_other_seconds(scene, factor))
    assert one.modes == two.modes
    assert two.event_times / float(factor) == pytest.approx(one.event_times, rel=1e-14)
    assert two.event_states[0] == pytest.approx(one.event_states[0], rel=1e-12, abs=1e-15)
    assert two.accuracy.digits == pytest.approx(one.accuracy.digits, abs=1)
    early = two.sol(two.scene.until / 3)
    assert early[0] == pytest.approx(one.sol(scene.until / 3)[0], rel=1e-13)
    assert early[1] * float(factor) == pytest.approx(one.sol(scene.until / 3)[1], rel=1e-13)
    assert abs(two.ledger.residual) <= 1e-12 * (two.ledger.friction + two.ledger.viscous)


@pytest.mark.parametrize(("a2", "way"), [("1e-900", "float64"), ("1e900", "float64"), ("1e900", "ball")])
def test_rates_out_of_all_proportion_are_refused_in_one_line(a2, way):
    """@example of a found fault: ZeroDivisionError."""
    scene = Scene(Pair(1, 1, a2, "0.05", a1=1), State(), 3, force=Force.sine("0.45", 5))
    with pytest.raises(NumericsError) as refused:
        solve(scene, arithmetic=way)
    assert len(str(refused.value).splitlines()) == 1


@reaching
@given(driven_scenes())
def test_any_scene_agrees_with_the_reference(scene):
    """In balls: the same modes, and every event and the end to 28 digits of their scale; or a refusal at a touch."""
    try:
        found = solve(scene, arithmetic="ball", digits=30, max_digits=300)
    except EventUndecided:
        raise LeftOut from None
    truth = Reference(tomllib.loads(scene_text(scene), parse_float=str), digits=70).run()
    before, ctx.dps = ctx.dps, 70
    try:
        rows = [(event.t, *event.y) for event in found.events] + [(found.end_time, *found.final_state)]
        right = [(event.t, *event.y) for event in truth.events] + [(truth.t, *truth.state())]
        assert [mode.value for mode in found.modes] == truth.modes
        far, fast = truth.far, truth.fast
        for got, true in zip(rows, right, strict=True):
            for one, two, scale in zip(got, true, (abs(true[0]), far, fast, far, fast), strict=True):
                assert one.overlaps(two + scale * arb(0, 1e-50))
                assert abs(one.mid() - two) <= scale * arb(10) ** -28
    finally:
        ctx.dps = before
