"""Whether the proof kernel is here; `INERTIAL_PAIR_KERNEL=required` (the continuous integration) allows no fallback."""

import os

import pytest

from paper_checks.proofs import kernel
from paper_checks.proofs.__main__ import main

MISSING = kernel.why_not()


@pytest.fixture(scope="session")  # before what a session compiles once
def needs_kernel():
    if MISSING and os.environ.get("INERTIAL_PAIR_KERNEL") == "required":
        pytest.fail(MISSING)
    if MISSING:
        pytest.skip(MISSING)


@pytest.fixture
def store(tmp_path):
    """A store that holds all that is compiled, and keeps what a test compiles out of the user's cache."""
    folder = tmp_path / "store"
    folder.mkdir()
    for kept in kernel.cache_folder().iterdir():
        if kept.is_dir():
            (folder / kept.name).symlink_to(kept)
    return folder


@pytest.fixture
def command(monkeypatch, ended):
    """Exit code, output and errors of `python -m paper_checks.proofs`."""

    def run(*words):
        monkeypatch.setattr("sys.argv", ["paper_checks.proofs", *map(str, words)])
        return ended(main)

    return run
