"""The pair under a force: the mode rule's derivatives, the load; thresholds and transfers are held against numerics."""

import sympy as sp

from theory import forced, forced_control
from theory.symbols import b, m2, t, total_mass, u, v1, x1


def test_at_a_tie_slip_and_stick_part_by_the_first_derivative_only(same):
    # x1 chosen so that the load is sign b, and its rate zero: the second derivative of both loads is (m2/M) p''
    for mode in ("stick", "slip-"):
        assert same(forced.deviation_force(mode, -1), forced.imbalance(-1))
    assert same(forced.imbalance(-1).subs(t, 0), total_mass() / m2 * (forced.load() + b))


def test_the_load_is_what_holds_body_2():
    field = forced.forced_system(forced.load() / b)
    assert sp.simplify((field[1] - field[2]).subs(sp.Symbol("v2", real=True), v1)) == 0


def test_the_stuck_force_moves_the_stuck_pair(same):
    along = {
        forced_control.r_place: sp.sin(t),
        forced_control.r_speed: sp.cos(t),
        forced_control.r_acceleration: -sp.sin(t),
    }
    force = forced_control.stuck_force().subs(along)
    load = forced.load().subs({u: force, x1: sp.sin(t), v1: sp.cos(t)})
    assert same(load, -m2 * sp.sin(t))
