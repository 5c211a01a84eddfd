"""A scene as the TOML text that describes it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from numerics.scene.decimals import decimal_text
from numerics.scene.model import BUILD, Law, Scene, require_kind
from numerics.scene.pieces import Piece
from numerics.scene.plane import AXES, PlaneScene


def scene_text(scene: Scene | PlaneScene) -> str:
    """Return TOML that `parse_scene` reads as the same scene: decimals where a number has one, else ratios; exact.

    >>> from numerics import load_scene
    >>> scene_text(load_scene("at-rest")).splitlines()[:6]
    ['[pair]', 'm1 = 1', 'm2 = 1', 'a1 = 0', 'a2 = 200', 'b = 0.5']
    """
    if not isinstance(scene, PlaneScene):
        require_kind("scene_text", scene, Scene, BUILD)
    return "\n".join(_lines(scene)) + "\n"


def _lines(scene: Any) -> Iterator[str]:
    """Yield the lines; on a surface numbers are lists, and a piece of force has its axis."""
    off_line = isinstance(scene, PlaneScene)
    yield from _table("pair", scene.pair, "m1 m2 a1 a2 b")
    if off_line:
        yield f'shape = "{scene.pair.shape}"'
    yield from _table("initial", scene if off_line else scene.initial, "x1 v1 x2 v2")
    yield from _table("run", scene, "until")
    if not off_line and scene.law is not Law.FILIPPOV:
        yield f'law = "{scene.law.value}"'
    if not off_line and scene.friction.weakening is not None:
        yield from _table("weakening", scene.friction.weakening, "last_slope speed place")
    for axis, force in zip(AXES, scene.force if off_line else [scene.force], strict=False):
        for piece in force.pieces:
            yield from _force(piece, [f'axis = "{axis}"'] * off_line)
    for start, b in scene.friction if off_line else scene.friction.pieces:
        yield from ("[[friction]]", f"from = {_text(start)}", f"b = {_text(b)}")


def _table(name: str, of: Any, keys: str) -> Iterator[str]:
    yield f"[{name}]"
    yield from (f"{key} = {_text(getattr(of, key))}" for key in keys.split())


def _force(piece: Piece, axis: list[str]) -> Iterator[str]:
    yield from ("[[force]]", *axis, f"from = {_text(piece.start)}", f"polynomial = {_text(piece.polynomial)}")
    sines = (
        f"{{ amplitude = {_text(s.amplitude)}, omega = {_text(s.omega)}, phase = {_text(s.phase)} }}"
        for s in piece.sines
    )
    yield f"sines = [{', '.join(sines)}]"


def _text(value: Any) -> str:
    """Return a number, or a list."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(_text, value))}]"
    text = decimal_text(value)
    return f'"{text}"' if "/" in text or len(text) > 18 else text  # TOML's whole numbers have 64 bits
