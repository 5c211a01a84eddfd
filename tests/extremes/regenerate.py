"""Writes answers.json: every scene of the catalogue solved by a route that shares nothing with the solver.

From the repository: PYTHONPATH=tests python -m extremes.regenerate [SCENE ...]
"""

import json
import sys
import tomllib
from pathlib import Path

import mpmath
from extremes import return_map
from extremes.scan import PRINTED, scanned

from numerics.scene import Scene
from numerics.scene.file import load_scene

HERE = Path(__file__).parent
ANSWERS = HERE / "answers.json"


def catalogue() -> dict[str, dict]:
    """The catalogue's tables by scene name."""
    return tomllib.loads((HERE / "catalogue.toml").read_text("utf-8"))


def scene(name: str) -> Scene:
    return load_scene(HERE / "scenes" / f"{name}.toml")


def answer(name: str, entry: dict) -> dict:
    """The answer of one scene as decimal text."""
    one = scene(name)
    found = scanned(one, entry.get("max_events", 12), entry.get("digits", 150), entry.get("smallest", 40))
    if "late" in entry:
        found["late"] = LATE[entry["late"]](one)
    return found


def by_return_map(one: Scene) -> dict:
    """Energy at the horizon, from the exit ray on which the scene starts; Omega = 1."""
    q = one.pair.m1 / one.pair.mass
    excursions, excess = return_map.after_time(q, one.energy_excess, one.until)
    return {"excursions": str(excursions), "energy_excess": excess, "digits": 45}


def by_rate_law(one: Scene) -> dict:
    """t w -> (4 pi/9) (m1/m2) sqrt(M/a2), the limit of t (E - E_cr)/E_cr; what is missing is O(log n/n)."""
    with mpmath.workdps(PRINTED):
        pair = one.pair
        factor = pair.m1 / pair.m2 / one.until
        root = mpmath.sqrt(mpmath.mpf((pair.mass / pair.a2).numerator) / (pair.mass / pair.a2).denominator)
        excess = 4 * mpmath.pi / 9 * root * factor.numerator / factor.denominator
        return {"energy_excess": mpmath.nstr(excess, 30), "digits": 18}


LATE = {"return-map": by_return_map, "rate-law": by_rate_law}


def main(names: list[str]) -> None:
    entries = catalogue()
    answers = json.loads(ANSWERS.read_text("utf-8")) if names and ANSWERS.exists() else {}
    for name in names or entries:
        answers[name] = answer(name, entries[name])
        print(name, len(answers[name]["events"]), file=sys.stderr)
    ordered = {name: answers[name] for name in entries if name in answers}
    ANSWERS.write_text(json.dumps(ordered, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
