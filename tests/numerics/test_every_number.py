"""Every number of a run is within its bound, in every arithmetic and in a batch: against balls of 60 digits or more."""

import pytest
from every_number import compared, unlisted
from hypothesis import given
from reaching import reaching
from strategies import ties


def wrong(scene, arithmetic):
    """The numbers of a run that are not within their bounds."""
    return [one for one in compared(scene, arithmetic)[1] if not one.ratio <= 1.0]


def test_no_number_goes_without_its_comparison():
    assert unlisted() == set()


@pytest.mark.parametrize("arithmetic", ["float64", "double-double", "ball"])
def test_every_number_of_a_tie_is_within_its_bound(arithmetic):
    @reaching
    @given(ties())
    def hold(scene):
        assert wrong(scene, arithmetic) == []

    hold()
