"""The frozen answers, and their scenes as the package knows them."""

import json
import lzma
from functools import cache
from pathlib import Path
from typing import Any

from numerics import Force, Friction, Pair, Piece, Scene, Sine, State, load_scene

HERE = Path(__file__).parent


@cache
def scenes() -> list[dict[str, Any]]:
    """The answers to scenes."""
    found: list[dict[str, Any]] = json.loads(lzma.decompress((HERE / "answers.json.xz").read_bytes()))["scenes"]
    return found


def scene_of(answer: dict[str, Any]) -> Scene:
    """The scene of a frozen answer: of its file, or of its data."""
    if isinstance(name := answer.get("scene", answer.get("name")), str):
        folder, name = name.split("/")
        return load_scene(name if folder == "shipped" else HERE.parent / folder / "scenes" / f"{name}.toml")
    pair, state, until, law, force, friction = answer["scene"]
    pieces = [Piece(start, powers, [Sine(*sine) for sine in sines]) for start, powers, sines in force]
    return Scene(Pair(*pair), State(*state), until, law, Force(pieces), Friction(friction))
