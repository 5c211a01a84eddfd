"""The command `report`: rows, figures and chapters to files, in each form that is asked for."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numerics.trade.recorded import Trade
    from paper_checks.evidence.claim import Claim
    from paper_checks.report.content.blocks import Section
    from paper_checks.report.content.document import Document
    from paper_checks.report.output.finished import Files, Finished
    from paper_checks.report.output.pictures import Pictures
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
    parser.add_argument("ids", nargs="*", metavar="ID", help="rows to report on; all without it (see list)")
    parser.add_argument("--out", type=Path, default=Path("report-out"), metavar="DIR", help="default: %(default)s")
    parser.add_argument(
        "--format", type=forms, default=("html",), metavar="F[,F]", help=f"of {', '.join(FORMS)}; default: html"
    )
    parser.add_argument(
        "--steps", action="store_true", help="print all steps in LaTeX and PDF; the HTML pages have them folded"
    )
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
    """Write each form, as it was made before or anew, and return the main files. Raises OSError, ToolMissingError."""
    from paper_checks.report.output.finished import Finished, name_of, placed

    kept = Finished(options.trade) if options.program else None
    names = {form: name_of(rows, form, (options.steps,)) for form in options.format}
    files: dict[str, Files] = {}
    if kept and not options.fresh:
        files = {form: found for form, name in names.items() if (found := kept.files(name)) is not None}
    wanted = [form for form in names if form not in files]
    if wanted:
        from paper_checks.report.output import files as writing  # with it comes matplotlib

        report, pictures = _drawable(options, rows, trade, wanted, complaints, kept)
        for form in wanted:
            made = writing.made(form, report, pictures, options.steps)
            files[form] = made
            if kept and not complaints:
                kept.keep_files(names[form], made)
    if kept:
        kept.forget_old()
    return [placed(options.out, files[form]) for form in names]


def _drawable(
    options: argparse.Namespace,
    rows: Sequence[Row],
    trade: Trade,
    wanted: Sequence[str],
    complaints: list[str],
    kept: Finished | None,
) -> tuple[Document, Pictures]:
    """Return the report, and its figures for the forms that are wanted; what cannot be drawn is added to the complaints."""
    from paper_checks.claims import CLAIMS
    from paper_checks.report.content import document
    from paper_checks.report.output.pictures import Pictures
    from paper_checks.reporting import parts
    from paper_checks.speed import section

    whole = len(rows) == len(CLAIMS)
    figures, chapters = parts.figures(trade), list(parts.chapters(trade)) if whole else []
    report = None if whole else document.document(rows)
    pictures = Pictures(report.pictures if report else list(figures), figures, complaints.append, kept, options.fresh)
    sections = _sections_and_pictures(options, trade, wanted, chapters, pictures)
    report = report or document.document(rows, [sections[name] for name in chapters], section.answers(trade))
    pictures.names = report.pictures
    return report, pictures


def _sections_and_pictures(
    options: argparse.Namespace,
    trade: Trade,
    wanted: Sequence[str],
    chapters: Sequence[str],
    pictures: Pictures,
) -> dict[str, Section]:
    """Make the chapters, which are returned by name, and all figures that are missing for the forms that are wanted."""
    from numerics.tasks import available_cores
    from paper_checks.report.content.blocks import Section
    from paper_checks.report.formats import progress
    from paper_checks.report.output.files import FIGURES_OF
    from paper_checks.reporting import parts

    forms: dict[str, list[str]] = {}
    for form in dict.fromkeys(FIGURES_OF[one] for one in wanted):
        for name in pictures.missing(form):
            forms.setdefault(name, []).append(form)
    todo: list[parts.Part] = [parts.Chapter(name) for name in chapters]
    todo += [parts.Drawing(name, tuple(some)) for name, some in forms.items()]
    sections: dict[str, Section] = {}
    with progress.parts(len(todo)) as told:
        for part, found in parts.made(todo, trade, options.jobs or (available_cores() if options.program else 1)):
            told(part.name)
            if isinstance(found, Section):
                sections[part.name] = found
            else:
                for form, content in found.items():
                    pictures.take(part.name, form, content)
    return sections


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
