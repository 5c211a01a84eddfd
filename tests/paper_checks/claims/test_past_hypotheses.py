"""Where a stronger sentence would be false, what is said keeps its hypothesis; and two things that once were not so.

What a row, a clause or a theorem says is signed (`python -m paper_checks sign`); reasons and pages are not.
"""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from numerics import (
    Force,
    Friction,
    InvalidScene,
    Mode,
    Pair,
    Scene,
    State,
    fastest_transfer,
    load_reference,
    load_scene,
    solve,
    solve_many,
    solve_scenes,
    track,
)
from numerics.control.tracking import stuck_force

ROOT = Path(__file__).parents[3]
ONES = Pair(m1=1, m2=1, a2=1, b=1)
PLUS, MINUS, STICK = Mode.SLIP_PLUS, Mode.SLIP_MINUS, Mode.STICK


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ("paper_checks/claims/forced_modes.py", "without end in a bounded time"),  # u = 0: no last event in Fig. 5 (a)
        ("paper_checks/claims/merging_share.py", "For three mass ratios"),  # m1 > 0.7927 m2 merges from no energy
        ("paper_checks/claims/merging.py", "If body 2 is heavy enough"),  # the same
        ("paper_checks/claims/uniform_rate.py", "over all trajectories that never merge"),  # as in the kernel's theorem
        ("paper_checks/claims/near_critical.py", "over all with one $E(0)$ that never merge"),
        ("paper_checks/claims/steering.py", "without jumps, with bounded slopes, a start still has one motion"),
        ("paper_checks/claims/steering.py", "without a force friction that stays above"),  # what never stops slips on
        ("paper_checks/claims/steering.py", "without a damper a free oscillation may stay"),
        ("paper_checks/claims/tolerance.py", "The first slip may cross $S$"),
        ("paper_checks/explore/explore.html", "no slip that starts on S does"),
        ("paper_checks/explore/surface.html", "slips once or a few times"),
        ("paper_checks/explore/surface.html", "But for exceptions, exactly straight slips among them"),
        ("paper_checks/report/content/under_a_force.py", "A pair that sticks does it"),
        ("paper_checks/report/content/under_a_force.py", "With a damper, under a force whose second half"),
        ("notebooks/past_the_paper.py", "at $r^*$ it does from some energies"),
        ("notebooks/one_over_t_law.py", "m_1/m_2<0.7926"),
    ],
)
def test_what_is_said_keeps_what_it_once_left_out(place, words):
    assert words in " ".join(re.sub(r'"\s+f?"', "", (ROOT / place).read_text("utf-8")).split())


def test_read_literally_friction_gives_what_a_reference_asks():
    """sgn(0) = 0 with a stick that is never left: body 2 follows too-fast."""
    rest, reference = replace(load_scene("at-rest"), law="three-valued-sgn", until=2), load_reference("too-fast")
    force = Force([stuck_force(rest.pair, piece) for piece in reference])
    assert solve(replace(rest, force=force)).sol(2) == pytest.approx([0.1, 0, 0.1, 0], abs=1e-9)
    for asked in (lambda: track(rest, reference), lambda: fastest_transfer(rest, "0.01")):
        with pytest.raises(InvalidScene, match="law"):
            asked()


@pytest.mark.parametrize("later", [{"friction": Friction([(10, "0.1")])}, {"force": Force.step(10, 5)}])
def test_a_stick_is_not_for_ever_where_a_piece_after_the_horizon_breaks_it(later):
    scene = Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(x1="0.004"), until=20, **later)
    assert solve(scene, digits=20).events[0].t == 10
    for how in ({}, {"digits": 20}, {"arithmetic": "ball"}):
        assert solve(replace(scene, until=5), **how).message == "reached the horizon"
    assert solve_many(1, 1, 200, 0.5, x1=0.004, until=[5, 10], **later).status.tolist() == [0, 0]
    scenes = [replace(scene, until=5), Scene(scene.pair, scene.initial, until=5)]
    assert solve_scenes(scenes).status.tolist() == [0, 1]
