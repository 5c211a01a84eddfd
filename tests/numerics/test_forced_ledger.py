"""Where the energy goes under a force: integrals with honest remainders, ledgers to the digits asked, batches."""

from pathlib import Path

import numpy as np
import pytest
from flint import arb
from hypothesis import given, settings
from reaching import LeftOut, reaching
from strategies import driven_scenes

from numerics import Force, Pair, Scene, State, solve, solve_scenes
from numerics.errors import NumericsError
from numerics.scene.file import load_scene
from numerics.trajectory import forced_segment

SCENES = Path(__file__).parents[1] / "forced" / "scenes"
NAMES = (
    *("damping-heavy", "near-resonance-in-slip", "polynomial-of-degree-8", "sine-stick-slip", "soft-spring"),
    *("friction-by-pieces", "resonance-in-slip-damped", "strong-friction"),
)


def named(name):
    return load_scene(SCENES / f"{name}.toml")


@pytest.mark.parametrize("digits", [20, 50])
@pytest.mark.parametrize("name", NAMES)
def test_a_ledger_has_the_digits_asked(name, digits):
    ledger = solve(named(name), arithmetic="ball", digits=digits).ledger
    size = abs(ledger.work) + ledger.final + ledger.initial
    assert ledger.residual.contains(0)
    assert ledger.residual.rad() < arb(10) ** -digits * size


@reaching
@given(driven_scenes())
@settings(max_examples=10)
def test_ledgers_close(scene):
    try:
        ledger = solve(scene, arithmetic="ball", digits=20, max_events=60).ledger
    except NumericsError:
        raise LeftOut from None
    assert ledger.residual.contains(0)
    sizes = abs(ledger.work) + ledger.final + ledger.friction + ledger.viscous + float(scene.pair.critical_energy)
    assert ledger.residual.rad() < arb("1e-18") * sizes
    assert not ledger.viscous < 0
    assert not ledger.friction < 0


@pytest.mark.parametrize("name", ["damping-heavy", "sine-stick-slip", "polynomial-of-degree-8"])
def test_the_remainder_is_bounded(name, monkeypatch):
    """With too few nodes the bound says so; without the bound the ledger would not close."""
    scene = named(name)
    monkeypatch.setattr(forced_segment, "_gauss", forced_segment._gauss.__wrapped__)
    monkeypatch.setattr(forced_segment, "_count", lambda bits: 4)
    ledger = solve(scene, arithmetic="ball", digits=20).ledger
    assert ledger.residual.contains(0)
    assert ledger.residual.rad() > arb("1e-15") * abs(ledger.work)
    monkeypatch.setattr(forced_segment, "_remainder", lambda n: arb(0))
    assert not solve(scene, arithmetic="ball", digits=20).ledger.residual.contains(0)


def test_the_other_arithmetics_agree():
    scene = named("damping-heavy")
    balls = solve(scene, arithmetic="ball", digits=25).ledger
    for arithmetic, digits in (("mpmath", 1e-15), ("float64", 1e-12)):
        ledger = solve(scene, arithmetic=arithmetic).ledger
        for name in ("work", "viscous", "friction"):
            assert float(getattr(ledger, name)) == pytest.approx(float(getattr(balls, name).mid()), rel=digits)


def test_batches_say_what_was_dissipated_and_how_well():
    scenes = [named(name) for name in (*NAMES, "step-within-adhesion")]
    found = solve_scenes(scenes)
    for scene, value, off in zip(scenes, found.dissipated, found.dissipated_error, strict=True):
        ledger = solve(scene, arithmetic="ball", digits=25).ledger
        true = float((ledger.friction + ledger.viscous).mid())
        assert abs(value - true) <= off
        assert off < 1e-9 * (abs(float(ledger.work.mid())) + true)


def test_what_is_too_stiff_to_integrate_is_not_a_number_in_a_batch():
    stiff = Scene(Pair(1, 1, 1, 1), State("0.1"), 1000, force=Force.sine("0.1", 10**8))
    free = Scene(Pair(1, 1, 1, 1), State("0.1"), 1, force=Force.step("0.5", "0.1"))
    found = solve_scenes([stiff, free])
    assert np.isnan(found.dissipated[0])
    assert found.success.tolist() == [True, True]
    assert found.dissipated[1] == 0
