"""python -m numerics audit: its rows, and that each kind of row fails when its fault is planted."""

import copy
import dataclasses
import json

import numpy as np
import pytest
from flint import arb

from numerics.audit import solves
from numerics.plane.answer import PlaneState
from numerics.scene.plane import PlanePair


def audited(seed, cases, more, **chosen):
    """The rows; nobody hears what is being tried."""
    return list(solves.audit(seed, cases, more, lambda _: None, **chosen))


@pytest.fixture(scope="module")
def small():
    return audited(7, 2, 4)


@pytest.mark.long
def test_the_small_audit_passes():
    assert [row.name for row in audited(11, *solves.SIZES["small"]) if not row.passed] == []


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, 4])
def test_no_run_of_an_ellipsoid_has_loose_bounds(seed):
    """Among such scenes were stiff slips, whose bounds were 20,000 times the errors when every defect added to N."""
    assert all(row.passed for row in audited(seed, 12, 12, kinds={"ellipsoid": solves.KINDS["ellipsoid"]}))


def test_every_row_is_as_required_and_shown(small, run, record, monkeypatch):
    assert [row.name for row in small if not row.passed or row.tried == 0] == []
    json.dumps(solves.as_record(small, 7, "small"), allow_nan=False)
    shown = small[:3]
    monkeypatch.setattr(solves, "audit", lambda *_: iter(shown))
    found = record("audit", "--size", "small", "--seed", 7)
    assert (found["seed"], found["size"], found["passed"], len(found["rows"])) == (7, "small", True, 3)
    assert all(list(row) == list(solves.AuditRow._fields) for row in found["rows"])
    shown[1] = shown[1]._replace(passed=False)
    code, out, err = run("audit", "--size", "small")
    assert (code, "FAIL" in out, err) == (1, True, "")
    assert json.loads(run("audit", "--size", "small", "--json")[1])["passed"] is False


# faults


def wrong(found):
    """An event that there is not."""
    found.__dict__["modes"] = (found.modes[0], *found.modes)


def beyond(found):
    """A final x1 that is off by a little."""
    x1, *rest = found.final_state
    if isinstance(x1, tuple):
        moved = tuple(x + 4 * arb(x.rad()) + abs(x) * arb("1e-40") for x in x1)
        found.__dict__["final_state"] = PlaneState(moved, *rest)
    else:
        found.__dict__["final_state"] = (x1 * (1 + found.arithmetic.number(1) / 10**9), *rest)


def residual(found):
    """Lost energy."""
    books = found.ledger
    leak = (books.initial + books.friction) / 10**8
    found.__dict__["ledger"] = dataclasses.replace(books, residual=books.residual + leak)


def loose(found):
    """A bound that says nothing."""
    found.final_state = PlaneState(*(tuple(x + arb(0, "1e-9") for x in part) for part in found.final_state))


def row_of(kind, name, change):
    """The row of one kind in one arithmetic, where something of each answer is changed."""

    def changed(scene):
        found = copy.copy(honest(scene)) if kind in solves.SURFACES else honest(scene).but()
        with found.context():
            change(found)
        return found

    honest = solves.SOLVERS[name]
    (row,) = audited(3, 2, 2, solvers={name: changed}, kinds={kind: solves.KINDS[kind]})
    return row


ON_A_LINE = [("masses", name, change) for name in ("float64", "ball") for change in (wrong, beyond, residual)]
OFF_IT = [(kind, "ball", change) for kind in solves.SURFACES for change in (wrong, beyond, loose)]


@pytest.mark.parametrize(("kind", "name", "change"), [*ON_A_LINE, *OFF_IT, ("friction of the state", "ball", wrong)])
def test_what_is_planted_is_found(kind, name, change):
    row = row_of(kind, name, change)
    assert not row.passed
    assert row.details
    limit = {"residual": solves.MOST_RESIDUAL[name], "loose": solves.MOST_SLACK}.get(change.__name__, 0)
    assert row.measured[{"loose": "bound/error"}.get(change.__name__, change.__name__)] > limit


def test_an_arithmetic_that_only_refuses_has_not_passed():
    def refusing(found):
        raise solves.NumericsError("no")

    row = row_of("masses", "float64", refusing)
    assert not row.passed
    assert row.measured["NumericsError"] == 2


@pytest.mark.parametrize("column", range(9))  # t, x1, v1, x2, v2 by axes
def test_a_bound_that_is_10_000_times_as_large_is_loose(column):
    """An event of which one axis is off by 0 and another by 1e-20, bounds 30 times what N makes of that."""
    values = np.full((2, 9), 0.5)
    errors = np.zeros((2, 9))
    errors[0, 8] = 1e-20
    bounds = np.array([[0.3, 3, 3, 15, 15, 30, 30, 30, 30]] * 2) * 1e-20
    pair = PlanePair([1, 4], 1, [100, 100], 1)
    usual = solves.slack(pair, values, errors, bounds)
    bounds[0, column] *= 10**4
    assert 1 < usual < 100 < solves.MOST_SLACK < solves.slack(pair, values, errors, bounds)
