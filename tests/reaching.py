"""Properties whose every case is left out assert nothing: they fail.

A case to which a property does not apply raises LeftOut, and `@reaching` above `@given` counts: at least one case of a
run has to come to the end of the test; `--hypothesis-show-statistics` says how many were left out.
"""

import functools
from collections.abc import Callable
from typing import Any

from hypothesis import event


class LeftOut(Exception):
    """The property does not speak of this case."""


def reaching(test: Callable[..., None]) -> Callable[..., None]:
    """Fail a Hypothesis test of which no case came to its end."""
    inner, ends = test.hypothesis.inner_test, []  # type: ignore[attr-defined]

    @functools.wraps(inner)
    def case(*arguments: Any, **named: Any) -> None:
        try:
            inner(*arguments, **named)
        except LeftOut:
            event("left out")
            return
        ends.append(True)

    test.hypothesis.inner_test = case  # type: ignore[attr-defined]

    @functools.wraps(test)
    def counted(*arguments: Any, **named: Any) -> None:
        ends.clear()
        test(*arguments, **named)
        assert ends, f"all cases of {test.__name__} were left out: it asserts nothing"

    return counted
