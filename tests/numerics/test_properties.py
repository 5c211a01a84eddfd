"""What every trajectory does, over masses, stiffness, friction, damping and states of many magnitudes."""

from fractions import Fraction

from hypothesis import example, given
from hypothesis import strategies as st
from reaching import LeftOut, reaching
from strategies import driven_scenes, scenes

from numerics import EventUndecided, Force, Friction, OutOfRange, Pair, Piece, Scene, State, solve

CAP = 25


def solved(scene, **how):
    return solve(scene, max_events=CAP, **how)


any_scene = st.one_of(scenes(damped=None), driven_scenes())


@reaching
@given(any_scene)
@example(Scene(Pair(1, 10, 1, 1, 1), State(), 5, force=Force([Piece(0, [0, 0, "0.5"])])))  # a stick without a load
@example(Scene(Pair(1, 1, 1, 1), State(0, "2.8284", 0, "2.8284"), "2.2", force=Force([Piece("0.8838", [2])])))
def test_the_sign_flip_commutes_with_solving_bit_for_bit(scene):
    at = scene.initial
    start = State(-at.x1, -at.v1, -at.x2, -at.v2)
    mirrored = Scene(scene.pair, start, scene.until, scene.law, -scene.force, scene.friction)
    for how in ({}, {"digits": 20}):
        try:
            one, two = solved(scene, **how), solved(mirrored, **how)
        except EventUndecided:
            raise LeftOut from None
        assert one.signs == [-sign for sign in two.signs]
        enclosed = one.arithmetic.name == "ball"
        with one.arithmetic.context():
            for a, b in zip(one.y.ravel(), two.y.ravel(), strict=True):
                assert a == -b or (enclosed and a.overlaps(-b))
            for a, b in zip(one.t, two.t, strict=True):
                assert a == b or (enclosed and a.overlaps(b))


@reaching
@given(any_scene, st.integers(-40, 40), st.integers(-40, 40))
def test_other_units_change_a_run_within_its_bounds(scene, k, n):
    """Lengths times 2^k and masses times 2^n: exact in every number, so that only a rounding of a unit can differ."""
    length, mass = Fraction(2) ** k, Fraction(2) ** n
    pair, at, force = scene.pair, scene.initial, mass * length
    other = Scene(
        Pair(pair.m1 * mass, pair.m2 * mass, pair.a2 * mass, pair.b * force, pair.a1 * mass),
        State(*(length * x for x in (at.x1, at.v1, at.x2, at.v2))),
        scene.until,
        scene.law,
        Force((force * scene.force).pieces),
        Friction([(start, b * force) for start, b in scene.friction.steps]),
    )
    try:
        one, two = (solve(each, arithmetic="float64", max_events=30) for each in (scene, other))
    except (EventUndecided, OutOfRange):  # on a tie, or a damper that is far too steep for float64
        raise LeftOut from None
    if not (one.certain and two.certain):
        raise LeftOut
    assert one.modes == two.modes
    for a, b, *off in zip(one.t[1:], two.t[1:], one.accuracy.t, two.accuracy.t, strict=False):
        assert abs(a - b) <= sum(off)
    ends = zip(one.final_state, two.final_state, one.accuracy.final, two.accuracy.final, strict=True)
    for a, b, off, scaled in ends:
        assert abs(Fraction(a) - Fraction(b) / length) <= Fraction(off) + Fraction(scaled) / length
