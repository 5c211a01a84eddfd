"""Bands with false slips that look right: each is refused, for every share and excess, and the true one is accepted."""

import json
from fractions import Fraction

import pytest
from flint import arb

from paper_checks.certificates import checker

TEXT = checker.CERTIFICATE.read_text("utf-8")


def objections(change):
    data = json.loads(TEXT)
    change(data)
    return checker.objections(json.dumps(data))


def wider(interval, times):
    low, high = map(Fraction, interval)
    by = (high - low) * (times - 1) / 2
    return [str(low - by), str(high + by)]


@pytest.mark.parametrize("name", ["share", "excess"])
def test_a_band_is_proved_for_all_of_its_parameters(name):
    """Twenty times as wide about the same middle: the slips of its ends do not end in the bracket."""

    def widen(data):
        data["bands"][3][name] = wider(data["bands"][3][name], 20)

    assert objections(widen)


@pytest.mark.parametrize(("times", "slip"), [(10, 2), (4, 3)])
def test_so_are_the_slips_after_the_first(times, slip):
    """The brackets before are wide enough for that much more excess, this one is not."""

    def widen(data):
        band = data["bands"][9]
        band["excess"] = wider(band["excess"], times)
        for one in band["slips"][: slip - 1]:
            one[:2] = wider(one[:2], times)

    assert [one.partition(": slip ")[2] for one in objections(widen)] == [
        f"{slip} does not end in [{', '.join(bracket(slip))}]"
    ]


def bracket(slip):
    return json.loads(TEXT)["bands"][9]["slips"][slip - 1][:2]


@pytest.mark.parametrize(
    ("share", "excess", "slip", "said"),
    [
        # the contact function rises through 0 at 10.549 too; the slip ends at its first root
        ("0.95", "3.2", ("10.5494", "10.5495", "merges"), "does not end"),
        # it ends at 0.3, above E_cr; a bracket from -6 has a deep slip at both ends
        ("0.5", "0.005", ("-6", "3", "merges"), "does not end"),
        # it ends near 3.3, above E_cr; with the depth of the bracket's upper end alone it would merge
        ("0.6", "1.2", ("3.2", "5", "merges"), "merges is not proved"),
    ],
)
def test_a_slip_that_is_another_one_is_refused(share, excess, slip, said):
    assert said in checker._follow(arb(share), arb(excess), [slip])


def test_a_band_that_stops_before_its_outcome_is_refused():
    """Even where the number of outcomes is made to agree."""

    def stop(data):
        data["bands"][9]["slips"].pop()
        data["outcomes"]["merges"] -= 1

    assert objections(stop)


def test_what_a_bracket_leaves_open_the_next_one_has_to_hold():
    """Both of the gap and of the push; for either of them alone the second bracket is wide enough."""
    slips = [("4.6742", "4.6782", "crosses"), ("1.63764", "1.64984", "opposite"), ("3", "4", "merges")]
    assert checker._follow(arb("0.6"), arb(12), slips) == "slip 2 does not end in [1.63764, 1.64984]"
