"""CONTRIBUTING's worked example of a new claim is what the code does: its row holds, and its faults turn it."""

import re
import sys
import textwrap
from pathlib import Path
from types import ModuleType

import pytest

from paper_checks.checks import registry
from paper_checks.checks.registry import Context, Registry
from paper_checks.evidence.finding import Verdict
from paper_checks.running import runner
from paper_checks.running.planting import planted

TEXT = (Path(__file__).resolve().parents[2] / "CONTRIBUTING.md").read_text("utf-8")
BLOCKS = re.findall(r"^ *```python\n *# (\S+)\.py\n(.*?)^ *```", TEXT, re.DOTALL | re.MULTILINE)


@pytest.fixture
def example(monkeypatch):
    """The files of the example as modules, the check registered in a registry of its own."""
    registry.load_checks()  # before theirs is the only place to register
    checks = Registry(["rest-at-the-edge"])
    monkeypatch.setattr(registry, "check", checks.check)
    for path, block in BLOCKS:
        module = ModuleType(path.replace("/", "."))
        module.__package__ = f"{__package__}.checks" if path.startswith("tests") else module.__name__.rpartition(".")[0]
        monkeypatch.setitem(sys.modules, module.__name__, module)
        exec(textwrap.dedent(block), vars(module))
    return [sys.modules[path.replace("/", ".")] for path, _ in BLOCKS], checks


def test_the_example_s_row_holds_and_each_fault_in_its_formula_turns_it(example):
    (_, ledger, *_), checks = example
    (row,) = runner.run(ledger.RESTING, checks, Context())
    assert row.finding.verdict is Verdict.HOLDS
    assert row.established_by.value == "argument"
    faults = list(planted(ledger.RESTING))
    assert len(faults) > 8
    assert all(one.turned for one in faults)


def test_the_example_s_test_plants_a_fault_that_turns_it(example, monkeypatch):
    (_, _, checks, tests), _ = example

    def plant(target, fault):
        module, _, name = target.rpartition(".")
        assert module == checks.__name__
        monkeypatch.setattr(checks, name, fault(getattr(checks, name)))

    with pytest.raises(AssertionError):
        tests.test_a_wrong_level_turns_the_claim(lambda *_: None)
    tests.test_a_wrong_level_turns_the_claim(plant)
