"""Where a stronger sentence would be false: friction read literally, and a stick that a later piece breaks."""

from dataclasses import replace

import pytest

from numerics import (
    Force,
    Friction,
    InvalidScene,
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


def test_read_literally_friction_gives_what_a_reference_asks():
    """sgn(0) = 0 with a stick that is never left: body 2 follows too-fast."""
    rest, reference = replace(load_scene("at-rest"), law="three-valued-sgn", until=2), load_reference("too-fast")
    force = stuck_force(rest.pair, Force(reference))
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
