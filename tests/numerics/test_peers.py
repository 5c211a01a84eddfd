"""The peers: each installed one gets the paper's scene right, says what is missing, and never runs for ever."""

import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from numerics.motion.modes import EventKind
from numerics.scene import Law, Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.solver.solve import solve
from numerics.trade.comparisons import (
    diffrax_arc,
    euler_peer,
    heyoka_peer,
    heyoka_tuned,
    scipy_peer,
    siconos_peer,
    switching,
)
from numerics.trade.comparisons.edge_coordinates import EdgePair
from numerics.trade.comparisons.forward_euler import forward_euler
from numerics.trade.comparisons.heyoka_formats import format_of, nearest
from numerics.trade.comparisons.peer import PeerFailed, Unsupported
from numerics.trade.comparisons.registry import all_peers
from numerics.trade.comparisons.switching import EventLog, SwitchedPair

PAPER = "relative-motion-b05"
VISCOUS = Scene(Pair(1, 2, 200, "0.5", a1=1), State(v1="0.6"), 5)
NEAR_CRITICAL = Scene(Pair(1, 1, 200, "0.5"), State("0.005", "5e-8", 0, "5e-8"), 5)

# (name, start of its use): a fine setting, and the errors it may have there (final state and last event, dissipated)
FINE = {
    ("forward Euler", "plain"): (1e-4, 1e-2, 1e-2),
    ("forward Euler", "compiled"): (1e-5, 1e-3, 1e-3),
    ("SciPy DOP853", "terminal"): (1e-12, 1e-9, 1e-9),
    ("SciPy Radau", "terminal"): (1e-7, 1e-5, 1e-5),
    ("SciPy LSODA", "terminal"): (1e-12, 1e-8, 1e-8),
    ("SciPy DOP853", "edge"): (1e-12, 1e-9, 1e-9),
    ("heyoka", "terminal"): (1e-6, 1e-5, 1e-5),
    ("heyoka", "edge"): (1e-15, 1e-12, 1e-12),
    ("heyoka long double", "edge"): (1e-18, 1e-14, 1e-14),
    ("heyoka quadruple", "edge"): (1e-24, 1e-14, 1e-14),
    ("heyoka real", "edge"): (50, 1e-14, 1e-14),
    ("diffrax Tsit5", "edge"): (1e-9, 1e-6, 1e-6),
    ("diffrax Dopri8", "edge"): (1e-12, 1e-7, 1e-7),
    ("Siconos ZeroOrderHold", "exact"): (1e-3, 2e-3, 1e-4),
    ("Siconos EulerMoreau", "theta"): (1e-3, 2e-3, 1e-4),
}
CASES = [pytest.param(peer, id=f"{peer.name}: {peer.use}") for peer in all_peers()]


def fine(peer):
    return next(FINE[name, use] for name, use in FINE if peer.name == name and peer.use.startswith(use))


@cache
def reference(scene):
    exact = solve(scene, digits=20, arithmetic="ball")
    number = exact.arithmetic.to_float
    lost = number(exact.ledger.friction + exact.ledger.viscous)
    kinds = tuple(event.kind for event in exact.events)
    return kinds, np.array([number(event.t) for event in exact.events]), [number(v) for v in exact.y[:, -1]], lost


def compare(peer, scene):
    if missing := peer.missing():
        pytest.skip(f"missing: {missing}")
    setting, state_error, lost_error = fine(peer)
    kinds, times, y, lost = reference(scene)
    run = peer.prepare(scene, setting)()
    assert run.kinds == kinds
    assert run.t_events == pytest.approx(times, abs=state_error)
    assert run.y_final == pytest.approx(y, abs=state_error)
    assert run.dissipated == pytest.approx(lost, rel=lost_error)
    assert run.steps >= len(kinds) / 3
    assert run.elapsed is None or run.elapsed > 0


@pytest.mark.parametrize("peer", CASES)
def test_the_paper_s_scene_is_right_at_a_fine_setting(peer):
    compare(peer, load_scene(PAPER))


@pytest.mark.parametrize(
    "peer", [case for case in CASES if "forward Euler" not in case.id and ": terminal" not in case.id]
)
def test_viscosity_is_supported(peer):
    compare(peer, VISCOUS)


@pytest.mark.parametrize("precision", ["double", "long double", "quadruple", "real"])
def test_heyoka_at_its_best_follows_excursions_of_relative_energy_1e_12(precision):
    pytest.importorskip("heyoka")
    kinds, times, _, lost = reference(NEAR_CRITICAL)
    peer = heyoka_tuned.TunedHeyokaPeer(precision)
    if peer.missing():
        pytest.skip(peer.missing())
    run = peer.prepare(NEAR_CRITICAL, 50 if precision == "real" else peer.settings[-1])()
    assert run.kinds == kinds
    assert run.t_events == pytest.approx(times, abs=1e-9)
    assert run.dissipated == pytest.approx(lost, rel=1e-2 if precision == "double" else 1e-4)


@pytest.mark.parametrize("value", ["1/10", "0.005", "-1e-300", "1e-10", "123456789123456789123456789/1024", "0", "-3"])
def test_constants_are_rounded_correctly(value):
    exact = Fraction(value)
    assert nearest(exact, 53) == Fraction(float(exact))
    form = format_of("long double", 0)
    number, near = form.number(exact), nearest(exact, form.bits)
    assert Fraction(*number.as_integer_ratio()) == near
    assert abs(near - exact) <= abs(exact) / 2**form.bits
    assert abs(Fraction(form.text(number)) - near) <= abs(near) / 10**40


@pytest.mark.parametrize(("precision", "digits"), [("quadruple", 33), ("real", 200)])
def test_constants_keep_every_digit_of_heyoka_s_formats(precision, digits):
    pytest.importorskip("heyoka")
    form = format_of(precision, digits)
    for text in ("0.1", "-0.005", "5e-8"):
        number = form.number(Fraction(text))
        assert number == form.read(text)
        assert abs(Fraction(form.text(number)) / Fraction(text) - 1) < Fraction(1, 10**digits)


def test_long_steps_in_many_digits_lose_roots(monkeypatch):
    """heyoka's steps get so long that root isolation fails: that is why they are cut. Watched, lest it change."""
    pytest.importorskip("heyoka")
    kinds, *_ = reference(load_scene(PAPER))
    peer = heyoka_tuned.TunedHeyokaPeer("real")
    if peer.missing():
        pytest.skip(peer.missing())
    assert peer.prepare(load_scene(PAPER), 100)().kinds == kinds
    monkeypatch.setattr(heyoka_tuned, "_LONGEST", None)
    assert peer.prepare(load_scene(PAPER), 100)().kinds != kinds


def test_a_missed_root_shows_in_the_event_sequence():
    """heyoka's natural use loses slips at fine tolerances: that is why its best use exists. Watched, lest it change."""
    pytest.importorskip("heyoka")
    run = heyoka_peer.HeyokaPeer().prepare(load_scene(PAPER), 1e-15)()
    assert run.kinds != reference(load_scene(PAPER))[0]


@pytest.mark.parametrize("peer", CASES)
def test_the_other_reading_is_refused(peer):
    scene = load_scene(PAPER)
    literal = Scene(scene.pair, scene.initial, scene.until, Law.THREE_VALUED_SGN)
    if peer.missing():
        pytest.skip(peer.missing())
    with pytest.raises(Unsupported, match="filippov"):
        peer.prepare(literal, peer.settings[0])


def test_what_is_missing_is_named(monkeypatch):
    modules = (diffrax_arc, euler_peer, heyoka_peer, heyoka_tuned, scipy_peer)
    for module in modules:
        monkeypatch.setattr(module, "find_spec", lambda name: None)
    monkeypatch.setattr(siconos_peer, "_interpreter", lambda: None)
    missing = {f"{peer.name}: {peer.use}": peer.missing() for peer in all_peers()}
    assert missing.pop("forward Euler: plain Python") is None
    for words, said in missing.items():
        tool = {"forward": "numba", "Siconos": "python3-siconos"}.get(
            words.split()[0], words.split()[0].lower().strip(":")
        )
        assert tool in said


def test_the_list_imports_no_integrator():
    code = (
        "import sys; from numerics.trade.comparisons.registry import all_peers; all_peers(); "
        "sys.exit(any(name in sys.modules for name in ('scipy', 'heyoka', 'jax', 'diffrax', 'numba', 'siconos')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_events_on_the_spot_and_too_many_events_stop_a_run():
    def note(log, times):
        for t in times:
            log.add(EventKind.EXIT, t)

    with pytest.raises(PeerFailed, match="finds its own start"):
        note(EventLog(), [1.0] * (1 + switching.MAX_ON_THE_SPOT))
    with pytest.raises(PeerFailed, match="more than 10 events"):
        note(EventLog(limit=10), range(11))
    note(EventLog(limit=11), range(11))


@pytest.mark.parametrize("module", [euler_peer, siconos_peer])
def test_too_many_steps_are_refused(module, monkeypatch):
    monkeypatch.setattr(module, "MAX_STEPS", 10)
    peer = euler_peer.EulerPeer(False) if module is euler_peer else siconos_peer.SiconosPeer("ZeroOrderHold")
    with pytest.raises(PeerFailed, match="steps"):
        peer.prepare(load_scene(PAPER), 1e-2)()


def test_a_failing_siconos_process_says_why(monkeypatch, tmp_path):
    child = tmp_path / "child.py"
    child.write_text("raise SystemExit('no such scheme')")
    monkeypatch.setattr(siconos_peer, "CHILD", child)
    monkeypatch.setattr(siconos_peer, "_interpreter", lambda: sys.executable)
    with pytest.raises(PeerFailed, match="no such scheme"):
        siconos_peer.SiconosPeer("ZeroOrderHold").prepare(load_scene(PAPER), 1e-2)()


def test_the_compiled_euler_is_the_plain_one():
    numba = pytest.importorskip("numba")
    loop = numba.njit(euler_peer.march)
    plain, compiled = forward_euler(VISCOUS, 1e-3), forward_euler(VISCOUS, 1e-3, loop)
    assert np.array_equal(plain.y, compiled.y)


def test_euler_s_chatter_is_read_as_sticking():
    """signs + + - + - (chatter) ... outside with the old sign, then the new one, then back inside with the old one."""
    sign = np.array([1, 1, -1, 1, -1, 1, 1, -1, -1, 1, -1])
    load = np.array([0, 0, 0, 0.5, 0.5, 0.5, 1.5, 1.5, 1.2, 0.9, 0.8])
    found = list(euler_peer._events(sign, load, 1.0, 1))
    assert found == [(EventKind.ENTRY, 2), (EventKind.EXIT, 6), (EventKind.ENTRY, 9)]
    crossing = list(euler_peer._events(np.array([1, 1, -1, -1]), np.array([2.0, 2.0, 2.0, 2.0]), 1.0, 1))
    assert crossing == [(EventKind.CROSSING, 2)]
    touching = list(euler_peer._events(np.array([0, -1, 0, 1, 1]), np.array([2.0, 2.0, -2.0, -2.0, -2.0]), 1.0, -1))
    assert touching == [(EventKind.CROSSING, 2)]


@pytest.mark.parametrize("u", [1e-8, 1e-3, 0.3, 2.0, 30.0])
def test_the_step_off_the_surface_stays_inside_the_slip(u):
    """From an exit, V = u sqrt(q): g is back at the angle t with (t - sin t)/(1 - cos t) = u, t = time sqrt(a2/m1)."""
    scene = load_scene(PAPER)
    pair = EdgePair(scene, float)
    rate = (pair.a2 / pair.m1) ** 0.5
    speed = u * float(scene.pair.half_width) * rate * pair.m1 / pair.mass
    predicted = pair.comes_back(0.0, -speed)
    true = brentq(lambda t: t - np.sin(t) - u * (1 - np.cos(t)), min(1.5 * u, 1.0), 2 * np.pi - 1e-9) / rate
    assert predicted >= true * (1 - 1e-6)
    assert 0 < min(predicted / 2, pair.quick) < true


def test_rules_at_the_surface():
    pair = SwitchedPair.of(load_scene(PAPER))
    edge = pair.held / pair.a2
    plus, minus, stick = (next(m for m in type(pair.start) if m.sign == s) for s in (1, -1, 0))
    assert pair.after(plus, 0.5 * edge, 0.1) is stick
    assert pair.after(plus, 1.5 * edge, 0.1) is minus
    assert pair.after(stick, edge, 0.1) is minus
    assert pair.after(stick, -edge, -0.1) is plus
    assert replace(pair, a1=1.0).load_rate(0.0, 1.0) == pytest.approx(200 - 0.5)
