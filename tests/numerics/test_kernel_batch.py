"""Many scenes in one compiled call: what each gives by itself, in any order; rows in doubt are left alone."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kernel_runs import run

from numerics import Force, Law, Pair, Piece, Scene, Sine, State
from numerics.linear.batch import run_rows
from numerics.linear.engine import run_pairs
from numerics.linear.record import AT, END_ROW, ROW

KEPT = 6
NOT_THERE = [AT["excess"], AT["excess_low"]]
BOUNDS = slice(AT["late"], ROW)


class Columns:
    """A batch of scenes with as many coefficients and sines each."""

    def __init__(self, scenes):
        given = [(one.pair, one.initial, one.until) for one in scenes]
        numbers = [(p.m1, p.m2, p.a2, p.b, s.x1, s.v1, s.x2, s.v2, t, p.a1) for p, s, t in given]
        self.table = np.array([[half for one in row for half in (float(one), 0.0)] for row in numbers])
        pieces = [one.force.pieces[0] for one in scenes]
        self.polynomial = np.array([[float(c) for c in one.polynomial] for one in pieces])
        self.sines = np.array(
            [[[float(n) for n in (s.amplitude, s.omega, s.phase)] for s in one.sines] for one in pieces]
        )
        self.sines = self.sines.reshape(len(scenes), -1, 3)


def solved(scenes, how=-7.0, most=40):
    columns, literal = Columns(scenes), scenes[0].law is Law.THREE_VALUED_SGN
    kept, ends = np.zeros((len(scenes), KEPT, ROW)), np.full((len(scenes), END_ROW), how)
    run_rows(columns, literal, most, kept, ends)
    return kept, ends


@st.composite
def batches(draw):
    """Scenes of any size in which binary fractions are exact, some of them with the same pair and frequencies."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    terms, waves = draw(st.integers(0, 3)), draw(st.integers(0, 2))
    law = draw(st.sampled_from([Law.FILIPPOV, Law.FILIPPOV, Law.THREE_VALUED_SGN]))
    size = [2.0 ** int(n) for n in random.integers(-9, 9, 3)]

    def number(unit=1.0):
        return Fraction(int(random.integers(1, 64)), 16) * Fraction(unit)

    def scene(like):
        mass, time, length = size
        force = mass * length / time**2
        pair = (
            like.pair
            if like
            else Pair(number(mass), number(mass), number(mass / time**2), number(force), number(mass / time))
        )
        b = number(force)
        pair = Pair(pair.m1, pair.m2, pair.a2, b, pair.a1)
        sines = [Sine(number(2 * force), number(1 / time), number()) for _ in range(waves)]
        if like:
            sines = [
                Sine(one.amplitude, two.omega, one.phase)
                for one, two in zip(sines, like.force.pieces[0].sines, strict=True)
            ]
        polynomial = [number(force / time**k) for k in range(terms)]
        at = State(number(length), -number(length / time), number(length), number(length / time))
        return Scene(pair, at, 5 * number(time), law, Force([Piece(0, polynomial, sines)]))

    scenes = [scene(None)]
    for _ in range(draw(st.integers(1, 4))):
        scenes.append(scene(scenes[int(random.integers(len(scenes)))] if draw(st.booleans()) else None))
    return scenes


@given(batches(), st.sampled_from([1, 2, 40]))
@settings(max_examples=12)
def test_each_row_is_what_its_scene_gives_by_itself_in_any_order(scenes, most):
    kept, ends = solved(scenes, most=most)
    backwards = solved(scenes[::-1], most=most)
    for one, two in ((kept, backwards[0]), (ends, backwards[1])):
        np.testing.assert_allclose(two[::-1][..., : AT["late"]], one[..., : AT["late"]], rtol=1e-9, atol=1e-200)
    for scene, rows, end in zip(scenes, kept, ends, strict=True):
        if run(scene, most=most).modes is None:
            assert (end == -7.0).all()
            continue
        record = run_pairs(scene, wide=False, max_events=most)
        count = min(KEPT, len(record.rows))
        for ours, its in ((rows[:count], record.rows[:count]), (end[None], record.end[None])):
            one, two = np.delete(ours, NOT_THERE, 1), np.delete(its, NOT_THERE, 1)
            assert one == pytest.approx(two, rel=1e-6, abs=1e-11 * abs(record.rows[:, AT["x1"] : AT["excess"]]).max())
        assert ours[:, BOUNDS] == pytest.approx(its[:, BOUNDS], rel=0.3)
        assert (rows[count:] == 0).all()


def test_a_row_in_doubt_keeps_what_it_had():
    """At rest exactly on the edge: a tie that binary64 does not decide."""
    tie = Scene(Pair(1, 1, 2, 1), State(1, 0, 0, 0), 3, force=Force([Piece(0, [], [Sine("0.5", 1, 0)])]))
    plain = Scene(tie.pair, State(0.25, 1, 0, 0), 3, force=tie.force)
    kept, ends = solved([plain, tie, plain])
    assert (ends[1] == -7.0).all()
    assert not math.isnan(ends[0, AT["x1"]])
    np.testing.assert_array_equal(ends[0], ends[2])
    assert kept[0, 0, AT["x1"]] == 0.25


@pytest.mark.parametrize("changed", range(6))
def test_a_row_that_differs_by_one_number_of_the_pair_or_force_has_its_own_answer(changed):
    scenes = []
    for n in range(3):
        m1, m2, a2, a1, omega, b = (1 + n / 4 * (k == changed) for k in range(6))
        force = Force([Piece(0, [], [Sine(2, omega, 0)])])
        scenes.append(Scene(Pair(m1, m2, a2, b, a1), State(1, 2, 0, 0), 5, force=force))
    for end, scene in zip(solved(scenes)[1], scenes, strict=True):
        expected = run_pairs(scene, wide=False, max_events=40).end
        assert end[AT["x1"] : AT["excess"]] == pytest.approx(expected[AT["x1"] : AT["excess"]], abs=1e-11)
