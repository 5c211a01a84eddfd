"""Runs of the engine in balls, and scenes in which one part of a bound is nearly all of it."""

from flint import arb
from overlapping import overlap
from scene_files import scenes_in

from numerics.arithmetic.ball import Ball
from numerics.linear.enclosed import run_enclosed
from numerics.linear.pieces import pieces_of

LETTERS = {0: "0", 1: "+", -1: "-"}


def run(scene, digits=40, most=1000, arithmetic=Ball):
    return run_enclosed(scene, arithmetic(digits), most)


def events(record):
    return [row for row in record.rows if row.event]


def itinerary(record):
    return "".join(LETTERS[row.mode] for row in (record.rows[0], *events(record)))


def numbers(scene, row):
    """Time since the start, x1, v1, x2, v2."""
    return [arb(row.local) + Ball.number(pieces_of(scene)[row.piece].start), row.x1, row.v1, row.x2, row.v2]


def same(one, two):
    """Whether two runs of a scene may be of the same motion."""
    rows = ([numbers(scene, row) for row in (*events(found), found.end)] for scene, found in (one, two))
    return itinerary(one[1]) == itinerary(two[1]) and overlap(*rows)


OFF = """
a-slower-body-2-at-the-event   | 0 0 0 1
a-slower-body-2-in-its-slip    | 0 0 0 1
a-place-in-a-steep-cell        | 1 0 -1 0
a-place-before-a-steep-cell    | 0 0 1 0
a-place-behind-a-steep-cell    | 0 0 1 0
speeds-that-part               | 0 1 0 -1
speeds-that-part-behind-a-knot | 0 0 0 -1e16
a-place-in-a-stick             | 1 0 0 0
a-speed-in-a-stick             | 0 1 0 1
"""
ONE_ANSWER = scenes_in("one-answer")
"""Of what bounds the difference to a start beside theirs, off by so many units of 1e-20, one part is nearly all."""
STARTS_BESIDE = {name.strip(): off.split() for name, off in (row.split("|") for row in OFF.strip().splitlines())}
