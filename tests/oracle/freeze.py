"""Writes answers.json.xz: what the solver of commit e73de71 answers in balls, frozen.

From a checkout of e73de71: PYTHONPATH=THIS/tests python -m oracle.freeze VERDICTS.json, where VERDICTS.json is what
`python -m paper_checks run --json` printed there. Half an hour on two cores.
"""

import json
import lzma
import multiprocessing
import signal
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from flint import acb, arb

from numerics import sensitivities, solve
from numerics.errors import NumericsError
from oracle.controls import controls
from oracle.draws import KINDS, drawn
from oracle.reading import ANSWERS, TESTS, scene_of

DIGITS, PRINTED, PRINTED_LEDGER, PRINTED_SLOPES = 40, 24, 20, 15
MAX_EVENTS, SECONDS = 200, 10
EVERY = 15
"""Of the random scenes that have an event, one in so many gets sensitivities."""


def text(value: arb, digits: int) -> str:
    """The midpoint, rounded; 0 where it may be 0."""
    return "0" if value.contains(0) else str(value.mid().str(digits, radius=False))


def named() -> Iterator[tuple[str, int]]:
    """The scenes that are files, and the cap on events of each."""
    catalogue = tomllib.loads((TESTS / "extremes" / "catalogue.toml").read_text("utf-8"))
    for path in sorted((TESTS.parent / "numerics" / "scene" / "shipped").glob("*.toml")):
        yield f"shipped/{path.stem}", MAX_EVENTS
    for path in sorted((TESTS / "forced" / "scenes").glob("*.toml")):
        yield f"forced/{path.stem}", 150
    for name in catalogue:
        yield f"extremes/{name}", catalogue[name].get("max_events", 12)


def tasks() -> Iterator[dict[str, Any]]:
    """What is to be solved: by its file, or by its data."""
    for name, most in named():
        yield {"name": name, "max_events": most}
    for kind, (count, _) in KINDS.items():
        for number in range(count):
            yield {"name": f"{kind}/{number}", "max_events": MAX_EVENTS, "scene": drawn(kind, number)}


class TooLong(BaseException):
    """The time of one scene is over."""


def out_of_time(*_: Any) -> None:
    raise TooLong


def answered(task: dict[str, Any]) -> dict[str, Any] | None:
    """The task with its answer, or the kind of its refusal; None where it takes too long."""
    signal.signal(signal.SIGALRM, out_of_time)
    signal.alarm(SECONDS)
    try:
        return task | answer(task)
    except NumericsError as error:
        return task | {"refused": type(error).__name__}
    except TooLong:
        return None
    finally:
        signal.alarm(0)


def answer(task: dict[str, Any]) -> dict[str, Any]:
    scene = scene_of(task)
    found = solve(scene, arithmetic="ball", digits=DIGITS, max_digits=1500, max_events=task["max_events"])
    events = list(found.events)
    signs = {"stick": "0", "slip+": "+", "slip-": "-"}
    kept = [k for k in range(len(events)) if len(events) <= 30 or k < 10 or (k + 1) % 50 == 0 or k == len(events) - 1]
    with found.arithmetic.context():
        ledger = found.ledger
        rows = {str(k): [text(one, PRINTED) for one in (events[k].t, *events[k].y)] for k in kept}
        got = {
            "status": found.status.name,
            "modes": "".join(signs[one.before.value] for one in events) + signs[found.final_mode.value],
            "causes": "".join(one.cause[0] for one in events),
            "events": rows,
            "final": [text(one, PRINTED) for one in (found.end_time, *found.final_state)],
            "excess": text(found.final.w, PRINTED),
            "ledger": [text(arb(one), PRINTED_LEDGER) for one in (ledger.friction, ledger.viscous, ledger.work)],
        }
    name, _, number = task["name"].partition("/")
    if name == "shipped" or (name in KINDS and events and int(number) % EVERY == 0):
        got["slopes"] = slopes(found)
    return got


def slopes(found: Any) -> dict[str, Any] | str:
    """Derivatives of the last event's time and of the final state by every number of the scene."""
    try:
        slope = sensitivities(found)
    except NumericsError as error:
        return type(error).__name__
    with found.arithmetic.context():
        last = [text(one, PRINTED_SLOPES) for one in slope.t[-1]] if len(slope.t) else []
        return {
            "wrt": list(slope.wrt),
            "t": last,
            "final": [[text(one, PRINTED_SLOPES) for one in row] for row in slope.final],
        }


def plain(value: Any) -> Any:
    """Enclosures as text of 20 digits; a complex one as a pair."""
    if isinstance(value, acb):
        return [plain(value.real), plain(value.imag)]
    if isinstance(value, arb):
        return text(value, PRINTED_LEDGER)
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    return [plain(one) for one in value] if isinstance(value, list | tuple) else value


def main(verdicts: str) -> None:
    todo = list(tasks())
    with multiprocessing.Pool(2) as pool:
        answers = []
        for k, one in enumerate(pool.imap(answered, todo, chunksize=4)):
            if one is None:
                print("left out:", todo[k]["name"], file=sys.stderr, flush=True)
            else:
                answers.append(one)
            if k % 200 == 0:
                print(k, len(todo), file=sys.stderr, flush=True)
    rows = json.loads(Path(verdicts).read_text("utf-8"))
    data = {
        "scenes": answers,
        "control": {name: plain(one) for name, one in controls().items()},
        "verdicts": {row["id"]: [row["verdict"], row["established_by"]] for row in rows},
    }
    ANSWERS.write_bytes(lzma.compress(json.dumps(data, separators=(",", ":")).encode(), preset=9 | lzma.PRESET_EXTREME))


if __name__ == "__main__":
    main(sys.argv[1])
