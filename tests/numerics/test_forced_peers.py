"""The peers under a force: each installed one gets scenes right that an independent reference has solved."""

import math
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from forced.catalogue import ANSWER, scene

from numerics.scene import Force, Friction, Law, Pair, Scene, State
from numerics.trade.comparisons.forced_pair import ForcedPair, spans_of
from numerics.trade.comparisons.hand_written import HandWrittenPeer
from numerics.trade.comparisons.peer import Unsupported
from numerics.trade.comparisons.registry import all_peers, forced_peers
from numerics.trade.contender import peer_outcome

LETTERS = {"0": "n", "+": "x", "-": "x"}
# name: a setting, and the error of the final state that it may have there, in L and L Omega
FINE = {
    "SciPy DOP853": (1e-10, 1e-7),
    "SciPy Radau": (1e-8, 1e-5),
    "SciPy LSODA": (1e-10, 1e-5),
    "heyoka": (1e-15, 1e-10),
    "diffrax Dopri8": (1e-10, 1e-5),
    "Siconos EulerMoreau": (1e-3, 1e-2),
    "Karnopp's dead zone": (1e-2, 0.5),
    "tanh smoothing": (1e-3, 0.1),
}
SCENES = ["sine-stick-slip", "friction-by-pieces"]
ONE_SCENE = {
    "diffrax Dopri8",  # compiles for seconds
    "tanh smoothing",  # never at rest, it reads a reversal as a short stick
}


def kinds(modes):
    """The letters of outcome.LETTERS: a slip ends in stick (n), begins from it (x), or reverses (c)."""
    return "".join("n" if after == "0" else "x" if before == "0" else "c" for before, after in pairwise(modes))


def error(run, name):
    pair, true = scene(name).pair, [float(value) for value in ANSWER[name]["final"][1:]]
    length = float(pair.half_width)
    speed = length * math.sqrt(pair.a2 / pair.mass)
    return max(abs(run.y_final - true) / [length, speed, length, speed])


def present(peer):
    if missing := peer.missing():
        pytest.skip(f"missing: {missing}")
    return peer


RUNS = [
    pytest.param(peer, name, id=f"{peer.name}-{name}")
    for peer in forced_peers()
    for name in SCENES[: 1 if peer.name in ONE_SCENE else None]
]


@pytest.mark.parametrize(("peer", "name"), RUNS)
def test_it_agrees_with_the_reference(peer, name):
    setting, most = FINE[peer.name]
    run = present(peer).prepare(scene(name), setting)()
    assert peer_outcome(run).kinds == kinds(ANSWER[name]["modes"])
    assert error(run, name) <= most
    energies = balance(name)
    assert run.dissipated == pytest.approx(energies, rel=30 * most)


@cache
def balance(name):
    """What friction and viscosity took, J, by the finest run of an explicit method."""
    peer = next(one for one in forced_peers() if one.name == "SciPy DOP853")
    return present(peer).prepare(scene(name), 1e-11)().dissipated


def test_a_wrong_friction_is_seen():
    """The comparison can fail: b a thousandth off is far beyond the errors allowed."""
    right = scene("sine-stick-slip")
    pair = Pair(right.pair.m1, right.pair.m2, right.pair.a2, "0.05005", right.pair.a1)
    peer = next(one for one in forced_peers() if one.name == "SciPy DOP853")
    run = present(peer).prepare(Scene(pair, right.initial, right.until, force=right.force), 1e-10)()
    assert error(run, "sine-stick-slip") > 1e-4


@pytest.mark.parametrize("kind", ["Karnopp", "tanh"])
def test_what_is_written_by_hand_comes_nearer_with_a_narrower_zone(kind):
    peer, name = present(HandWrittenPeer(kind)), "step-breaks-adhesion"
    wide, narrow = (error(peer.prepare(scene(name), zone)(), name) for zone in (0.1, 0.01))
    assert 1e-5 < narrow < wide


def test_spans_lie_between_jumps_and_carry_what_acts_there():
    given = Scene(
        Pair(1, 1, 200, "0.05"),
        State(),
        3,
        force=Force.step(1, 2) + Force.sine("0.5", 4, start=2),
        friction=Friction([(1, "0.1"), ("2.5", "0.2"), (7, 1)]),
    )
    spans = spans_of(given)
    assert [(one.start, one.end, one.b) for one in spans] == [(0, 1, 0.05), (1, 2, 0.1), (2, 2.5, 0.1), (2.5, 3, 0.2)]
    for span in spans:
        middle = (span.start + span.end) / 2
        assert span.force()(middle) == pytest.approx(float(given.force(middle)), abs=1e-14)


def test_each_says_for_which_scenes_it_is():
    assert not any(peer.forced for peer in all_peers())
    assert all(peer.forced for peer in forced_peers())
    assert {peer.name for peer in forced_peers()} == set(FINE)


def test_the_literal_law_is_refused():
    given = scene("sweep")
    with pytest.raises(Unsupported, match="filippov"):
        ForcedPair.of(Scene(given.pair, given.initial, 1, law=Law.THREE_VALUED_SGN, force=given.force))


def test_a_run_can_be_repeated():
    for peer in forced_peers():
        if peer.missing() is None and peer.name in {"SciPy DOP853", "heyoka"}:
            call = peer.prepare(scene("step-breaks-adhesion"), peer.settings[1])
            one, two = call(), call()
            assert one.kinds == two.kinds
            assert np.array_equal(one.y_final, two.y_final)
