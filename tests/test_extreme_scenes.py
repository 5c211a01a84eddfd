"""The scenes of tests/extremes in every arithmetic: right to the digits claimed, or refused as the catalogue says."""

import json
from decimal import Decimal, localcontext

import pytest
from control_scenes import referred
from extremes.catalogue import ANSWER, CATALOGUE, HERE, scene
from flint import arb, ctx

from numerics import EventUndecided, NumericsError, solve
from numerics.free.energy import energy_at
from numerics.solver.truth import record as as_record

WAYS = {"ball": {"digits": 50}, "mpmath": {"arithmetic": "mpmath", "digits": 50}, "float64": {"arithmetic": "float64"}}
NAMES = ("t", "x1", "v1", "x2", "v2", "energy", "energy_excess")


def solved(name, way):
    entry = CATALOGUE[name]
    caps = {"max_events": entry.get("max_events", 12)}
    if way == "ball" and "max_digits" in entry:
        caps["max_digits"] = entry["max_digits"]
    return as_record(solve(scene(name), **WAYS[way], **caps))


def rows(record):
    return [[row[name] for name in NAMES if name in row] for row in (*record["events"], record["final"])]


def radii(record):
    return [[row[f"{name}_radius"] for name in NAMES if name in row] for row in (*record["events"], record["final"])]


def modes(record):
    """The itinerary, with the mode that a last event leads to even if the cap on events stopped it there."""
    last = record["events"][-1]["to"] if record["events"] else record["final"]["mode"]
    return [row["from"] for row in record["events"]] + [last]


def scales(pair):
    """Units of t, x1, v1, x2, v2, energy and excess: a number below 10^(-4 n) of its unit counts as 0 to n digits."""
    width, rate_squared, energy = (
        Decimal(one.numerator) / Decimal(one.denominator)
        for one in (pair.half_width, pair.a2 / pair.mass, pair.critical_energy)
    )
    speed = width * rate_squared.sqrt()
    return Decimal(0), width, speed, width, speed, energy, Decimal(1)


def require_right(record, truth, pair):
    """Balls contain the 60 digits of the reference and agree in 50; the others are right up to their last digit."""
    assert modes(record) == truth["modes"]
    truths = [*truth["events"], truth["final"]]
    with localcontext() as context:
        context.prec, context.Emin, context.Emax = 120, -(10**6), 10**6
        if record["arithmetic"] == "ball":
            units = scales(pair)
            for row, radius, exact in zip(rows(record), radii(record), truths, strict=True):
                numbers = ([Decimal(value) for value in values] for values in (row, radius, exact))
                for one, r, two, unit in zip(*numbers, units[: len(row)], strict=True):
                    assert abs(one - two) <= r + abs(two) * Decimal("1e-59"), (one, two)
                    assert abs(one - two) <= abs(two) * Decimal("1e-50") or abs(one) < unit * Decimal("1e-200")
            return
        for row, exact in zip(rows(record), truths, strict=True):
            for one, two in zip(map(Decimal, row), map(Decimal, exact), strict=True):
                # rounded where the error begins: the last digit may be off by one, and the rounding adds a half
                unit = Decimal((0, (1,), one.as_tuple().exponent))
                assert abs(one - two) <= unit * Decimal("1.5") + abs(two) * Decimal("1e-59"), (one, two)


def test_every_scene_has_an_entry_and_an_answer():
    files = {path.stem for path in (HERE / "scenes").glob("*.toml")}
    assert files == set(CATALOGUE) == set(ANSWER)
    assert all((HERE / "scenes" / f"{name}.toml").read_text("utf-8").startswith("# ") for name in files)


def outcome(name, way):
    """The record, or the typed error."""
    try:
        return solved(name, way)
    except NumericsError as error:
        return error


CASES = [(name, way) for name in CATALOGUE for way in WAYS if (name, way) != ("damping-1e300", "mpmath")]
SLOW = pytest.param("damping-1e300", "mpmath", marks=pytest.mark.long)


@pytest.mark.parametrize(("name", "way"), [*CASES, SLOW])
def test_right_to_the_digits_claimed_or_refused(name, way):
    refusal = CATALOGUE[name].get(way, "right")
    found = outcome(name, way)
    if isinstance(found, NumericsError):
        assert type(found).__name__ in refusal.split(" or ")
        assert str(found).isprintable()
        assert "ball" in str(found) or "raise max_digits" in str(found)
    else:
        assert "right" in refusal.split(" or ")
        require_right(found, ANSWER[name], scene(name).pair)


@pytest.mark.parametrize("name", [name for name, entry in CATALOGUE.items() if "late" in entry])
def test_the_energy_at_the_horizon_without_stepping_there(name):
    one, late = scene(name), ANSWER[name]["late"]
    found = energy_at(one, one.until, digits=late["digits"])
    with found.frame.arithmetic.context():
        text = found.energy_excess.mid().str(60, radius=False)
    with localcontext() as context:
        context.prec = 80
        truth = Decimal(late["energy_excess"])
        assert abs(Decimal(str(text)) - truth) <= truth * Decimal(10) ** -late["digits"]
    assert str(found.excursions) == late.get("excursions", str(found.excursions))
    assert found.excursions > 10**6


def test_an_undecided_graze_shows_the_enclosure():
    with pytest.raises(EventUndecided, match="graze") as caught:
        solved("graze-to-900-digits", "ball")
    assert "+/-" in caught.value.enclosure
    assert caught.value.digits <= 500
    # with the digits that it asks for it is decided
    require_right(
        as_record(solve(scene("graze-to-900-digits"), digits=50, arithmetic="ball")),
        ANSWER["graze-to-900-digits"],
        scene("graze-to-900-digits").pair,
    )


@pytest.mark.parametrize("name", ["corner-plus", "mass-ratio-1e-6", "capture-from-off-S", "excess-1e-12"])
def test_another_reference_has_the_answers(name):
    found = referred(scene(name), digits=140)
    assert found.modes[: len(ANSWER[name]["modes"])] == ANSWER[name]["modes"]
    with ctx.workdps(120):
        for event, row in zip(found.events, ANSWER[name]["events"], strict=False):
            for value, text in zip((event.t, *event.y), row, strict=True):
                assert text == "0" or abs(value / arb(text) - 1) < arb("1e-55"), (value, text)


@pytest.mark.parametrize("way", WAYS)
def test_a_wrong_digit_would_be_noticed(way):
    pair, record = scene("excess-1e-12").pair, solved("excess-1e-12", way)
    truth = json.loads(json.dumps(ANSWER["excess-1e-12"]))
    require_right(record, truth, pair)
    value = truth["events"][3][4]
    place = {"ball": 48, "mpmath": 45, "float64": 10}[way] + value.index(".")
    truth["events"][3][4] = value[:place] + str((int(value[place]) + 5) % 10) + value[place + 1 :]
    with pytest.raises(AssertionError):
        require_right(record, truth, pair)
