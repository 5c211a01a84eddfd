"""Radii of sensitivities: what is widened holds the derivatives of every point inside; the worst column counts."""

from fractions import Fraction

import numpy as np
import pytest
from differences import moved
from scene_files import scenes_in

from numerics import solve
from numerics.arithmetic.ball import Ball, widened
from numerics.trajectory.saltation import Chain
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
    length = one.length.union(two.length)
    return one._replace(start=one.start.union(two.start), end=end, length=length, state=state)


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
