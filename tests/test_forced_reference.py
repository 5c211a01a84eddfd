"""The reference of forced scenes checked by itself, by hand, by the energy balance and by the free motion."""

import json
from fractions import Fraction

import pytest
from flint import arb, arb_poly, ctx
from forced.first_roots import Zeros
from forced.regenerate import ANSWERS, HERE, SIGNS, names, tables
from forced_reference import Reference, number
from hypothesis import given
from strategies import scenes

from numerics import Pair, Scene, State, solve
from numerics.errors import EventUndecided

ANSWER = json.loads(ANSWERS.read_text("utf-8"))
# longer than a second, or decided by less than the digits of a quick run
LONG = {"four-thousand-events", "fast-ripple", "mass-ratio-1e-6", "sine-that-starts-late", "thousand-pieces"}
SHARP = {name for name in ANSWER if "just-" in name and "contact" in name}
QUICK = sorted(set(ANSWER) - LONG - SHARP)
DIGITS = 60


@pytest.fixture
def digits():
    """Sixty digits for what a test computes itself."""
    before, ctx.dps = ctx.dps, DIGITS
    yield DIGITS
    ctx.dps = before


def run(given, **how):
    return Reference(given, **{"digits": DIGITS, "balance": True, **how}).run()


def modes(found):
    first = found.events[0].before if found.events else found.mode
    return "".join(SIGNS[mode] for mode in (first, *(event.after for event in found.events)))


def near(one, two, scale, power):
    """Numbers or texts that differ by at most 10^power of their size or of a scale."""
    one, two = (value if isinstance(value, arb) else number(value) for value in (one, two))
    return bool(abs(one - two) <= arb(10) ** power * (abs(two) + scale))


def test_every_scene_says_what_it_is_for_and_has_an_answer():
    assert names() == sorted(ANSWER)
    assert len(ANSWER) >= 30
    assert all((HERE / "scenes" / f"{name}.toml").read_text("utf-8").startswith("# ") for name in ANSWER)


@pytest.mark.parametrize("name", QUICK)
def test_fewer_digits_and_other_steps_come_to_the_same_and_the_energy_balances(name, digits):
    found, truth = run(tables(name), radians=3), ANSWER[name]
    assert modes(found) == truth["modes"]
    assert len(found.touches) == truth["touches"]
    kept = [(found.events[one["n"]], one) for one in truth["events"]]
    assert all(event.cause == one["cause"] for event, one in kept)
    got = [(event.t, *event.y) for event, _ in kept] + [(found.t, *found.state())]
    scales = (0, found.far, found.fast, found.far, found.fast)
    for row, right in zip(got, [*(one["row"] for _, one in kept), truth["final"]], strict=True):
        assert all(near(a, b, scale, -40) for a, b, scale in zip(row, right, scales, strict=True))
    left = found.energy() - found.initial_energy - found.work + found.viscous + found.rubbed
    turned = abs(found.work) + abs(found.viscous) + found.rubbed + found.initial_energy
    assert found.rubbed >= 0
    assert abs(left) <= turned * arb(10) ** -50


ROOT_2 = "1.41421356237309504880168872420969807856967187537694807317667973799"
ROOT_2_4 = "1.18920711500272106671749997056047591529297209246381741301900222472"
BY_HAND = {
    # name: modes, then t, x1, v1 of the first event, from the derivation at the head of the scene
    "exit-at-a-rational-time": ("0+", "1", "1/120", "1/40"),
    "jump-at-exit-slips": ("0+", "1", "1/120", "1/40"),
    "jump-at-exit-to-the-other-side": ("0-", "1", "1/120", "1/40"),
    "tie-by-first-derivative-slips": ("0+", "1", "1/120", "1/40"),
    "tie-by-second-derivative-slips": ("0+", "1", "1/120", "1/40"),
    "tie-by-third-derivative-slips": ("0+", "1", "1/120", "1/40"),
    "tie-by-second-derivative-sticks": ("0",),
    "tie-by-third-derivative-sticks": ("0",),
    "tie-on-the-lower-edge": ("0-", "1", "-1/120", "-1/40"),
    "tie-at-the-start-fourth-derivative-slips": ("+",),
    "load-touches-the-edge": ("0-",),
    "load-touches-to-fourth-order": ("0-",),
    "load-crosses-to-third-order": ("0+", "1", "3/200", "3/80"),
    "contact-at-a-rational-time": ("+0", "1", "3/40", "1/20"),
    "jump-at-contact-sticks": ("+0", "1", "3/40", "1/20"),
    "jump-at-contact-reverses": ("+-", "1", "3/40", "1/20"),
    "tie-at-a-jump-at-contact-sticks": ("+0", "1", "3/40", "1/20"),
    "tie-at-a-jump-at-contact-slips-on": ("+",),
    "contact-to-third-order": ("+0", "1", "1/20", "1/20"),
    "touch-in-slip": ("+",),
    "friction-jumps-onto-the-load-slips": ("0+", "1/2", "1/960", "1/160"),
    "friction-jumps-onto-the-load-sticks": ("0-", "3"),
    "sine-at-threshold": ("0",),
    "sine-at-threshold-damped": ("0",),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_what_is_derived_by_hand(name, digits):
    right, *state = BY_HAND[name]
    assert ANSWER[name]["modes"].startswith(right)
    if len(right) == 1:
        assert ANSWER[name]["modes"] == right
    for got, exact in zip(ANSWER[name]["events"][0]["row"] if state else [], state, strict=False):
        assert near(got, exact, 0, -58)


def test_exits_at_known_irrational_times(digits):
    assert near(ANSWER["load-touches-the-edge"]["events"][0]["row"][0], 1 + number(ROOT_2), 0, -50)
    row = ANSWER["load-touches-to-fourth-order"]["events"][0]["row"]
    assert near(row[0], 1 + number(ROOT_2_4), 0, -50)


def test_a_constant_force_only_moves_the_origin(digits):
    moved = tables("constant-force")
    free = {"pair": moved["pair"], "initial": {"x1": "0.006"}, "run": moved["run"]}
    one, two = run(moved), run(free)
    assert modes(one) == modes(two)
    for a, b in zip(one.events, two.events, strict=True):
        assert near(a.t, b.t, 0, -50)
        assert near(a.y[0] - number("0.01"), b.y[0], two.far, -50)
        assert near(a.y[3], b.y[3], two.fast, -50)


def as_tables(scene):
    pair, start = scene.pair, scene.initial
    return {
        "pair": {key: getattr(pair, key) for key in ("m1", "m2", "a1", "a2", "b")},
        "initial": {key: getattr(start, key) for key in ("x1", "v1", "x2", "v2")},
        "run": {"until": scene.until},
    }


def require_the_solver_agrees(scene):
    try:
        proved = solve(scene, digits=30, max_events=40, max_digits=200)
    except EventUndecided:
        return
    found = run(as_tables(scene), digits=90, balance=False)
    signs = {"stick": "0", "slip+": "+", "slip-": "-"}
    right = "".join(signs[mode.value] for mode in proved.modes)
    assert modes(found)[: len(right)] == right
    with_digits, ctx.dps = ctx.dps, 90
    try:
        for got, event in zip(found.events, proved.events, strict=False):
            assert near(got.t, event.t.mid(), 0, -28)
            assert near(got.y[0], event.y[0].mid(), found.far, -28)
            assert near(got.y[3], event.y[3].mid(), found.fast, -28)
    finally:
        ctx.dps = with_digits


@given(scene=scenes(periods=(1, 2)))
def test_free_scenes_agree_with_the_solver(scene):
    require_the_solver_agrees(scene)


@pytest.mark.parametrize(("m1", "m2", "a1"), [(2, 1, "0.5"), (2, 1, 12), (3, 1, 12), (2, 1, 60), ("0.01", 1, 3)])
@pytest.mark.parametrize("x1", ["0.2", "-3"])
def test_free_damped_scenes_agree_with_the_solver(m1, m2, a1, x1):
    require_the_solver_agrees(Scene(Pair(m1, m2, 12, 1, a1), State(x1=x1, v1=2, v2="-0.7"), until=5))


def test_the_rule_for_ties_is_needed(monkeypatch):
    """A mode that the derivatives do not allow cannot begin: its guard is negative at once."""
    right = Reference.decided

    def blind(self):
        return right(self) if self.t == 0 else 0

    monkeypatch.setattr(Reference, "decided", blind)
    with pytest.raises(ArithmeticError, match="cannot begin"):
        run(tables("tie-by-second-derivative-slips"))


def test_a_force_off_by_1e_30_is_seen(digits):
    given = tables("sine-stick-slip")
    given["force"][0]["sines"][0]["amplitude"] = Fraction("0.45") + Fraction(1, 10**30)
    found = run(given)
    assert not near(found.state()[0], ANSWER["sine-stick-slip"]["final"][1], found.far, -40)


@pytest.mark.parametrize(
    ("coefficients", "zero"),
    [
        ([1, -2, 1], "1"),  # a double zero at the end
        (["1/4", -1, 1], "1/2"),  # a double zero
        (["-1/27", "1/3", -1, 1], "1/3"),  # a triple one
        ([1, "-3/2"], "2/3"),
        (["1/16", "-1/2", "3/2", -2, 1], "1/2"),  # of order four
        (["101/400", -1, 1], None),  # passes by
        ([1, -1], "1"),
        ([0], None),
    ],
)
def test_first_zeros(coefficients, zero, digits):
    found = Zeros(arb_poly([number(c) for c in coefficients]), arb(10) ** -40).first()
    assert (found is None) == (zero is None)
    assert zero is None or near(found, zero, 0, -50)
