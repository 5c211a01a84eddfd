"""The peers: each installed one gets free and forced scenes right, says what is missing, and never runs for ever."""

import subprocess
import sys
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq
from sixty_digits import forced_scene

from numerics import Force, Law, Pair, PlanePair, PlaneScene, Scene, State, load_scene
from numerics.trade import contenders
from numerics.trade.comparisons import direct, forward_euler, switched
from numerics.trade.comparisons.peer import PeerFailed, Unsupported
from numerics.trade.comparisons.switched import Ended, SwitchedPair
from numerics.trade.contenders import CONTENDERS, answer_of, contender
from numerics.trade.judge import judge, proved
from numerics.trade.recorded import OURS
from numerics.trade.scenes import benchmark

PEERS = [one for one in CONTENDERS if one.label not in OURS and "free" in one.kinds]
PAPER = load_scene("relative-motion-b05")
SCENES = {
    "paper": PAPER,
    "viscous": Scene(Pair(1, 2, 200, "0.5", a1=1), State(v1="0.6"), 5),
    **{name: forced_scene(name) for name in ("sine-stick-slip", "friction-by-pieces")},
}
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
    [(one, name) for one in FINE for name in SCENES if one != "forward Euler" or not SCENES[name].is_forced],
)
def test_a_fine_setting_has_the_events_and_the_digits(label, name):
    setting, digits = FINE[label]
    call = prepared(label, SCENES[name], setting)
    found = call()
    verdict = judge(answer_of(found), truth_of(SCENES[name]), SCENES[name])
    assert verdict.difference is None
    assert verdict.digits >= digits
    assert call().final == found.final


@pytest.mark.parametrize("label", ["SciPy DOP853", "heyoka"])
def test_a_short_stay_beyond_the_edge_is_not_stepped_over(label):
    touch = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.01000001", v2="0.01000001"), 6, force=Force.sine("0.3000003", 5))
    assert judge(prepared(label, touch, 1e-12)(), truth_of(touch), touch).difference is None


@pytest.mark.parametrize("peer", PEERS, ids=lambda one: one.label)
def test_the_other_reading_is_refused_and_what_is_missing_is_named(peer, monkeypatch):
    literal = Scene(PAPER.pair, PAPER.initial, PAPER.until, Law.THREE_VALUED_SGN)
    if not peer.missing():
        with pytest.raises(Unsupported, match="filippov"):
            peer.prepare(literal, peer.settings[0])
    monkeypatch.setattr(contenders, "find_spec", lambda name: None)
    assert (peer.missing() or "") == ("" if not peer.package else peer.missing())
    assert peer.package in (peer.missing() or "")


def test_the_list_imports_no_integrator():
    code = (
        "import sys; import numerics.trade.contenders; "
        "sys.exit(any(name in sys.modules for name in ('scipy', 'heyoka', 'numba')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


class TestSwitched:
    @pytest.mark.parametrize("u", [1e-8, 1e-3, 0.3, 2.0, 30.0])
    def test_the_step_off_the_surface_stays_inside_the_slip(self, u):
        """From an exit, V = u sqrt(q): g is back at the angle t with (t - sin t)/(1 - cos t) = u."""
        pair = SwitchedPair(PAPER)
        rate = (pair.a2 / pair.m1) ** 0.5
        speed = u * float(PAPER.pair.half_width) * rate * pair.m1 / pair.mass
        first, predicted = pair.first_step(pair.spans[0], 1, 0.0, 0.0, -speed)
        true = brentq(lambda t: t - np.sin(t) - u * (1 - np.cos(t)), min(1.5 * u, 1.0), 2 * np.pi - 1e-9) / rate
        assert predicted >= true * (1 - 1e-6)
        assert 0 < first < true

    def test_a_run_that_does_not_get_on_is_stopped(self, monkeypatch):
        pair = SwitchedPair(PAPER)
        with pytest.raises(PeerFailed, match="arcs on the spot"):
            switched.run(pair, lambda asked: (Ended.MET, asked.t, [1.0, 0.1, 0.0, 0.0]))
        monkeypatch.setattr(switched, "MAX_EVENTS", 5)
        with pytest.raises(PeerFailed, match="6 events"):
            prepared("SciPy DOP853", PAPER, 1e-6)()


class TestEuler:
    def test_chatter_is_read_as_sticking(self):
        """Signs + + - + - (chatter), outside with the old sign, then the new one, then back inside with the old one."""
        for sign, load, mode, events in (
            (
                [1, 1, -1, 1, -1, 1, 1, -1, -1, 1, -1],
                [0, 0, 0, 0.5, 0.5, 0.5, 1.5, 1.5, 1.2, 0.9, 0.8],
                1,
                [(0, 2), (-1, 6), (0, 9)],
            ),
            ([1, 1, -1, -1], [2.0] * 4, 1, [(-1, 2)]),
            ([0, -1, 0, 1, 1], [2.0, 2.0, -2.0, -2.0, -2.0], -1, [(1, 2)]),
        ):
            assert list(forward_euler._events(np.array(sign), np.array(load), 1.0, mode)) == events

    def test_too_many_steps_are_refused(self):
        with pytest.raises(PeerFailed, match="steps"):
            contender("forward Euler").prepare(PAPER, 1e-9)


class TestOffTheLine:
    """A surface, and friction of the speed: the event-driven law has the events, the smoothed one comes nearer."""

    @pytest.mark.long
    def test_from_event_to_event_it_has_the_events(self):
        scene = benchmark("surface-stick-slip")
        found = judge(prepared("SciPy DOP853, events", scene, 1e-4)(), truth_of(scene), scene)
        assert found.difference is None
        assert found.digits > 1

    @pytest.mark.parametrize("name", ["surface-stick-slip", "state-weakening"])
    def test_a_smoothed_law_comes_nearer_with_less_smoothing(self, name):
        scene = benchmark(name)
        calls = [prepared("heyoka, smoothed", scene, eps) for eps in (1e-2, 1e-4)]
        coarse, fine = (judge(call(), truth_of(scene), scene).digits for call in calls)
        assert fine > max(coarse + 0.5, 1.5)

    def test_it_is_right_for_a_slip_that_no_friction_law_bends(self):
        """On one slip of constant direction both laws are the same but for eps."""
        scene = PlaneScene(PlanePair(1, 1, 200, "0.5"), "0.05", v1=["0.6", "0.8"])
        assert judge(prepared("heyoka, smoothed", scene, 1e-6)(), truth_of(scene), scene).digits > 5

    def test_what_is_not_written_down_is_refused(self):
        with pytest.raises(Unsupported, match="one piece"):
            direct.smoothed(forced_scene("friction-by-pieces"), 1e-3, "SciPy")
