"""Hypothesis profiles, and the process-wide precisions that every test must leave as it found them."""

import os
from collections.abc import Iterator
from pathlib import Path

import flint
import mpmath
import pytest
from hypothesis import HealthCheck, Phase, settings

# the explain phase traces every line: too slow beneath mpmath
_COMMON = {
    "deadline": None,
    "suppress_health_check": [HealthCheck.too_slow],
    "phases": [Phase.explicit, Phase.reuse, Phase.generate, Phase.shrink],
}
# cases of a property: 15 new ones, after those that failed before; the same 15; the same 1000; 5000 new ones
settings.register_profile("dev", max_examples=15, **_COMMON)
settings.register_profile("landing", max_examples=15, derandomize=True, database=None, **_COMMON)
settings.register_profile("ci", max_examples=1000, derandomize=True, database=None, **_COMMON)
settings.register_profile("nightly", max_examples=5000, **_COMMON)


def pytest_configure(config: pytest.Config) -> None:
    """Load the profile that HYPOTHESIS_PROFILE names, or dev; --hypothesis-profile goes before both."""
    if not config.getoption("--hypothesis-profile"):
        settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Of two processes one begins with half a minute of what needs no compiled code, while the other compiles."""
    items.sort(key=lambda item: "claims/test_faults" not in item.nodeid)


BITS = 53, 53


@pytest.fixture(autouse=True)
def precision_is_left_alone() -> Iterator[None]:
    """flint.ctx.prec and mpmath.mp.prec are global: a test starts at 53 bits and has to end there."""
    flint.ctx.prec, mpmath.mp.prec = BITS
    yield
    left = flint.ctx.prec, mpmath.mp.prec
    flint.ctx.prec, mpmath.mp.prec = BITS
    assert left == BITS, f"precision left at {left} bits (flint, mpmath)"


@pytest.fixture(autouse=True)
def progress_does_not_hang_on_the_clock(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a busy machine a command may take more than the 5 s after which it prints a line of progress."""
    monkeypatch.setattr("numerics.meter._COMMAND", 1e6)


@pytest.fixture
def ended(capsys):
    """Return `ended(main, ...)`: exit code, output and errors of a command."""

    def told(main, *given):
        try:
            code = main(*given)
        except SystemExit as stop:
            code = stop.code
        return code, *capsys.readouterr()

    return told


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Write what was skipped, one test a line, to the file that SKIPPED names, for `pytest @FILE`."""
    if named := os.environ.get("SKIPPED"):
        tests = dict.fromkeys(report.nodeid for report in terminalreporter.stats.get("skipped", []))
        Path(named).write_text("".join(f"{test}\n" for test in tests), "utf-8")
