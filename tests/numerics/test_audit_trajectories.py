"""The audit of trajectories: lost, invented and moved events, lost energy and one changed bit are seen."""

import dataclasses
import math
from fractions import Fraction

import pytest
from audit_rows import quiet
from flint import arb

from numerics.audit import enclosures, symmetries, trajectories
from numerics.scene.file import parse_scene
from numerics.solver.solve import solve
from numerics.trajectory.record import END_CODES, Record
from numerics.trajectory.trajectory import Trajectory


def planted(trajectory, **parts):
    """The same trajectory with some of what is made of its record replaced."""
    copy = trajectory.but()
    copy.__dict__.update(parts)
    return copy


def uncertain(trajectory):
    """The same trajectory, its error bounds leaving the sequence of events open."""
    record = trajectory.record
    end = list(record.end_row)
    end[END_CODES.index("certain")] = 0.0
    return Trajectory(trajectory.scene, trajectory.arithmetic, Record(record.rows, end, record.width), bounded=True)


def test_trajectories_that_part_are_a_failure():
    scene = parse_scene("[pair]\nm1=1\nm2=1\na2=200\nb=0.5\n[initial]\nv1=0.15\n[run]\nuntil=2")
    coarse, fine = (solve(scene, digits=n, arithmetic="ball") for n in (10, 30))
    assert enclosures.compare_trajectories(coarse, fine) > 100
    shorter = Record(coarse.record.rows[:-1], coarse.record.end_row, coarse.record.width)
    lost = Trajectory(coarse.scene, coarse.arithmetic, shorter, bounded=False)
    assert enclosures.compare_trajectories(lost, fine) is None
    moved = dataclasses.replace(coarse.events[2], t=coarse.events[2].t * (1 + arb(10) ** -6))
    shifted = planted(coarse, events=(*coarse.events[:2], moved, *coarse.events[3:]))
    assert enclosures.compare_trajectories(shifted, fine) is None


def trajectory_rows(**solvers):
    rows = trajectories.audit_trajectories(3, 2, quiet, trajectories.SOLVERS | solvers)
    return {row.name: row for row in rows}


@pytest.mark.parametrize("name", ["float64", "double-double", "mpmath"])
@pytest.mark.parametrize("where", [0, -1], ids=["the first event", "the last event"])
def test_a_lost_event_fails(name, where):
    def losing(scene):
        found = trajectories.SOLVERS[name](scene)
        events = list(found.events)
        if events:
            del events[where]
        return planted(found, events=tuple(events))

    rows = trajectory_rows(**{name: losing})
    assert not rows["masses"].passed
    assert rows["masses"].measured["missed or invented"] > 0


def test_an_invented_event_fails():
    def inventing(scene):
        found = trajectories.SOLVERS["float64"](scene)
        return planted(found, events=(*found.events, *found.events[-1:]))

    assert trajectory_rows(float64=inventing)["light driver"].measured["missed or invented"] > 0


def test_a_lost_event_that_is_said_is_counted_apart():
    """Seed 6479: runs whose own bounds left the sequence open were counted as lies."""

    def honest(scene):
        found = trajectories.SOLVERS["float64"](scene)
        return planted(uncertain(found), events=tuple(found.events)[:-1])

    row = trajectory_rows(float64=honest)["masses"]
    assert row.passed
    assert row.measured["missed or invented"] == 0
    assert row.measured["other than proved, and said so, float64"] > 0


def test_scenes_are_drawn_until_every_arithmetic_has_answered():
    refusals_left = {"float64": 5}

    def reluctant(scene):
        if refusals_left["float64"]:
            refusals_left["float64"] -= 1
            raise trajectories.NumericsError("no")
        return trajectories.SOLVERS["float64"](scene)

    row = trajectory_rows(float64=reluctant)["masses"]
    assert row.passed
    assert row.tried == 6


def test_an_arithmetic_that_only_refuses_has_not_passed():
    def refusing(scene):
        raise trajectories.NumericsError("no")

    rows = trajectory_rows(mpmath=refusing)
    assert not any(rows[kind].passed for kind in trajectories.KINDS)
    assert not rows["ledger residual, mpmath"].passed


@pytest.mark.parametrize("name", trajectories.SOLVERS)
def test_lost_energy_fails(name):
    def leaking(scene):
        found = trajectories.SOLVERS[name](scene)
        with found.arithmetic.context():
            ledger = found.ledger
            leak = ledger.initial / 10**10 + ledger.friction / 10**10
            books = dataclasses.replace(ledger, residual=ledger.residual + leak)
        return planted(found, ledger=books)

    row = trajectory_rows(**{name: leaking})[f"ledger residual, {name}"]
    assert not row.passed
    assert 1e-12 < row.measured["max"] < 1e-9


@pytest.mark.parametrize(
    ("name", "moved"),
    [
        ("the same run again", lambda t, calls: math.nextafter(t, math.inf) if calls % 2 else t),
        ("sign flip", lambda t, calls: math.nextafter(t, math.inf) if calls % 2 else t),
        ("times times 2^k", lambda t, calls: t + 1e-16),
    ],
)
def test_one_bit_is_seen(name, moved):
    calls = 0

    def trembling(scene):
        nonlocal calls
        calls += 1
        found = solve(scene, max_events=20)
        events = tuple(dataclasses.replace(event, t=moved(event.t, calls)) for event in found.events)
        return planted(found, events=events)

    rows = {row.name: row for row in symmetries.audit_symmetries(0, 14, quiet, trembling)}
    assert not rows[name].passed


def test_a_scene_in_other_units_is_the_same_scene():
    scene = parse_scene("[pair]\nm1=1\nm2=3\na1=0.5\na2=200\nb=0.5\n[initial]\nx1=0.001\nv1=0.15\n[run]\nuntil=2")
    units = symmetries.Units(3, -2, 5)
    there = symmetries.rescaled(scene, units)
    back = symmetries.rescaled(there, symmetries.Units(-3, 2, -5))
    assert back == scene
    assert there.energy_excess == scene.energy_excess
    assert there.energy == scene.energy * Fraction(2) ** (-2 + 2 * 3 - 2 * 5)
