"""A table of how the package's answers differ from the frozen ones.

PYTHONPATH=tests python -m oracle.compare [--kinds free damped] [--arithmetic ball float64] [--every 10] [--slopes]
    [--names forced/sine-at-threshold] [--control] [--open] [--lines 40] [--jobs 2]
"""

import argparse
import multiprocessing
import signal
import sys
from collections import Counter, defaultdict
from typing import Any

from numerics.errors import NumericsError
from oracle.holding import WAYS, Outcome, held, same
from oracle.reading import data

SECONDS = 20


class TooLong(BaseException):
    """The time of one scene is over."""


def out_of_time(*_: Any) -> None:
    raise TooLong


def compared(task: tuple[int, str, bool]) -> tuple[str, Outcome]:
    index, way, slopes = task
    answer = data()["scenes"][index]
    signal.signal(signal.SIGALRM, out_of_time)
    signal.alarm(SECONDS)
    try:
        return way, held(answer, way, slopes=slopes)
    except TooLong:
        return way, Outcome(answer["name"], [f"no answer in {SECONDS} s"])
    except Exception as error:  # noqa: BLE001 - whatever a solver under construction raises is a line of the table
        return way, Outcome(answer["name"], [f"raised {error!r}"[:200]])
    finally:
        signal.alarm(0)


def wanted(options: argparse.Namespace) -> list[int]:
    """The indices of the scenes that are asked for."""
    kinds, found = options.kinds, []
    for index, answer in enumerate(data()["scenes"]):
        name = answer["name"]
        by_kind = not kinds or any(name.startswith(kind) for kind in kinds)
        if name in options.names or (not options.names and by_kind):
            found.append(index)
    return found[:: options.every]


def table(outcomes: list[tuple[str, Outcome]]) -> None:
    """How many of each kind are the same, left open and different; seconds; what answered."""
    groups: dict[tuple[str, str], list[Outcome]] = defaultdict(list)
    for way, one in outcomes:
        groups[way, one.name.split("/")[0]].append(one)
    print(f"{'asked':14}{'kind':22}{'scenes':>7}{'same':>7}{'open':>6}{'DIFF':>6}{'worst':>9}{'ms':>9}  answered by")
    for (way, kind), ones in groups.items():
        different, left_open = sum(bool(one.differences) for one in ones), sum(bool(one.left_open) for one in ones)
        mean = 1000 * sum(one.seconds for one in ones) / len(ones)
        who = ", ".join(f"{name} {count}" for name, count in Counter(one.arithmetic for one in ones).items() if name)
        numbers = f"{len(ones):7}{len(ones) - different - left_open:7}{left_open:6}{different:6}"
        print(f"{way:14}{kind:22}{numbers}{max(one.worst for one in ones):9.2g}{mean:9.1f}  {who}")


def compare_control() -> None:
    """The answers of control, one line for each that differs."""
    from oracle.controls import answers as questions

    frozen, different = data()["control"], 0
    for name, ask in questions().items():
        try:
            got = ask()
        except NumericsError as error:
            got = {"refused": type(error).__name__}
        except Exception as error:  # noqa: BLE001 - as above
            got = {"raised": repr(error)[:200]}
        if not same(frozen[name], got):
            different += 1
            print(f"{name}:\n  frozen {str(frozen[name])[:400]}\n  got    {str(got)[:400]}")
    print(f"control: {len(frozen)} questions, {different} differ")


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="oracle.compare", description=__doc__.splitlines()[0])
    parser.add_argument("--kinds", nargs="+", default=[], help="beginnings of kinds: free, damped-stiff, forced/, ...")
    parser.add_argument("--names", nargs="+", default=[], help="whole names of scenes")
    parser.add_argument("--arithmetic", nargs="+", default=["ball", "float64"], choices=list(WAYS))
    parser.add_argument("--every", type=int, default=1, help="one scene in so many")
    parser.add_argument("--slopes", action="store_true", help="sensitivities too")
    parser.add_argument("--control", action="store_true", help="the answers of control too")
    parser.add_argument("--open", action="store_true", help="a line for each scene that is left open too")
    parser.add_argument("--lines", type=int, default=60, help="at most so many differences are printed")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args(words)
    tasks = [(index, way, options.slopes) for way in options.arithmetic for index in wanted(options)]
    with multiprocessing.Pool(options.jobs) as pool:
        outcomes = list(pool.imap(compared, tasks, chunksize=8))
    table(outcomes)
    lines = [f"{way} {one.name}: {'; '.join(one.differences[:3])}" for way, one in outcomes if one.differences]
    if options.open:
        lines += [f"{way} {one.name} open: {one.left_open}" for way, one in outcomes if one.left_open]
    print("\n".join(lines[: options.lines]))
    if options.control:
        compare_control()
    return int(any(one.differences for _, one in outcomes))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
