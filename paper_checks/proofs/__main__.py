"""`python -m paper_checks.proofs [check | pin | list | F.v [--out DIR]]`: compile the proofs and compare the statements with
the recorded ones; record the statements; list the theorems; check a proof file written by `python -m numerics solve --proof
F.v`, or write it with all files that it requires into an empty folder, where plain coqc checks it."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from numerics.exits import USAGE, OneLineParser, refuse
from paper_checks import atomic
from paper_checks.proofs import cited, library, submitted
from paper_checks.proofs.pins import PINS, Pin, Pins, pinned, written


def main() -> int:
    """Run a command; 0 if all is proved (as pinned), 1 if something is not, 2 for bad usage, 3 without the kernel."""
    parser = OneLineParser(prog="python -m paper_checks.proofs", description=__doc__)
    parser.add_argument(
        "command", nargs="?", default="check", help="check, pin, list, or a proof file (its name ends in .v)"
    )
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="files compiled in parallel (2)")
    out = (
        "for a proof file: write it with all files that it requires into this empty folder, and print the coqc commands"
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help=out)
    options = parser.parse_args()
    if options.out and not options.command.endswith(".v"):
        parser.error(f"--out is for a proof file, whose name ends in .v, not for {options.command}")
    if options.command.endswith(".v"):
        return (
            _write(Path(options.command), options.out) if options.out else _judge(Path(options.command), options.jobs)
        )
    if options.command not in ("check", "pin", "list"):
        parser.error(f"{options.command!r} is not check, pin, list or a proof file, whose name ends in .v")
    if options.command == "list":
        for one, (name, sentence) in cited.CITED.items():
            print(f"{one:28} {name:34} {sentence}")
        return 0
    return _pin(options.jobs) if options.command == "pin" else _check(options.jobs)


def _write(path: Path, folder: Path) -> int:
    try:
        print(submitted.write(path, folder))
    except UnicodeDecodeError:
        return refuse(f"cannot read {path}: it is not UTF-8 text", USAGE)
    except OSError as error:
        return refuse(f"{error.filename}: {error.strerror}", USAGE)
    except ValueError as error:
        return refuse(str(error), USAGE)
    return 0


def _judge(path: Path, jobs: int) -> int:
    began = time.monotonic()
    try:
        found = submitted.judged(path, jobs=jobs)
    except (OSError, UnicodeDecodeError) as error:
        return refuse(f"cannot read {path}: {getattr(error, 'strerror', None) or 'it is not UTF-8 text'}", USAGE)
    if found.holds is None:
        print(f"unchecked: {found.reason}", file=sys.stderr)
        return 3
    if not found.holds:
        print(f"refused: {found.reason}", file=sys.stderr)
        return 1
    print(f"accepted: {found.reason}; {time.monotonic() - began:.1f} s")
    return 0


def _progress(done: int, total: int, name: str) -> None:
    print(f"{done:3}/{total} {name}", file=sys.stderr)


def _check(jobs: int) -> int:
    began = time.monotonic()
    built = library.build(_progress if sys.stderr.isatty() else None, jobs)
    if not built.ran:
        print(built.kernel, file=sys.stderr)
        return 3
    proved = sum(one.holds is True for one in built.theorems.values())
    print(f"{built.kernel}: {proved} of {len(built.theorems)} theorems proved as pinned, ", end="")
    print(f"{built.compiled_anew} files compiled, {time.monotonic() - began:.1f} s")
    for problem in built.problems:
        print(problem, file=sys.stderr)
    return 1 if built.problems else 0


def _pin(jobs: int) -> int:
    """Pin what the kernel prints now; refuses while anything is wrong that a pin cannot mend."""
    from paper_checks.proofs import ties

    told = {tie.name: tie.words for tie in ties.ties()}
    atomic.write(PINS, written(Pins(pinned().theorems, pinned().definitions, told, {})))
    pinned.cache_clear()
    library.names.cache_clear()
    built = library.build(_progress, jobs)
    if not built.ran:
        print(built.kernel, file=sys.stderr)
        return 3
    broken = [line for line in built.problems if "pinned" not in line]
    theorems = built.theorems.values()
    if broken or not all(one.statement for one in theorems):
        print("\n".join(["not pinned:", *broken]), file=sys.stderr)
        return 1
    atomic.write(
        PINS,
        written(
            Pins(
                {one.id: Pin(one.statement, tuple(one.definitions), one.uses) for one in theorems},
                {name: text for one in theorems for name, text in one.definitions.items()},
                told,
                {one.id: _named(one) for one in theorems if one.id.startswith("tie-")},
            )
        ),
    )
    print(f"{len(theorems)} theorems pinned")
    return 0


def _named(tie: library.Proved) -> tuple[str, ...]:
    return tuple(name for name in tie.definitions if name in tie.statement)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        sys.exit(130)
