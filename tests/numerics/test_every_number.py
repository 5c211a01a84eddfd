"""Every number of a run is within its bound, in every arithmetic and in a batch: against balls of 60 digits or more."""

from contextlib import suppress
from fractions import Fraction
from pathlib import Path

import pytest
from every_number import against, compared, solved_truly, unlisted
from hypothesis import given
from reaching import LeftOut, reaching
from scene_files import scenes_in
from sixty_digits import forced_scene
from strategies import driven_scenes, extreme_scenes, fewer, free_scenes, ties, viscous_scenes, weakened_scenes

from numerics import Pair, Scene, State, load_scene, solve

KINDS = {
    "ties": ties(),
    "free": free_scenes(),
    "viscous": viscous_scenes(),
    "driven": driven_scenes(),
    "friction of the state": weakened_scenes(),
}
EXTREME = {f"extreme {name}": one for name, one in extreme_scenes.items() if name not in {"ellipsoid", "box"}}
WAYS = ["float64", "ball"]
TESTS = Path(__file__).parent.parent
ELSEWHERE = [
    "at-once",
    "belts",
    "cycles",
    "derivatives",
    "far-out",
    "from-the-start",
    "in-doubt",
    "left-open",
    "long-sticks",
    "one-answer",
    "rest-to-rest",
    "signals",
    "slides-to-a-stop",
    "surfaces",
]
"""Scenes of all signals, what floats leave open or can do little with, and surfaces have tests of their own."""
FOLDERS = [
    f"scenes/{one.name}" for one in sorted((TESTS / "scenes").iterdir()) if one.is_dir() and one.name not in ELSEWHERE
]
RESTARTED = """contact-to-third-order friction-drops-at-contact jump-at-contact-reverses jump-at-contact-slips-on
jump-at-contact-sticks jump-just-after-contact tie-at-a-jump-at-contact-slips-on tie-at-a-jump-at-contact-sticks
tie-on-the-lower-edge touch-in-slip"""
"""Of these `dissipated` was once what was lost after an exact tie alone, and was said to be certain."""
FOUND = scenes_in("bounded") | {name: forced_scene(name) for name in RESTARTED.split()}
FOUND["relative-motion-b05"] = load_scene("relative-motion-b05")


def wrong(scene, arithmetic):
    """The numbers of a run that are not within their bounds."""
    return [one for one in compared(scene, arithmetic)[1] if not one.ratio <= 1.0]


def test_no_number_goes_without_its_comparison():
    assert unlisted() == set()


@pytest.mark.parametrize("arithmetic", WAYS)
@pytest.mark.parametrize("kind", [*KINDS, *(pytest.param(one, marks=pytest.mark.long) for one in EXTREME)])
def test_every_number_is_within_its_bound(kind, arithmetic):
    @reaching
    @fewer(2 if kind in KINDS else 1)
    @given((KINDS | EXTREME)[kind])
    def hold(scene):
        assert wrong(scene, arithmetic) == []

    hold()


@pytest.mark.parametrize("arithmetic", WAYS)
@pytest.mark.parametrize("name", FOUND)
def test_every_number_of_what_was_once_wrong_is_within_its_bound(name, arithmetic):
    with suppress(LeftOut):
        assert wrong(FOUND[name], arithmetic) == []


@pytest.mark.long
@pytest.mark.parametrize("arithmetic", WAYS)
@pytest.mark.parametrize("folder", ["forced/scenes", "extremes/scenes", *FOLDERS])
def test_every_number_of_every_frozen_scene_is_within_its_bound(folder, arithmetic):
    found, names = {}, sorted((TESTS / folder).glob("*.toml"))
    for name in names:
        with suppress(LeftOut):
            found[name.stem] = wrong(load_scene(name), arithmetic)
    assert found
    assert {name: rows for name, rows in found.items() if rows} == {}


@pytest.mark.parametrize("name", ["a-force-of-degree-30", "a-short-time"])
def test_high_powers_of_time_cost_no_digits_between_events(name):
    """Balls had no digit: k! stands in the derivatives of a force, and 10^60 in its coefficients."""
    run = solve(scenes_in("far-out")[name], arithmetic="ball", max_events=40)
    with run.context():
        for one in (run.ledger.work, run.ledger.friction, *run.sol(2 * run.scene.until / 3)):
            assert one.rad() < 1e-12 * abs(one.mid())


def test_an_error_that_the_bounds_do_not_know_of_is_noticed():
    scene = Scene(Pair(2, 1, 3, 1, a1=1), State("-0.3", "1.1", 0, -3), until=20)
    moved = scene.replace(v1=scene.initial.v1 * (1 + Fraction(1, 10**11)))
    run, truth = solve(scene, arithmetic="float64"), solved_truly(moved)
    with truth.context():
        beyond = {one.name for one in against(run, truth) if one.ratio > 1.0}
    assert beyond >= {"t", "y", "energy", "final", "event_states", "dissipated", "sol", "reduced", "printed x1"}
