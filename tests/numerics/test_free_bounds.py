"""The error bounds of a free run against errors that are planted in its start."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import numpy as np
import pytest
from differences import moved
from flint import arb
from planted_errors import COORDINATES, draw_scene, in_units, run, unit_pair

from numerics import Scene, State
from numerics.arithmetic.ball import Ball
from numerics.free import engine, motion, rows
from numerics.free.bounds import ROW_UNIT, initial
from numerics.free.contact import contact, ray_contact
from numerics.free.frame import begin, is_known
from numerics.free.slip import Start
from numerics.linear.record import AT

EVENT = [("local", "late"), *((name, f"{name}_error") for name in COORDINATES)]
END = [*EVENT[1:], ("excess", "excess_error"), ("friction", "dissipated_error")]
COUNT = 500


def exceeds(one, other, names):
    """By how much differences exceed the bounds: the largest quotient, and the column it belongs to."""
    found = [(0.0, "")]
    for name, bound in names:
        allowed = one[..., AT[bound]] * (1 + 1e-2) + other[..., AT[bound]] + 1e-25
        found.append((float(np.max(abs(one[..., AT[name]] - other[..., AT[name]]) / allowed, initial=0.0)), name))
    return max(found)


def of_first_order(found):
    """Whether the planted errors are small beside w at every event, and beside the time since the last one."""
    rows, end = found.rows[1:], found.end
    small = rows[:, AT["excess_error"]] <= 3e-3 * abs(rows[:, AT["excess"]])
    return bool(small.all()) and rows[-1, AT["late"]] <= 3e-3 * end[AT["length"]]


def draw_neighbours(random):
    """A scene and another close to it that starts in the same mode; a third of the horizons lie next to an event."""
    scene, size = draw_scene(random), 10 ** random.uniform(-8, -3)
    names = random.sample(COORDINATES, random.choice([1, 1, 2, 4]))
    by = {one: Fraction(random.uniform(-1, 1) * size) for one in names}
    if scene.initial.v1 == scene.initial.v2 and {"v1", "v2"} & set(by):
        by["v1"] = by["v2"] = by.get("v1", by.get("v2"))  # on the surface as well
    first = run(scene).rows[1:]
    if len(first) and random.random() < 1 / 3:
        at = random.choice(first)[AT["local"]] + random.uniform(-3, 3) * size
        scene = replace(scene, until=Fraction(at)) if at > 0 else scene
    return scene, moved(scene, by)


def test_bounds_hold_for_planted_errors():
    """A run whose errors at the start are those of a neighbour bounds the distance to the neighbour's run.

    Where it says `certain` both have the same events.
    """
    random, compared = Random(17), 0
    for _ in range(COUNT):
        scene, neighbour = draw_neighbours(random)
        found, other = run(scene, planted=neighbour), run(neighbour)
        if not found.certain or found.modes[0] != other.modes[0]:  # the first mode is decided on exact data
            continue
        assert found.modes == other.modes, (scene, neighbour)
        if len(found.rows) == 1 or not of_first_order(found):
            continue
        compared += 1
        assert (far := exceeds(found.rows[1:], other.rows[1:], EVENT))[0] <= 1, (far, scene, neighbour)
        if not found.stopped:
            assert (far := exceeds(found.end, other.end, END))[0] <= 1, (far, scene, neighbour)
    assert compared > COUNT / 5


def edge_of_itinerary(random):
    """A scene, one of its coordinates, and the value of it where the events change but not the first mode."""
    while True:
        scene, name = draw_scene(random), random.choice(["x1", "v1", "v2"])
        if scene.initial.v1 == scene.initial.v2 and name != "x1":
            continue  # it would leave the surface
        by = Fraction(random.choice([-1, 1]) * 10 ** random.uniform(-2, 0))
        here, there = run(scene).modes, run(moved(scene, {name: by})).modes
        if here != there and here[0] == there[0]:
            break
    inside, outside = Fraction(0), by
    for _ in range(50):
        middle = (inside + outside) / 2
        if run(moved(scene, {name: middle})).modes == here:
            inside = middle
        else:
            outside = middle
    return scene, name, outside


def test_nothing_is_certain_where_planted_errors_reach_other_events():
    """A start that lies 1e-7 to 1e-5 from one with other events does not claim to know its own."""
    random = Random(5)
    for _ in range(COUNT // 4):
        scene, coordinate, edge = edge_of_itinerary(random)
        off = Fraction(random.choice([-1, 1]) * 10 ** random.uniform(-7, -5))
        start = moved(scene, {coordinate: edge + off})
        found = run(start, planted=moved(start, {coordinate: off * Fraction(6, 5)}))
        other = run(moved(scene, {coordinate: edge - off / 10}))
        if found.modes != [0.0]:  # whether a pair that starts in stick stays there is decided on exact data
            assert not found.certain or found.modes == other.modes, (start, off)


def test_an_excess_that_may_be_negative_is_no_certain_exit():
    """A pair that sticks with an excess w of less than twice its error may stick for ever."""
    random, exits = Random(8), 0
    for _ in range(40):
        scene = draw_scene(random)
        x1, w, part = Fraction(random.uniform(-0.9, 0.9)), 10 ** random.uniform(-9, -3), random.uniform(0.5, 2.5)
        v1, other = (Fraction((1 + size - float(x1) ** 2) ** 0.5) for size in (w, w * (1 - part)))
        stuck = Scene(scene.pair, State(x1, v1, 0, v1), 20)
        found = run(stuck, planted=Scene(scene.pair, State(x1, other, 0, other), 20))
        exits += found.modes[1:2] != []
        assert not found.certain
    assert exits == 40


@pytest.mark.parametrize(("share", "excess", "returns"), [("9/10", "0.1", 1), ("1/50", "10", -1)])
def test_an_exit_is_off_by_what_slip_and_stick_before_it_add_up_to(share, excess, returns):
    """And not by much less: to the other edge, and to the same one."""
    v, off = Fraction(float(1 + Fraction(excess)) ** 0.5), Fraction(1, 10**8)
    scene = Scene(unit_pair(Fraction(share)), State(0, v, 0, v), 30)
    neighbour = moved(scene, {"v1": off, "v2": off})
    found, other = run(scene, planted=neighbour).rows[1:4], run(neighbour).rows[1:4]
    assert list(found[:, 0]) == [-1, 0, returns]
    late = abs(found - other)[:, AT["local"]] / found[:, AT["late"]]
    assert 0.9 < late[2] <= 1 + 1e-3


def test_a_start_formed_of_floats_is_within_the_bounds_of_the_exact_one():
    """Where its signs are certain; elsewhere it is left to exact arithmetic."""
    random, left, largest = Random(23), 0, dict.fromkeys(("gap", "push", "w", "Z", "state"), 0.0)
    for _ in range(10 * COUNT):
        scene = in_units(draw_scene(random), *(Fraction(random.randint(1, 99), 7) for _ in range(3)))
        if random.random() < 0.1:  # one rounding apart
            scene = moved(
                scene, {"v2": (scene.initial.v1 - scene.initial.v2) + scene.initial.v1 / 2 ** random.choice([52, 55])}
            )
        row = engine.scene_row(scene)
        begun = None if row is None else begin(tuple(row.tolist()[:9]), False, float, ROW_UNIT)
        if begun is None or not is_known(begun):
            left += 1
            continue
        exact, errors = engine.begin_in_rows(scene)[0], initial(begun, 1.0)
        (q, r, *_), one, two = exact.at, begun.start, exact.start
        assert (one.kind, one.side, one.turns) == (two.kind, two.side, two.turns)
        state = (one.X - two.X) ** 2 + q * (begun.V1 - exact.V1) ** 2 + r * (begun.V2 - exact.V2) ** 2
        by = (q, q**0.5) if one.kind == motion.STICK else (1, 1)
        far = [
            abs(one.gap - two.gap) / by[0] / errors.gap,
            abs(one.push - two.push) / by[1] / errors.push,
            abs(one.w - two.w) / errors.w,
            abs(one.Z - two.Z) / errors.place,
            state**0.5 / errors.norm,
        ]
        assert max(far) <= 1, (far, scene)
        largest = {name: max(x, y) for (name, x), y in zip(largest.items(), far, strict=True)}
    assert 0 < left < 5 * COUNT
    assert min(largest.values()) > 0.1, largest


UNIT = 1e-9
"""A rounding that is planted: so large that those of float64 are nothing beside it."""
OFF = {"contact": (4, 8), "ray_contact": (8, 8), "first_contact": (8,), "guard_and_gap": (8, 8), "slid_at": (15,)}
OFF |= {"push_at": (8,), "sine_cosine": (8, 8), "atan2": (8,), "sqrt": (8,), "in_si": (8, 8, 8, 8), "resolve": (4,)}
"""Functions of a run, and by how many roundings the numbers are off that each returns."""


def rounded(function, roundings, signs):
    """A function whose results are off; the excess after a slip from a ray is that of its depth."""

    def disturbed(*given):
        found, off = function(*given), [1 + UNIT * n * sign for n, sign in zip(roundings, signs, strict=False)]
        if isinstance(found, Start):  # the gap beyond the other edge, a difference
            beyond = (off[0] - 1) * (4 / given[0].q + found.gap) * (found.kind == motion.SURFACE)
            return found._replace(gap=found.gap + beyond)
        if not isinstance(found, tuple):
            return found * off[0]
        first, *rest = (*(x * one for x, one in zip(found, off, strict=False)), *found[len(off) :])
        if function is motion.ray_contact:
            w, _, q, r, _ = given
            rest[1] = w - r * q * rest[0] * rest[0]
        return first, *rest

    return disturbed


@pytest.mark.parametrize("name", OFF)
def test_roundings_of_every_function_are_within_the_bounds(name, monkeypatch):
    """One function at a time, in every one of its calls in the same direction."""
    random, largest, module = Random(3), 0.0, rows if hasattr(rows, name) else motion
    for scene in [draw_scene(random) for _ in range(100)]:
        exact, signs = run(scene), random.choices([-1, 1], k=4)
        with monkeypatch.context() as patch:
            patch.setattr(module, name, rounded(getattr(module, name), OFF[name], signs))
            patch.setattr(engine, "UNIT", UNIT)
            found = run(replace(scene))
        if not found.certain or (len(found.rows) > 1 and not of_first_order(found)):
            continue
        assert found.modes == exact.modes
        far = [exceeds(found.rows[1:], exact.rows[1:], EVENT)[0]]
        far += [] if found.stopped else [exceeds(found.end, exact.end, END)[0]]
        assert max(far) <= 1, scene
        largest = max(largest, *far)
    assert largest > 0.2


def ray(w, q):
    """The end of a slip from an exit ray: angle, depth, excess."""
    return ray_contact(w, (w / q).sqrt(), q, 1 - q, q.sqrt())[:3]


def test_the_contact_of_balls_holds_those_of_points_inside():
    """One argument is a wide ball, so that no other one covers for it."""
    random = Random(2)
    with Ball(40).context():
        for _ in range(300):
            gap, push, w = (arb(10 ** random.uniform(-3, 1.3)) for _ in range(3))
            sign, off, q = random.choice([-1, 1]), 10 ** random.uniform(-9, -2), arb(random.uniform(0.02, 0.98))
            for end in (
                lambda x, gap=gap, push=sign * push: contact(gap * x, push),
                lambda x, gap=gap, push=sign * push: contact(gap, push * x),
                lambda x, push=push: contact(arb(0), push * x),
                lambda x, w=w, q=q: ray(w * x, q),
            ):
                wide = end(1 + off * arb(0, 1))
                for place in (-1, 1):
                    inside = end(1 + off * arb(place) * (1 - 1e-6))
                    assert all(one.overlaps(two) for one, two in zip(wide, inside, strict=True))
