"""Sensitivities as the command line tells them: digits that are right, an archive, a table, refusals."""

from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from flint import arb
from three_scenes import PAPER

from numerics import sensitivities, solve
from numerics.arithmetic.ball import Ball
from numerics.scene.model import WRT


@pytest.mark.parametrize("arithmetic", ["ball", "mpmath", "float64"])
def test_json_carries_them(arithmetic, scene_file, record):
    found = record("solve", scene_file, "--sensitivity", "--arithmetic", arithmetic)
    truth = sensitivities(solve(replace(PAPER, until=2), digits=60, arithmetic="ball"))
    for event, t, y in zip(found["events"], truth.t, truth.y, strict=True):
        assert set(event["sensitivity"]) == {"t", "x1", "v1", "x2", "v2"}
        for row, true in zip(event["sensitivity"].values(), (t, *y), strict=True):
            check_row(row, true, arithmetic)
    for row, true in zip(found["final"]["sensitivity"].values(), (*truth.final, truth.energy), strict=True):
        check_row(row, true, arithmetic)


def check_row(row, true, arithmetic):
    with Ball(70).context():
        for name, value in zip(WRT, true, strict=True):
            exact, exponent = row[name] in {"0", "1"}, Decimal(row[name]).as_tuple().exponent
            place = row[f"{name}_radius"] if arithmetic == "ball" else "0" if exact else f"1e{exponent}"
            assert arb(row[name], arb(place)).overlaps(value), (name, row[name])
            assert arb(place) <= arb("1e-10") * (1 + abs(value))


def test_the_archive_and_the_table_carry_them(scene_file, tmp_path, output):
    path = tmp_path / "out.npz"
    output("solve", scene_file, "--npz", path, "--sensitivity", "--digits", 20)
    found = sensitivities(solve(replace(PAPER, until=2)))
    with np.load(path) as archive:
        assert tuple(archive["sensitivity_wrt"]) == WRT
        for name in ("t", "y", "final", "energy"):
            assert np.allclose(archive[f"sensitivity_{name}"], getattr(found, name), rtol=1e-9, atol=1e-12)
    lines = output("solve", scene_file, "--sensitivity").splitlines()
    last = next(line for line in lines if line.startswith("by b ")).split()
    assert float(last[2]) == pytest.approx(found.t[-1, WRT.index("b")], rel=1e-5)
