"""What a hostile reader made the software say wrongly, once."""

import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

from numerics.errors import InvalidScene
from numerics.scene import Pair, Scene, State
from numerics.solver.many import solve_many
from numerics.solver.solve import solve

AT_AN_EVENT = Fraction(2.10700551516822)


def test_an_event_in_the_same_place_as_the_horizon():
    scene = Scene(Pair("1e-4", 10, 1, 5, 2), State(x1=-150, v1=-288, v2=29), until=AT_AN_EVENT)
    assert solve(scene).arithmetic.name != "float64"
    assert solve(scene, digits=5).arithmetic.name != "float64"
    code = (
        "from numerics.solver.many import solve_many\n"
        "found = solve_many(1e-4, 10, 1, 5, a1=2, x1=-150, v1=-288, v2=29, until=2.10700551516822)\n"
        "print(int(found.status), float(found.dissipated).hex(), float(found.dissipated_error).hex())"
    )
    plain = subprocess.run(
        [sys.executable, "-c", "import os; os.environ['NUMBA_DISABLE_JIT'] = '1'\n" + code],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    found = solve_many(1e-4, 10, 1, 5, a1=2, x1=-150, v1=-288, v2=29, until=2.10700551516822)
    assert plain.split() == [
        str(int(found.status)),
        float(found.dissipated).hex(),
        float(found.dissipated_error).hex(),
    ]
    assert np.isfinite(found.dissipated_error) or not found.certain


def test_energies_below_the_normal_numbers_have_no_digits_to_claim():
    scene = Scene(Pair(1, 1, 1, "1e-160"), State(v1="3e-160"), until=4)
    found, truth = solve(scene), solve(scene, digits=30, arithmetic="ball")
    with truth.arithmetic.context():
        energy = float(truth.frame.energy(truth.final).mid())
    assert abs(found.frame.energy(found.final) - energy) <= found.accuracy.energy
    assert found.accuracy.energy > 0
    assert found.accuracy.dissipated > 0
    assert solve(scene, digits=8).arithmetic.name != "float64"
    assert solve_many(1, 1, 1, 1e-158, v1=3e-158, until=4).dissipated_error > 0


def test_nothing_at_rest_is_known_exactly():
    assert solve(Scene(Pair(1, 1, 1, 1), State(), until=3), digits=15).arithmetic.name == "float64"


@pytest.mark.parametrize("given", [{"digits": 2.5}, {"digits": True}, {"digits": "5"}, {"max_events": 1.5}])
def test_counts_are_whole_numbers(given):
    with pytest.raises(ValueError, match="must be a whole number"):
        solve(Scene(Pair(1, 1, 1, 1), State(v1=1), until=3), **given)


def test_numbers_of_a_batch_that_are_masked_or_countless():
    with pytest.raises(InvalidScene, match="masked"):
        solve_many(1, 1, 200, 0.5, v1=np.ma.masked_array([0.1, 0.2], [True, False]), until=5)
    with pytest.raises(ValueError, match="at most 2"):
        solve_many(1, 1, 200, 0.5, until=5, max_events=10**20)
