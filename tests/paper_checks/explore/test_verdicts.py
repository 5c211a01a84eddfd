"""What the page says of a motion, on both sides of each threshold, in headless Chromium; and its rule at a tie."""

import tomllib
from dataclasses import replace
from math import pi
from pathlib import Path

import pytest
from chromium import faults, planted

from numerics import Force, Pair, Scene, State, solve
from paper_checks.explore.page import SOLVER, source
from paper_checks.explore.scenes import ReducedScene

SINE = ReducedScene(zeta=0.1, omega=0.7, until=400)
SETTLING = [replace(SINE, amplitude=1.0, V1=0.4, V2=0.4, until=float(until)) for until in range(110, 175, 8)]
VERDICTS = tomllib.loads(Path(__file__).with_name("verdicts.toml").read_text("utf-8"))["verdicts"]
EXPECTED = {ReducedScene(**one["scene"]): one["said"] for one in VERDICTS}
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
