"""How to trust the report: what each kind of step guarantees, what the whole rests on, and where the paper comes from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from importlib.metadata import PackageNotFoundError, version

from paper_checks.claims import source
from paper_checks.decide import kernel
from paper_checks.decide.kernel import PROVED
from paper_checks.evidence.evidence import Evidence, EvidenceKind, closure
from paper_checks.report.content.blocks import Block, Command, Folded, Graph, Node, Paragraph, Points, Section, Table
from paper_checks.report.content.phrases import kind
from paper_checks.running.graph import Proof
from paper_checks.running.runner import Row

SOFTWARE = "inertial-pair"
INSTALL = "python3 -m venv .venv && .venv/bin/python -m pip install -e . && .venv/bin/python -m paper_checks"
"""The first command of the README."""
TRUST, GRAPH, PROVENANCE = "trust", "what-rests-on-what", "provenance"
GUARANTEES = {
    EvidenceKind.KERNEL: (
        "A theorem was proved line by line, and the small kernel of the proof assistant Coq accepted every line.",
        "the kernel, its axioms of the real numbers, and that the theorem says what the row says: its statement is pinned, its "
        "definitions are tied to the formulas of this page",
    ),
    EvidenceKind.SMT: (
        "Two solvers, z3 and cvc5, each found that the negation of a formula in real numbers has no solution; the assumptions "
        "alone have one, so they contradict nothing.",
        "that not both solvers err in the same way",
    ),
    EvidenceKind.EXACT: (
        "An identity was simplified to zero by symbolic algebra, and is zero at rational points that are tried besides.",
        "sympy's algebra",
    ),
    EvidenceKind.ENCLOSURE: (
        "A number was computed with a proved bound of all its errors (a ball), or an inequality at every point of a whole set.",
        "the ball arithmetic of FLINT, and that the program computes what the row says",
    ),
    EvidenceKind.ARGUMENT: (
        "A person wrote the inference down; a reader can follow it in a few lines, and each step that it names is checked.",
        "the reader: nothing but reading checks the inference itself",
    ),
    EvidenceKind.PROPERTY: (
        "A statement was tried on many random cases.",
        "nothing: it stands beside a proof and never counts",
    ),
    EvidenceKind.SIMULATION: ("One trajectory was computed.", "nothing: it stands beside a proof and never counts"),
}
"""What a step of each kind guarantees, and what one has to believe for it."""


def section(rows: Sequence[Row], *, short: bool = False) -> Section:
    """Return how to trust the verdicts; in short, the kinds of steps that can settle one."""
    counts = Counter(row.established_by for row in rows if row.established_by)
    lines = tuple(
        (one.value, what, belief, str(counts[one]) if one.decisive else "–")
        for one, (what, belief) in GUARANTEES.items()
        if one.decisive or not short
    )
    guards = (
        Paragraph(
            "To see which rows those are, choose a kind under “Weakest step”, above the claims of the HTML page."
        ),
        Paragraph("What guards the report against its own errors:"),
        Points(tuple(_guards(rows))),
        Paragraph("To check everything again:"),
        Command("python -m paper_checks run --fresh"),
    )
    return Section(
        TRUST,
        "How to trust it",
        (
            Paragraph(
                "A row is as strong as the weakest step that its verdict needs. The table goes from the strongest kind of step to the "
                "weakest. Samples settle nothing."
            ),
            Table(
                ("kind", "what is guaranteed", "what you have to believe", "rows"),
                lines,
                "Kinds of steps, and rows by their weakest step",
            ),
            *(() if short else guards),
        ),
    )


def _guards(rows: Sequence[Row]) -> Iterable[str]:
    formulas = sum(len(clause.formulas) for row in rows for clause in (*row.claim.clauses, *row.claim.correction))
    yield (
        f"The {formulas} formulas of the clauses are shown and decided from the same expressions. `python -m paper_checks plant` "
        "changes a sign, a factor, an exponent or a relation in every one of them and says whether its row turns."
    )
    yield "Every check is tested with a wrong statement, and has to refuse it."
    yield "The equations (`theory`) and the integrator (`numerics`) do not know each other; their answers are compared."
    yield "Where a tool is missing a row is unchecked, where a check breaks it is undecided: neither is ever a pass."


def graph(rows: Sequence[Row]) -> Section:
    """Return what rests on what: the graph, the theorems of the kernel with their axioms, and each row's clauses."""
    theorems = kernel_theorems(rows)
    blocks: list[Block] = [_graph(rows, theorems)]
    if theorems:
        blocks += [
            Paragraph(_axioms(theorems)),
            Folded(f"The {len(theorems)} theorems of the kernel", (_theorems(rows, theorems),)),
        ]
    lines = tuple((f"`{row.claim.id}`", row.finding.verdict.value, kind(row), _clauses(row)) for row in rows)
    table = Table(("row", "verdict", "established by", "clauses"), lines, "How each row is established")
    return Section(GRAPH, "What rests on what", (*blocks, Folded("Each row, clause by clause", (table,))))


def kernel_theorems(rows: Sequence[Row]) -> dict[str, Evidence]:
    """Return the kernel's theorems that the rows rest on, directly or not, by id."""
    steps = closure(step for row in rows for proof in row.proofs for step in (*proof.kernel, *proof.steps))
    found = {kernel.name_of(step): step for step in steps if step.kind is EvidenceKind.KERNEL}
    return dict(sorted(found.items()))


def anchor(theorem: str) -> str:
    """Return the anchor of a theorem of the kernel."""
    return f"theorem-{theorem}"


def _direct(row: Row) -> list[str]:
    steps = (step for proof in row.proofs for step in closure((*proof.kernel, *proof.steps)))
    below = {one for step in closure(s for proof in row.proofs for s in proof.kernel) for one in step.rests_on}
    names = (kernel.name_of(step) for step in steps if step.kind is EvidenceKind.KERNEL and step not in below)
    return list(dict.fromkeys(names))


def _graph(rows: Sequence[Row], theorems: dict[str, Evidence]) -> Graph:
    nodes = tuple(
        Node(
            row.claim.id,
            row.claim.id,
            row.established_by.value if row.established_by else "open",
            tuple(map(anchor, _direct(row))),
        )
        for row in rows
    )
    used = {one for node in nodes for one in node.below}
    kinds = tuple(dict.fromkeys(node.kind for node in sorted(nodes, key=_rank)))
    steps = tuple(Node(anchor(name), name, "kernel") for name in theorems if anchor(name) in used)
    return Graph(
        nodes,
        steps,
        kinds,
        "Each row on the left rests on the theorems of the proof kernel on the right that its curves lead to; hover over a row "
        "to see its own. The colour of a row is the weakest kind of step that it needs. Every name is a link.",
    )


def _rank(node: Node) -> int:
    order = [one.value for one in EvidenceKind]
    return order.index(node.kind) if node.kind in order else len(order)


def _axioms(theorems: dict[str, Evidence]) -> str:
    axioms = Counter(axiom for step in theorems.values() for axiom in step.assumptions)
    everywhere = [
        axiom for axiom, count in axioms.items() if count == sum(bool(s.assumptions) for s in theorems.values())
    ]
    others = len(axioms) - len(everywhere)
    text = f"All that the kernel takes for granted in these theorems: {', '.join(f'`{axiom}`' for axiom in sorted(everywhere))}"
    numbers = f"; and, for theorems with computed intervals, {others} axioms of machine integers" if others else ""
    return f"{text}{numbers}." if axioms else "The proof kernel was not run here, so its axioms are not listed."


def _theorems(rows: Sequence[Row], theorems: dict[str, Evidence]) -> Table:
    users: dict[str, list[str]] = {}
    for row in rows:
        for name in _direct(row):
            users.setdefault(name, []).append(f"`{row.claim.id}`")
    lines = tuple(
        (
            f"`{name}`",
            step.statement.partition("): ")[2] or step.statement,
            ", ".join(users.get(name, [])) or "–",
        )
        for name, step in theorems.items()
    )
    return Table(
        ("theorem", "what it says", "rows"), lines, "Theorems of the proof kernel", tuple(map(anchor, theorems))
    )


def _clauses(row: Row) -> str:
    return "; ".join(_clause(proof) for proof in row.proofs if proof.steps or proof.kernel) or "–"


def _clause(proof: Proof) -> str:
    by = proof.established_by.value if proof.established_by else "open"
    theorems = ", ".join(f"`{name}`" for name in proof.clause.kernel)
    status = "" if proof.kernel_status in (None, PROVED) else f", kernel {proof.kernel_status}"
    return f"{proof.clause.id}: {by}" + (f" ({theorems}{status})" if theorems else "")


def _version() -> str:
    try:
        return version(SOFTWARE)
    except PackageNotFoundError:
        return "unknown, as it is not installed"


def provenance() -> Section:
    """Return which text was checked, by which version of this software, and how to install that."""
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
        "Provenance",
        (
            Table(("", "of the paper"), lines, "Which text was checked"),
            Paragraph(
                f"It was checked by {SOFTWARE}, version {_version()}. In its directory this installs it (Python 3.11 or later) and checks "
                "every claim; the commands of this page then start with `.venv/bin/python`:"
            ),
            Command(INSTALL),
            Paragraph(
                "`python -m paper_checks source FILE` says whether a file is that text. Sentences are quoted by their place in print; "
                "numbers of equations and figures are those of the printed paper."
            ),
        ),
    )
