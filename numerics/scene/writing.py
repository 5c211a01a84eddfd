"""A scene as the TOML text that describes it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from numerics.scene.decimals import decimal_text
from numerics.scene.model import BUILD, Law, Scene, require_kind
from numerics.scene.pieces import Piece
from numerics.scene.plane import AXES, PlaneScene
from numerics.scene.weakening import Weakening


def scene_text(scene: Scene | PlaneScene) -> str:
    """Return TOML that `parse_scene` reads as the same scene: decimals where a number has one, else ratios; exact.

    >>> from numerics import load_scene
    >>> scene_text(load_scene("at-rest")).splitlines()[:6]
    ['[pair]', 'm1 = 1', 'm2 = 1', 'a1 = 0', 'a2 = 200', 'b = 0.5']
    """
    if isinstance(scene, PlaneScene):
        return "\n".join(_surface_lines(scene)) + "\n"
    require_kind("scene_text", scene, Scene, BUILD)
    pair, at = scene.pair, scene.initial
    lines = ["[pair]", *(f"{name} = {_number(getattr(pair, name))}" for name in ("m1", "m2", "a1", "a2", "b"))]
    lines += ["[initial]", *(f"{name} = {_number(getattr(at, name))}" for name in ("x1", "v1", "x2", "v2"))]
    lines += ["[run]", f"until = {_number(scene.until)}"]
    if scene.law is not Law.FILIPPOV:
        lines.append(f'law = "{scene.law.value}"')
    lines += _weakening_lines(scene.friction.weakening)
    for piece in scene.force.pieces:
        lines += _force_lines(piece)
    for start, b in scene.friction.pieces:
        lines += ["[[friction]]", f"from = {_number(start)}", f"b = {_number(b)}"]
    return "\n".join(lines) + "\n"


def _surface_lines(scene: PlaneScene) -> Iterator[str]:
    """Yield the lines of a scene on a surface: everything as lists, the pieces of force by axes."""
    pair = scene.pair
    yield "[pair]"
    yield from (f"{name} = {_numbers(getattr(pair, name))}" for name in ("m1", "m2", "b"))
    yield from (f"{name} = [{', '.join(map(_numbers, getattr(pair, name)))}]" for name in ("a1", "a2"))
    yield f'shape = "{pair.shape}"'
    yield "[initial]"
    yield from (f"{name} = {_numbers(getattr(scene, name))}" for name in ("x1", "v1", "x2", "v2"))
    yield f"[run]\nuntil = {_number(scene.until)}"
    for axis, force in zip(AXES, scene.force, strict=False):
        for piece in force.pieces:
            table, *rest = _force_lines(piece)
            yield from (table, f'axis = "{axis}"', *rest)
    for start, b in scene.friction:
        yield from ("[[friction]]", f"from = {_number(start)}", f"b = {_numbers(b)}")


def _numbers(values: Iterable[Fraction]) -> str:
    return f"[{', '.join(map(_number, values))}]"


def _weakening_lines(given: Weakening | None) -> Iterator[str]:
    if given is not None:
        yield "[weakening]"
        yield f"last_slope = {_number(given.last_slope)}"
        for name in ("speed", "place"):
            yield f"{name} = [{', '.join(f'[{_number(one)}, {_number(two)}]' for one, two in getattr(given, name))}]"


def _force_lines(piece: Piece) -> Iterator[str]:
    yield "[[force]]"
    yield f"from = {_number(piece.start)}"
    yield f"polynomial = [{', '.join(map(_number, piece.polynomial))}]"
    sines = (
        f"{{ amplitude = {_number(s.amplitude)}, omega = {_number(s.omega)}, phase = {_number(s.phase)} }}"
        for s in piece.sines
    )
    yield f"sines = [{', '.join(sines)}]"


def _number(value: Fraction) -> str:
    text = decimal_text(value)
    return f'"{text}"' if "/" in text or len(text) > 18 else text  # TOML's whole numbers have 64 bits
