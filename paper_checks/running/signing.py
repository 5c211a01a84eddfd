"""What a person has to read and sign: sentences beside statements of the kernel, and all that a row says."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence

from paper_checks.evidence.claim import Claim
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps
from paper_checks.proofs import signed
from paper_checks.proofs.cited import CITED
from paper_checks.proofs.pins import pinned


def pairs(claims: Iterable[Claim]) -> dict[str, signed.Texts]:
    """Return by key every pair, of the cited theorems that are pinned and of the clauses that the kernel proves, and every row.

    What a row says has no other witness where words are all there is, or where less is said and still true.
    """
    pins, found = pinned(), dict[str, signed.Texts]()
    for one, (_, sentence) in CITED.items():
        if pin := pins.theorems.get(one):
            definitions = {name: pins.definitions[name] for name in pin.definitions}
            found[one] = signed.of_theorem(sentence, pin.statement, definitions)
    for claim in claims:
        clauses = (*claim.clauses, *claim.correction)
        found[f"{claim.id}/"] = (f"{claim.recorded.value}: {claim.where}", *(one.shown for one in clauses), *claim.open)
        for clause in clauses:
            if clause.kernel:
                found[key(claim, clause)] = signed.of_clause(clause.text, clause.kernel)
    return found


def key(claim: Claim, clause: Clause) -> str:
    """Return the key of a clause."""
    return f"{claim.id}/{clause.id}"


def bindings(claim: Claim, clause: Clause) -> Steps:
    """Return what turns a clause whose words were not signed beside its theorems; nothing where they were."""
    if not clause.kernel or signed.is_signed(key(claim, clause), signed.of_clause(clause.text, clause.kernel)):
        return ()
    what = f"the words of the clause {clause.id} were read beside what the theorems {', '.join(clause.kernel)} say"
    value = f"not signed: python -m paper_checks sign {key(claim, clause)}"
    return (Evidence(EvidenceKind.ARGUMENT, "signature", what, None, value=value),)


def sign(claims: Sequence[Claim], keys: Sequence[str]) -> int:
    """Print the pairs of these keys, and sign them; without keys print those that are not signed. Return the exit code."""
    known = pairs(claims)
    if unknown := [one for one in keys if one not in known]:
        print(
            f"unknown key: {', '.join(unknown)}; without a key, the pairs not yet signed are printed", file=sys.stderr
        )
        return 2
    some = keys or [one for one, texts in known.items() if not signed.is_signed(one, texts)]
    for one in some:
        print(one, *(" " + text.replace("\n", "\n ") for text in known[one]), sep="\n")
    if keys:
        signed.sign(known, keys)
    else:
        print(f"{len(known) - len(some)} of {len(known)} pairs are signed")
    return 1 if some and not keys else 0
