"""The audit of formulas and enclosures: a fault of a few units in the last place is seen in each."""

import dataclasses
import json
import math
from fractions import Fraction

import pytest
from audit_rows import quiet, row_of
from flint import arb

from numerics.audit import catalogue, enclosures, table
from numerics.audit.formulas import Formula, audit_formulas, ulps

FORMULAS = {formula.name.split(":")[0]: formula for formula in catalogue.formulas()}


def test_the_same_seed_gives_the_same_rows_and_another_seed_others():
    formula = FORMULAS["versine"]
    first, again, other = (row_of(audit_formulas([formula], seed, 5, quiet)) for seed in (1, 1, 2))
    assert first == again
    assert first != other


@pytest.mark.parametrize("name", ["versine", "sine deficit", "cosine deficit", "lag", "rise", "depth"])
@pytest.mark.parametrize("only", [None, (1e-30, 1e-29), (1.0, 2.0)], ids=["everywhere", "one decade", "around 1"])
def test_a_formula_8_ulp_off_fails(name, only):
    formula = FORMULAS[name]

    def wrong(x):
        value = formula.value(x)
        return value + 8 * math.ulp(value) if only is None or only[0] <= x < only[1] else value

    planted = dataclasses.replace(formula, value=wrong, lowest=max(formula.lowest, 1e-40))
    row = row_of(audit_formulas([planted], 0, 5, quiet))
    assert not row.passed
    assert 5 < row.measured["max ulp"] < 20  # 8 ulp of a value just above a power of two are 16 just below it


def test_formulas_that_cancel_are_found_out():
    cancelling = [
        dataclasses.replace(FORMULAS["sine deficit"], value=lambda x: x - math.sin(x)),
        dataclasses.replace(FORMULAS["versine"], value=lambda x: 1 - math.cos(x)),
        dataclasses.replace(FORMULAS["log1p x, |x| < 1/2"], value=lambda x: math.log(1 + x)),
    ]
    assert not any(row.passed for row in audit_formulas(cancelling, 0, 5, quiet))


def test_a_value_that_is_no_number_fails():
    planted = Formula("nan", lambda x: math.nan, lambda x: x, 1.0, 100.0)
    row = row_of(audit_formulas([planted], 0, 5, quiet))
    assert not row.passed
    assert '"max ulp": "inf"' in json.dumps(table.as_record([row], 0, "small"), allow_nan=False)


def test_ulps_count_from_the_true_value():
    assert ulps(math.nextafter(1.0, 2.0), arb(1)) == 1.0
    assert ulps(math.nextafter(1.0, 0.0), arb(1)) == 0.5
    assert ulps(5e-300, arb(5e-300)) == 0.0


def enclosures_of(tried):
    return {row.name: row for row in enclosures.audit_enclosures(0, 200, 1, quiet, [tried])}


@pytest.mark.parametrize("name", [one.name for one in enclosures.functions() if one.name != "constants of a pair"])
def test_an_enclosure_that_misses_fails(name):
    honest = next(one for one in enclosures.functions() if one.name == name)

    def shifted(ball, *arguments):
        # by a little more than its width, and only where the digits are few: the truth stays
        values = honest.value(ball, *arguments)
        if ball.digits > 25:
            return values
        return tuple(value + 3 * value.rad() + abs(value) * arb(10) ** -9 for value in values)

    rows = enclosures_of(dataclasses.replace(honest, value=shifted))
    assert not rows[f"function: {name}"].passed
    assert not rows["together"].passed
    assert rows["trajectories"].passed


def test_an_enclosure_without_bounds_is_no_trial():
    vacuous = enclosures.Enclosed("vacuous", lambda _: (Fraction(1),), lambda ball, x: (x / arb(0),))
    row = enclosures_of(vacuous)["function: vacuous"]
    assert (row.tried, row.passed) == (0, False)
