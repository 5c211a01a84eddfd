"""The rows as a table on the terminal; plain text where the output is piped."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from textwrap import shorten

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from paper_checks.evidence.claim import Claim
from paper_checks.evidence.evidence import Evidence, Subject
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content.phrases import OUTCOMES, headline, in_short, is_new_theorem, kind, speaker
from paper_checks.report.mathematics.prose import plain
from paper_checks.running.failing import Failure, lowest
from paper_checks.running.runner import Row

STYLES = {
    Verdict.HOLDS: "green",
    Verdict.HOLDS_CORRECTED: "yellow",
    Verdict.REFUTED: "red",
    Verdict.NOT_JUDGED: "cyan",
    Verdict.UNDECIDED: "magenta",
    Verdict.UNCHECKED: "bright_black",
}


SHOWN_FAILURES, SHOWN_CLAIMS, SHOWN_STATEMENT, SHOWN_VALUE = 5, 4, 240, 120
"""How many failing steps are printed first; of each, so many claims by name, and characters of what it says and found."""
ROOM_FOR_PLACES = 8
"""Columns that have to be left for the places; in fewer there would be nothing but dots."""
ROOM_FOR_REASONS = 120
"""Columns from which on the table carries the reasons too; below, it would fold them into ribbons."""


def print_rows(console: Console, rows: Sequence[Row], *, times: bool = False) -> None:
    """Print one row: its whole story. Print several: the table, the findings, and the count of verdicts."""
    _print_failures(console, lowest(rows))
    if len(rows) == 1:
        _print_story(console, rows[0])
    else:
        console.print(_table(rows, console.width, times))
        _print_findings(console, rows)
    differing: dict[str, list[str]] = {}
    for row in rows:
        if not row.as_recorded and row.finding.verdict is not Verdict.UNCHECKED:
            change = f"{row.finding.verdict.value}, recorded {row.claim.recorded.value}"
            differing.setdefault(change, []).append(row.claim.id)
    for change, names in differing.items():
        _say(console, f"differs from the record: {change}: {', '.join(names)}")
    if waiting := [row.claim.id for row in rows if row.finding.verdict is Verdict.UNCHECKED]:
        _say(console, f"unchecked, because a tool is missing: {', '.join(waiting)}")
    if why := _no_kernel(rows):
        _say(console, why)
    _say(console, headline(rows))
    if len(rows) > 1 and (some := [row.claim.id for row in rows if row.open]):
        _say(console, f"part open: {', '.join(some)}")


def _print_failures(console: Console, failures: Sequence[Failure]) -> None:
    """Print the steps that fail first, each once, with the claims that it turns."""
    if failures:
        changed = len({name for one in failures for name in one.claims})
        _say(console, f"{changed} {'claim differs' if changed == 1 else 'claims differ'} from the record.")
    for one in failures[:SHOWN_FAILURES]:
        value = f" [{shorten(plain(one.value), SHOWN_VALUE)}]" if one.value else ""
        turned = f"{len(one.claims)} claim{'s' if len(one.claims) != 1 else ''}"
        named = ", ".join(one.claims[:SHOWN_CLAIMS]) + ", ..." * (len(one.claims) > SHOWN_CLAIMS)
        console.print(
            Text("Fails first: ", "bold red") + Text(f"{shorten(plain(one.statement), SHOWN_STATEMENT)}{value}")
        )
        console.print(Padding(Text(f"turns {turned}: {named}"), (0, 0, 0, 2)))
    if more := len(failures) - SHOWN_FAILURES:
        _say(console, f"{more} more steps fail\n" if more > 0 else "")


def _no_kernel(rows: Sequence[Row]) -> str:
    """Return why the kernel was not run, and what to do, as the first step that wanted it says; empty if it was."""
    steps = (step for row in rows for proof in row.proofs for step in proof.kernel if step.passed is None)
    said, mark, why = next((step.value or "" for step in steps), "").rpartition("kernel not run: ")
    return mark + why if said else ""


def print_claims(console: Console, claims: Sequence[Claim]) -> None:
    """Print the claims with the verdict on record and the place in the paper."""
    table = _empty_table("claim", "recorded")
    table.add_column("where")
    for claim in claims:
        table.add_row(Text(claim.id), _coloured(claim.recorded), _cut(claim.where))
    console.print(table)


def _empty_table(*titles: str) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in titles:
        table.add_column(title, no_wrap=True)
    return table


def _cut(text: str) -> Text:
    """Return text that keeps to one line, however narrow its column is."""
    return Text(text, no_wrap=True, overflow="ellipsis")


def _coloured(verdict: Verdict) -> Text:
    return Text(verdict.value, STYLES[verdict])


def _table(rows: Sequence[Row], width: int, times: bool) -> Table:
    """Ids, verdicts and kinds keep their width; places are cut to what is left, or left out; reasons fold."""
    titles = "claim", "verdict", "established by"
    table = _empty_table(*titles)
    lines = [titles, *((one.claim.id, one.finding.verdict.value, kind(one)) for one in rows)]
    places = width - sum(max(map(len, column)) + 2 for column in zip(*lines, strict=True)) >= ROOM_FOR_PLACES
    if places:
        table.add_column("where", ratio=1)
    reasons = width >= ROOM_FOR_REASONS
    if reasons:
        table.add_column("reason", ratio=3)
    if times:
        table.add_column("seconds", justify="right", no_wrap=True)
    for row in rows:
        cells = [Text(row.claim.id), _coloured(row.finding.verdict), Text(kind(row))]
        cells += [_cut(row.claim.where)] if places else []
        cells += [Text(plain(in_short(row)))] if reasons else []
        cells += [Text(f"{row.seconds:.1f}")] if times else []
        table.add_row(*cells)
    return table


def _print_findings(console: Console, rows: Sequence[Row]) -> None:
    """Print a sentence for each claim that does not simply hold, and for each theorem beyond the paper."""
    console.print()
    for row in rows:
        if row.finding.verdict is not Verdict.HOLDS or is_new_theorem(row):
            reason = plain(in_short(row))
            console.print(Text.assemble((row.claim.id, "bold"), " ", _coloured(row.finding.verdict)))
            console.print(Padding(Text(reason), (0, 0, 0, 2)))
    console.print()


def _print_story(console: Console, row: Row) -> None:
    finding = row.finding
    console.print(Text(row.claim.id, "bold"), Text(finding.verdict.value, STYLES[finding.verdict]))
    texts = {
        speaker(row.claim): row.claim.statement,
        "Hypotheses": row.claim.assuming if is_new_theorem(row) else "",
        "Reason": finding.reason,
        "Corrected": finding.corrected,
        "Counterexample": finding.counterexample,
        "Missing": finding.missing,
    }
    for title, text in texts.items():
        if text:
            _say(console, f"{title}: {plain(text)}")
    for text in row.open:
        _say(console, f"Open: {plain(text)}")
    _say(console, f"Established by: {kind(row)}")
    for proof in row.proofs:
        if proof.counts:
            by = proof.established_by.value if proof.established_by else "open"
            theorems = "".join(f", kernel {name} {proof.kernel_status}" for name in proof.clause.kernel)
            _say(console, f"* {proof.clause.id} ({by}{theorems}): {plain(proof.clause.shown)}")
    for item, subjects in _once(finding.evidence).items():
        value = f" [{plain(item.value)}]" if item.value else ""
        cases = f", {item.cases} cases" if item.cases != 1 else ""
        head = f"- {item.kind.value} ({item.engine}{cases}), {subjects}, {OUTCOMES[item.passed]}: "
        _say(console, head + plain(item.statement) + value)


def _once(evidence: Sequence[Evidence]) -> dict[Evidence, str]:
    """Return each step once, and all that it speaks about: a counterexample and a correction may share it."""
    found: dict[Evidence, list[str]] = {}
    for step in evidence:
        found.setdefault(replace(step, about=Subject.CLAIM, rests_on=()), []).append(step.about.value)
    return {step: " and ".join(dict.fromkeys(subjects)) for step, subjects in found.items()}


def _say(console: Console, text: str) -> None:
    console.print(Text(text))
