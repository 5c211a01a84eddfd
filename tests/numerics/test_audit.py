"""python -m numerics audit: its rows, and that each kind of row fails when its fault is planted."""

import copy
import dataclasses
import json
from fractions import Fraction
from itertools import islice

import pytest
from flint import arb

from numerics.audit import solves
from numerics.audit.slack import slack
from numerics.plane.answer import PlaneState
from numerics.scene.plane import PlanePair, PlaneScene


def nothing(_):
    """Nobody listens."""


@pytest.fixture(scope="module")
def small():
    return list(solves.audit(7, 2, 4, nothing))


@pytest.mark.long
def test_the_small_audit_passes():
    assert [row.name for row in solves.audit(11, *solves.SIZES["small"], nothing) if not row.passed] == []


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, 4])
def test_no_run_of_an_ellipsoid_has_loose_bounds(seed):
    """Among these are stiff slips, whose bounds were 20,000 times the errors when every defect added to N."""
    rows = list(solves.audit(seed, 12, 12, nothing, kinds={"ellipsoid": solves.KINDS["ellipsoid"]}))
    assert [row for row in rows if not row.passed] == []


def test_every_row_is_as_required(small):
    assert [row.name for row in small if not row.passed] == []
    assert all(row.tried > 0 for row in small)


def test_the_json_has_its_shape(small):
    record = json.loads(json.dumps(solves.as_record(small, 7, "small"), allow_nan=False))
    assert list(record) == ["seed", "size", "passed", "rows"]
    assert (record["seed"], record["size"], record["passed"]) == (7, "small", True)
    keys = ["name", "tried", "measured", "required", "passed", "details"]
    assert all(list(row) == keys for row in record["rows"])


def test_the_exit_code_is_that_of_the_rows(run, record, monkeypatch, small):
    shown = list(islice(small, 3))
    monkeypatch.setattr(solves, "audit", lambda *_: iter(shown))
    assert record("audit", "--size", "small")["passed"] is True
    shown[1] = shown[1]._replace(passed=False)
    code, out, err = run("audit", "--size", "small")
    assert (code, "FAIL" in out, err) == (1, True, "")


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
    return list(solves.audit(3, cases, cases, nothing, solver, {"masses": solves.KINDS["masses"]}))


@pytest.mark.parametrize("name", ["float64", "ball"])
@pytest.mark.parametrize("where", [slice(1, None), slice(None, -1), slice(0, None, 2)])
def test_a_lost_event_fails(name, where):
    (row,) = scene_rows(lambda found: planted(found, events=tuple(found.events)[where]), name)
    assert not row.passed
    assert row.measured["wrong"] > 0


@pytest.mark.parametrize("name", ["float64", "ball"])
def test_a_number_beyond_its_bound_fails(name):
    def moved(found):
        with found.arithmetic.context():
            factor = 1 + found.arithmetic.number(1) / 10**9
            x1, *rest = found.final_state
            return planted(found, final_state=(x1 * factor, *rest))

    (row,) = scene_rows(moved, name)
    assert not row.passed
    assert row.measured["beyond"] > 0


@pytest.mark.parametrize("name", ["float64", "ball"])
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


def surface_row(change, kind="ellipsoid"):
    """The row of a kind off the line in which something of each trajectory is changed."""

    def changed(scene):
        found = copy.copy(solves.SOLVERS["ball"](scene))
        with found.context():
            change(found)
        return found

    (row,) = solves.audit(1, 3, 3, nothing, {"ball": changed}, {kind: solves.KINDS[kind]})
    return row


@pytest.mark.parametrize("kind", solves.SURFACES)
def test_on_a_surface_what_is_planted_is_found(kind):
    assert surface_row(lambda _: None, kind).passed

    def moved(found):
        x1, *rest = found.final_state
        found.final_state = PlaneState(tuple(x + 4 * arb(x.rad()) + abs(x) * arb("1e-40") for x in x1), *rest)

    def lost(found):
        found.modes = found.modes[1:]

    def loose(found):
        found.final_state = PlaneState(*(tuple(x + arb(0, "1e-9") for x in part) for part in found.final_state))

    changes = [(moved, "beyond"), (lost, "wrong"), (loose, "bound/error")]
    for change, figure in changes:
        row = surface_row(change, kind)
        assert not row.passed
        assert row.measured[figure] > (solves.MOST_SLACK if change is loose else 0)


@pytest.mark.parametrize("name", ["t", "x1", "v1", "x2", "v2"])
def test_bounds_of_one_kind_that_are_10_000_times_as_large_are_loose(name):
    """An event of which one axis is off by 0 and another by 1e-20, bounds 30 times what N makes of that."""
    pair = PlanePair([1, 4], 1, [100, 100], 1)
    scene, e = PlaneScene(pair, 1, x1=1), Fraction(1, 10**20)
    bounds = {"t": 0.3 * e, "x1": 3 * e, "v1": 15 * e, "x2": 30 * e, "v2": 30 * e}

    def figures(off, factor):
        for kind in ("t", "x1", "v1", "x2", "v2", "x1", "v1", "x2", "v2"):
            for axis in range(1 if kind == "t" else 2):
                value = Fraction(1, 2) + (off * e if (kind, axis) == ("v2", 1) else 0)
                yield kind, value, Fraction(bounds[kind]) * (factor if kind == name else 1)

    usual = slack(scene, figures(1, 1), figures(0, 1))
    assert 1 < usual < 100 < solves.MOST_SLACK < slack(scene, figures(1, 10**4), figures(0, 1))


def test_a_sequence_of_friction_of_the_state_that_is_wrong_is_found():
    kind = "friction of the state"

    def shortened(scene):
        found = solves.SOLVERS["ball"](scene)
        return planted(found, events=tuple(found.events)[1:])

    (row,) = solves.audit(1, 4, 4, nothing, {"ball": shortened}, {kind: solves.KINDS[kind]})
    assert row.measured["wrong"] > 0
    assert not row.passed
