"""Every number of a run is within its bound, in every arithmetic and in a batch: against balls of 60 digits or more."""

import pytest
from every_number import compared, unlisted
from hypothesis import given
from reaching import reaching
from strategies import extreme_scenes, ties


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


ON_A_LINE = sorted(extreme_scenes.keys() - {"ellipsoid", "box", "friction of the state"})


@pytest.mark.long
@pytest.mark.parametrize("arithmetic", ["float64", "ball"])
@pytest.mark.parametrize("kind", ON_A_LINE)
def test_every_number_of_a_scene_at_the_extremes_is_within_its_bound(kind, arithmetic):
    @reaching
    @given(extreme_scenes[kind])
    def hold(scene):
        assert wrong(scene, arithmetic) == []

    hold()
