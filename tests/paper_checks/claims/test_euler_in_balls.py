"""The paper's forward Euler in balls: what would turn its claim, and that it is the program."""

from dataclasses import replace
from fractions import Fraction

import pytest

from numerics import Pair, Scene, State, load_scene
from numerics.trade.forward_euler import forward_euler
from paper_checks.claims.section_4 import euler
from paper_checks.decide import euler_in_balls as decide_euler
from paper_checks.decide.euler_in_balls import euler_in_balls, run
from paper_checks.evidence.finding import Verdict


def test_a_run_that_meets_the_surface_turns_the_euler_claim(monkeypatch):
    """From v1 = 2 one step of 1 s takes exactly 2 from z': it lands on z' = 0."""
    scene = Scene(Pair(m1=1, m2=1, a2=1, b=1), State(v1=2), until=3)
    landed = euler_in_balls(scene, Fraction(1), Fraction(3))
    assert landed.contact == 1
    monkeypatch.setattr(euler, "run", lambda name, h: replace(run(name, h), contact=landed.contact))
    assert euler.euler_reproduces_figures.decide().verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("step", [Fraction(1, 1000), Fraction(1, 100)])  # with the second a flip leaves the strip
def test_euler_in_balls_is_the_program_without_rounding(step):
    scene = load_scene("start-with-speed")
    program, method = forward_euler(scene, float(step)), euler_in_balls(scene, step, Fraction(5))
    assert method.chatter == program.chatter
    assert float(method.energy_ratio.mid()) == pytest.approx(program.energy[-1] / program.energy[0], rel=1e-9)


@pytest.mark.parametrize("name", ["velocities", "relative-motion-b02"])
def test_many_steps_at_once_are_as_many_steps(name, monkeypatch):
    """The run that tries each step by itself has the same signs, and its energy in the same ball."""
    scene, step, until = load_scene(name), Fraction(1, 1000), Fraction(2)
    jumped = euler_in_balls(scene, step, until)
    monkeypatch.setattr(decide_euler, "SINGLE", jumped.steps + 1)
    single = euler_in_balls(scene, step, until)
    assert (jumped.contact, jumped.chatter, jumped.adhesion) == (single.contact, single.chatter, single.adhesion)
    assert jumped.energy_ratio.overlaps(single.energy_ratio)
    assert jumped.energy_ratio.rad() < single.energy_ratio.rad()  # it has rounded less often
