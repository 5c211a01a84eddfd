"""Where a creeping pair comes to rest: its limit, how far and how fast it still moves."""

from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import pytest
from flint import arb

from numerics import Pair, Scene, State
from numerics.arithmetic.ball import Ball
from numerics.free.engine import run_free
from numerics.free.resting_place import creeping_place
from numerics.linear.modes import MODES, event_kind

BALLS = Ball(40)


def solved(pair, until, speed):
    """A pair that leaves S0 by a ray with this speed, as far as a resting place looks at its trajectory."""
    scene = Scene(pair, State(x1=pair.half_width, v1=speed, v2=speed), until)
    record = run_free(scene, BALLS, 10_000)
    events = [
        SimpleNamespace(
            t=two.local, kind=event_kind(MODES[one.mode], MODES[two.mode]), after=MODES[two.mode], y=two[7:11]
        )
        for one, two in pairwise(record.rows)
    ]
    end = record.end[7:11]
    return SimpleNamespace(scene=scene, arithmetic=BALLS, record=record, events=events, final_state=end)


@pytest.mark.parametrize("share", [Fraction(1, 5), Fraction(1, 2), Fraction(9, 10)])
def test_a_creeping_pair_stays_within_what_is_said(share):
    """From the event on x1 - x2 is within `reach` of the limit, v1 - v2 within `speed`, and both bounds are of use."""
    with BALLS.context():
        pair = Pair(m1=share, m2=1 - share, a2=1, b=1 - share)  # L = Omega = 1
        run = solved(pair, 60, Fraction(float(share * Fraction(12, 1000)) ** 0.5))
        found = creeping_place(run, pair, 1.0, Fraction(0))
        assert found.index < 4
        later = [event.y for event in run.events[found.index :]]
        far = [abs(x1 - x2 - found.limit) for x1, _, x2, _ in later]
        assert all(one <= found.reach for one in far)
        assert max(float(one) for one in far) > float(found.reach) / 3
        # a slip is fastest where its guard is largest; by slips of a hundredth of the time
        start = run.events[found.index]
        slip = run.events[found.index + 1].t - start.t
        fastest = max(abs(one) for one in _relative_speeds(pair, start, slip))
        assert fastest <= float(found.speed)
        assert fastest > float(found.speed) / 8


def _relative_speeds(pair, event, slip):
    """v1 - v2 along the slip that an exit starts: q v1' = -(x1 + r s), v2' = s, in closed form."""
    q, s, (x1, v1, _, v2) = float(pair.share), event.after.sign, map(float, event.y)
    for part in range(1, 100):
        t = float(slip) * part / 100
        omega = q**-0.5
        offset = x1 + (1 - q) * s
        body_1 = v1 * float(arb(omega * t).cos()) - offset * omega * float(arb(omega * t).sin())
        yield body_1 - (v2 + s * t)
