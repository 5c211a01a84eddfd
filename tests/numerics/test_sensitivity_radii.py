"""Radii of sensitivities: what is widened holds the derivatives of every point inside; the worst column counts."""

from fractions import Fraction

import numpy as np
import pytest
from differences import moved
from flint import arb
from scene_files import scenes_in

from numerics import solve
from numerics.arithmetic.ball import Ball, widened
from numerics.trajectory import sensitivity
from numerics.trajectory.saltation import CarriedDerivatives, Chain
from numerics.trajectory.sensitivity import parameters
from numerics.trajectory.variation import legs

SCENES = scenes_in("followed") | scenes_in("followed-in-balls")
RADIUS = Fraction(1, 10**6)


def everything(scene, followed):
    """The derivatives along legs: of times and states of events, of the state between them and at the end."""
    chain = Chain(scene, followed, tuple(parameters(scene)))
    final, _ = chain.final(followed[-1].state)
    grid = [chain.at(k, (leg.end - leg.start) / 2) for k, leg in enumerate(followed)]
    return [np.concatenate([np.ravel(one) for one in found]) for found in (chain.t, chain.y, grid, final)]


def joined(one, two):
    """A leg whose start, end and state hold those of two."""
    state = tuple(x.union(y) for x, y in zip(one.state, two.state, strict=True))
    end = one.end if one.end is one.start else one.end.union(two.end)
    return one._replace(start=one.start.union(two.start), end=end, state=state)


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("coordinate", ["x1", "v1", "x2", "v2"])
def test_what_is_widened_holds_the_derivatives_of_points_inside(name, coordinate):
    scene = SCENES[name]
    solved = [solve(one, arithmetic="ball", digits=30) for one in (scene, moved(scene, {coordinate: RADIUS}))]
    assert solved[0].modes == solved[1].modes
    assert len(solved[0].events) > 3
    with Ball(30).context():
        followed = [legs(one) for one in solved]
        wide = everything(scene, [joined(one, two) for one, two in zip(*followed, strict=True)])
        points = [everything(scene, one) for one in followed]
        for enclosed, *inside in zip(wide, *points, strict=True):
            assert all(one.is_finite() for one in enclosed)
            for point in inside:
                # a point's own radius is that of 30 digits
                near = (widened(one, two.rad()) for one, two in zip(enclosed, point, strict=True))
                assert all(one.contains(two) for one, two in zip(near, point, strict=True))


@pytest.mark.parametrize("worst", range(3))
def test_the_worst_column_says_the_digits(worst):
    with Ball(40).context():
        columns = [[arb(1, 1e-20), arb(3, 1e-20)] for _ in range(3)]
        columns[worst][1] = arb(2, 1e-9)
        first, second = np.array(columns).T, np.full((2, 4, 3), arb(1, 1e-25))
        for arrays in ((first, second), (second, first)):
            assert sensitivity._right_digits(arrays, 40) == 9
        assert sensitivity._right_digits((first, np.full((2, 1), arb(0, 1e-30))), 20) == 5  # it may be 0, and may not


@pytest.fixture(scope="module", params=SCENES)
def chain(request):
    scene = SCENES[request.param]
    trajectory = solve(scene, arithmetic="ball", digits=30)
    with Ball(30).context():
        return Chain(scene, legs(trajectory), tuple(parameters(scene)))


@pytest.mark.parametrize("row", range(4))
def test_what_is_carried_as_points_keeps_its_radii(chain, row):
    with Ball(30).context():
        y, zeros = chain.starts[0].y + arb(0), chain.starts[0].norm * 0
        y[row] += arb(0, 1)
        again = chain._enclosed(chain._pointed(CarriedDerivatives(y, zeros, zeros, zeros)))
        assert all(one.contains(two) for one, two in zip(again.ravel(), y.ravel(), strict=True))


@pytest.mark.parametrize("off", [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (1, 1, 0, 1)], ids=str)
def test_a_bound_holds_what_starts_within_it(chain, off):
    """Of every leg: in it, at the event that ends it, and after that."""
    with Ball(30).context():
        pair, zeros = chain.scene.pair, chain.starts[0].norm * 0
        norm = sum(abs(x) * Ball.number(c).sqrt() for x, c in zip(off, (pair.a2, pair.m1, 0, pair.m2), strict=True))
        norm += abs(off[0] - off[2]) * Ball.number(chain.cells.pulling if chain.cells else 0).sqrt()
        for index, leg in enumerate(chain.legs[:-1]):
            if leg.side == 0 and off[1] != off[3]:
                continue
            y, kept = chain.starts[index].y, len(chain.t)
            found = []
            for carried in (
                CarriedDerivatives(y, zeros + norm, zeros + abs(off[0]), zeros + abs(off[0] - off[2])),
                CarriedDerivatives(y + np.array(off)[:, None], zeros, zeros, zeros),
            ):
                within = Chain.__new__(Chain)
                within.__dict__ |= chain.__dict__ | {"starts": [*chain.starts]}
                within.starts[index] = carried
                crossed = within._enclosed(within._crossed(index))
                parts = [within.at(index, (leg.end - leg.start) / 2), crossed]
                if len(chain.t) > kept:
                    parts += [chain.t.pop(), chain.y.pop(), chain.before.pop()]
                found.append(np.concatenate([np.ravel(one) for one in parts]))
            for wide, point in zip(*found, strict=True):
                assert widened(wide, point.rad() + arb("1e-25")).contains(point)
