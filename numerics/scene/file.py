"""Scene files: TOML in, a Scene out, nothing evaluated. The paper's examples are found by a short name."""

from __future__ import annotations

import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene import Law, Pair, Scene, State

MAX_BYTES = 65536
_KEYS = {
    "pair": {"m1", "m2", "a1", "a2", "b"},
    "initial": {"x1", "v1", "x2", "v2"},
    "run": {"law", "until"},
}
_REQUIRED = (("pair", "m1"), ("pair", "m2"), ("pair", "a2"), ("pair", "b"), ("run", "until"))


def shipped_scenes() -> tuple[str, ...]:
    """Return the short names of the scenes in the repository, sorted: the paper's examples and a few more."""
    folder = resources.files("numerics") / "scene" / "shipped"
    return tuple(sorted(one.name.removesuffix(".toml") for one in folder.iterdir() if one.name.endswith(".toml")))


def load_scene(name_or_path: str | Path) -> Scene:
    """Return the scene of a shipped short name such as "velocities", or of a TOML file.

    Raises InvalidScene (one line, with the remedy) if there is no such file or it describes no scene.

    >>> load_scene("velocities").pair.b
    Fraction(1, 20)
    """
    name = str(name_or_path)
    if name in shipped_scenes():
        return parse_scene((resources.files("numerics") / "scene" / "shipped" / f"{name}.toml").read_text("utf-8"))
    path = Path(name_or_path)
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        known = ", ".join(shipped_scenes())
        raise InvalidScene(f"no scene {name!r}: {reason}; give a TOML file or one of: {known}") from None
    if len(data) > MAX_BYTES:
        raise InvalidScene(f"scene file {name!r} is larger than {MAX_BYTES} bytes; a scene needs a dozen lines")
    try:
        return parse_scene(data.decode("utf-8"))
    except UnicodeDecodeError:
        raise InvalidScene(f"scene file {name!r} is not UTF-8 text; save it as UTF-8") from None


def parse_scene(text: str) -> Scene:
    """Return the Scene that TOML `text` describes, numbers read as exact decimals. Raises InvalidScene."""
    try:
        # floats stay text until decimals.py has checked them: 0.005 must be 1/200, 1e999999999 must cost nothing
        tables = tomllib.loads(text, parse_float=_float_text)
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())[:200]
        raise InvalidScene(f"not a TOML scene: {reason}") from None
    _check_keys(tables)
    pair, initial, run = (tables.get(name, {}) for name in _KEYS)
    return Scene(Pair(**pair), State(**initial), until=run["until"], law=run.get("law", Law.FILIPPOV))


def _float_text(text: str) -> str:
    return text.replace("_", "")


def _check_keys(tables: dict[str, Any]) -> None:
    for table, content in tables.items():
        if table not in _KEYS:
            raise InvalidScene(f"unknown table or key [{table[:40]!r}]; a scene has [pair], [initial] and [run]")
        if not isinstance(content, dict):
            raise InvalidScene(f"{table} must be a table; write [{table}] on a line of its own")
        for key in content:
            if key not in _KEYS[table]:
                known = ", ".join(sorted(_KEYS[table]))
                raise InvalidScene(f"unknown key {key[:40]!r} in [{table}]; it takes {known}")
    for table, key in _REQUIRED:
        if key not in tables.get(table, {}):
            raise InvalidScene(f"missing key {key} in [{table}]; every scene must give it")
