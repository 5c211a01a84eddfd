"""The forced scenes and their answers to 60 digits, as the tests read them."""

import json

from forced.regenerate import ANSWERS, HERE

from numerics import Scene
from numerics.scene.file import load_scene

ANSWER = json.loads(ANSWERS.read_text("utf-8"))
SIGNS = {"stick": "0", "slip+": "+", "slip-": "-"}
UNDECIDABLE = "touches-at-irrational-times"
"""What no number that is known nearly can decide."""


def scene(name: str) -> Scene:
    return load_scene(HERE / "scenes" / f"{name}.toml")


def itinerary(trajectory) -> str:
    """The modes one after the other, in the letters of the answers."""
    return "".join(SIGNS[mode.value] for mode in trajectory.modes)
