"""Errors planted at the start of a path: all motions that begin as near are in what is said, or it is in doubt."""

import math
from fractions import Fraction

import pytest
from flint import arb

from numerics import Force
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.plane.coupled import BoxRun
from numerics.plane.reduced import reduced
from numerics.plane.run import Run
from numerics.plane.states import States
from numerics.plane.system import System
from numerics.scene.plane import PlanePair, PlaneScene

NUMBERS = ([1, 2], ["0.5", 1], [[200, 60], [60, 120]], ["0.5", "0.1"], [["0.3", "0.1"], ["0.1", "0.2"]])
START = {"x1": ["0.012", "-0.007"], "v1": ["0.1", "0.05"], "force": [Force.sine(1, 9), Force.sine("0.5", 7, 1)]}
BOX = PlaneScene(PlanePair(*NUMBERS, shape="box"), "0.9", **START)
ELLIPSE = PlaneScene(PlanePair(*NUMBERS), "0.5", **START)
ROUND = PlaneScene(PlanePair(1, 1, 200, "0.5"), "0.5", x1=["0.012", "0.002"], v1=[0, "0.06"], v2=[0, "0.05"])


def said(scene, off=0.0, digits=16):
    """Events, and state and mode at the end, of all that begin within `off` of a scene in N."""
    kind = BoxRun if scene.pair.shape == "box" else Run
    run = kind(System(reduced(scene), digits), 100, 2000)
    with run.system.fine():
        run.norm = arb(off)
        run.apart = (run.system.soft * run.norm).each(arb.upper)
    run.follow()
    states = States(scene, run.system, run.legs)
    with run.system.fine():
        return [states.event(one) for one in run.events], states.at(Ball.number(scene.until)), run.mode


def moved(scene, name, axis, by):
    """A scene that begins off in one coordinate, so far in N."""
    weights = {"x1": [row[k] for k, row in enumerate(scene.pair.a2)], "v1": scene.pair.m1, "v2": scene.pair.m2}
    given = list(getattr(scene, name))
    given[axis] += Fraction(by / math.sqrt(weights[name][axis]))
    return changed(scene, **{name: given})


def changed(scene, **new):
    parts = {name: getattr(scene, name) for name in ("x1", "v1", "x2", "v2", "until", "force", "friction")}
    return PlaneScene(scene.pair, **(parts | new))


def agree(one, two):
    """Whether two answers may be of the same motion."""
    (events, end, mode), (others, other_end, other_mode) = one, two
    if mode != other_mode or [(e.before, e.after) for e in events] != [(e.before, e.after) for e in others]:
        return False
    pairs = [
        pair
        for a, b in zip(events, others, strict=True)
        for pair in [(a.t, b.t), *zip(a.load, b.load, strict=True), *zip(a.direction, b.direction, strict=True)]
    ]
    states = [(a.y, b.y) for a, b in zip(events, others, strict=True)] + [(end, other_end)]
    pairs += [pair for a, b in states for p, q in zip(a, b, strict=True) for pair in zip(p, q, strict=True)]
    return all(a.overlaps(b) for a, b in pairs)


@pytest.mark.parametrize(("scene", "off"), [(BOX, 1e-9), (ELLIPSE, 1e-13), (ROUND, 1e-13)])
def test_who_begins_within_the_errors_is_in_what_is_said(scene, off):
    found = said(scene, off)
    assert found[0]
    for name, axis, side in (("x1", 0, 0.99), ("v1", 1, -0.99), ("v2", 0, -0.99)):
        assert agree(found, said(moved(scene, name, axis, side * off)))
    assert not agree(found, said(moved(scene, "x1", 0, 300 * off)))


@pytest.mark.parametrize(("scene", "off"), [(BOX, 1e-9), (ROUND, 1e-13)])
def test_an_event_that_may_come_before_or_after_a_jump_is_in_doubt(scene, off):
    first = said(scene, off)[0][0]
    late = Fraction(float(first.t.rad()))
    for part in (-300, Fraction(-1, 2), Fraction(1, 2)):
        jump = changed(scene, friction=[(Fraction(float(first.t.mid())) + part * late, "0.45")])
        if part < -1:
            assert said(jump, off)
        else:
            with pytest.raises(EventUndecided):
                said(jump, off)


@pytest.mark.parametrize(("after", "is_decided"), [(20e-9, False), (400e-9, True)])
def test_an_end_right_after_the_beginning_of_another_slip_is_in_doubt(after, is_decided):
    """Axis 0 slips from 0 at 0.03 m/s^2, so for 94 times its error it may not yet; axis 1 ends at 0.98 m/s^2."""
    pair = PlanePair(1, 1, [[200, 1], [1, 200]], "0.5", shape="box")
    scene = PlaneScene(pair, "0.01", x1=["-0.00515", 0], v1=[0, Fraction(0.98 * after)])
    if is_decided:
        assert said(scene, 1e-9)[0][0].after == "+0"
    else:
        with pytest.raises(EventUndecided, match="which axis"):
            said(scene, 1e-9)
