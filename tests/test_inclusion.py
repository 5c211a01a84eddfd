"""Any scene's answer is a motion of it; and what is not quite one is seen, and said to be what it is."""

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from differences import moved
from flint import arb
from hypothesis import given
from inclusion import faults, motion, solved
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import KINDS as STRATEGIES
from strategies import weakened_scenes

from numerics import EventUndecided, load_scene
from numerics.trajectory.sensitivity import parameters

KINDS = STRATEGIES | {"friction of the state": weakened_scenes()}
FOUND = scenes_in("passed-over")
SHAKEN = load_scene("forced-sine-stick-slip")


@pytest.mark.parametrize("kind", KINDS)
def test_any_answer_is_a_motion(kind):
    """For some events; or it is refused at a touch."""

    @reaching
    @given(KINDS[kind])
    def holds(scene):
        try:
            run = solved(scene, max_events=4)
        except EventUndecided:
            raise LeftOut from None
        assert [*faults(run)] == []
        assert len(run.events) <= 4
        assert run.reached or len(run.events) == 4
        assert len(run.row_signs) == len(run.row_times)
        assert run.signs[0] == run.row_signs[0]

    holds()


@pytest.mark.parametrize("scene", FOUND.values(), ids=FOUND)
def test_no_event_is_passed_over(scene):
    run = solved(scene)
    assert run.success
    assert run.certain
    assert [*faults(run)] == []


def test_the_motion_of_a_scene_that_is_off_by_little_is_none_of_this():
    run = motion(FOUND["everything"])
    for name in parameters(run.scene).keys() - {"until"}:
        by = Fraction(1, 10 ** (8 if name.endswith("from") else 16))
        assert next(faults(run, moved(run.scene, {name: by})), ""), name


@pytest.mark.parametrize("longer", ["1e-9", "0.01"])
@pytest.mark.parametrize("row", range(4))
def test_a_mode_that_lasts_too_long_is_none(row, longer):
    """A slip beyond v1 = v2, and a stick beyond what friction holds."""
    run = motion(SHAKEN, max_events=6)
    with run.arithmetic.context():
        begin, end = run.row_times[row : row + 2]
        late = SimpleNamespace(
            scene=run.scene, row_times=[begin], end_time=end + arb(longer), row_signs=run.row_signs[row:]
        )
        late.sol = lambda t, side="right": run.row_motion(row).after(max(t - begin, arb(0)))
        assert any(one.startswith(f"no {'slip' if late.row_signs[0] else 'stick'}") for one in faults(late))


SPOILT = {
    "another start": lambda _, side: [1, 0, 0, 0],
    "a jump of the state": lambda _, side: [0, 0, int(side == "left"), 0],
    "a velocity that is none": lambda t, _: [0, 0, t, 0],
    "forces that do not balance": lambda t, _: [t * t, 2 * t, 0, 0],
}
"""What is added to a motion, in units of 1e-12."""


@pytest.mark.parametrize("said", SPOILT)
def test_each_way_to_be_no_motion_is_seen_and_named(said):
    run = motion(SHAKEN, max_events=4)
    parts = {name: getattr(run, name) for name in ("scene", "row_times", "end_time", "row_signs")}

    def spoilt(t, side="right"):
        return run.sol(t, side) + np.array([arb(one) * arb("1e-12") for one in SPOILT[said](arb(t), side)])

    found = [*faults(SimpleNamespace(sol=spoilt, **parts))]
    assert found
    assert any(one.startswith(said) for one in found)
