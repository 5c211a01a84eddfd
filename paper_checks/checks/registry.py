"""Which check decides which claim."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from paper_checks.errors import LedgerError
from paper_checks.evidence.finding import Finding
from paper_checks.ledger import CLAIMS


@dataclass(frozen=True)
class Context:
    """What a check is given: the seed of whatever it draws at random."""

    seed: int = 0
    debug: bool = False
    """Whether a check that fails prints its traceback on stderr."""


Check = Callable[[Context], Finding]


class Registry:
    """Checks by the id of the claim that they decide. Several checks may decide one claim together."""

    def __init__(self, ids: Iterable[str]) -> None:
        """Accept checks for these claim ids only."""
        self._checks: dict[str, list[Check]] = {name: [] for name in ids}

    def check(self, claim_id: str) -> Callable[[Check], Check]:
        """Register the decorated function as a check of that claim.

        Raises LedgerError where the ledger has no such claim, or the same function is registered for it twice.
        """

        def register(function: Check) -> Check:
            if claim_id not in self._checks:
                raise LedgerError(f"{_name(function)} checks {claim_id!r}, which is no claim of the ledger")
            if _name(function) in map(_name, self._checks[claim_id]):
                raise LedgerError(f"{_name(function)} checks {claim_id!r} twice")
            self._checks[claim_id].append(function)
            return function

        return register

    def of(self, claim_id: str) -> tuple[Check, ...]:
        """Return the checks of a claim, in the order of registration."""
        return tuple(self._checks[claim_id])

    def without_check(self) -> tuple[str, ...]:
        """Return the ids of the claims that nothing checks."""
        return tuple(name for name, checks in self._checks.items() if not checks)


def _name(function: Check) -> str:
    return f"{function.__module__}.{function.__qualname__}"


REGISTRY = Registry(claim.id for claim in CLAIMS)
check = REGISTRY.check


def load_checks() -> Registry:
    """Import every module of `paper_checks.checks`, each of which registers its checks, and return the registry."""
    package = importlib.import_module("paper_checks.checks")
    for module in sorted(pkgutil.iter_modules(package.__path__), key=lambda module: module.name):
        importlib.import_module(f"{package.__name__}.{module.name}")
    return REGISTRY
