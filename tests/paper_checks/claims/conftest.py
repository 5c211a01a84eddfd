"""Planting faults in theory, in the steps of an argument, or in what the paper is said to print."""

import importlib
import sys
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.evidence.claim import Claim

CHECKS: dict[str, Claim] = {claim.id: claim for claim in CLAIMS}
"""Each claim by its id."""


@pytest.fixture(autouse=True)
def remembering(the_solvers_remember: None) -> None:
    """A fault that reaches a proof changes the text, so a solver is asked anew."""


def forgetful(patch: pytest.MonkeyPatch, target: str) -> None:
    """Give the steps, and theory for a fault there, empty caches: what was derived before must not answer.

    The full ones come back when the patch is undone, so that the next test does not derive it all again.
    """
    packages = ("paper_checks.claims.", "theory.") if target.startswith("theory.") else ("paper_checks.claims.",)
    emptied: dict[Any, Any] = {}
    modules = [module for name, module in sys.modules.items() if name.startswith(("paper_checks.", "theory."))]
    for module in modules:
        for name, member in list(vars(module).items()):
            if hasattr(member, "cache_clear") and str(member.__module__).startswith(packages):
                emptied.setdefault(member, cache(member.__wrapped__))
                patch.setattr(module, name, emptied[member])


@pytest.fixture
def plant() -> Iterator[Callable[..., None]]:
    """Return `plant("module.name", fault)`: the name is replaced by fault(original) in that module."""
    patch = pytest.MonkeyPatch()

    def planted(target: str, fault: Callable[[Any], Any]) -> None:
        module_name, name = target.rsplit(".", 1)
        module = importlib.import_module(module_name)
        forgetful(patch, target)
        patch.setattr(module, name, fault(getattr(module, name)))

    yield planted
    patch.undo()
