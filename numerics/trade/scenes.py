"""The scenes on which everything is measured, each a file; the beginning of a name says of which kind it is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from numerics.scene.file import load_scene

FOLDER = Path(__file__).with_name("benchmarks")
HEADLINE, LONG = "relative-motion-b05", "long-"
"""The scene for which single numbers are quoted, and how those begin that go on for more and more excursions."""
KINDS = {
    "free": "without a force",
    "forced": "under a force",
    "surface": "on a surface",
    "state": "with friction of the state",
}
"""How the names of scenes begin that are not free, and what the kinds are."""
LINE = "free", "forced"
"""Those that others are measured on, too."""


def kind(name: str) -> str:
    """Return the kind of a scene by its name."""
    first = name.partition("-")[0]
    return first if first in KINDS else "free"


NAMES = tuple(sorted((one.stem for one in FOLDER.glob("*.toml")), key=lambda name: ([*KINDS].index(kind(name)), name)))


def benchmark(name: str) -> Any:
    """Return a scene by its name."""
    return load_scene(FOLDER / f"{name}.toml")


def why(name: str) -> str:
    """Return why a scene is measured: the first line of its file."""
    return (FOLDER / f"{name}.toml").read_text("utf-8").partition("\n")[0].removeprefix("# ")
