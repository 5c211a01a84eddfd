"""Answers of the control tools at other parameters, against numbers from mpmath alone, without a line of this project.

Each mode by its closed form at 45 digits, events by bisection and the secant method; the periodic motion by Newton on
the period map, its multipliers from central differences of that map with steps of 10^-18; the last time on a ring by a
scan of each slip. The digits given agree with a second precision.
"""

from __future__ import annotations

import pytest
from flint import arb

from numerics import Force, Pair, Piece, Scene, Sine, State, fastest_transfer, response, ring_entry
from numerics.arithmetic.ball import Ball


def same(found: arb, expected: str) -> bool:
    """Whether an enclosure has 16 digits of a number."""
    with Ball(40).context():
        return bool(abs(found - arb(expected)) <= abs(arb(expected)) * arb("1e-16"))


A, B, C, D = (
    ("1.3", "0.7", "150", "0.4", "2.2"),
    ("0.5", "2", "80", "0.3", "0.9"),
    ("1", "1", "200", "0.5", "3"),
    ("2", "0.4", "60", "0.2", "5"),
)
MOTIONS = [
    (A, [("0.62", 11)], ["0.340371629571482244", "0.173304288420553268"], "0.0297312236609203830", None),
    (
        B,
        [("1.4", 7)],
        ["0.729336181512710547", "0.25313049977163417", "0.0390133680976209238"],
        "0.67378370718291992",
        None,
    ),
    (
        C,
        [("0.5", 12), ("0.3", 24, 1)],
        ["0.456640087431195689", "0.0140139837714773292"],
        None,
        "-0.00808123471390706878",
    ),
    (D, [("9", 4, "0.3")], ["0.611453251971602147"], "1.21482249756672209", None),
]


@pytest.mark.parametrize(("pair", "sines", "multipliers", "event", "drift"), MOTIONS)
def test_multipliers_events_and_drift_of_a_periodic_motion(pair, sines, multipliers, event, drift):
    force = Force((Piece(0, [], [Sine(*one) for one in sines]),))
    found = response(Scene(Pair(*pair), State(), 1, force=force), digits=20)
    with Ball(40).context():
        sizes = [abs(one) for one in found.multipliers]
    for size, expected in zip(sizes, multipliers, strict=False):
        assert same(size, expected)
    assert event is None or any(same(leg.t, event) for leg in found.orbit.legs)
    assert same(found.drift, drift) if drift else found.drift.is_zero()


RINGS = [
    (A, ("0.01", "0.9", 0, "-0.2"), "0.004", 1, "1.81933692402019827", "0.189314077900404019"),
    (
        ("0.8", "1.9", "64", "0.25", "40"),
        (0, 2, "0.1", 0),
        "0.05",
        3,
        "0.0458578861428991834",
        "-0.0726029154699079647",
    ),
    (
        ("2", "3", "50", "0.6", "0.5"),
        ("-0.03", 0, 0, "0.4"),
        "0.01",
        "0.7",
        "2.45240372409533733",
        "-0.428579508344535612",
    ),
]


@pytest.mark.parametrize(("pair", "state", "radius", "rate", "entry", "centre"), RINGS)
def test_the_entry_into_a_ring_and_its_centre(pair, state, radius, rate, entry, centre):
    found = ring_entry(Scene(Pair(*pair), State(*state), 5), radius, rate=rate, digits=20)
    assert same(found.entry, entry)
    assert same(found.centre, centre)


TRANSFERS = [
    (
        A,
        "0.004",
        {
            "bound": "0.16733200530681511",
            "stuck_amplitude": "1.5480372604785695",
            "least_amplitude": "1.31493381877664192",
        },
    ),
    (
        ("5", "0.05", "900", "0.03", "134"),
        "0.0007",
        {"stuck_amplitude": "6.09118280527717237", "least_amplitude": "4.77169648499793175"},
    ),
    (("0.8", "1.9", "64", "0.25", "40"), "0.02", {"stuck_amplitude": "3.04721986206504503", "least_amplitude": None}),
]


@pytest.mark.parametrize(("pair", "distance", "expected"), TRANSFERS)
def test_the_bound_and_the_amplitudes_of_a_transfer(pair, distance, expected):
    found = fastest_transfer(Scene(Pair(*pair), State(), 1), distance, digits=20)
    for name, text in expected.items():
        value = getattr(found, name)
        assert value is None if text is None else same(value, text)


def test_the_time_of_a_transfer_under_full_force_forwards_and_backwards():
    """U = 1.4 a2 D: the two times by Newton on position and velocity at the end."""
    found = fastest_transfer(Scene(Pair("0.2", "2.5", 31, "1.1"), State(), 1), "0.01", amplitude="0.434", digits=20)
    assert same(found.time, "0.458305657079908681")
