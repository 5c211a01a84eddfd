"""Where forward Euler misleads: counted against theory and judged like a peer."""

import pytest

from numerics import load_scene
from numerics.trade.euler import euler_figure, stick_energy


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_energy_in_stick_grows_as_theory_says(step):
    found, theory = stick_energy(step)
    assert found == pytest.approx(theory, rel=1e-9)
    assert found > 1.05


def test_a_figure_is_judged_against_balls_and_chatters_more_with_finer_steps():
    found = euler_figure(load_scene("start-with-speed"), (1e-2, 1e-3, 1e-4))
    assert found.events == 32
    assert [one.right for one in found.outcomes] == [False, True, True]
    assert found.right_from() == 1e-3
    for some in ([one.digits for one in found.outcomes], [one.chatter for one in found.outcomes]):
        assert some == sorted(some)
