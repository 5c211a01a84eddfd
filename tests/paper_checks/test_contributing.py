"""CONTRIBUTING's worked example of a new claim is what the code does: its row holds, and its faults turn it."""

import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

from paper_checks.claims import in_order
from paper_checks.evidence.finding import Verdict
from paper_checks.running.planting import planted
from paper_checks.running.rows import rows
from paper_checks.running.runner import Context

TEXT = (Path(__file__).resolve().parents[2] / "CONTRIBUTING.md").read_text("utf-8")
BLOCKS = re.findall(r"^```python\n# (\S+)\.py\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


@pytest.fixture
def example(monkeypatch):
    """The file of the example as a module."""
    ((path, block),) = BLOCKS
    module = ModuleType(path.replace("/", "."))
    monkeypatch.setitem(sys.modules, module.__name__, module)
    exec(block, vars(module))
    return module


def test_the_example_s_row_holds_and_each_fault_in_its_formula_turns_it(example):
    claims = in_order(vars(example).values())
    (row,) = rows(claims, Context())
    assert row.finding.verdict is Verdict.HOLDS
    assert row.established_by.value == "argument"
    faults = list(planted(claims))
    assert len(faults) > 8
    assert all(one.turned for one in faults)


def test_a_fault_in_the_example_s_step_turns_its_row(example, monkeypatch):
    level = example.critical_energy()
    monkeypatch.setattr(example, "critical_energy", lambda: 2 * level)
    assert example.rest_at_the_edge.decide().verdict is Verdict.UNDECIDED
