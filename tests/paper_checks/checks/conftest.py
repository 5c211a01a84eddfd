"""Planting faults in theory, in the steps of an argument, or in what the paper is said to print."""

import importlib
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from paper_checks.evidence import Finding
from paper_checks.ledger import CLAIMS
from paper_checks.registry import Check, Context
from paper_checks.report import mathematics

STEPS = ("paper_checks.steps.", "paper_checks.arguments")


def forget(target: str) -> None:
    """Clear the caches of the steps, and of theory for a fault there: what was derived before must not answer."""
    packages = (*STEPS, "theory.") if target.startswith("theory.") else STEPS
    for name, module in list(sys.modules.items()):
        if name.startswith(packages):
            for member in vars(module).values():
                if hasattr(member, "cache_clear"):
                    member.cache_clear()


@pytest.fixture
def plant() -> Iterator[Callable[..., None]]:
    """Return `plant("module.name", fault)`: the name is replaced by fault(original) in that module."""
    patch = pytest.MonkeyPatch()
    targets: list[str] = []

    def planted(target: str, fault: Callable[[Any], Any]) -> None:
        module_name, name = target.rsplit(".", 1)
        module = importlib.import_module(module_name)
        patch.setattr(module, name, fault(getattr(module, name)))
        targets.append(target)
        forget(target)

    yield planted
    patch.undo()
    for target in targets:
        forget(target)


def finding_of(check: Check) -> Finding:
    """Run a check with the default seed; what it raises, a test sees."""
    return check(Context())


def recorded(claim_id: str) -> str:
    """Return the verdict on record."""
    return {claim.id: claim.recorded.value for claim in CLAIMS}[claim_id]


def unreadable(finding: Finding) -> list[str]:
    """Return the texts of a finding whose mathematics the report could not set."""
    evidence = [text for item in finding.evidence for text in (item.statement, item.value, *item.assumptions)]
    texts = [finding.reason, finding.corrected or "", finding.counterexample or "", *finding.derivation, *evidence]
    return [text for text in texts if "<code>" in mathematics.html(text) or text.count("$") % 2]


# Faults: each takes the original and returns the replacement.


def negated(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong sign."""
    return lambda *arguments, **named: -original(*arguments, **named)


def doubled(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong factor."""
    return lambda *arguments, **named: 2 * original(*arguments, **named)


def squared(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong exponent."""
    return lambda *arguments, **named: original(*arguments, **named) ** 2
