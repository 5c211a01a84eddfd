"""Errors planted at the start of a path: all motions that begin as near are in what is said, or it is in doubt."""

import math
from contextlib import suppress
from fractions import Fraction

import pytest
from flint import arb, arb_poly
from hypothesis import example, given
from hypothesis import strategies as st
from plane_paths import agree, path_of, said
from scene_files import scenes_in
from strategies import fewer

from numerics import NotSettled
from numerics.errors import EventUndecided
from numerics.plane import series
from numerics.plane.polynomial import first_root
from numerics.plane.series import expand
from numerics.scene.plane import PlanePair, PlaneScene

SURFACES = scenes_in("surfaces")
BOX, ELLIPSE, ROUND = (SURFACES[name] for name in ("box", "ellipse", "round"))


def moved(scene, name, axis, by):
    """A scene that begins off in one coordinate, so far in N."""
    weights = {"x1": [row[k] for k, row in enumerate(scene.pair.a2)], "v1": scene.pair.m1, "v2": scene.pair.m2}
    given = list(getattr(scene, name))
    given[axis] += Fraction(by / math.sqrt(weights[name][axis]))
    return scene.replace(**{name: given})


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
        jump = scene.replace(friction=[(Fraction(float(first.t.mid())) + part * late, "0.45")])
        if part < -1:
            assert said(jump, off)
        else:
            with pytest.raises(EventUndecided):
                said(jump, off)


@pytest.mark.parametrize("side", [0.99, -0.99])
def test_a_stick_ends_no_later_or_earlier_than_is_said(side):
    """What an error in x1 alone moves its load by is all that N allows."""
    scene = SURFACES["a-stick-on-the-way-to-the-edge"]
    (found, *_), (first, *_) = said(scene, 1e-13)[0], said(moved(scene, "x1", 0, side * 1e-13))[0]
    assert (found.before, found.after) == ("stick", "slip")
    assert found.t.overlaps(first.t)
    assert not found.t.overlaps(said(moved(scene, "x1", 0, 10 * side * 1e-13))[0][0].t)


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


def test_where_a_slip_ends_with_a_load_that_may_just_be_outside_is_in_doubt():
    """The load of axis 0 falls at 200 N/s and is 7e-8 N inside when the slip ends, which is known to 7e-10 s."""
    scene = SURFACES["an-end-with-a-load-just-inside"]
    first = said(scene)[0][0]
    assert (first.after, float(first.load[0]) + 0.5) == ("0+", pytest.approx(7e-8, rel=1e-5))
    with pytest.raises(EventUndecided, match="where the slip ends"):
        said(scene, 1e-9)


@pytest.mark.parametrize(
    ("coefficients", "error", "found"),
    [
        ((1, "-1.005"), "0.01", False),  # it comes to -0.005, and may stay positive
        (("1e-30", "1e-16", 1), "0.9e-30", None),  # it rises from a little more than its error
        (("1e-30", "1e-16", 1), "1.1e-30", False),
        (("0.005",), "0.01", False),  # all of it is within its error
    ],
)
def test_a_root_counts_where_the_function_surely_falls_below_0(coefficients, error, found):
    assert first_root(arb_poly([*map(arb, coefficients)]), arb(error)) is found


@pytest.mark.parametrize("digits", [3, 5, 9])
def test_in_what_few_digits_say_is_what_many_say(digits):
    assert agree(said(BOX, digits=digits), said(BOX, digits=30))


def test_with_a_damper_a_slip_from_the_edge_is_not_sure_for_long():
    """The load rises by little, and the slip itself takes some of that: to second order in the window."""
    run = path_of(SURFACES["a-damper-at-the-edge"])
    with run.system.fine():
        normal = run.load
        assert run.leaves(normal, arb(1e-6), 2)
        near = run.around(arb(1e-4))
        assert normal @ near.drift > 0
        # a mode that is followed past the true motion's end has a little more friction than there is
        assert min(near.second * run.system.m2 - run.drive.b) > 0
        assert not run.leaves(normal, arb(1e-4), 2)


@pytest.fixture(scope="module")
def right():
    return said(ELLIPSE)


@fewer(3)
@given(row=st.integers(0, 40), k=st.none() | st.integers(0, 27), power=st.integers(-70, 20))
@example(row=0, k=None, power=-40)  # s
@example(row=6, k=None, power=-50)  # t, whose beginning is that of the step
def test_wrong_digits_of_a_series_are_in_the_bound_or_end_in_doubt(right, row, k, power):
    """A series proves nothing: wrong numbers make bounds larger, steps shorter, or the end undecided."""

    def spoilt(table, *given):
        expand(table, *given)
        row_of = table[row % len(table)]
        for j in range(len(row_of)) if k is None else [k]:
            row_of[j] = row_of[j] * (1 + 2.0**power)

    with pytest.MonkeyPatch.context() as patch, suppress(EventUndecided, NotSettled):
        patch.setattr(series, "expand", spoilt)
        assert agree(said(ELLIPSE), right)
