"""python -m numerics audit: its rows at the small size, and that each kind of row fails when its fault is planted."""

import dataclasses
import json
import math
import os
import time
from fractions import Fraction
from itertools import islice

import pytest
from interruption import interrupted

from numerics import Force, Friction, Pair, Piece, Scene, Sine, State, solve
from numerics.__main__ import main
from numerics.audit import formulas, plan, refusals, solves, symmetries, table
from numerics.scene.file import parse_scene


def nothing(_):
    """Nobody listens."""


@pytest.fixture(scope="module")
def small():
    return list(plan.audit(plan.SIZES["small"], 7, nothing))


def test_every_row_is_as_required(small):
    assert [row.name for row in small if not row.passed] == []
    assert list(dict.fromkeys(row.section for row in small)) == ["formulas", "scenes", "symmetries", "refusals"]
    assert all(row.tried > 0 for row in small)


def test_the_json_has_its_shape(small):
    record = json.loads(json.dumps(table.as_record(small, 7, "small"), allow_nan=False))
    assert list(record) == ["seed", "size", "passed", "rows"]
    assert (record["seed"], record["size"], record["passed"]) == (7, "small", True)
    keys = ["section", "name", "tried", "measured", "required", "passed", "details"]
    assert all(list(row) == keys for row in record["rows"])
    reasons = [row["details"][0]["reasons"] for row in record["rows"] if row["section"] == "refusals"]
    assert all(sum(one.values()) > 100 for one in reasons)


def test_tables_are_printed(small, capsys):
    for show in (table.print_rows, table.print_decades, table.print_reasons):
        show(small)
    out = capsys.readouterr().out
    assert "FAIL" not in out
    assert "depth: 2 - x cot(x/2), double-double" in out
    assert "not a TOML scene" in out


def test_the_exit_code_is_that_of_the_rows(capsys, monkeypatch, small):
    shown = list(islice(small, 3))
    monkeypatch.setattr(plan, "audit", lambda *_: iter(shown))
    assert main(["audit", "--size", "small", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["passed"] is True
    shown[1] = dataclasses.replace(shown[1], passed=False)
    assert main(["audit", "--size", "small", "--decades"]) == 1
    captured = capsys.readouterr()
    assert "FAIL" in captured.out
    assert captured.err == ""


@pytest.mark.parametrize("arguments", [["--size", "huge"], ["--seed", "-1"], ["--seed", "x"]])
def test_wrong_usage(arguments, capsys):
    with pytest.raises(SystemExit) as stop:
        main(["audit", *arguments])
    assert stop.value.code == 2


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_an_interrupt_ends_it_in_one_line(tmp_path):
    code, out, err = interrupted("numerics", ["audit", "--size", "large"], "flint", tmp_path)
    assert (code, out) == (130, "")
    assert err == "error: interrupted; nothing was written\n"


# formulas

FORMULA = {one.name.split(":")[0]: one for one in formulas.FORMULAS}


def rows_of(formula, cases=3, seed=0):
    rows = formulas.audit_formulas(seed, cases, nothing, (formula,))
    return dict(zip(formulas.ARITHMETICS, rows, strict=True))


@pytest.mark.parametrize("name", FORMULA)
@pytest.mark.parametrize("only", [(0, math.inf), (1e-30, 1e-29), (1.0, 2.0)], ids=["all", "one decade", "around 1"])
def test_a_formula_that_is_a_little_off_fails_in_every_arithmetic(name, only):
    formula, off = FORMULA[name], {float: 1 + 2.0**-49, formulas.Pair: 1 + formulas.as_pair(2.0**-99)}

    def wrong(x):
        at, value = formulas.functions.as_float(x), formula.value(x)
        if not only[0] <= at < only[1]:
            return value
        return value * off[type(x)] if type(x) in off else value + 3 * value.rad() + abs(value) * 1e-9

    rows = rows_of(dataclasses.replace(formula, value=wrong, lowest=max(formula.lowest, 1e-40), highest=5))
    assert not any(row.passed for row in rows.values())
    assert 8 < rows["binary64"].measured["max ulp"] < 24
    assert math.isinf(rows["ball"].measured["max ulp"])


def test_formulas_that_cancel_are_found_out():
    wrong = dataclasses.replace(FORMULA["versine"], value=lambda x: 1 - formulas.functions.sine_cosine(x)[1])
    assert [row.passed for row in rows_of(wrong).values()] == [False, False, True]


def test_an_enclosure_without_bounds_fails_at_a_point():
    vacuous = dataclasses.replace(FORMULA["sqrt x"], value=lambda x: x / 0 if hasattr(x, "rad") else math.nan)
    assert not any(row.passed for row in rows_of(vacuous).values())


def test_the_same_seed_gives_the_same_rows_and_another_seed_others():
    first, again, other = (rows_of(FORMULA["versine"], seed=seed) for seed in (1, 1, 2))
    assert first == again
    assert first != other


# scenes


def planted(trajectory, **parts):
    """The same trajectory with some of what is made of its record replaced."""
    copy = trajectory.but()
    copy.__dict__.update(parts)
    return copy


def scene_rows(change, name="float64", cases=2):
    """The rows of one arithmetic in which each trajectory is changed."""
    honest = solves.SOLVERS[name]
    solver = {name: lambda scene: change(honest(scene))}
    return [row for row in solves.audit_solves(3, cases, cases, nothing, solver) if row.name.startswith("masses")]


@pytest.mark.parametrize("name", solves.SOLVERS)
def test_what_is_right_passes(name):
    assert all(row.passed for row in scene_rows(lambda found: found, name))


@pytest.mark.parametrize("name", solves.SOLVERS)
@pytest.mark.parametrize("where", [slice(1, None), slice(None, -1), slice(0, None, 2)])
def test_a_lost_event_fails(name, where):
    (row,) = scene_rows(lambda found: planted(found, events=tuple(found.events)[where]), name)
    assert not row.passed
    assert row.measured["wrong"] > 0


def test_an_invented_event_fails():
    (row,) = scene_rows(lambda found: planted(found, events=(*found.events, *found.events[-1:])))
    assert row.measured["wrong"] > 0


@pytest.mark.parametrize("name", ["float64", "double-double", "ball"])
def test_a_number_beyond_its_bound_fails(name):
    def moved(found):
        with found.arithmetic.context():
            factor = 1 + found.arithmetic.number(1) / 10**9
            x1, *rest = found.final_state
            return planted(found, final_state=(x1 * factor, *rest))

    (row,) = scene_rows(moved, name)
    assert not row.passed
    assert row.measured["beyond"] > 0


@pytest.mark.parametrize("name", solves.SOLVERS)
def test_lost_energy_fails(name):
    def leaking(found):
        with found.arithmetic.context():
            books = found.ledger
            leak = (books.initial + books.friction) / 10**8
            return planted(found, ledger=dataclasses.replace(books, residual=books.residual + leak))

    (row,) = scene_rows(leaking, name)
    assert not row.passed


def test_an_arithmetic_that_only_refuses_has_not_passed():
    def refusing(found):
        raise solves.NumericsError("no")

    (row,) = scene_rows(refusing)
    assert not row.passed
    assert row.measured["NumericsError"] == 2


# symmetries


@pytest.mark.parametrize(
    ("name", "moved"),
    [
        ("the same run again", lambda x, calls: math.nextafter(x, math.inf) if calls % 2 else x),
        ("mirror image", lambda x, calls: math.nextafter(x, math.inf) if calls % 2 else x),
        ("units times 2^k", lambda x, calls: x + 1e-9),
    ],
)
def test_a_run_that_is_no_mirror_image_is_found_out(name, moved):
    calls = 0

    def trembling(scene):
        nonlocal calls
        calls += 1
        found = solves.SOLVERS["float64"](scene)
        return planted(found, final_state=tuple(moved(x, calls) for x in found.final_state))

    rows = {row.name: row for row in symmetries.audit_symmetries(0, 14, nothing, trembling)}
    assert not rows[name].passed


def test_a_scene_in_other_units_is_the_same_scene():
    force = Force([Piece("1/2", [1, "1/3", 2], [Sine(3, 5, "0.7")]), Piece(1, [4])])
    scene = Scene(Pair(1, 3, 200, "0.5", 1), State("0.01", "0.15"), 2, force=force, friction=Friction([("0.3", 1)]))
    two, one = Fraction(2), Fraction(1)
    there = symmetries.rescaled(scene, symmetries.Units(two**3, two**-2, two**5, -1))
    assert symmetries.rescaled(there, symmetries.Units(two**-3, two**2, two**-5, -1)) == scene
    assert there.energy_excess == scene.energy_excess
    factor = two ** (3 - 2 - 2 * 5)
    assert [there.force(t * 32) for t in (one / 2, one * 3)] == pytest.approx(
        [-scene.force(one / 2) * factor, -4 * factor]
    )
    assert [mode.sign for mode in solve(there).modes] == [-mode.sign for mode in solve(scene).modes]


# refusals


def spin(_):
    end = time.process_time() + 1.05
    while time.process_time() < end:
        pass
    return parse_scene("")


@pytest.mark.parametrize(
    ("reader", "figure"),
    [
        (lambda text: Scene(Pair(1, 1, 1, 1), State(), 1), "accepted wrongly"),
        (lambda text: parse_scene(text.replace("-", "")), "accepted wrongly"),
        (lambda text: int("x"), "other errors"),
        (spin, "over 1 s"),
    ],
)
def test_a_wrong_reader_fails(reader, figure):
    rows = list(refusals.audit_refusals(0, 1 if reader is spin else 200, nothing, reader))
    assert not all(row.passed for row in rows)
    assert sum(row.measured[figure] for row in rows) > 0
