"""The interactive page, made once."""

import pytest

from paper_checks.explore.page import page


@pytest.fixture(scope="package")
def whole() -> str:
    return page()
