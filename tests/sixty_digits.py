"""The scenes of tests/forced and tests/extremes, their answers in 60 digits, and what is printed held against these."""

import json
import tomllib
from decimal import Decimal, localcontext
from pathlib import Path
from typing import Any, NamedTuple

from numerics import Scene, load_scene

HERE = Path(__file__).parent
NAMES = ("t", "x1", "v1", "x2", "v2", "energy", "energy_excess")
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
WAYS = ("ball", "float64")
"""With mpmath, a second computation of the free pair alone."""


class Case(NamedTuple):
    """A scene, what `solve` is asked for, which errors are right, and what must come out."""

    scene: Scene
    asked: dict[str, Any]
    right: set[str]
    """Names of errors, and "right" where an answer is."""
    digits: int | None
    """How many must be right of each number, or of its scale where that is larger; None: those that are printed."""
    scales: list[Decimal]
    modes: str
    rows: list[tuple[int, list[str], str | None]]
    """The event, -1 for the end, its numbers, and its cause."""


FORCED, EXTREMES = (json.loads((HERE / one / "answers.json").read_text("utf-8")) for one in ("forced", "extremes"))
CATALOGUE = tomllib.loads((HERE / "extremes" / "catalogue.toml").read_text("utf-8"))
UNDECIDABLE = "touches-at-irrational-times"
"""What no number that is known nearly can decide."""
# neighbours of a tie or of a contact, nearer than the bounds of float64; solve(scene) climbs there
NEAR = {"jump-just-before-contact", "reversal-just-before-contact", "sine-barely-above-threshold", "mass-ratio-1e-6"}
BEYOND = {"ball": {UNDECIDABLE}, "float64": {UNDECIDABLE, *NEAR}}
FEWER = {"sine-just-above-threshold": 6, "four-thousand-events": 6, "mass-ratio-1e6": 8, "sine-non-stop": 8}
"""Right digits of float64 where a slip is so short that its end keeps fewer, or events are so many."""


def forced_scene(name: str) -> Scene:
    return load_scene(HERE / "forced" / "scenes" / f"{name}.toml")


def extreme_scene(name: str) -> Scene:
    return load_scene(HERE / "extremes" / "scenes" / f"{name}.toml")


def forced(name: str, way: str) -> Case:
    """A scene under a force; of those with very many events the first ones will do."""
    answer, most = FORCED[name], {"ball": 51, "float64": 10_000}[way]
    asked = {"arithmetic": way, "max_events": most} | ({} if way == "float64" else {"digits": 40})
    asked |= {"max_digits": 120} if name == UNDECIDABLE else {}
    rows = [(one["n"], one["row"], one["cause"]) for one in answer["events"] if one["n"] < most]
    if len(answer["modes"]) <= most + 1:
        rows.append((-1, answer["final"], None))
    right = {"right", "EventUndecided"} if name in BEYOND[way] else {"right"}
    sizes = [max(abs(Decimal(row[k])) for _, row, _ in rows) for k in range(5)]
    far, fast = max(sizes[1], sizes[3]), max(sizes[2], sizes[4])
    digits = {"ball": 38, "float64": FEWER.get(name, 9)}[way]
    scales = [Decimal(0), far, fast, far, fast]
    return Case(forced_scene(name), asked, right, digits, scales, answer["modes"][: most + 1], rows)


def extreme(name: str, way: str) -> Case:
    """An extreme scene: a number below 10^-150 of its unit has no digits."""
    entry, answer, scene = CATALOGUE[name], EXTREMES[name], extreme_scene(name)
    asked = {"arithmetic": way, "max_events": entry.get("max_events", 12)}
    asked |= {} if way == "float64" else {"digits": 50}
    asked |= {"max_digits": entry["max_digits"]} if way == "ball" and "max_digits" in entry else {}
    pair = scene.pair
    width, square, energy = (
        Decimal(one.numerator) / Decimal(one.denominator)
        for one in (pair.half_width, pair.a2 / pair.mass, pair.critical_energy)
    )
    speed = width * square.sqrt()
    scales = [one * Decimal("1e-150") for one in (Decimal(0), width, speed, width, speed, energy, Decimal(1))]
    rows = [*((n, row, None) for n, row in enumerate(answer["events"])), (-1, answer["final"], None)]
    modes = "".join(SIGNS[one] for one in answer["modes"])
    right = set(entry.get(way, "right").split(" or "))
    return Case(scene, asked, right, 50 if way == "ball" else None, scales, modes, rows)


def require_right(record: dict[str, Any], case: Case) -> None:
    """A ball holds the truth; of other numbers the last digit is off by one at most, and its rounding by a half."""
    got = [*record["events"], record["final"]]
    last = record["events"][-1]["to"] if record["events"] else record["final"]["mode"]
    assert "".join(SIGNS[one] for one in (*(event["from"] for event in record["events"]), last)) == case.modes
    with localcontext() as context:
        context.prec, context.Emin, context.Emax = 120, -(10**6), 10**6
        for n, row, cause in case.rows:
            assert cause in {None, "both", got[n].get("cause")}
            for name, text, scale in zip(NAMES, row, case.scales, strict=False):
                one, two = Decimal(got[n][name]), Decimal(text)
                off, size = abs(one - two), max(abs(two), scale)
                half = Decimal((0, (1, 5), one.as_tuple().exponent - 1))
                within = Decimal(got[n].get(f"{name}_radius", half))
                assert off <= within + size * Decimal("1e-59"), (n, name, one, two)
                assert case.digits is None or off <= size * Decimal(10) ** -case.digits, (n, name, one, two)
