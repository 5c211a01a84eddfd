"""The peers: each installed one gets free and forced scenes right, says what is missing, and never runs for ever."""

from functools import cache

import numpy as np
import pytest
from sixty_digits import forced_scene

from numerics import Force, Pair, Scene, State, load_scene
from numerics.trade.comparisons import switched
from numerics.trade.forward_euler import events_of
from numerics.trade.comparisons.switched import PeerFailed, SwitchedPair
from numerics.trade.contenders import answer_of, contender
from numerics.trade.judge import judge, proved
from numerics.trade.scenes import benchmark

PAPER = load_scene("relative-motion-b05")
TOUCH = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.01000001", v2="0.01000001"), 6, force=Force.sine("0.3000003", 5))
FREE = {"paper": PAPER, "viscous": Scene(Pair(1, 2, 200, "0.5", a1=1), State(v1="0.6"), 5)}
FORCED = {name: forced_scene(name) for name in ("sine-stick-slip", "friction-by-pieces")}
# a fine setting, and the digits that it must have there
FINE = {
    "forward Euler": (1e-5, 1.5),
    "SciPy DOP853": (1e-12, 8),
    "heyoka": (1e-15, 11),
    "heyoka long double": (1e-18, 13),
}
truth_of = cache(proved)


def prepared(label, scene, setting):
    if missing := contender(label).missing():
        pytest.skip(f"missing: {missing}")
    return contender(label).prepare(scene, setting)


@pytest.mark.parametrize(
    ("label", "name"),
    [(label, name) for label in FINE for name in (FREE if label == "forward Euler" else FREE | FORCED)],
)
def test_a_fine_setting_has_the_events_and_the_digits(label, name):
    setting, digits = FINE[label]
    scene = (FREE | FORCED)[name]
    call = prepared(label, scene, setting)
    found = call()
    verdict = judge(answer_of(found), truth_of(scene), scene)
    assert verdict.difference is None
    assert verdict.digits >= digits
    assert list(call().final) == list(found.final)


@pytest.mark.parametrize(
    ("label", "scene"), [("SciPy DOP853", TOUCH), ("heyoka", TOUCH), ("heyoka", benchmark("near-critical-1e-12"))]
)
def test_a_short_stay_beyond_the_edge_is_not_stepped_over(label, scene):
    assert judge(prepared(label, scene, 1e-12)(), truth_of(scene), scene).difference is None


def test_what_does_not_get_on_is_stopped_(monkeypatch):
    monkeypatch.setattr(switched, "MAX_ARCS", 5)
    with pytest.raises(PeerFailed, match="in 6 arcs"):
        switched.run(SwitchedPair(PAPER), lambda slip, span, s, t, start: (True, t, [1.0, 0.1, 0.0, 0.0]))


@pytest.mark.parametrize(
    ("sign", "load", "mode", "events"),
    [
        # + + - + - (chatter), outside with the old sign, then the new one, then back inside with the old one
        (
            [1, 1, -1, 1, -1, 1, 1, -1, -1, 1, -1],
            [0, 0, 0, 0.5, 0.5, 0.5, 1.5, 1.5, 1.2, 0.9, 0.8],
            1,
            [(2, 0), (6, -1), (9, 0)],
        ),
        ([0, -1, 0, 1, 1], [2.0, 2.0, -2.0, -2.0, -2.0], -1, [(2, 1)]),
    ],
)
def test_the_chatter_of_forward_euler_is_read_as_sticking(sign, load, mode, events):
    assert list(events_of(np.array(sign), np.array(load), mode)) == events
