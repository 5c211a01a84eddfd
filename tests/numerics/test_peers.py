"""The peers: each installed one gets scenes of every kind right, and never runs for ever."""

from functools import cache

import pytest
from scene_files import scenes_in
from sixty_digits import forced_scene

from numerics import Law, Pair, Scene, State, load_scene
from numerics.trade import peers
from numerics.trade.contenders import CONTENDERS
from numerics.trade.forward_euler import forward_euler
from numerics.trade.judge import judge, proved
from numerics.trade.measure import FOLDER
from numerics.trade.peers import PeerFailed, SwitchedPair

PAPER = load_scene("relative-motion-b05")
SCENES = {"paper": PAPER, "viscous": scenes_in("differentiated")["damped"]}
SCENES |= {name: forced_scene(name) for name in ("sine-stick-slip", "friction-by-pieces", "trapezoid")}
SIGNALS = "belt-and-wall", "wall-of-a-sine", "incline", "friction-by-a-sine", "static-friction-under-a-sine"
SCENES |= {name: scenes_in("signals")[name] for name in SIGNALS}
EULER = "forward Euler"
# a fine setting, and the digits that it must have there
FINE = {
    EULER: (1e6, 1.5),
    "SciPy DOP853": (1e-12, 8),
    "heyoka": (1e-15, 11),
    "heyoka long double": (1e-18, 13),
}
truth_of = cache(proved)


def contender(name):
    return next(one for one in CONTENDERS if one.name == name)


def verdict(one, scene, setting):
    if missing := one.left_out(scene):
        pytest.skip(missing)
    return judge(one.prepare(scene, setting)(), truth_of(scene))


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("name", FINE)
def test_a_fine_setting_has_the_events_and_the_digits(name, scene):
    one, (setting, digits) = contender(name), FINE[name]
    if name == EULER and SCENES[scene].is_forced:  # which has the paper's equations
        assert one.left_out(SCENES[scene]).startswith("not for ")
        return
    found = verdict(one, SCENES[scene], setting)
    assert found.note == ""
    assert found.digits >= digits


@pytest.mark.parametrize(("law", "v"), [(Law.FILIPPOV, (-0.28, -0.25)), (Law.THREE_VALUED_SGN, (-0.26, -0.26))])
def test_forward_euler_slips_from_rest_beyond_the_edge_unless_sgn_0_is_0(law, v):
    """The edge is L = 0.00375 m."""
    assert forward_euler(Scene(Pair(1, 2, 200, "0.5"), State("0.0039"), 2, law), 1).y[[1, 3], 1] == pytest.approx(v)


TOUCH, NEAR = (load_scene(FOLDER / f"{name}.toml") for name in ("forced-touch", "near-critical-1e-12"))


@pytest.mark.parametrize(("name", "scene"), [("SciPy DOP853", TOUCH), ("heyoka", TOUCH), ("heyoka", NEAR)])
def test_a_short_stay_beyond_the_edge_is_not_stepped_over(name, scene):
    assert verdict(contender(name), scene, 1e-12).note == ""


def test_what_does_not_get_on_is_stopped(monkeypatch):
    monkeypatch.setattr(peers, "MAX_ARCS", 5)
    with pytest.raises(PeerFailed, match="in 6 arcs"):
        peers.run(SwitchedPair(PAPER), lambda own, slip, y, left: (True, 0.0, [1.0, 1.0, 0.0, 0.1, 0.0, 0.0, 0.5]))
