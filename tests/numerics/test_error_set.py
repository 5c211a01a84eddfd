"""Sets of errors E c + r, |c| <= 1, |r| <= R, held against their members."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from numerics.linear.error_set import box, norm_of, take_in, width


@given(st.integers(0, 2**32 - 1))
def test_bounds_hold_for_the_members_of_a_set_and_are_reached(seed):
    random = np.random.default_rng(seed)
    E, R = random.normal(size=(4, 4)) * 10 ** random.uniform(-3, 0, 4), random.uniform(0, 1, 2)
    rests = random.normal(size=(20, 4)) * [1, 1, 0, 1]
    w = rests[0].copy()
    rests *= R[0] / np.linalg.norm(rests, axis=1)[:, None]
    rests[:, 2] = R[1]
    members = random.choice([-1.0, 1.0], (20, 4)) @ E.T + rests
    assert (abs(members) <= [box(E, R, i) for i in range(4)]).all()
    assert (np.linalg.norm(members[:, [0, 1, 3]], axis=1) <= norm_of(E, R)).all()
    widest = width(E, R, w[0], w[1], w[3])
    assert (abs(members @ w) <= widest).all()
    assert abs(w @ E).sum() + np.linalg.norm(w) * R[0] > (1 - 1e-6) * widest
    take_in(E, R, np.zeros((4, 4)), np.zeros(4))
    assert not R.any()
    assert (abs(np.linalg.solve(E, members.T)) <= 1 + 1e-9).all()
