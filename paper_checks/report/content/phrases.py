"""What every form of the report says alike: sections, kinds, outcomes, first sentences."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from paper_checks.claims import claim_named
from paper_checks.decide.kernel import PROVED
from paper_checks.evidence.claim import Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.running.runner import Row

COUNTED = {
    Verdict.HOLDS: ("holds", "hold"),
    Verdict.HOLDS_CORRECTED: ("holds after a correction", "hold after a correction"),
    Verdict.REFUTED: ("is refuted", "are refuted"),
    Verdict.NOT_JUDGED: ("is not judged", "are not judged"),
    Verdict.UNDECIDED: ("is undecided", "are undecided"),
    Verdict.UNCHECKED: ("is unchecked for lack of a tool", "are unchecked for lack of a tool"),
}
_PROVED = {**COUNTED, Verdict.HOLDS: ("is proved", "are proved")}
"""What is said of one claim, or theorem, of a verdict, and of several."""


def headline(rows: Sequence[Row]) -> str:
    """Return how many of the paper's claims, and of the theorems beyond it, have which verdict; statements not judged are no claims."""
    claims = Counter(row.finding.verdict for row in rows if row.claim.kind is Kind.CLAIM)
    theorems = Counter(row.finding.verdict for row in rows if row.claim.kind is Kind.THEOREM)
    left, some = claims.pop(Verdict.NOT_JUDGED, 0), sum(bool(row.open) for row in rows)
    of_paper = [f"Of the paper's {_number(claims, 'claim')} {_verdicts(claims, COUNTED)}"] if claims else []
    if left:
        what = f"statement{'s' if left != 1 else ''} {COUNTED[Verdict.NOT_JUDGED][left != 1]}"
        of_paper.append(f"{left} {'further ' if claims else ''}{what}")
    said = ["; ".join(of_paper)] if of_paper else []
    if theorems:
        paper = "it" if of_paper else "the paper"
        said.append(f"Of {_number(theorems, 'theorem')} beyond {paper} {_verdicts(theorems, _PROVED)}")
    if some:
        said.append(f"{some} {'leaves' if some == 1 else 'leave'} a part open")
    return " ".join(f"{one}." for one in said)


def _number(counted: Counter[Verdict], what: str) -> str:
    return f"{counted.total()} {what}{'s' if counted.total() != 1 else ''}"


def _verdicts(counted: Counter[Verdict], words: Mapping[Verdict, tuple[str, str]]) -> str:
    return listed([f"{counted[one]} {words[one][counted[one] != 1]}" for one in Verdict if counted[one]])


def listed(names: Sequence[str] | dict[str, None]) -> str:
    """Return names as a sentence has them.

    >>> listed(["a", "b", "c"]), listed(["a"]), listed([])
    ('a, b and c', 'a', 'none')
    """
    *most, last = [*names] or ["none"]
    return f"{', '.join(most)} and {last}" if most else last


def formula(row: str, clause: str, name: str) -> str:
    """Return LaTeX of a formula of a row: what stands there is what is checked."""
    found = next(one for one in claim_named(row).clauses if one.id == clause)
    return found.formulas[name].latex


def coded(names: Iterable[str]) -> str:
    """Return names as code, with commas between them."""
    return ", ".join(f"`{name}`" for name in names)


def section_title(name: str) -> str:
    """Return what a section is called: the paper's are numbered.

    >>> section_title("III"), section_title("Theorems")
    ('Section III', 'Theorems')
    """
    return f"Section {name}" if set(name) <= set("IVX") else name


def kind(row: Row) -> str:
    """Return the weakest kind of step that the verdict needs, or a dash; and that the kernel was not run."""
    text = row.established_by.value if row.established_by else "–"
    return text if row.kernel in (None, PROVED) else f"{text} (kernel {row.kernel})"


def in_short(row: Row) -> str:
    """Return the first sentence of a row's reason that says what is true, not how the claim is read."""
    reason = row.finding.reason
    return first_sentence(reason.partition(". ")[2] if reason.startswith("Read as") else reason)


def first_sentence(text: str) -> str:
    """Return the text up to the first full stop that ends a sentence, outside mathematics.

    >>> first_sentence("At t = 4.7 s, i.e. late. Then more.")
    'At t = 4.7 s, i.e. late.'
    >>> first_sentence("With $a. B$ it fails. Then more.")
    'With $a. B$ it fails.'
    """
    head, _, rest = text.partition(". ")
    while rest and _goes_on(head, rest):
        more, _, rest = rest.partition(". ")
        head = f"{head}. {more}"
    return head.rstrip(".") + "."


def _goes_on(head: str, rest: str) -> bool:
    abbreviated = head.endswith(("i.e", "e.g", "cf", "eq", "eqs", "Eq", "Eqs", "Fig"))
    inside = (head.count("$") - head.count(r"\$")) % 2 == 1
    return abbreviated or inside or rest[0].islower()
