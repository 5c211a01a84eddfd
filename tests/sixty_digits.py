"""The scenes of tests/forced and tests/extremes, with their answers in 60 digits."""

import json
import tomllib
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

from oracle.holding import Case, largest

from numerics import Scene, load_scene

HERE = Path(__file__).parent
FORCED, EXTREMES = (json.loads((HERE / one / "answers.json").read_text("utf-8")) for one in ("forced", "extremes"))
ANSWERS = {"forced": FORCED, "extremes": EXTREMES}
CATALOGUE = {one: tomllib.loads((HERE / one / "catalogue.toml").read_text("utf-8")) for one in ANSWERS}


def forced_scene(name: str, folder: str = "forced") -> Scene:
    return load_scene(HERE / folder / "scenes" / f"{name}.toml")


def extreme_scene(name: str) -> Scene:
    return forced_scene(name, "extremes")


def case_of(folder: str, name: str, way: str) -> Case:
    """A scene under a force, of those with very many events the first ones; an extreme scene up to so many events."""
    answer, entry, scene = ANSWERS[folder][name], CATALOGUE[folder].get(name, {}), forced_scene(name, folder)
    is_forced, pair = folder == "forced", scene.pair
    most = entry.get("max_events", 12) if not is_forced else 51 if way == "ball" else 10_000
    asked = {"arithmetic": way, "max_events": most} | ({} if way == "float64" else {"digits": 50})
    if way == "ball" and "max_digits" in entry:
        asked["max_digits"] = entry["max_digits"]
    rows = {event["n"]: event["row"] for event in answer["events"] if event["n"] < most}
    if len(answer["modes"]) <= most + 1:
        rows[-1] = answer["final"]
    _, far, fast, *_ = largest(rows)
    if not is_forced:  # what is below 10^-150 of its unit has no digits
        far, square = pair.half_width / 10**150, pair.a2 / pair.mass
        fast = far * Fraction((Decimal(square.numerator) / Decimal(square.denominator)).sqrt())
    scales = [Fraction(0), far, fast, far, fast, pair.critical_energy / 10**150, Fraction(1, 10**150)]
    right = {"ball": 50, "float64": entry.get("right_in_float64", 9 if is_forced else None)}.get(way)
    causes = {event["n"]: event["cause"][0] for event in answer["events"] if "cause" in event and event["n"] < most}
    may = set(entry.get(way, "right").split(" or "))
    return Case(scene, asked, may, right, scales, answer["modes"][: most + 1], causes, rows, "1e-59", "1e-59")
