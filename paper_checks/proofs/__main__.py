"""`python -m paper_checks.proofs [check | pin | list]`: compile the proofs; write the pins anew; name the theorems."""

from __future__ import annotations

import sys
import time

from numerics.exits import OneLineParser
from paper_checks import atomic
from paper_checks.proofs import cited, library
from paper_checks.proofs.pins import PINS, Pin, Pins, pinned, written


def main() -> int:
    """Run a command; 0 if every theorem is proved as pinned, 1 if one is not, 3 without the kernel."""
    parser = OneLineParser(prog="python -m paper_checks.proofs", description=__doc__)
    parser.add_argument("command", nargs="?", choices=("check", "pin", "list"), default="check")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="files that are compiled at a time (2)")
    options = parser.parse_args()
    if options.command == "list":
        for one, (name, sentence) in cited.CITED.items():
            print(f"{one:28} {name:34} {sentence}")
        return 0
    return _pin(options.jobs) if options.command == "pin" else _check(options.jobs)


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
