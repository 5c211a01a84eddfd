"""How to trust the report: what each kind of step guarantees, what the whole rests on, and where the paper comes from."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence

from paper_checks.claims import source
from paper_checks.evidence.clause import Clause
from paper_checks.evidence.evidence import EvidenceKind
from paper_checks.report.content import citation
from paper_checks.report.content.blocks import Code, Heading, Paragraph, Points, Section, Table
from paper_checks.report.mathematics.prose import Span, pieces
from paper_checks.running.runner import Row

LAW = (
    "All verdicts are under Coulomb's law, with the whole interval $[-b,b]$ as friction while the bodies stick (Filippov's reading). "
    "For $u=0$ that is the paper's system (3), (4); under a force (3), (4) have no solution where a stuck pair stays at the limit $b$ "
    "(`sgn-three-valued`). Section IV uses (11), (12), which leave out the limit $b$: where they allow another motion, the claim says so."
)
INSTALL = "python3 -m venv .venv && .venv/bin/python -m pip install -e '.[checks]' && .venv/bin/python -m paper_checks"
"""The first command of the README."""
TRUST, PROVENANCE = "trust", "provenance"
GUARANTEES = {
    EvidenceKind.KERNEL: (
        "A theorem was proved line by line, and the small kernel of the proof assistant Coq accepted every line.",
        "the kernel, its axioms of the real numbers, and that the theorem says what the claim says: its statement is on record, its "
        "definitions are tied to the formulas of this report",
    ),
    EvidenceKind.SMT: (
        "Two solvers, z3 and cvc5, each found that the negation of a formula in real numbers has no solution; the assumptions "
        "alone have one, so they contradict nothing.",
        "that not both solvers err in the same way",
    ),
    EvidenceKind.EXACT: (
        "Symbolic algebra simplified an identity to zero, and it is zero at rational test points.",
        "sympy's algebra",
    ),
    EvidenceKind.ENCLOSURE: (
        "A number was computed with a proved error bound (a ball), or an inequality at every point of a set.",
        "the ball arithmetic of FLINT, and that the program computes what the claim says",
    ),
    EvidenceKind.ARGUMENT: (
        "A person wrote the inference, in a few lines, and each step that it names is checked.",
        "the reader: nothing but reading checks the inference itself",
    ),
    EvidenceKind.PROPERTY: (
        "A statement was tried on many random cases.",
        "nothing: it supports a proof and never counts",
    ),
    EvidenceKind.SIMULATION: ("One trajectory was computed.", "nothing: it supports a proof and never counts"),
    EvidenceKind.READING: (
        "It is said which formula words of the paper are read as.",
        "the reader: whether that is what the words mean; it carries no claim",
    ),
}
"""What a step of each kind guarantees, and what has to be trusted for it."""


def section(rows: Sequence[Row]) -> Section:
    """Return how to trust the verdicts."""
    counts = Counter(row.established_by for row in rows if row.established_by)
    lines = tuple(
        (one.value, what, belief, str(counts[one]) if one.decisive else "–")
        for one, (what, belief) in GUARANTEES.items()
    )
    return Section(
        TRUST,
        "How to trust it",
        (
            Paragraph(
                "A claim's evidence level is that of the weakest step that its verdict needs. The table goes from the strongest kind to the "
                "weakest. Samples settle nothing."
            ),
            Table(
                ("kind", "what is guaranteed", "what has to be trusted", "claims"),
                lines,
                "Kinds of steps, and claims by their weakest step",
            ),
            Paragraph(LAW),
            Paragraph("How the checks are tested:"),
            Points(tuple(_guards(rows))),
            Paragraph("To check everything again:"),
            Code("python -m paper_checks run"),
        ),
    )


_TYPED = re.compile(r"[=<>]|\\(?:leqslant|geqslant|leq?|geq?|neq?|to|in|notin|approx|sim)(?![A-Za-z])")


def has_typed_relation(clause: Clause) -> bool:
    """Return whether a relation stands in the text of a clause as LaTeX, beside the formulas that are decided."""
    spans = pieces(re.sub("«[^»]*»", "", clause.text))
    return any(_TYPED.search(text) for kind, text in spans if kind is not Span.PROSE)


def _guards(rows: Sequence[Row]) -> Iterable[str]:
    clauses = [clause for row in rows for clause in (*row.claim.clauses, *row.claim.correction)]
    typed = [clause for clause in clauses if has_typed_relation(clause)]
    alone = sum(not clause.kernel for clause in typed)
    yield (
        f"The {sum(len(clause.formulas) for clause in clauses)} formulas of the clauses are shown and decided from the same expressions. Mutation test: `python -m paper_checks plant` "
        "changes a sign, a factor, an exponent or a relation in each of them and says whether its claim fails."
    )
    yield (
        f"{len(typed)} of the {len(clauses)} clauses also contain a relation that is typed, a condition as a rule; {alone} of them name no theorem of "
        "the kernel. There only a reader can confirm that the sentence says what was checked: a misprint in such a relation is not detected."
    )
    yield "Every check is tested with a wrong statement, and must reject it."
    yield "The equations (`theory`) and the integrator (`numerics`) are independent of each other; their answers are compared."
    yield "A claim that needs a missing tool is unchecked, one with a check that raises an error is undecided: neither is a pass."


def provenance() -> Section:
    """Return which text was checked, by which version of this software, how to install that, and how to cite both."""
    lines = (
        ("paper", source.TITLE),
        ("authors", ", ".join(source.AUTHORS)),
        ("version", source.VERSION),
        ("source", f"`{source.FILE}`, SHA-256 `{source.SHA256}`"),
        ("preprint", source.PREPRINT),
        ("DOI", source.DOI),
    )
    return Section(
        PROVENANCE,
        "Provenance and citation",
        (
            Table(("", "of the paper"), lines, "Which text was checked"),
            Paragraph(
                f"It was checked by {citation.SOFTWARE}, version {citation.of_package('Version')}. In its directory this installs it (Python 3.11 or later) "
                "and checks every claim; the commands of this report then start with `.venv/bin/python`:"
            ),
            Code(INSTALL),
            Paragraph(
                "`python -m paper_checks source FILE` says whether a file is that text. Sentences are quoted by their place in print; "
                "numbers of equations and figures are those of the printed paper."
            ),
            Heading("How to cite"),
            Code(citation.bibtex()),
        ),
    )
