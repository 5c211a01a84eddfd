"""Every number of a run is within its bound, in every arithmetic and in a batch: against balls of 60 digits."""

from fractions import Fraction

import numpy as np
import pytest
from every_number import DIGITS, EVENTS, held, held_in_a_batch, unlisted
from hypothesis import given
from reaching import LeftOut, reaching
from strategies import ties

from numerics import NumericsError, solve
from numerics.arithmetic.ball import Ball
from numerics.trajectory.run import run_scene


def wrong(scene, arithmetic):
    """The numbers of a run, and of a batch, that are not within their bounds. Raises LeftOut where nothing is sure."""
    try:
        run = solve(scene, arithmetic=arithmetic, max_events=EVENTS)
    except NumericsError:
        raise LeftOut from None
    if not run.certain:
        raise LeftOut
    truth = run_scene(scene, Ball(DIGITS), EVENTS)
    assert (run.modes, run.event_kinds) == (truth.modes, truth.event_kinds)
    shares, end = (Fraction(k, 7) for k in range(8)), Fraction(min(float(one.floats(one.end_time)) for one in (run, truth)))
    events = [Fraction(t) for t in run.floats(run.event_times)[:19].tolist()]
    times = [t for t in sorted([*(one * end for one in shares), *events]) if t <= min(end, scene.until)]
    with truth.context(), np.errstate(all="ignore"):
        rows = held(run, truth, times) + (held_in_a_batch(scene, truth) if arithmetic == "float64" else [])
        return [one for one in rows if not one.ratio <= 1.0]


def test_no_number_goes_without_its_comparison():
    assert unlisted() == set()


@pytest.mark.parametrize("arithmetic", ["float64", "double-double", "ball"])
def test_every_number_of_a_tie_is_within_its_bound(arithmetic):
    @reaching
    @given(ties())
    def hold(scene):
        assert wrong(scene, arithmetic) == []

    hold()
