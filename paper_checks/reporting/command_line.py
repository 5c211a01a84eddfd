"""The command `report`: rows, figures and chapters to files."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from numerics.trade.recorded import Trade
    from paper_checks.evidence.claim import Claim
    from paper_checks.report.content.blocks import Section
    from paper_checks.report.output.finished import Files
    from paper_checks.report.output.pictures import Undrawn
    from paper_checks.running.runner import Row

# Everything that is not needed for --help is imported where it is used.

USAGE, UNCHECKED = 2, 3


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options of the command."""
    parser.add_argument("ids", nargs="*", metavar="ID", help="rows to report on; all without it (see list)")
    parser.add_argument("--out", type=Path, default=Path("report-out"), metavar="DIR", help="default: %(default)s")
    parser.add_argument(
        "--trade", type=Path, metavar="F", help="output of `python -m numerics trade --json`; default: the shipped one"
    )


def report(
    options: argparse.Namespace,
    claims: Sequence[Claim],
    run: Callable[[Sequence[Claim]], list[Row]],
    complain: Callable[[str], None],
) -> int:
    """Write the report on these claims, which `run` decides, and return the exit code."""
    from numerics.trade.recorded import UnreadableTrade, recorded
    from paper_checks.running.runner import exit_code

    try:
        trade = recorded(options.trade)
    except UnreadableTrade as error:
        complain(str(error))
        return USAGE
    rows = run(claims)
    complaints: list[str] = []
    try:
        path = _written(options, rows, trade, complaints)
    except OSError as error:
        complain(f"the report cannot be written: {error.filename}: {error.strerror}; choose another folder with --out")
        return USAGE
    for complaint in complaints:
        complain(complaint)
    print(path)
    return exit_code(rows) or (UNCHECKED if complaints else 0)


def _written(options: argparse.Namespace, rows: Sequence[Row], trade: Trade, complaints: list[str]) -> Path:
    """Write the report, as it was made before or anew, and return its first page. Raises OSError."""
    from paper_checks.report.output.finished import Finished, name_of, placed

    kept, name = Finished(options.trade) if options.program else None, name_of(rows)
    files = kept.files(name) if kept and not options.fresh else None
    if files is None:
        files = _made(options, rows, trade, complaints)
        if kept and not complaints:
            kept.keep(name, files)
    if kept:
        kept.forget_old()
    return placed(options.out, files)


def _made(options: argparse.Namespace, rows: Sequence[Row], trade: Trade, complaints: list[str]) -> Files:
    """Return the files of the report; why a figure was not drawn is added to the complaints."""
    from numerics.tasks import available_cores
    from paper_checks.claims import CLAIMS
    from paper_checks.report.content.document import document
    from paper_checks.report.formats import html, progress
    from paper_checks.report.output.pictures import drawn, shown
    from paper_checks.reporting import parts
    from paper_checks.speed import section

    report = None if len(rows) == len(CLAIMS) else document(rows)
    figures, chapters = parts.figures(trade), () if report else tuple(map(parts.Chapter, parts.chapters(trade)))
    todo: list[parts.Part] = [*chapters, *map(parts.Drawing, report.pictures if report else figures)]
    found: dict[parts.Part, parts.Made] = {}
    with progress.parts(len(todo)) as told:
        for part, made in parts.made(todo, trade, options.jobs or (available_cores() if options.program else 1)):
            told(part.name)
            found[part] = made
    report = report or document(rows, [cast("Section", found[one]) for one in chapters], section.answers(trade))
    pictures = ((name, found.get(parts.Drawing(name)) or drawn(figures, name)) for name in report.pictures)
    return html.render(report, shown(cast("Iterator[tuple[str, str | Undrawn]]", pictures), complaints.append))


def is_the_source(options: argparse.Namespace, complain: Callable[[str], None]) -> int:
    """Say whether a file is the text that was checked: exit code 0 or 1, or 2 where it cannot be read."""
    from paper_checks.claims import source

    try:
        same = source.is_the_source(options.file)
    except OSError as error:
        complain(f"{options.file} cannot be read: {error.strerror or error}")
        return USAGE
    print(f"{options.file} {'is' if same else 'is not'} the text that was checked (SHA-256 {source.SHA256})")
    return 0 if same else 1
