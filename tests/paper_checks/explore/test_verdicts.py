"""What the page says of a motion, on both sides of each threshold, in headless Chromium; and its rule at a tie."""

from dataclasses import replace
from math import pi

import pytest
from chromium import faults, planted

from numerics import Force, Pair, Scene, State, solve
from paper_checks.explore.page import SOLVER, source
from paper_checks.explore.scenes import ReducedScene

LEVEL = (pi / 2 - 1) ** 2 / 3
"""Excess energy up to which the pair with m1/m2 = 1/2 never merges."""


def at_centre(ratio: float, excess: float) -> ReducedScene:
    """Sticking at X = 0 with so much above E_cr, for a while in which nothing happens."""
    speed = (1 + excess) ** 0.5
    return ReducedScene(ratio=ratio, V1=speed, V2=speed, until=0.5)


SINE = ReducedScene(zeta=0.1, omega=0.7, until=400)
STUCK = 2 * ((1 - 0.7**2) ** 2 + (0.2 * 0.7) ** 2) ** 0.5 / 0.7**2
"""Amplitude up to which that pair is entrained."""
SETTLING = [replace(SINE, amplitude=1.0, V1=0.4, V2=0.4, until=float(until)) for until in range(110, 175, 8)]
EXPECTED = {
    at_centre(0.5, 0.999 * LEVEL): "Creeps",
    at_centre(0.5, 1.001 * LEVEL): "Not merged yet",
    at_centre(0.7926, 0.5): "Not merged yet",
    at_centre(0.79264, 0.5): "Creeps",
    at_centre(0.5, -0.001): "Sticks permanently",
    ReducedScene(constant=1.8, V1=0.8, V2=0.8, until=0.1): "Creeps",  # E/E_cr = 1.45 about the moved centre
    ReducedScene(constant=4, X=2.5, until=3): "Sticks permanently",
    replace(SINE, amplitude=0.99 * STUCK): "Entrained",
    replace(SINE, amplitude=1.002 * STUCK): "Stick and slip",
    replace(SINE, amplitude=10.0): "Slips all the time",
    replace(SINE, amplitude=1.0, until=17.9): "Driven",  # just shorter than two periods, 17.952
    ReducedScene(
        zeta=0.3, X=-0.452, V1=-0.88, V2=-0.88, until=0.05
    ): "Not settled yet",  # 0.979 E_cr; it slips at 0.0815
    ReducedScene(
        zeta=0.05, amplitude=0.3, omega=1.0, until=20
    ): "Stuck so far",  # at 1.5 U*, where none sticks for ever
}
FORCE = Force.sine("0.5", "0.7")
"""The same for the pair with b = 1/2."""
FAULTS = faults("verdicts")
TIE = {"pair": {"q": 0.5, "r": 0.5, "zeta": 0}, "t": pi / 2, "V": 0}
TIES = [  # p' = 0 at the edge: p'' = f'' - p decides
    (TIE | {"force": {"constant": 0, "amplitude": -bend, "omega": 1}, "p": 1}, 1 if bend > 1 else 0)
    for bend in (-0.5, 0.5, 0.999, 1.001, 2)
]


@pytest.fixture(scope="module")
def answers(ask) -> dict:
    program = source((*SOLVER, "regimes"))
    scenes = [vars(one) for one in (*EXPECTED, *SETTLING)]
    ties = [one for one, _ in TIES]
    return ask("verdicts", PROGRAM=program, FAULTY=planted(program, FAULTS), SCENES=scenes, TIES=ties)


@pytest.fixture(scope="module")
def settled() -> list[bool]:
    """Whether the state of each settling scene repeats itself over its last period, by the project's integrator."""
    pair, period, found = Pair("0.5", "0.5", 1, "0.5", "0.2"), 2 * pi / SINE.omega, []
    for one in SETTLING:
        run = solve(Scene(pair, State(one.X, one.V1, 0, one.V2), one.until, force=FORCE))
        change = run.sol(one.until) - run.sol(one.until - period)
        found.append(max(abs(change[[0, 1, 3]])) < 1e-6)
    return found


def told(found: dict) -> tuple[list[str], list[bool], list[int]]:
    """The titles of the first scenes, whether the others are said to agree with themselves, and the modes at ties."""
    said = found["said"]
    agree = ["agree" in one["text"] for one in said[len(EXPECTED) :]]
    return [one["title"] for one in said[: len(EXPECTED)]], agree, found["ties"]


def test_each_verdict_turns_at_its_threshold(answers, settled):
    found = answers["right"]
    assert told(found) == ([*EXPECTED.values()], settled, [mode for _, mode in TIES])
    assert "E/E_cr = 0.25 " in found["said"][6]["text"]
    assert 0.9 < found["shares"][8] < 1


@pytest.mark.parametrize("number", range(len(FAULTS)), ids=[wrong for _, wrong in FAULTS])
def test_a_fault_in_what_is_said_is_seen(answers, number):
    assert told(answers["faulty"][number]) != told(answers["right"])
