"""One contender at one setting on one scene in a fresh process: judged once, then timed by pyperf in its processes.

    python -m numerics.trade.fresh CONTENDER SCENE SETTING

prints one line of JSON: seconds and their median absolute deviation, the difference and the digits, or a note on what
went wrong. pyperf starts this module again for every process that it times in; without pyperf there is no time.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

from numerics.trade.contenders import answer_of, contender
from numerics.trade.judge import judge, proved
from numerics.trade.scenes import benchmark

SLOW = 1.0
"""A call that takes so long (s) is its own measure: its second run counts."""
LEAST = 0.01
"""A value that pyperf takes lasts at least so long, s."""


def total_time(call: Callable[[], Any], loops: int) -> float:
    """Return the time of so many calls, s."""
    start = time.perf_counter()
    for _ in range(loops):
        call()
    return time.perf_counter() - start


def measured(label: str, name: str, setting: float, runner: Any = None) -> dict[str, Any]:
    """Return the answer to a request; `runner` is pyperf's, or None. In a process that only times, {}."""
    who, scene, answer = contender(label), benchmark(name), {}  # type: Any, Any, dict[str, Any]
    call = who.prepare(scene, setting)
    if runner is None or not runner.args.worker:
        digits = int(setting) if who.ours else 0
        verdict = judge(answer_of(call()), proved(scene, digits), scene, digits)
        answer = {"difference": verdict.difference, "digits": verdict.digits}
        once = total_time(call, 1)
        if once > SLOW:
            return answer | {"seconds": once}
        if runner is not None:
            runner.args.loops = max(1, round(LEAST / max(once, 1e-9)))
    if runner is not None:
        found = runner.bench_time_func(label, lambda loops: total_time(call, loops))
        answer |= {"seconds": found.median(), "deviation": found.median_abs_dev()} if answer else {}
    return answer


def main() -> None:
    """Answer one request."""
    runner, asked = None, sys.argv[1:4]
    if find_spec("pyperf"):
        import pyperf

        program = ("-m", "numerics.trade.fresh", *asked)
        runner = pyperf.Runner(values=3, processes=3, program_args=program, show_name=False)
        runner.argparser.add_argument("asked", nargs=3)
        runner.argparser.set_defaults(quiet=True, copy_env=True)
        runner.parse_args()
    try:
        answer = measured(asked[0], asked[1], float(asked[2]), runner)
    except Exception as error:  # noqa: BLE001 - a peer may raise anything, and the table goes on
        answer = {"note": f"{type(error).__name__}: {error}"[:200]}
    print("\n" + json.dumps(answer))


if __name__ == "__main__":
    main()
