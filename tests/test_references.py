"""Every kind of scene on a line against the law itself, which is seen to notice a scene that is off by little."""

from dataclasses import replace
from fractions import Fraction
from functools import partial
from types import SimpleNamespace

import draws
import numpy as np
import pytest
from differences import moved
from flint import arb
from hypothesis import given
from inclusion import faults, motion, overlap, solved
from reaching import LeftOut, reaching
from scene_files import scenes_in
from strategies import drawn, fewer

from numerics import EventUndecided, Law, load_scene, solve
from numerics.trajectory.sensitivity import parameters

KINDS = {
    "free": draws.scene,
    "damped": partial(draws.scene, damped=True),
    "the literal law": partial(draws.scene, damped=None, law=Law.THREE_VALUED_SGN),
    "driven": draws.driven,
    "friction of the state": partial(draws.weakened, damping=(-12, 2)),
    "what people bring": partial(draws.brought, exponents=(0, 0), damping=(-2, 0)),
    "many cycles in one slip": partial(draws.long_slip, damped=None, turns=(0, 0)),
    "next to E_cr": partial(draws.near_critical, decades=(3, 16)),
}
FOUND, SIGNALS = scenes_in("passed-over"), scenes_in("signals")
SHAKEN = load_scene("forced-sine-stick-slip")


@pytest.mark.parametrize("kind", KINDS)
def test_any_answer_obeys_the_law(kind):
    """For some events, and in floats it is that of balls; or it is refused at a touch."""

    @reaching
    @fewer(2)
    @given(drawn(KINDS[kind]))
    def holds(scene):
        try:
            run, quick = solved(scene, max_events=4), solve(scene, max_events=4)
        except EventUndecided:
            raise LeftOut from None
        assert [*faults(run)] == []
        assert run.reached or len(run.events) == 4
        assert quick.check().right

    holds()


@pytest.mark.parametrize("scene", (FOUND | SIGNALS).values(), ids=FOUND | SIGNALS)
def test_no_event_is_passed_over(scene):
    run = motion(scene)
    assert run.success
    assert overlap(run, solve(scene, arithmetic="ball", digits=30, max_digits=200))


OFF = "belt-and-wall", "wall-of-a-sine"


@pytest.mark.parametrize("scene", [FOUND["everything"], *(SIGNALS[one] for one in OFF)])
def test_the_motion_of_a_scene_that_is_off_by_little_is_none_of_this(scene):
    run = motion(scene)
    for name in parameters(scene).keys() - {"until"}:
        by = Fraction(1, 10 ** (8 if name.endswith("from") else 16))
        other = moved(scene, {name: by})
        assert other is None or next(faults(run, other), ""), name


def test_a_slip_that_begins_too_early_is_none():
    """Where static friction still holds, by a part in 1e8, or a stick is never left."""
    run = motion(SIGNALS["static-friction-under-a-sine"])
    pair, literal = run.scene.pair, run.scene.replace(law=Law.THREE_VALUED_SGN)
    stronger = run.scene.replace(pair=replace(pair, b_static=pair.b_static * (1 + Fraction(1, 10**8))))
    for scene in (stronger, literal):
        assert any(one.startswith("a slip that begins too early") for one in faults(run, scene))


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
        late.sol = lambda t, side="right": run.row_flow([row], [max(t - begin, arb(0))])[:, 0]
        assert any(one.startswith(f"no {'slip' if late.row_signs[0] else 'stick'}") for one in faults(late))


@pytest.mark.parametrize(
    ("said", "added"),
    [
        ("another start", lambda _, side: [1, 0, 0, 0]),
        ("a jump of the state", lambda _, side: [0, 0, int(side == "left"), 0]),
        ("a velocity that is none", lambda t, _: [0, 0, t, 0]),
        ("forces that do not balance", lambda t, _: [t * t, 2 * t, 0, 0]),
    ],
)
def test_each_way_to_be_no_motion_is_seen_and_named(said, added):
    """Of what is added to a motion, in units of 1e-12."""
    run = motion(SHAKEN, max_events=4)
    parts = {name: getattr(run, name) for name in ("scene", "row_times", "end_time", "row_signs")}

    def spoilt(t, side="right"):
        return run.sol(t, side) + np.array([arb(one) * arb("1e-12") for one in added(arb(t), side)])

    assert any(one.startswith(said) for one in faults(SimpleNamespace(sol=spoilt, **parts)))
