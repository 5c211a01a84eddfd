"""`python -m paper_checks.proofs [check | audit | list | F.v [--out DIR]]`: compile the proofs and compare what the kernel says
of every cited theorem with the record, `rocq/Audit.out`; write the record; list the theorems; check a proof file written by
`python -m numerics solve --proof F.v`, or write it with all files that it requires into an empty folder for plain coqc."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from numerics.exits import USAGE, OneLineParser, refuse
from paper_checks import atomic
from paper_checks.proofs import audit, graph, kernel, library, submitted
from paper_checks.proofs.sources import AUDIT, FOLDER, read


def main() -> int:
    """Run a command; 0 if all is proved (as on record), 1 if something is not, 2 for bad usage, 3 without the kernel."""
    parser = OneLineParser(prog="python -m paper_checks.proofs", description=__doc__)
    parser.add_argument(
        "command", nargs="?", default="check", help="check, audit, list, or a proof file (its name ends in .v)"
    )
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="files compiled in parallel (2)")
    out = (
        "for a proof file: write it with all files that it requires into this empty folder, and print the coqc commands"
    )
    parser.add_argument("--out", type=Path, metavar="DIR", help=out)
    options = parser.parse_args()
    path = Path(options.command)
    if options.out and path.suffix != ".v":
        parser.error(f"--out is for a proof file, whose name ends in .v, not for {options.command}")
    if path.suffix == ".v":
        return _write(path, options.out) if options.out else _judge(path, options.jobs)
    if options.command not in ("check", "audit", "list"):
        parser.error(f"{options.command!r} is not check, audit, list or a proof file, whose name ends in .v")
    if options.command == "list":
        for one, (name, sentence) in audit.register().items():
            print(f"{one:28} {name:34} {sentence}")
        return 0
    if reason := kernel.why_not():
        print(reason, file=sys.stderr)
        return 3
    return _audit(options.jobs) if options.command == "audit" else _check(options.jobs)


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
        judged = submitted.judged(path, jobs=jobs)
    except (OSError, UnicodeDecodeError) as error:
        return refuse(f"cannot read {path}: {getattr(error, 'strerror', None) or 'it is not UTF-8 text'}", USAGE)
    if judged.holds is None:
        print(f"unchecked: {judged.reason}", file=sys.stderr)
        return 3
    if not judged.holds:
        print(f"refused: {judged.reason}", file=sys.stderr)
        return 1
    print(f"accepted: {judged.reason}; {time.monotonic() - began:.1f} s")
    return 0


def _progress(done: int, total: int) -> None:
    if sys.stderr.isatty() and total:
        print(f"compiling Coq proofs {done}/{total}", end="\r" if done < total else "\n", file=sys.stderr)


def _check(jobs: int) -> int:
    began = time.monotonic()
    proved = library.prove(audit.register(), _progress, jobs)
    problems = [one.problem for one in proved.values() if one.problem]
    version, seconds = library.kernel_name(), time.monotonic() - began
    print(f"{version}: {len(proved) - len(problems)} of {len(proved)} theorems proved as recorded, {seconds:.1f} s")
    if problems and kernel.TESTED_VERSION not in version:
        problems.append(f"this is {version}, the proofs are written for {kernel.TESTED_VERSION}: that may be all")
    for problem in dict.fromkeys(problems):
        print(problem, file=sys.stderr)
    return 1 if problems else 0


def _audit(jobs: int) -> int:
    """Ask the kernel about all that is cited, some minutes, and write question and answer: a change is read in the diff."""
    sources = read()
    compiled = kernel.compile_files(sources, sources, _progress, jobs)
    try:
        if compiled.broken:
            raise RuntimeError("\n".join(compiled.broken.values()))
        text = script(compiled)
        answer = audit.answered(compiled, text, jobs)
        wrong = {axiom for theorem in audit.read(answer).theorems.values() for axiom in theorem.axioms}
        if wrong := {axiom for axiom in wrong if not audit.allowed(axiom)}:
            raise RuntimeError(f"a theorem rests on {', '.join(sorted(wrong))}, which nobody has proved")
    except RuntimeError as error:
        print(f"not written: {error}", file=sys.stderr)
        return 1
    atomic.write(FOLDER / f"{AUDIT}.v", text)
    atomic.write(FOLDER / f"{AUDIT}.out", answer)
    print(f"{len(audit.register())} theorems in {AUDIT}.out: read what has changed")
    return 0


def script(compiled: kernel.Compiled) -> str:
    """The text of `Audit.v`: what each theorem uses and the definitions of its statement as they are now."""
    references, definitions = graph.references(compiled.folders)
    ids = {name: one for one, (name, _) in audit.register().items()}
    uses = {
        one: sorted(ids[other] for other in graph.nearest(name, ids, references))
        for name, one in sorted(ids.items(), key=lambda item: item[1])
    }
    printed, _ = audit.asked(compiled, [list(ids)], sorted(definitions))
    statements = "\n".join(printed[name] for name in ids)
    sources = read()
    return audit.script(sorted(sources), uses, audit.below(statements, {name: printed[name] for name in definitions}))


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        sys.exit(130)
