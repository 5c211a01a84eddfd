"""Writes answers.json: every forced scene solved by tests/forced_reference.py, twice, with different digits and steps.

From the repository: PYTHONPATH=tests python -m forced.regenerate [SCENE ...]
"""

import json
import sys
import tomllib
from pathlib import Path

from flint import arb, ctx
from forced_reference import Reference

HERE = Path(__file__).parent
ANSWERS = HERE / "answers.json"
PRINTED = 60
KEPT = 60  # of more events than this, one in fifty is kept, and the last
SIGNS = {0: "0", 1: "+", -1: "-"}


def names() -> list[str]:
    return sorted(path.stem for path in (HERE / "scenes").glob("*.toml"))


def tables(name: str) -> dict:
    """The tables of a scene; decimals stay text."""
    return tomllib.loads((HERE / "scenes" / f"{name}.toml").read_text("utf-8"), parse_float=str)


def text(value: arb, scale: arb) -> str:
    """60 digits; "0" for what is only rounding of its scale."""
    return "0" if abs(value) <= scale * arb(10) ** -75 else value.str(PRINTED, radius=False)


def written(found: Reference) -> dict:
    """The answer of one scene as text: the modes (0 stick, + and - slip), events t, x1, v1, x2, v2, and the end."""
    many, last = len(found.events) > KEPT, len(found.events) - 1
    scales = (found.far, found.fast, found.far, found.fast)

    def row(t: arb, y: tuple) -> list[str]:
        return [text(t, t), *(text(one, scale) for one, scale in zip(y, scales, strict=True))]

    first = found.events[0].before if found.events else found.mode
    return {
        "modes": "".join(SIGNS[mode] for mode in (first, *(event.after for event in found.events))),
        "touches": len(found.touches),
        "events": [
            {"n": n, "cause": event.cause, "row": row(event.t, event.y)}
            for n, event in enumerate(found.events)
            if not many or n % 50 == 0 or n == last
        ],
        "final": row(found.t, found.state()),
    }


def same(one: Reference, two: Reference) -> bool:
    """Whether two runs agree in more digits than are printed."""
    if [event[1:4] for event in one.events] != [event[1:4] for event in two.events]:
        return False
    pairs = [((a.t, *a.y), (b.t, *b.y)) for a, b in zip(one.events, two.events, strict=True)]
    pairs.append(((one.t, *one.state()), (two.t, *two.state())))
    scales = (one.t, one.far, one.fast, one.far, one.fast)
    return all(
        abs(a - b) <= abs(a) * arb(10) ** (-2 - PRINTED) + scale * arb(10) ** -76
        for rows in pairs
        for a, b, scale in zip(*rows, scales, strict=True)
    )


def answer(name: str) -> dict:
    """The answer of one scene; raises ArithmeticError if the two runs differ."""
    given = tables(name)
    one, two = Reference(given, digits=120, radians=2).run(), Reference(given, digits=140, radians=1.25).run()
    before, ctx.dps = ctx.dps, 120
    try:
        if not same(one, two):
            raise ArithmeticError(f"{name}: two runs differ")
        return written(one)
    finally:
        ctx.dps = before


def main(asked: list[str]) -> None:
    answers = json.loads(ANSWERS.read_text("utf-8")) if asked and ANSWERS.exists() else {}
    for name in asked or names():
        answers[name] = answer(name)
        print(name, len(answers[name]["modes"]) - 1, file=sys.stderr)
    ANSWERS.write_text(json.dumps({name: answers[name] for name in sorted(answers)}, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
