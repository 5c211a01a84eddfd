"""The command `report`: rows, figures and chapters to files, in each form that is asked for."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from numerics.exits import path

if TYPE_CHECKING:
    from numerics.trade.recorded import Trade
    from paper_checks.evidence.claim import Claim
    from paper_checks.report.content.document import Document
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
    try:
        lost = _write(options, rows, trade)
    except OSError as error:
        complain(f"the report cannot be written: {error.filename}: {error.strerror}; choose another folder with --out")
        return USAGE
    except ToolMissingError as error:
        complain(str(error))
        return UNCHECKED
    for reason in lost:
        complain(reason)
    return exit_code(rows) or (UNCHECKED if lost else 0)


def _write(options: argparse.Namespace, rows: Sequence[Row], trade: Trade) -> list[str]:
    """Write each form, print its main file, and return why figures were not drawn. Raises OSError, ToolMissingError."""
    from numerics.tasks import available_cores
    from paper_checks import atomic
    from paper_checks.claims import CLAIMS
    from paper_checks.report.content.document import document, paper
    from paper_checks.report.formats import progress
    from paper_checks.report.output.pictures import Drawing, made  # with it comes matplotlib

    whole = trade if len(rows) == len(CLAIMS) else None
    reports = {form: document(rows, whole) if form == "html" else paper(rows) for form in options.format}
    kinds = {form: "svg" if form == "html" else "pdf" for form in reports}
    wanted = dict.fromkeys(Drawing(name, kinds[form]) for form, one in reports.items() for name in one.pictures)
    found: dict[Drawing, bytes] = {}
    lost: dict[str, None] = {}
    with progress.steps(len(wanted)) as step:
        for one, drawn in made([*wanted], trade, options.jobs or (available_cores() if options.program else 1)):
            step(one.name, 1, "")
            if isinstance(drawn, bytes):
                found[one] = drawn
            else:
                lost[drawn] = None
    for form, told in reports.items():
        drawings = ((name, found.get(Drawing(name, kinds[form]))) for name in told.pictures)
        files = written(form, told, {name: content for name, content in drawings if content})
        for file, text in files.items():
            atomic.write(options.out / file, text)
        print(options.out / [*files][-1])
    return [*lost]


def written(form: str, report: Document, figures: Mapping[str, bytes]) -> Mapping[str, bytes | str]:
    """Return the files of one of the forms, the main one last. Raises ToolMissingError for a PDF without TeX."""
    from paper_checks.report.formats import html, latex

    if form == "html":
        return html.render(report, {name: content.decode() for name, content in figures.items()})
    names = {one: f"figures/{one}.pdf" for one in figures}
    drawn = {names[one]: content for one, content in figures.items()}
    text = latex.render(report, names)
    return {"report.pdf": latex.typeset(text, drawn)[0]} if form == "pdf" else {**drawn, "report.tex": text}


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
