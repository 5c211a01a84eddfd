"""Every number of many drawn scenes against its bound, counted: `python tests/numbers_drawn.py 20000 [SEED]`.

Scenes are those of draws.py, all kinds on a line in turn; the table says for each kind how many scenes were compared,
left out (in doubt, or refused), how many events and numbers, which error is the largest part of its bound, how many
numbers are beyond it, and what Python raised. A number beyond its bound is printed with its scene and ends the command
with 1.
"""

import sys
from collections import Counter, defaultdict
from random import Random
from typing import Any

from draws import KINDS, near_critical, scene
from every_number import compared
from reaching import LeftOut

from numerics import Law

DRAWN = {kind: draw for kind, draw in KINDS.items() if kind not in {"ellipsoid", "box", "friction of the state"}}
DRAWN |= {
    "ordinary": scene,
    "the literal law": lambda random: scene(random, damped=None, law=Law.THREE_VALUED_SGN),
    "damped, near critical": lambda random: near_critical(random, (1, 14), damped=True),
}


def count(many: int, seed: int, arithmetic: str = "float64") -> int:
    """Draw and compare; print the table; return how many numbers were wrong, or could not be compared."""
    random, counted, worst = Random(seed), defaultdict[str, Counter[str]](Counter), dict[str, tuple[float, str]]()
    for k in range(many):
        kind = list(DRAWN)[k % len(DRAWN)]
        given, own = DRAWN[kind](random), counted[kind]
        try:
            run, numbers = compared(given, arithmetic)
        except LeftOut:
            own["left out"] += 1
            continue
        except Exception as error:  # noqa: BLE001  # counted, and said
            own["raised"] += 1
            print(f"{kind}, scene {k}: {type(error).__name__}: {str(error)[:200]}\n    {given!r}", flush=True)
            continue
        own.update({"scenes": 1, "events": len(run.events), "numbers": len(numbers)})
        for one in numbers:
            if not one.ratio <= 1.0:
                own["wrong"] += 1
                print(f"{kind}, scene {k}: {one.name} = {one.value}, bound {one.bound}, true {one.true}\n    {given!r}")
            worst[kind] = max(worst.get(kind, (0.0, "")), (one.ratio, one.name))
    return told(counted, worst)


def told(counted: dict[str, Counter[str]], worst: dict[str, Any]) -> int:
    """Print the table, and what it adds up to; return what is wrong in it."""
    columns, whole = ("scenes", "left out", "events", "numbers", "wrong", "raised"), Counter[str]()
    print(f"{'kind':24}" + "".join(f"{name:>12}" for name in columns) + "   worst error/bound")
    for kind, own in counted.items():
        whole.update(own)
        print(
            f"{kind:24}"
            + "".join(f"{own[name]:12}" for name in columns)
            + "   {:.3f} {}".format(*worst.get(kind, (0.0, "")))
        )
    print(f"{'all':24}" + "".join(f"{whole[name]:12}" for name in columns))
    return whole["wrong"] + whole["raised"]


if __name__ == "__main__":
    sys.exit(min(1, count(int(sys.argv[1]), int((sys.argv[2:] or [1])[0]))))
