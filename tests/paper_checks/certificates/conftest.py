"""The checker works with more bits than a test begins with."""

from collections.abc import Iterator

import flint
import pytest


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    before, flint.ctx.prec = flint.ctx.prec, 400
    yield
    flint.ctx.prec = before
