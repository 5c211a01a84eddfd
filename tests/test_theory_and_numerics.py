"""What theory states and what numerics does, where both speak: contact, landing, return map, damping, first mode."""

from fractions import Fraction

import pytest
from theory_values import exact, of_pair

from numerics import Mode, Pair, Scene, State, solve
from theory.filippov import transversality
from theory.return_map import contact_condition, landing

# L = Omega = M = 1 and a root that is rational: sqrt(q) = 1/2.
QUARTER = Pair(m1="0.25", m2="0.75", a2=1, b="0.75")


@pytest.mark.parametrize("start", [(0, 1), (0, 4), ("1/2", "1/3"), (3, -1), ("1/100", 2), (8, 0)])
def test_a_slip_from_the_surface_ends_where_the_contact_equation_says(start):
    d, u = (Fraction(one) for one in start)
    scene = Scene(QUARTER, State(x1=1 + d / 4, v1=u / 2, v2=u / 2), until=50)
    run = solve(scene, digits=25, arithmetic="ball", max_events=3)
    assert run.modes[0] is Mode.SLIP_MINUS
    event = run.events[0]
    with run.arithmetic.context():
        letters, ends = {"d": d, "nu": u, "theta": 2 * event.t}, landing()
        assert of_pair(contact_condition(), QUARTER, **letters).contains(0)
        place, speed, lost = (of_pair(one, QUARTER, **letters) for one in (ends.gap, ends.push, ends.excess_change))
        assert (1 + place / 4).overlaps(event.reduced.X)
        assert (speed / 2).overlaps(event.reduced.V1)
        assert (exact(2 * d / 4 + d * d / 16 + u * u / 4) + lost).overlaps(event.reduced.w)


@pytest.mark.parametrize("place", ["-2", "-1.0001", "-0.9999", "0", "0.9999", "1.0001", "3"])
def test_the_first_mode_is_that_of_the_signs_of_both_products(place):
    up, down = (of_pair(transversality(sign), QUARTER, x1=Fraction(place)) > 0 for sign in (1, -1))
    expected = {(False, False): Mode.SLIP_MINUS, (True, True): Mode.SLIP_PLUS, (False, True): Mode.STICK}[up, down]
    run = solve(Scene(QUARTER, State(x1=place, v1="0.1", v2="0.1"), until=1))
    assert run.modes[0] is expected
