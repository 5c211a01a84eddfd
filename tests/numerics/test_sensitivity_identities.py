"""What holds exactly of sensitivities: scaling groups, translations, the energy, neighbours that never part."""

from __future__ import annotations

import numpy as np
from finite_differences import ball
from flint import arb
from hypothesis import given
from strategies import scenes

from numerics.linear.modes import Mode
from numerics.solver.solve import solve
from numerics.trajectory.derivatives import WRT
from numerics.trajectory.sensitivity import sensitivities


@given(scenes(damped=None, periods=(1, 2)))
def test_identities(scene):
    """Euler's identity for the three scaling groups, translations of x2, and the energy of the final state."""
    trajectory = solve(scene, digits=20, arithmetic="ball")
    found, pair, at = sensitivities(trajectory), scene.pair, scene.initial
    with trajectory.arithmetic.context():
        weigh = Weights(pair, at)
        final, energy = trajectory.frame.si_state(trajectory.final), trajectory.frame.energy(trajectory.final)
        for t, y, event in zip(found.t, found.y, trajectory.events, strict=True):
            row = [t, *y]
            assert all(weigh(one, m1=1, m2=1, a2=1, b=1, a1=1).contains(0) for one in row)
            lengths = [weigh(one, x1=1, v1=1, x2=1, v2=1, b=1) for one in row]
            assert all(one.overlaps(value) for one, value in zip(lengths, (arb(0), *event.y), strict=True))
            times = [weigh(one, v1=-1, v2=-1, a2=-2, b=-2, a1=-1) for one in row]
            true = (event.t, arb(0), -event.y[1], arb(0), -event.y[3])
            assert all(one.overlaps(value) for one, value in zip(times, true, strict=True))
            assert [float(one[WRT.index("x2")]) for one in row] == [0, 0, 0, 1, 0]
        assert all(weigh(one, m1=1, m2=1, a2=1, b=1, a1=1).contains(0) for one in found.final)
        assert weigh(found.energy, m1=1, m2=1, a2=1, b=1, a1=1).overlaps(energy)
        lengths = [weigh(one, x1=1, v1=1, x2=1, v2=1, b=1) for one in found.final]
        assert all(one.overlaps(value) for one, value in zip(lengths, final, strict=True))
        assert weigh(found.energy, x1=1, v1=1, x2=1, v2=1, b=1).overlaps(2 * energy)
        assert all(
            one.overlaps(two) for one, two in zip(found.energy, energy_by_hand(scene, found, final), strict=True)
        )


class Weights:
    """Sums of derivatives, each times its quantity and a whole number."""

    def __init__(self, pair, at):
        self.values = [ball(getattr(at if name in {"x1", "v1", "x2", "v2"} else pair, name)) for name in WRT]

    def __call__(self, row, **weights):
        return sum((row[k] * self.values[k] * weights[name] for k, name in enumerate(WRT) if name in weights), arb(0))


def energy_by_hand(scene, found, final):
    """E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2 differentiated with the state's derivatives."""
    pair, (x1, v1, _, v2) = scene.pair, final
    explicit = {"a2": x1 * x1 / 2, "m1": v1 * v1 / 2, "m2": v2 * v2 / 2}
    moving = ball(pair.a2) * x1 * found.final[0] + found.final[1] * (ball(pair.m1) * v1)
    return moving + found.final[3] * (ball(pair.m2) * v2) + np.array([explicit.get(name, arb(0)) for name in WRT])


@given(scenes(damped=None, periods=(1, 4)))
def test_neighbours_never_move_apart(scene):
    """In the energy norm of (x1, v1, v2) the flow contracts: friction and viscosity are monotone."""
    trajectory = solve(scene, arithmetic="ball", digits=15)
    weights = np.sqrt([float(scene.pair.a2), float(scene.pair.m1), float(scene.pair.m2)])
    rows, columns = [0, 1, 3], [WRT.index(name) for name in ("x1", "v1", "v2")]
    final = sensitivities(trajectory).final
    jacobian = np.array([[float(final[i, j].mid()) for j in columns] for i in rows])
    assert np.linalg.norm(weights[:, None] * jacobian / weights, 2) <= 1 + 1e-9
    if trajectory.final_mode is Mode.STICK:
        assert all(abs(one - two) < 1e-9 * (1 + abs(one)) for one, two in zip(final[1], final[3], strict=True))
