"""Planting faults in theory, in the steps of an argument, or in what the paper is said to print."""

import importlib
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import Any

import pytest

from paper_checks.claims import CLAIMS
from paper_checks.decide import smt
from paper_checks.evidence.claim import Claim
from paper_checks.evidence.finding import Finding
from paper_checks.report.mathematics import prose

CHECKS: dict[str, Claim] = {claim.id: claim for claim in CLAIMS}
"""Each claim by its id."""


ask_once = cache(smt.ask)


@pytest.fixture(autouse=True)
def the_solvers_remember(monkeypatch: pytest.MonkeyPatch) -> None:
    """A solver is asked the same text once: a fault that reaches a proof changes the text, so it is asked anew."""
    monkeypatch.setattr(smt, "ask", ask_once)


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


def two_of_each(faults: Sequence[tuple[Any, ...]]) -> list[Any]:
    """The first two faults of each claim for every run, the others for the long one."""
    seen = Counter[str]()
    marked = []
    for fault in faults:
        seen[fault[0]] += 1
        marked.append(fault if seen[fault[0]] < 3 else pytest.param(*fault, marks=pytest.mark.long))
    return marked


def finding_of(claim: Claim) -> Finding:
    """Decide a claim with the default seed; what is raised, a test sees."""
    return claim.decide()


def recorded(claim_id: str) -> str:
    """Return the verdict on record."""
    return {claim.id: claim.recorded.value for claim in CLAIMS}[claim_id]


def unreadable(finding: Finding) -> list[str]:
    """Return the texts of a finding whose mathematics the report could not set."""
    evidence = [text for item in finding.evidence for text in (item.statement, item.value, *item.assumptions)]
    texts = [finding.reason, finding.corrected or "", finding.counterexample or "", *finding.derivation, *evidence]
    return [text for text in texts if "<code>" in prose.html(text) or text.count("$") % 2]


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


def halved(original: Callable[..., Any]) -> Callable[..., Any]:
    """A wrong factor, on the other side."""
    return lambda *arguments, **named: original(*arguments, **named) / 2


def other_sign(original: Callable[..., Any]) -> Callable[..., Any]:
    """The field, rate or branch of the other half-space."""
    return lambda sign, *arguments, **named: original(-sign, *arguments, **named)


def plus(term: Any) -> Callable[..., Any]:
    """Return a fault that adds a term to a scalar."""
    return lambda original: lambda *arguments, **named: original(*arguments, **named) + term


def without(*symbols: Any) -> Callable[..., Any]:
    """Return a fault that drops the terms with these symbols."""
    return lambda original: lambda *arguments, **named: original(*arguments, **named).subs(dict.fromkeys(symbols, 0))


class Misread:
    """Sympy with one relation read as another, such as `<` for `<=`, in some of its uses."""

    def __init__(self, original: Any, relation: str, read_as: str, uses: tuple[int, ...]) -> None:
        """Misread the relation in these uses, counted from 0; in all, where none is named."""
        self._original, self._relation, self._read_as, self._uses = original, relation, read_as, uses
        self._seen = -1

    def __getattr__(self, name: str) -> Any:
        """Sympy's, but for that relation."""
        if name == self._relation:
            self._seen += 1
            name = self._read_as if not self._uses or self._seen in self._uses else name
        return getattr(self._original, name)


def misread(relation: str, read_as: str, *uses: int) -> Callable[..., Any]:
    """Return the fault for a module's name `sp`."""
    return lambda original: Misread(original, relation, read_as, uses)
