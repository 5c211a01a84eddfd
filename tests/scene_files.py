"""The scenes of tests, one TOML file each, by the folder under tests/scenes that they stand in."""

from pathlib import Path

from numerics import Scene, State, load_scene

FOLDER = Path(__file__).parent / "scenes"


def mirrored(scene: Scene) -> Scene:
    """Return the scene in which everything points the other way."""
    at = scene.initial
    return scene.replace(initial=State(-at.x1, -at.v1, -at.x2, -at.v2), force=-scene.force)


def scenes_in(folder: str) -> dict[str, Scene]:
    """Return the scenes of a folder by their names."""
    return {path.stem: load_scene(path) for path in sorted((FOLDER / folder).glob("*.toml"))}
