"""A table of how the package's answers differ from the frozen ones.

PYTHONPATH=tests python -m oracle.compare [--kinds free damped] [--arithmetic ball float64] [--every 10] [--slopes]
    [--names forced/sine-at-threshold] [--lines 40] [--jobs 2]
"""

import argparse
import multiprocessing
import sys
from collections import Counter, defaultdict

from oracle.holding import WAYS, Outcome, held
from oracle.reading import data


def compared(task: tuple[int, str, bool]) -> tuple[str, Outcome]:
    index, way, slopes = task
    answer = data()["scenes"][index]
    try:
        return way, held(answer, way, slopes=slopes)
    except Exception as error:  # noqa: BLE001 - whatever a solver under construction raises is a line of the table
        return way, Outcome(answer["name"], [f"raised {error!r}"[:200]])


def wanted(options: argparse.Namespace) -> list[int]:
    """The indices of the scenes that are asked for."""
    names = [answer["name"] for answer in data()["scenes"]]
    kinds = tuple(options.kinds) if options.kinds or options.names else ("",)
    return [k for k, name in enumerate(names) if name in options.names or name.startswith(kinds)][:: options.every]


def table(outcomes: list[tuple[str, Outcome]]) -> None:
    """How many of each kind are the same, left open and different; seconds; what answered."""
    groups: dict[tuple[str, str], list[Outcome]] = defaultdict(list)
    for way, one in outcomes:
        groups[way, one.name.split("/")[0]].append(one)
    print(f"{'asked':14}{'kind':22}{'scenes':>7}{'open':>6}{'DIFF':>6}{'worst':>9}{'ms':>9}  answered by")
    for (way, kind), ones in groups.items():
        different, left_open = sum(bool(one.differences) for one in ones), sum(bool(one.left_open) for one in ones)
        mean, worst = 1000 * sum(one.seconds for one in ones) / len(ones), max(one.worst for one in ones)
        who = ", ".join(f"{name} {count}" for name, count in Counter(one.arithmetic for one in ones).items() if name)
        print(f"{way:14}{kind:22}{len(ones):7}{left_open:6}{different:6}{worst:9.2g}{mean:9.1f}  {who}")


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="oracle.compare", description=__doc__.splitlines()[0])
    parser.add_argument("--kinds", nargs="+", default=[], help="beginnings of kinds: free, damped-stiff, forced/, ...")
    parser.add_argument("--names", nargs="+", default=[], help="whole names of scenes")
    parser.add_argument("--arithmetic", nargs="+", default=["ball", "float64"], choices=list(WAYS))
    parser.add_argument("--every", type=int, default=1, help="one scene in so many")
    parser.add_argument("--slopes", action="store_true", help="sensitivities too")
    parser.add_argument("--lines", type=int, default=60, help="at most so many differences are printed")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args(words)
    tasks = [(index, way, options.slopes) for way in options.arithmetic for index in wanted(options)]
    with multiprocessing.Pool(options.jobs) as pool:
        outcomes = list(pool.imap(compared, tasks, chunksize=8))
    table(outcomes)
    lines = [f"{way} {one.name}: {'; '.join(one.differences[:3])}" for way, one in outcomes if one.differences]
    print("\n".join(lines[: options.lines]))
    return int(bool(lines))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
