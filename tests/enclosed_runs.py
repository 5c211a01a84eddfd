"""Runs of the engine in balls, and scenes in which one part of a bound is nearly all of it."""

from dataclasses import replace

from flint import arb
from overlapping import overlap

from numerics import Force, Friction, Pair, Piece, Scene, State, Weakening
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


BELT, EVEN, STICKY = Pair(10_000, 1, 100, "0.5"), Pair(2, 2, "1e-9", "0.5"), Pair(2, 1, 12, 1, 100)
"""Body 1 stays where it is, and x2 is off by what x1 - x2 is; only v1 - v2 counts; a motion that dies away."""


def under(pair, until, start, weakening, *u):
    return Scene(pair, State(*start), until, force=Force([Piece(0, u)]), friction=Friction((), weakening))


RISES, VANISHES = Weakening((), 0, [("0.1", 0), ("10.1", 1000)]), Weakening((), 0, [(-1, 1), (1, -1)])
PARTS = Weakening([("0.3", "0.2")], -1)
ONE_ANSWER = {
    "a slower body 2, at the event": (Scene(BELT, State(v2=-1), 3), (0, 0, 0, 1)),
    "a slower body 2, in its slip": (Scene(BELT, State(v2=-1), "1.9"), (0, 0, 0, 1)),
    "a place in a steep cell": (under(EVEN, "0.1", ("0.2", 20), RISES), (1, 0, -1, 0)),
    "a place before a steep cell": (under(EVEN, "0.1", ("0.09", 20), RISES), (0, 0, 1, 0)),
    "a place behind a steep cell": (under(BELT, "0.04", ("10.08", 1), RISES, 10_000), (0, 0, 1, 0)),
    "speeds that part": (under(EVEN, "1.6", (0, "0.1"), PARTS, 1), (0, 1, 0, -1)),
    "speeds that part behind a knot": (
        under(replace(BELT, a2="1e-9"), "0.42", (0, "0.1"), Weakening([("0.3", "0.5")], -5), 10_000),
        (0, 0, 0, -(10**16)),
    ),
    "a place in a stick": (Scene(STICKY, State("0.01"), 30), (1, 0, 0, 0)),
    "a speed in a stick": (Scene(replace(STICKY, a1=1), State("0.01"), 8), (0, 1, 0, 1)),
}
"""Scenes and a start beside theirs, in units of 1e-20: of what bounds the difference one part is nearly all."""
