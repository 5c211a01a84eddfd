"""The interactive page, made once, and what it answers in headless Chromium."""

from collections.abc import Callable
from pathlib import Path

import pytest
from chromium import asked

from paper_checks.explore.page import page


@pytest.fixture(scope="package")
def whole() -> str:
    return page()


@pytest.fixture(scope="package")
def ask(whole, tmp_path_factory) -> Callable[..., object]:
    """Return `ask(name, ...)`: what the file of that name, a question, returns on the page; it knows what is given."""

    def answer(name: str, *flags: str, on: str = whole, **given: object) -> object:
        return asked(on, Path(__file__).with_name(f"{name}.js"), tmp_path_factory.mktemp(name), *flags, **given)

    return answer
