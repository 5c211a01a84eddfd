"""Where forward Euler misleads: counted against theory and judged like a peer."""

import pytest

from numerics import load_scene
from paper_checks.report.content.euler_lessons import outcomes, right_from, stick_energy


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_energy_in_stick_grows_as_theory_says(step):
    found, theory = stick_energy(step)
    assert found == pytest.approx(theory, rel=1e-9)
    assert found > 1.05


def test_a_figure_is_judged_against_balls_and_chatters_more_with_finer_steps():
    found = outcomes(load_scene("start-with-speed"), (1e-2, 1e-3, 1e-4))
    assert [one.digits >= 0 for one in found] == [False, True, True]
    assert (right_from(found), right_from(found, 9)) == ("0.001", "finer than tried")
    for some in ([one.digits for one in found], [one.chatter for one in found]):
        assert some == sorted(some)
