"""What every trajectory does, over masses, stiffness, friction, damping and states of many magnitudes."""

from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from scene_files import mirrored, scenes_in
from sixty_digits import forced_scene
from strategies import driven_scenes, scenes

from numerics import EventUndecided, Force, Friction, Pair, Piece, Sine, State, solve


@reaching
@given(st.one_of(scenes(damped=None), driven_scenes()))
@example(scenes_in("mirrored")["a-stick-without-a-load"])
@example(scenes_in("mirrored")["a-jump"])
def test_the_sign_flip_commutes_with_solving_bit_for_bit(scene):
    for how in ({}, {"digits": 20}):
        try:
            one, two = (solve(each, max_events=25, **how) for each in (scene, mirrored(scene)))
        except EventUndecided:
            raise LeftOut from None
        assert one.signs == [-sign for sign in two.signs]
        is_ball = one.arithmetic.name == "ball"
        with one.arithmetic.context():
            for a, b in zip([*one.t, *one.y.flat], [*two.t, *-two.y.ravel()], strict=True):
                assert a.overlaps(b) if is_ball else a == b


def in_other_time(scene, time):
    """The same scene in another unit of time: what is a rate changes, nothing else."""
    pair, at, force = scene.pair, scene.initial, 1 / time**2
    pieces = [
        Piece(
            one.start * time,
            [force * c / time**k for k, c in enumerate(one.polynomial)],
            [Sine(force * s.amplitude, s.omega / time, s.phase) for s in one.sines],
        )
        for one in scene.force.pieces
    ]
    return scene.replace(
        pair=Pair(pair.m1, pair.m2, pair.a2 * force, pair.b * force, pair.a1 / time),
        initial=State(at.x1, at.v1 / time, at.x2, at.v2 / time),
        until=scene.until * time,
        force=Force(pieces),
        friction=Friction([(start * time, b * force) for start, b in scene.friction.steps]),
    )


TIES = ("tie-by-second-derivative-slips", "contact-to-third-order", "sine-at-threshold", "polynomial-of-degree-8")
ROUNDED = ("triangular-wave", "sine-stick-slip", "damping-heavy")


@pytest.mark.parametrize(
    "exponent", [-20, *(pytest.param(one, marks=pytest.mark.long) for one in (9, -9, 20, 60, -60))]
)
@pytest.mark.parametrize(
    ("name", "way"), [*((name, "ball") for name in TIES), *((name, "float64") for name in ROUNDED)]
)
def test_the_unit_of_time_does_not_matter(name, way, exponent):
    """Events, bounds, ledger. @example of found faults: a time below 1e-15 s was rounded to 0 at a tie, and others."""
    scene, digits = forced_scene(name), {"digits": 40} if way == "ball" else {}
    other = in_other_time(scene, Fraction(10) ** exponent)
    one, two = (solve(each, arithmetic=way, **digits) for each in (scene, other))
    assert one.modes == two.modes
    assert two.check().right
    assert two.right_digits == pytest.approx(one.right_digits, abs=1)
