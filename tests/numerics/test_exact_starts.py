"""Starts at which a sign is exactly zero through square roots: decided on rationals or by a horizon, never refused.

Found by a reader who attacked the solver: balls cannot see such a zero, and nothing of the motion is at a tie.
"""

from __future__ import annotations

from decimal import localcontext
from fractions import Fraction

import pytest
from flint import arb, fmpq

from numerics.__main__ import main
from numerics.arithmetic.ball import Ball
from numerics.errors import EventUndecided
from numerics.free.abel import AbelFunctions
from numerics.free.root import falling_root
from numerics.scene import Pair, Scene, State
from numerics.solver.solve import solve
from numerics.trajectory.comparison import require_same_sequence
from numerics.trajectory.rendering import _upwards as upwards
from numerics.trajectory.rendering import right_digits_text

STARTS = {
    "guard without extrema, A = 1": (Pair(1, 1, 100, 1), State(x1="-0.01", v1="0.1")),
    "the same elsewhere": (Pair(1, 1, 100, 1), State(x1="-0.004", v1="0.08")),
    "the same, body 2 moving": (Pair(1, 1, 100, 1), State(x1="-0.002", v1="0.06", v2=-1)),
    "slip on the critical eigenline": (Pair(1, 1, 1, 1, 2), State(x1="-1.5", v1="0.5")),
    "stick on the critical eigenline": (Pair("0.5", "0.5", 1, 1, 2), State(x1="1.9", v1="-1.9", v2="-1.9")),
    "stick on the fast eigenvector": (Pair("0.5", "0.5", 2, 2, 3), State(x1="0.9", v1="-1.8", v2="-1.8")),
}


@pytest.mark.parametrize("name", STARTS)
def test_a_zero_through_square_roots_is_no_tie(name):
    pair, state = STARTS[name]
    balls = solve(Scene(pair, state, until=5), digits=30, arithmetic="ball")
    require_same_sequence(solve(Scene(pair, state, until=5)), balls)
    nudged = State(state.x1, state.v1, state.x2, state.v2 + pair.half_width / 10**30) if state.v1 != state.v2 else state
    require_same_sequence(solve(Scene(pair, nudged, until=5)), balls)


def test_friction_work_near_the_critical_orbit_counts_every_slip():
    """Slips of 1e-17 s next to t = 1 s must not round away: the work of ten is ten times that of the first, nearly."""
    scene = Scene(Pair(1, 1, 200, "0.5"), State(x1="0.005", v1="1e-18", v2="1e-18"), until=10)
    balls = solve(scene, digits=30, arithmetic="ball")
    assert solve(scene).ledger.friction == pytest.approx(float(balls.ledger.friction.mid()), rel=1e-10)


def test_the_inverse_contains_its_proved_bracket():
    abel = AbelFunctions(Fraction(1, 2))
    with Ball(36).context():
        y = arb(fmpq(1, 1000))
        for steps in (1, 17, 10**6):
            value = abel.alpha(y) + steps
            found = abel.alpha_inverse(value, y)
            assert abel.alpha(found.lower()) > value
            assert abel.alpha(found.upper()) < value


def test_printed_radii_never_shrink():
    with Ball(60).context(), localcontext() as context:
        context.prec = 5  # the caller's context must not matter
        assert float(upwards(arb(1) + arb(2) ** -95)) > 1


def test_printed_digits_are_right_to_one_unit():
    with Ball(40).context():
        assert right_digits_text(Fraction(0), arb("3e-18"), 17) == "0E-17"
        assert right_digits_text(Fraction(55, 100), arb("6e-4"), 17) == "0.55"


def test_a_capped_run_says_so_in_its_exit_code(capsys):
    assert main(["solve", "velocities", "--max-events", "3", "--json"]) == 1
    captured = capsys.readouterr()
    assert "event-limit" in captured.out
    assert "the cap on events" in captured.err


def test_a_root_whose_newton_step_leaves_its_region_is_not_proved_to_exist():
    """The step overlaps the region but is not inside it, and a wider region would leave the bracket."""

    def wide(at, x):
        point = not isinstance(x, arb) or x.rad() == 0
        return (0.5 - x if not isinstance(x, arb) else arb(0.5) - x + arb(0, 1e-3)), arb(-1) if point else arb(-1, 0.95)

    with Ball(20).context(), pytest.raises(EventUndecided, match="existence"):
        falling_root(arb(0.497), arb(0.503), wide, ())
