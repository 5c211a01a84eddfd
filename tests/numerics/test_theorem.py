"""`solve --proof`: the bounds that it writes hold the events. The kernel judges them in paper_checks/proofs."""

import re
from fractions import Fraction

import pytest
from scene_files import scenes_in

from numerics import Force, solve
from numerics.trajectory.theorem import theorem

SCENES = scenes_in("proved")
SHORT = scenes_in("left-open")["friction-from-a-time-that-floats-do-not-hold"]
"""Its first spell is 0 s long in floats: there was no theorem of it, but a failure."""
BROKEN = SCENES["a-force-that-steps-and-a-stick-that-it-breaks"]
BORNE = BROKEN.replace(force=BROKEN.force + Force.step("0.25", "0.1"))
"""Before the step that breaks it, the stick bears another one."""


@pytest.mark.parametrize("scene", [*SCENES.values(), SHORT, BORNE])
def test_every_event_is_within_its_bounds(scene):
    trajectory = solve(scene, digits=30, arithmetic="ball")
    written = theorem(trajectory)
    table = re.findall(r"^  Event .*?\)\.?[;\]]", written, re.DOTALL | re.MULTILINE)
    assert len(table) == len(trajectory.events)
    with trajectory.arithmetic.context():
        for event, text in zip(trajectory.events, table, strict=True):
            bounds = re.findall(r"\((-?[0-9.e+-]+), (-?[0-9.e+-]+)\)", text)
            for value, (low, high) in zip((event.t, event.y[0], event.y[2], event.y[1]), bounds, strict=True):
                assert Fraction(low) <= Fraction(high)
                assert float(Fraction(low)) <= float(value) <= float(Fraction(high))


def test_the_command_writes_a_file(tmp_path, run):
    assert run("solve", "velocities", "--proof", tmp_path / "a.v")[0] == 0
    assert "Theorem trajectory x v1 x2 v2 : motion the_scene x v1 x2 v2" in (tmp_path / "a.v").read_text("utf-8")
