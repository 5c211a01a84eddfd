"""The rows as a table on the terminal; plain text where the output is piped."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import shorten

from rich.console import Console
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from paper_checks.evidence.claim import Claim, Kind
from paper_checks.evidence.finding import Verdict
from paper_checks.report.content.blocks import every
from paper_checks.report.content.phrases import headline, in_short, kind
from paper_checks.report.content.told import told
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


def print_rows(console: Console, rows: Sequence[Row], *, times: bool = False) -> None:
    """Print one row: its whole story. Print several: the table, the findings, and the count of verdicts."""
    _print_failures(console, lowest(rows))
    if len(rows) == 1:
        _print_story(console, rows[0])
    else:
        console.print(_table(rows, console.width, times))
        _print_findings(console, rows)
    named: dict[str, list[str]] = {}
    for row in rows:
        verdict = row.finding.verdict
        if verdict is Verdict.UNCHECKED:
            named.setdefault("unchecked, because a tool is missing", []).append(row.claim.id)
        elif not row.as_recorded:
            change = f"differs from the record: {verdict.value}, recorded {row.claim.recorded.value}"
            named.setdefault(change, []).append(row.claim.id)
    for what, names in named.items():
        _say(console, f"{what}: {', '.join(names)}")
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
        _say(console, f"Fails first: {shorten(plain(one.statement), SHOWN_STATEMENT)}{value}")
        named = ", ".join(one.claims[:SHOWN_CLAIMS]) + ", ..." * (len(one.claims) > SHOWN_CLAIMS)
        _say(console, f"  turns {len(one.claims)} claim{'s' * (len(one.claims) != 1)}: {named}")
    if (more := len(failures) - SHOWN_FAILURES) > 0:
        _say(console, f"{more} more steps fail\n")


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
        table.add_row(claim.id, _coloured(claim.recorded), _cut(claim.where))
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
    """Ids, verdicts and kinds keep their width; places are cut to what is left, or left out."""
    titles = "claim", "verdict", "established by"
    lines = [titles, *((one.claim.id, one.finding.verdict.value, kind(one)) for one in rows)]
    places = width - sum(max(map(len, column)) + 2 for column in zip(*lines, strict=True)) >= ROOM_FOR_PLACES
    table = _empty_table(*titles)
    if places:
        table.add_column("where", ratio=1)
    if times:
        table.add_column("seconds", justify="right", no_wrap=True)
    for row in rows:
        cells = [_cut(row.claim.where)] * places + [Text(f"{row.seconds:.1f}")] * times
        table.add_row(row.claim.id, _coloured(row.finding.verdict), kind(row), *cells)
    return table


def _print_findings(console: Console, rows: Sequence[Row]) -> None:
    """Print a sentence for each claim that does not simply hold, and for each theorem beyond the paper."""
    console.print()
    for row in rows:
        if row.finding.verdict is not Verdict.HOLDS or row.claim.kind is Kind.THEOREM:
            console.print(Text.assemble((row.claim.id, "bold"), " ", _coloured(row.finding.verdict)))
            console.print(Padding(Text(plain(in_short(row))), (0, 0, 0, 2)))
    console.print()


def _print_story(console: Console, row: Row) -> None:
    """Print what the page tells of a claim, a step of a table on a line."""
    console.print(Text(row.claim.id, "bold"), _coloured(row.finding.verdict), Text(kind(row)))
    for block in every(told(row)):
        if block.kind == "paragraph":
            _say(console, f"{block.label}: {block.text}" if block.label else block.text)
        elif block.kind == "row":
            _say(console, "- " + " | ".join(item.replace("<br>", "; ") for item in block.items))


def _say(console: Console, text: str) -> None:
    """Print prose with mathematics as plain text."""
    console.print(Text(plain(text.replace("`", ""))))
