"""Where a stronger sentence would be false: what is said there keeps its hypothesis, and a motion shows why it has it.

What a row, a clause or a theorem says is signed (`python -m paper_checks sign`); reasons and pages are not.
"""

import math
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
    PlanePair,
    PlaneScene,
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


HEAVY_DAMPER = Pair(m1=1, m2=1, a1=1000, a2=1, b=1)
LARGE_CIRCLE = {"x1": ["1.02", 0], "v1": [0, "1.02"], "v2": [0, "1.02"]}
MOTIONS = {
    "a short slip follows another slip": (Scene(ONES, State("2.02", -1, 0, -1), 1), (MINUS, STICK)),
    "a short slip starts no stick": (Scene(ONES, State(v1="1e-6"), 1), (PLUS, STICK)),
    "a circle that is 2 % too large slips twice": (
        PlaneScene(PlanePair(m1="0.05", m2="0.95", a2=1, b="0.95"), 10, **LARGE_CIRCLE),
        ("slip", "stick", "slip", "stick"),
    ),
    "body 2 at rest is met before a heavy damper settles": (Scene(HEAVY_DAMPER, State("2.1"), 2), (MINUS, STICK)),
    "the first slip under a heavy damper crosses": (Scene(HEAVY_DAMPER, State(v1=1), 1), (PLUS, MINUS, STICK)),
    "an oscillation grows until the bodies synchronise": (
        Scene(Pair(1, 1, 200, "0.5"), State(v2="-0.03"), 3),
        (PLUS, STICK),
    ),
    "a heavy body 1 merges by a slip from beside S": (load_scene("itinerary-that-merges"), (PLUS, STICK)),
    "body 2 follows a reference while the pair slips": (Scene(ONES, State(), 1, force=Force.step(0, 10)), (PLUS,)),
}


@pytest.mark.parametrize("what", MOTIONS)
def test_a_motion_of_which_a_stronger_sentence_would_be_false(what):
    scene, modes = MOTIONS[what]
    assert solve(scene).modes == modes


def test_no_level_of_the_energy_decides_under_a_friction_that_varies_in_time():
    """Omega = 1, L = b; b is 2 N near each half turn of the stuck pair, else 1 N: of one energy, one start sticks."""
    half_turns = [str(round(n * math.pi + side, 6)) for n in range(12) for side in (1.1, math.pi - 1.1)]
    friction = Friction(list(zip(half_turns, 12 * [1, 2], strict=True)))
    pair = Pair(m1=1, m2=1, a2=2, b=2)
    sticks, slips = (
        solve(Scene(pair, start, 37, friction=friction)) for start in (State("1.5"), State(v1="1.5", v2="1.5"))
    )
    assert sticks.energy[0] == slips.energy[0] == 2.25
    assert (sticks.modes, len(slips.modes) > 6) == ((STICK,), True)


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
