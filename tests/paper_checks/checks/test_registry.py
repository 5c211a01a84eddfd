"""Checks register for claims of the ledger only, and are found without being named."""

import importlib

import pytest

from paper_checks.checks import registry as module
from paper_checks.checks.registry import REGISTRY, Registry, load_checks
from paper_checks.errors import LedgerError
from paper_checks.ledger import CLAIMS


def test_an_unknown_claim_is_refused():
    with pytest.raises(LedgerError, match="no claim of the ledger"):
        Registry(["a"]).check("b")(lambda context: None)


def test_a_check_registers_once():
    registry = Registry(["a"])

    def twice(context): ...

    registry.check("a")(twice)
    with pytest.raises(LedgerError, match="twice"):
        registry.check("a")(twice)


def test_several_checks_may_decide_one_claim():
    registry = Registry(["a", "b"])

    def first(context): ...
    def second(context): ...

    assert registry.check("a")(first) is first
    registry.check("a")(second)
    assert registry.of("a") == (first, second)
    assert registry.without_check() == ("b",)


def test_every_module_of_checks_is_imported(monkeypatch, tmp_path):
    (tmp_path / "planted.py").write_text("PLANTED = True\n")
    package = importlib.import_module("paper_checks.checks")
    monkeypatch.setattr(package, "__path__", [str(tmp_path)])
    imported = []
    original = importlib.import_module
    monkeypatch.setattr(module.importlib, "import_module", lambda name: imported.append(name) or original(name))
    assert load_checks() is REGISTRY
    assert "paper_checks.checks.planted" in imported


def test_every_claim_has_a_check():
    assert load_checks().without_check() == ()


def test_the_registry_is_the_ledgers():
    assert all(REGISTRY.of(claim.id) is not None for claim in CLAIMS)
