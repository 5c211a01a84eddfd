# PYTHON_ARGCOMPLETE_OK
"""The command line: `python -m paper_checks [run] [ID ...]`, `list`, `report`, `plant`, `source`."""

from __future__ import annotations

import argparse
import difflib
import gc
import importlib.util
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from numerics.exits import (
    OneLineParser,
    Version,
    complete,
    drop_output,
    missing,
    open_streams,
    path,
    program_name,
    wrong_folder,
    wrong_path,
)
from numerics.shown import console
from paper_checks.report.output import command_line

if TYPE_CHECKING:
    from paper_checks.evidence.claim import Claim
    from paper_checks.running.runner import Row

# Everything that is not needed for --help is imported where it is used: sympy and the solvers take seconds.

SCRIPT = "inertial-pair-checks"
COMMANDS = ("run", "list", "report", "explore", "plant", "source")
USAGE, UNCHECKED, INTERRUPTED = 2, 3, 130
EPILOGUE = (
    "Exit codes: 0 every verdict is as recorded; 1 a verdict differs; 2 usage; "
    "3 something stays unchecked, because a tool or a figure is missing."
)


def main(arguments: Sequence[str] | None = None, *, program: bool = False) -> int:
    """Run a command and return the exit code.

    As a program, verdicts come from several processes; called from Python, from this one.
    """
    open_streams()
    words = list(sys.argv[1:] if arguments is None else arguments)
    if not words or words[0] not in (*COMMANDS, "-h", "--help", "--version"):
        words.insert(0, "run")
    parser = _parser()
    complete(parser)
    options = parser.parse_args(words, argparse.Namespace(program=program))
    if program:
        # some thousand short scenes: Python solves them, to the same bits, before numba has come or compiled anything
        os.environ.setdefault("NUMBA_DISABLE_JIT", "1")
        # sympy remembers a thousand answers of each of its functions; with more, rows take a tenth less
        os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
        # most expressions go by themselves: looking for the others takes a twentieth
        gc.set_threshold(2_000_000, 20, 20)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    for module in (
        "sympy",
        "rich",
        "math_core",
        *(("matplotlib", "jinja2") if options.command in (_report, _explore) else ()),
    ):
        if importlib.util.find_spec(module) is None:  # before anything is decided
            _complain(missing(module))
            return UNCHECKED
    try:
        code: int = options.command(options)
        sys.stdout.flush()
    except KeyboardInterrupt:
        _complain("interrupted")
        return INTERRUPTED
    except BrokenPipeError:
        drop_output()  # the reader has gone
        return 0
    except OSError as error:
        if error.filename is None:
            drop_output()
        _complain(f"cannot read or write {error.filename or 'the output'}: {error.strerror or error}")
        return USAGE
    except ModuleNotFoundError as error:
        if error.name is None or error.name.split(".")[0] in {"paper_checks", "numerics", "theory"}:
            raise
        _complain(missing(error.name))
        return UNCHECKED
    return code


def script() -> int:
    """Run as the installed program."""
    code = main(program=True)
    gc.freeze()  # the system takes all memory back: looking through it once more before takes a twentieth
    return code


def _parser() -> argparse.ArgumentParser:
    parser = OneLineParser(
        prog=program_name(SCRIPT, "paper_checks"),
        description="Check every claim of the paper. Without a command: run.",
        epilog=EPILOGUE,
    )
    parser.add_argument("--version", action=Version, nargs=0, help="print the version and exit")
    commands = parser.add_subparsers(required=True, metavar="{run,list,report,explore,plant,source}")
    run = commands.add_parser("run", help="check the claims, print verdicts and evidence", epilog=EPILOGUE)
    run.add_argument("ids", nargs="*", metavar="ID", help="claims to check (see list); default: all")
    run.add_argument("--json", action="store_true", help="print a JSON list")
    run.add_argument("--times", action="store_true", help="show how long each claim took")
    run.set_defaults(command=_run)
    claims = commands.add_parser("list", help="list the claims with the recorded verdict")
    claims.add_argument("--json", action="store_true", help="print a JSON list")
    claims.set_defaults(command=_list)
    report = commands.add_parser("report", help="write the report", epilog=EPILOGUE)
    command_line.add_arguments(report)
    report.set_defaults(command=_report)
    explore = commands.add_parser("explore", help="write the interactive page")
    explore.add_argument(
        "--out",
        type=path,
        default="explore.html",
        metavar="F",
        help="file to write; default: %(default)s",
    )
    explore.set_defaults(command=_explore)
    plant = commands.add_parser(
        "plant", help="mutation tests: change every formula of every clause, and count the claims that fail"
    )
    plant.add_argument("ids", nargs="*", metavar="ID", help="claims to test; default: all")
    plant.set_defaults(command=_plant)
    source = commands.add_parser("source", help="check whether a file is the text of the paper that was checked")
    source.add_argument("file", type=path, metavar="FILE")
    source.set_defaults(command=_source)
    for command in (run, report):
        command.add_argument(
            "--seed", type=int, default=0, metavar="N", help="seed of the random test points; default: %(default)s"
        )
        command.add_argument("--jobs", type=_number, metavar="N", help="number of processes; default: one per core")
        command.add_argument("--debug", action="store_true", help="print the traceback of a check that fails")
    return parser


def _number(text: str) -> int:
    """Read a number of processes."""
    if not (text.isascii() and text.isdigit() and len(text) < 5 and int(text) > 0):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from 1 to 9999")
    return int(text)


def _run(options: argparse.Namespace) -> int:
    from paper_checks.running.runner import exit_code

    claims = _chosen(options.ids)
    if claims is None:
        return USAGE
    rows = _rows(claims, options)
    if options.json:
        from paper_checks.report.formats import json

        sys.stdout.write(json.render(rows))
    else:
        from paper_checks.report.formats.terminal import print_rows

        print_rows(console(None), rows, times=options.times)
    return exit_code(rows)


def _list(options: argparse.Namespace) -> int:
    from paper_checks.claims import CLAIMS

    if options.json:
        from paper_checks.report.formats import json

        sys.stdout.write(json.render_claims(CLAIMS))
    else:
        from paper_checks.report.formats.terminal import print_claims

        # in a pipe no line is broken: grep reads lines
        print_claims(console(None if sys.stdout.isatty() else 1000), CLAIMS)
    return 0


def _plant(options: argparse.Namespace) -> int:
    from paper_checks.running.planting import places, planted

    claims = _chosen(options.ids)
    if claims is None:
        return USAGE
    formulas, found = list(places(claims)), list(planted(claims))
    for one in found:
        if not one.turned:
            print(f"{one.claim}, clause {one.clause}: still passes with a changed {one.fault}: {one.latex}")
    turned = sum(one.turned for one in found)
    print(f"{turned} of {len(found)} mutations made their claim fail: {len(formulas)} formulas of {len(claims)} claims")
    return 0 if turned == len(found) else 1


def _report(options: argparse.Namespace) -> int:
    if (wrong := wrong_folder(options.out)) is not None:
        _complain(f"the report cannot be written: {wrong} with --out")
        return USAGE
    claims = _chosen(options.ids)
    if claims is None:
        return USAGE
    return command_line.report(options, claims, lambda some: _rows(some, options), _complain)


def _source(options: argparse.Namespace) -> int:
    return command_line.is_the_source(options, _complain)


def _explore(options: argparse.Namespace) -> int:
    if (wrong := wrong_path(options.out) if options.out.is_dir() else wrong_folder(options.out.parent)) is not None:
        _complain(f"the page cannot be written: {wrong}")
        return USAGE
    from paper_checks import atomic
    from paper_checks.explore.page import page

    try:
        atomic.write(options.out, page())
    except OSError as error:
        _complain(f"the page cannot be written: {error.filename}: {error.strerror}; choose another file with --out")
        return USAGE
    print(options.out)
    return 0


def _chosen(ids: Sequence[str]) -> tuple[Claim, ...] | None:
    """Return the claims with these ids in the paper's order; None, with one line on stderr, if an id is unknown."""
    from paper_checks.claims import CLAIMS

    known = [claim.id for claim in CLAIMS]
    for name in ids:
        if name not in known:
            others = [one for one in (*known, *COMMANDS) if one != name]
            near = difflib.get_close_matches(name, others, n=3, cutoff=0.6)
            hint = f"did you mean {', '.join(near)}?" if near else "`list` prints the ids"
            _complain(f"unknown claim {name!r}; {hint}")
            return None
    return tuple(claim for claim in CLAIMS if not ids or claim.id in ids)


def _rows(claims: Sequence[Claim], options: argparse.Namespace) -> list[Row]:
    """Return what was found about each claim, with progress on stderr."""
    from numerics.files import cache_refused
    from numerics.tasks import available_cores
    from paper_checks.report.formats.progress import progress
    from paper_checks.running.rows import rows
    from paper_checks.running.runner import Context

    if options.program and (refused := cache_refused()):
        _complain(refused)
    jobs = options.jobs or (available_cores() if options.program else 1)
    with progress(len(claims)) as shown:
        return rows(claims, Context(options.seed, options.debug), jobs, shown)


def _complain(message: str) -> None:
    print(f"error: {message}", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(script())
