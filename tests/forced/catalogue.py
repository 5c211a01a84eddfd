"""The forced scenes and their answers to 60 digits, as the tests read them."""

import json
import tomllib
from pathlib import Path

from numerics import Scene, load_scene

HERE = Path(__file__).parent
ANSWER = json.loads((HERE / "answers.json").read_text("utf-8"))
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
UNDECIDABLE = "touches-at-irrational-times"
"""What no number that is known nearly can decide."""


def scene(name: str) -> Scene:
    return load_scene(HERE / "scenes" / f"{name}.toml")


def tables(name: str) -> dict:
    """The tables of a scene, as the reference reads them; decimals stay text."""
    return tomllib.loads((HERE / "scenes" / f"{name}.toml").read_text("utf-8"), parse_float=str)


def itinerary(trajectory) -> str:
    """The modes one after the other, in the letters of the answers."""
    return "".join(SIGNS[mode.value] for mode in trajectory.modes)
