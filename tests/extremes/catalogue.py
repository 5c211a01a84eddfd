"""The extreme scenes, their entries in the catalogue and their answers to 60 digits, as the tests read them."""

import json
import tomllib
from pathlib import Path

from numerics import Scene, load_scene

HERE = Path(__file__).parent
ANSWER = json.loads((HERE / "answers.json").read_text("utf-8"))
CATALOGUE = tomllib.loads((HERE / "catalogue.toml").read_text("utf-8"))


def scene(name: str) -> Scene:
    return load_scene(HERE / "scenes" / f"{name}.toml")
