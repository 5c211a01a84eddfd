"""The scenes on which everything is measured, each a file: the paper's, near-critical, longer and longer, forced."""

from __future__ import annotations

from pathlib import Path

from numerics.scene import Scene
from numerics.scene.file import load_scene

FOLDER = Path(__file__).with_name("benchmarks")
HEADLINE = "relative-motion-b05"
"""The scene for which single numbers are quoted."""
FORCED, LONG = "forced-", "long-"
"""How the names of the scenes under a force begin, and of those that go on for more and more excursions."""
NAMES = tuple(sorted((one.stem for one in FOLDER.glob("*.toml")), key=lambda name: (name.startswith(FORCED), name)))
"""Those under a force come last."""


def benchmark(name: str) -> Scene:
    """Return a scene by its name."""
    return load_scene(FOLDER / f"{name}.toml")


def kind(name: str) -> str:
    """Return "forced" or "free"."""
    return "forced" if name.startswith(FORCED) else "free"


def why(name: str) -> str:
    """Return why a scene is measured: the first line of its file."""
    return (FOLDER / f"{name}.toml").read_text("utf-8").partition("\n")[0].removeprefix("# ")
