"""Where a creeping pair comes to rest: its limit, how far and how fast it still moves."""

from fractions import Fraction

import pytest

from numerics import Pair, Scene, State
from numerics.arithmetic.ball import Ball
from numerics.free.abel import creeping_place
from numerics.trajectory.run import run_scene


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
def test_a_creeping_pair_stays_within_what_is_said(share):
    """From the event on x1 - x2 is within `reach` of the limit, v1 - v2 within `speed`, and both bounds are of use.

    The limit is the same, from whichever event it is read.
    """
    pair = Pair(m1=share, m2=1 - share, a2=1, b=1 - share)  # L = Omega = 1
    speed = Fraction(float(share * Fraction(12, 1000)) ** 0.5)
    run = run_scene(Scene(pair, State(x1=pair.half_width, v1=speed, v2=speed), 60), Ball(40))
    with run.arithmetic.context():
        found = creeping_place(run, pair, 1.0, Fraction(0))
        assert found.index < 4
        assert found.limit.overlaps(creeping_place(run, pair, 1.0, Fraction(40)).limit)
        far = [abs(one.y[0] - one.y[2] - found.limit) for one in list(run.events)[found.index :]]
        assert all(one <= found.reach for one in far)
        assert max(float(one) for one in far) > float(found.reach) / 3
    # a slip is fastest where its guard is largest; by slips of a hundredth of the time
    begin, end = (Fraction(float(run.events[found.index + n].t)) for n in (0, 1))
    states = (run.sol(begin + (end - begin) * Fraction(part, 100)) for part in range(1, 100))
    fastest = max(abs(float(v1 - v2)) for _, v1, _, v2 in states)
    assert float(found.speed) / 8 < fastest <= float(found.speed)
