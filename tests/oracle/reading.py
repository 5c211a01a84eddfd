"""The frozen answers, and their scenes as the package knows them."""

import json
import lzma
from functools import cache
from pathlib import Path
from typing import Any

from numerics import Force, Friction, Pair, Piece, Scene, Sine, State, load_scene

HERE = Path(__file__).parent
TESTS = HERE.parent
ANSWERS = HERE / "answers.json.xz"


@cache
def data() -> dict[str, Any]:
    """All that is frozen: `scenes`, `control`, `verdicts`."""
    found: dict[str, Any] = json.loads(lzma.decompress(ANSWERS.read_bytes()))
    return found


def scene_of(answer: dict[str, Any]) -> Scene:
    """The scene of a frozen answer: of its file, or of its data."""
    if "scene" not in answer:
        folder, name = answer["name"].split("/")
        return load_scene(name if folder == "shipped" else TESTS / folder / "scenes" / f"{name}.toml")
    pair, state, until, law, force, friction = answer["scene"]
    pieces = [Piece(start, powers, [Sine(*sine) for sine in sines]) for start, powers, sines in force]
    return Scene(Pair(*pair), State(*state), until, law, Force(pieces), Friction(friction))
