"""The reference of forced scenes checked by itself, by hand, by the energy balance and by the free motion."""

import tomllib

import pytest
from flint import arb, ctx
from forced_reference import Reference, number
from sixty_digits import FORCED, HERE, SIGNS

# longer than a second, or decided by less than the digits of a quick run
LONG = {"four-thousand-events", "fast-ripple", "mass-ratio-1e-6", "sine-that-starts-late", "thousand-pieces"}
SHARP = {name for name in FORCED if "just-" in name and "contact" in name}
QUICK = sorted(set(FORCED) - LONG - SHARP)
DIGITS = 60


@pytest.fixture
def digits():
    """Sixty digits for what a test computes itself."""
    before, ctx.dps = ctx.dps, DIGITS
    yield DIGITS
    ctx.dps = before


def run(given, **how):
    return Reference(given, **{"digits": DIGITS, "balance": True, **how}).run()


def tables(name):
    """The tables of a scene, as the reference reads them; decimals stay text."""
    return tomllib.loads((HERE / "forced" / "scenes" / f"{name}.toml").read_text("utf-8"), parse_float=str)


def modes(found):
    return "".join(SIGNS[name] for name in found.modes)


def near(one, two, scale, power):
    """Numbers or texts that differ by at most 10^power of their size or of a scale."""
    one, two = (value if isinstance(value, arb) else number(value) for value in (one, two))
    return bool(abs(one - two) <= arb(10) ** power * (abs(two) + scale))


@pytest.mark.parametrize("name", QUICK)
def test_fewer_digits_and_other_steps_come_to_the_same_and_the_energy_balances(name, digits):
    found, truth = run(tables(name), radians=3), FORCED[name]
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
