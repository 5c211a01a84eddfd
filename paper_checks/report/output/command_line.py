"""The command `report`: rows, figures and chapters to files, in each form that is asked for."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from numerics.exits import path

if TYPE_CHECKING:
    from pathlib import Path

    from numerics.trade.recorded import Trade
    from paper_checks.evidence.claim import Claim
    from paper_checks.report.output.files import Files
    from paper_checks.running.runner import Row

# Everything that is not needed for --help is imported where it is used.

FORMS = ("html", "latex", "pdf")
USAGE, UNCHECKED = 2, 3


def forms(text: str) -> tuple[str, ...]:
    """Read forms that are separated by commas; raises ArgumentTypeError for any other word.

    >>> forms("html,pdf")
    ('html', 'pdf')
    """
    words = tuple(dict.fromkeys(word.strip() for word in text.split(",")))
    for word in words:
        if word not in FORMS:
            raise argparse.ArgumentTypeError(f"{word!r} is none of {', '.join(FORMS)}; separate several by commas")
    return words


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options of the command."""
    parser.add_argument("ids", nargs="*", metavar="ID", help="claims to report on (see list); default: all")
    parser.add_argument(
        "--out", type=path, default="report-out", metavar="DIR", help="folder to write; default: %(default)s"
    )
    parser.add_argument(
        "--format", type=forms, default=("html",), metavar="F[,F]", help=f"formats: {', '.join(FORMS)}; default: html"
    )
    parser.add_argument(
        "--trade",
        type=path,
        metavar="F",
        help="measurement by `python -m numerics trade --json`; default: the shipped one",
    )


def report(
    options: argparse.Namespace,
    claims: Sequence[Claim],
    run: Callable[[Sequence[Claim]], list[Row]],
    complain: Callable[[str], None],
) -> int:
    """Write the report on these claims, which `run` decides, and return the exit code."""
    from numerics.trade.recorded import UnreadableTrade, recorded
    from paper_checks.errors import ToolMissingError
    from paper_checks.report.formats import latex
    from paper_checks.running.runner import exit_code

    try:
        trade = recorded(options.trade)
    except UnreadableTrade as error:
        complain(str(error))
        return USAGE
    if "pdf" in options.format and (remedy := latex.missing()):
        complain(remedy)
        return UNCHECKED
    rows = run(claims)
    complaints: list[str] = []
    try:
        paths = _written(options, rows, trade, complaints)
    except OSError as error:
        complain(f"the report cannot be written: {error.filename}: {error.strerror}; choose another folder with --out")
        return USAGE
    except ToolMissingError as error:
        complain(str(error))
        return UNCHECKED
    for complaint in complaints:
        complain(complaint)
    print(*paths, sep="\n")
    return exit_code(rows) or (UNCHECKED if complaints else 0)


def _written(options: argparse.Namespace, rows: Sequence[Row], trade: Trade, complaints: list[str]) -> list[Path]:
    """Write each form, and return the main files. Raises OSError, ToolMissingError."""
    from paper_checks.report.output.files import placed

    return [placed(options.out, made) for made in _made(options, rows, trade, complaints)]


def _made(options: argparse.Namespace, rows: Sequence[Row], trade: Trade, complaints: list[str]) -> Iterator[Files]:
    """Yield the files of each form that is wanted; why a figure was not drawn is added to the complaints."""
    from numerics.tasks import available_cores
    from paper_checks.claims import CLAIMS
    from paper_checks.report.content import speed, under_a_force
    from paper_checks.report.content.document import document
    from paper_checks.report.formats import progress
    from paper_checks.report.output import files, pictures  # with them comes matplotlib

    whole = "html" in options.format and len(rows) == len(CLAIMS)  # chapters are pages only
    chapters = [under_a_force.section(), speed.section(trade)] if whole else []
    report = document(rows, chapters, [*speed.answers(trade)] if whole else [])
    names = {form: files.shown_in(form, report) for form in options.format}
    drawings = dict.fromkeys(pictures.Drawing(name, files.FIGURES_OF[form]) for form in names for name in names[form])
    found: dict[pictures.Drawing, bytes | pictures.Undrawn] = {}
    with progress.figures(len(drawings)) as told:
        jobs = options.jobs or (available_cores() if options.program else 1)
        for one, made in pictures.made([*drawings], trade, jobs):
            told(one.name)
            found[one] = made
    for form, some in names.items():
        drawn = {name: found[pictures.Drawing(name, files.FIGURES_OF[form])] for name in some}
        yield files.made(form, report, pictures.shown(drawn, complaints))


def is_the_source(options: argparse.Namespace, complain: Callable[[str], None]) -> int:
    """Say whether a file is the text that was checked: exit code 0 or 1, or 2 where it cannot be read."""
    from paper_checks.claims import source

    try:
        same = source.is_the_source(options.file)
    except OSError as error:
        complain(f"{options.file} cannot be read: {error.strerror or error}")
        return USAGE
    print(
        f"{options.file} {'is' if same else 'is not'} the text of the paper that was checked (SHA-256 {source.SHA256})"
    )
    return 0 if same else 1
