"""What the tests of the trade share."""

from __future__ import annotations

from numerics.scene import Scene
from numerics.scene.file import load_scene
from numerics.trade import scenes
from numerics.trade.measure import Limits
from numerics.trade.ours import BALL, READ, Ours, our_contenders, solved
from numerics.trade.outcome import Outcome

QUICK = Limits(prepare=60, run=20, budget=0.01)
SCENE = scenes.Benchmark("headline", "", load_scene(scenes.HEADLINE))


def ours(label: str) -> Ours:
    return next(one for one in our_contenders() if one.label == label)


def floats_of(scene: Scene) -> Outcome:
    return ours(READ).outcome(solved(None)(scene, 53.0)())


def balls_of(scene: Scene, digits: int) -> Outcome:
    return ours(BALL).outcome(solved("ball")(scene, float(digits))())
