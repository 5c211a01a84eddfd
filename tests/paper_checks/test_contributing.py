"""CONTRIBUTING's worked example of a new claim is what the code does: its row holds, and its faults turn it."""

import re
import textwrap
from pathlib import Path

import pytest

from paper_checks.checks import registry
from paper_checks.checks.registry import Context, Registry
from paper_checks.evidence.finding import Verdict
from paper_checks.running import runner
from paper_checks.running.planting import planted

from .checks.conftest import doubled, finding_of

TEXT = (Path(__file__).resolve().parents[2] / "CONTRIBUTING.md").read_text("utf-8")
BLOCKS = [textwrap.dedent(block) for block in re.findall(r"^ *```python\n(.*?)^ *```", TEXT, re.DOTALL | re.MULTILINE)]


@pytest.fixture
def example(monkeypatch):
    """The blocks run one after the other, the check registered in a registry of its own."""
    checks = Registry(["rest-at-the-edge"])
    monkeypatch.setattr(registry, "check", checks.check)
    names = {"doubled": doubled, "finding_of": finding_of}
    for block in BLOCKS:
        exec(block, names)
    return names, checks


def test_the_example_s_row_holds_and_each_fault_in_its_formula_turns_it(example):
    names, checks = example
    claim = names["AT_THE_EDGE"]
    (row,) = runner.run([claim], checks, Context())
    assert row.finding.verdict is Verdict.HOLDS
    assert row.established_by.value == "argument"
    faults = list(planted([claim]))
    assert len(faults) > 8
    assert all(one.turned for one in faults)


def test_the_example_s_test_plants_a_fault_that_turns_it(example):
    names, _ = example
    turns = names["test_a_wrong_level_turns_the_claim"]

    def plant(target, fault):
        name = target.rpartition(".")[2]
        names[name] = fault(names[name])

    with pytest.raises(AssertionError):
        turns(lambda *_: None)
    turns(plant)
