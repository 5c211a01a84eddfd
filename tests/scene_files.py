"""The scenes of tests, one TOML file each, by the folder under tests/scenes that they stand in."""

from pathlib import Path

from numerics import Scene, load_scene

FOLDER = Path(__file__).parent / "scenes"


def scenes_in(folder: str) -> dict[str, Scene]:
    """Return the scenes of a folder by their names."""
    return {path.stem: load_scene(path) for path in sorted((FOLDER / folder).glob("*.toml"))}
