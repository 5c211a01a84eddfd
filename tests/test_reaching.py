"""A property of which every case is left out fails; one that a single case reaches does not; and how many are tried."""

import os

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reaching import LeftOut, reaching


@reaching
@given(st.integers(0, 3))
def never_there(n):
    raise LeftOut


@reaching
@given(st.sampled_from([0, 1]))
def sometimes_there(n):
    if n == 0:
        raise LeftOut


@reaching
@given(st.integers(0, 3))
def false(n):
    assert n > 5


def test_what_asserts_nothing_fails():
    sometimes_there()
    with pytest.raises(AssertionError, match="left out"):
        never_there()


def test_what_is_false_still_fails():
    with pytest.raises(AssertionError, match="assert 0 > 5"):
        false()


def test_the_profile_that_is_asked_for_is_the_one_that_runs(pytestconfig):
    asked = pytestconfig.getoption("--hypothesis-profile") or os.environ.get("HYPOTHESIS_PROFILE", "dev")
    assert settings.default.max_examples == settings.get_profile(asked).max_examples
