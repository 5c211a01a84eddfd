"""Paths on a surface, and whether two answers may be of the same motion."""

from typing import Any

from flint import arb
from overlapping import overlap

from numerics import PlaneScene
from numerics.arithmetic.ball import Ball
from numerics.plane.reduced import reduced
from numerics.plane.run import PlaneRun
from numerics.plane.system import System
from numerics.plane.vector import wide


def path_of(scene: PlaneScene, digits: int = 16, legs: int = 2000) -> PlaneRun:
    """A path that nobody has followed yet."""
    return PlaneRun([System(one, digits) for one in reduced(scene)], 100, legs)


def said(scene: PlaneScene, off: float = 0.0, digits: int = 16) -> tuple[Any, ...]:
    """Events, and state and mode at the end, of all that begin within `off` of a scene in N."""
    run = path_of(scene, digits)
    with run.system.fine():
        run.norm = arb(off)
        run.at = run.at._replace(z=wide(run.at.z, run.system.soft * run.norm))
    run.follow()
    with run.system.fine():
        return run.events, run.motion.at(Ball.number(scene.until)), run.mode


def agree(one: tuple[Any, ...], two: tuple[Any, ...]) -> bool:
    """Whether events, and all else that two answers say, may be of the same motion."""
    return overlap(*([[[*vars(event).values()] for event in events], *rest] for events, *rest in (one, two)))
