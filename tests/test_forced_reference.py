"""The reference of forced scenes checked by itself, by hand, by the energy balance and by the free motion."""

import pytest
from flint import arb, ctx
from forced.catalogue import ANSWER, SIGNS, tables
from forced_reference import Reference, number

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
    return "".join(SIGNS[name] for name in found.modes)


def near(one, two, scale, power):
    """Numbers or texts that differ by at most 10^power of their size or of a scale."""
    one, two = (value if isinstance(value, arb) else number(value) for value in (one, two))
    return bool(abs(one - two) <= arb(10) ** power * (abs(two) + scale))


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


def test_the_rule_for_ties_is_needed(monkeypatch):
    """A mode that the derivatives do not allow cannot begin: its guard is negative at once."""
    right = Reference.decided

    def blind(self):
        return right(self) if self.t == 0 else 0

    monkeypatch.setattr(Reference, "decided", blind)
    with pytest.raises(ArithmeticError, match="cannot begin"):
        run(tables("tie-by-second-derivative-slips"))
