"""The numbers of the chapter on forces, each with a proved error, for the pair of Section IV with b = 0.5 N."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp
from flint import arb

from numerics.control.response import response
from numerics.control.ring import ring_entry
from numerics.control.thresholds import thresholds
from numerics.control.tracking import track
from numerics.control.transfer import fastest_transfer
from numerics.scene import Force
from numerics.scene.file import load_reference, load_scene
from paper_checks.decide.enclosure import rounded
from paper_checks.drawing.under_a_force import DAMPED, DRIVEN, PAIR
from theory.forced import breaking_damping
from theory.forced_response import harmonic_amplitude, multiple, resonant_amplitude
from theory.symbols import b, m1, m2, v1

SPEED = sp.Rational("0.03")
"""A velocity, m/s, with which the stuck pair passes its rest position."""


def given() -> dict[str, Any]:
    """Return what the chapter needs."""
    rest = load_scene("at-rest")
    fastest, attracts = fastest_transfer(rest, "0.001", amplitude="1.08"), response(DRIVEN).multipliers or ()
    assert fastest.least_amplitude is not None  # the half time is below a quarter turn of body 1
    with_harmonic = replace(DRIVEN, force=DRIVEN.force + Force.sine("0.05", 24, 1))
    asymmetric = response(with_harmonic).orbit
    assert asymmetric is not None
    known = {
        letter: sp.Rational(*value.as_integer_ratio()) for letter, value in ((m1, PAIR.m1), (m2, PAIR.m2), (b, PAIR.b))
    }
    return {
        "pair": PAIR,
        "thresholds": _thresholds,
        "third": sp.N(harmonic_amplitude().subs(multiple, 3), 5),
        "resonant": sp.N(resonant_amplitude().subs(known), 5),
        "share": rounded(100 * track(rest, load_reference("s-curve")).share, 1),
        "least_time": rounded(1000 * fastest.bound, 2),
        "stuck_amplitude": rounded(fastest.stuck_amplitude, 4),
        "least_amplitude": rounded(fastest.least_amplitude, 4),
        "entry": rounded(ring_entry(load_scene("velocities"), "0.001", rate=20).entry, 4),
        "multiplier": rounded(100 * max(map(abs, attracts), key=float, default=arb(0)), 1),
        "drift": rounded(1000 * asymmetric.travel / asymmetric.drive.period, 3),
        "speed": float(SPEED),
        "breaking": sp.N(breaking_damping().subs(known).subs(v1, SPEED), 5),
    }


def _thresholds(rate: int) -> list[str]:
    """Return U* and U** at a frequency in rad/s, without and with a damper."""
    both = (thresholds(pair, rate) for pair in (PAIR, DAMPED))
    return [rounded(one, 4) for found in both for one in (found.entrainment, found.non_stop)]
