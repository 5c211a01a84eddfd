"""A sentence that is shown and the statement behind it are bound: one that is changed alone turns its rows."""

from dataclasses import replace

import pytest

from paper_checks.__main__ import main
from paper_checks.claims import CLAIMS, claim_named
from paper_checks.decide import kernel
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.finding import Verdict
from paper_checks.proofs import library, pins, signed
from paper_checks.running import signing
from paper_checks.running.runner import Context, decide, row

THEOREM, ROWS = "ring-factor", ("ring-of-tolerance", "tolerance-ring")


@pytest.fixture
def accepting(monkeypatch):
    """A kernel that accepts whatever is pinned, and pins that were changed."""

    def plant(**statements):
        there = pins.pinned()
        changed = {one: replace(there.theorems[one], statement=text) for one, text in statements.items()}
        planted = replace(there, theorems={**there.theorems, **changed})
        for module in (library, signed, signing):
            monkeypatch.setattr(module, "pinned", lambda: planted)
        found = library.build()
        theorems = {name: replace(one, holds=one.holds is not False) for name, one in found.theorems.items()}
        monkeypatch.setattr(kernel, "theorem", theorems.__getitem__)
        kernel.step.cache_clear()
        return found

    monkeypatch.setenv("PATH", "")
    yield plant
    kernel.step.cache_clear()


@pytest.fixture(scope="module")
def findings():
    return {name: decide(claim_named(name), Context()) for name in ROWS}


def weakened():
    """@example of a found fault: 'no smaller factor will do' weakened to 0 <= c in its file, and pinned again."""
    true = pins.pinned().theorems[THEOREM].statement
    weak = true.replace(" (m1 + m2) / (m1 * m2) <= c)", " 0 <= c)")
    assert weak != true
    return weak


def test_all_pairs_that_are_shown_are_signed(capsys):
    assert main(["sign"]) == 0, "read what this prints, then sign it by key"
    known = signing.pairs(CLAIMS)
    assert capsys.readouterr().out == f"{len(known)} of {len(known)} pairs are signed\n"
    assert set(signed.signatures()) == set(known)
    assert {THEOREM, "tolerance-ring/ring"} <= set(known)


def test_a_theorem_that_is_weakened_and_pinned_again_turns_itself_and_its_rows(accepting, findings):
    for turns, statements in ((False, {}), (True, {THEOREM: weakened()})):
        found = accepting(**statements)
        assert [one.id for one in found.theorems.values() if one.holds is False] == [THEOREM] * turns
        assert found.problems == (f"Relative.ring_factor and its sentence were not signed together: "
                                  f"python -m paper_checks sign {THEOREM}",) * turns  # fmt: skip
        for name, finding in findings.items():
            verdict = row(claim_named(name), finding, 0.0).finding.verdict
            assert (verdict is Verdict.UNDECIDED) is turns, name


def test_so_do_a_sentence_and_the_words_of_a_clause_that_are_changed_alone(accepting, findings, monkeypatch):
    accepting()
    claim = claim_named("tolerance-ring")
    said = tuple(replace(one, text=one.text.replace("no smaller", "no larger")) for one in claim.clauses)
    turned = row(replace(claim, said=said), findings[claim.id], 0.0).finding
    assert turned.verdict is Verdict.UNDECIDED
    assert "the words of the clause ring were read beside what the theorems ring-factor say" in turned.reason
    name, sentence = library.CITED[THEOREM]
    monkeypatch.setitem(library.CITED, THEOREM, (name, sentence.replace("no smaller", "no larger")))
    assert accepting().theorem(THEOREM).holds is False


def test_all_that_a_row_says_is_signed():
    """@example of found faults: a bound that is weakened with what derives it, words without a theorem."""
    claim = claim_named("tolerance-ring")
    ring = next(one for one in claim.said if one.id == "ring")
    weaker = replace(ring.formulas["within"], right=2 * ring.formulas["within"].right)
    assert weaker.evidence().passed is True
    less = replace(ring, formulas=ring.formulas | {"within": weaker})
    for changed in (
        {"said": tuple(less if one is ring else one for one in claim.said)},
        {"said": claim.said[:-1]},
        {"correction": (Clause("more", "It is so."),)},
        {"open": ("Nothing.",)},
        {"recorded": Verdict.REFUTED},
    ):
        assert not signed.is_signed("tolerance-ring/", signing.pairs([replace(claim, **changed)])["tolerance-ring/"])


def test_both_sides_are_shown_and_only_what_is_named_is_signed(accepting, monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(signed, "FILE", tmp_path / "signed.json")
    accepting(**{THEOREM: weakened()})
    assert main(["sign", "no-such-pair"]) == 2
    signed.signatures.cache_clear()
    signed.sign({}, ())
    capsys.readouterr()
    assert main(["sign", THEOREM]) == 0
    shown = capsys.readouterr().out
    assert library.CITED[THEOREM][1] in shown
    assert "0 <= c)" in shown
    assert set(signed.signatures()) == {THEOREM}
    assert main(["sign"]) == 1
    signed.signatures.cache_clear()
