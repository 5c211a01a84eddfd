"""Scene files: TOML in, a Scene out, nothing evaluated, and back. The paper's examples are found by a short name."""

from __future__ import annotations

import difflib
import os
import sys
import tomllib
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from importlib import resources
from pathlib import Path
from typing import Any, cast

from numerics.errors import InvalidScene
from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, Weakening
from numerics.scene.decimals import decimal_text, exact_decimal, listed, shown
from numerics.scene.model import BUILD, read_law, require_kind
from numerics.scene.pieces import two_coefficients
from numerics.scene.plane import AXES, PlanePair, PlaneScene

MAX_BYTES, MAX_FORCED_BYTES = 65536, 2**25
"""Of a scene without a force, and of one with."""
_PIECE = "from polynomial sines"
_REFERENCE = {"reference": ("", _PIECE)}
_SCENE = {
    "pair": ("m1 m2 a2 b", "a1 shape"),
    "initial": ("", "x1 v1 x2 v2"),
    "run": ("until", "law"),
    "weakening": ("", "speed last_slope place"),
    "force": ("", f"{_PIECE} axis"),
    "friction": ("from b", ""),
}
"""The keys of each table: those that it must have, and others."""
_SINE = ("amplitude omega", "phase")
_REPEATED = {"force", "friction", "reference"}
"""Tables of which there may be many."""
_TWO_COEFFICIENTS = {"b_s", "b_k", "b_static", "b_kinetic", "mu_s", "mu_k"}
_FOLDER = resources.files("numerics") / "scene"


def shipped_scenes() -> tuple[str, ...]:
    """Return the short names of the scenes in the repository, sorted: the paper's examples and a few more."""
    return _names_in("shipped")


def described_scenes() -> dict[str, str]:
    """Return the shipped scenes by their names, with the sentence that each file begins with."""
    return {name: _shipped("shipped", name).partition("\n")[0].lstrip("# ") for name in shipped_scenes()}


def _names_in(folder: str) -> tuple[str, ...]:
    files = (_FOLDER / folder).iterdir()
    return tuple(sorted(one.name.removesuffix(".toml") for one in files if one.name.endswith(".toml")))


def _shipped(folder: str, name: str) -> str:
    return (_FOLDER / folder / f"{name}.toml").read_text("utf-8")


def load_scene(name_or_path: str | Path) -> Scene:
    """Return the scene of a shipped short name such as "velocities", or of a TOML file, "-" for standard input.

    Raises InvalidScene (one line, with the remedy) if there is no such file or it describes no scene.

    >>> load_scene("velocities").pair.b
    Fraction(1, 20)
    """
    return parse_scene(*_text_and_file(name_or_path, "shipped", "scene", "a TOML file"))


def load_line(name_or_path: str | Path) -> Scene:
    """Return a scene of one line, as `load_scene`; one on a surface is refused."""
    scene: Scene | PlaneScene = load_scene(name_or_path)
    if isinstance(scene, PlaneScene):
        raise InvalidScene("this is available on a line only; of a scene on a surface there are solve and response")
    return scene


def load_reference(name_or_path: str | Path) -> tuple[Piece, ...]:
    """Return the pieces of a reference r(t) (m), of a shipped short name or a TOML file of [[reference]] tables.

    They are written as those of a force, exact. Raises InvalidScene.

    >>> [float(piece.start) for piece in load_reference("s-curve")]
    [0.0, 2.0]
    """
    text, file = _text_and_file(name_or_path, "references", "reference", "a TOML file of [[reference]] tables")
    tables = _tables(text, "reference", file, _REFERENCE)
    return tuple(_read("reference", tables, _force_piece))


def _text_and_file(name_or_path: Any, folder: str, what: str, form: str) -> tuple[str, str]:
    """Return the text of a shipped file, or of one that somebody named, "-" for standard input, and that name.

    Raises InvalidScene.
    """
    if not isinstance(name_or_path, (str, os.PathLike)):
        raise InvalidScene(f"{shown(name_or_path)} is not the name of a {what}; give {form} or a shipped name")
    name, known = os.fspath(name_or_path), _names_in(folder)
    shipped = ", ".join(known) if len(known) < 9 else "those that `inertial-pair scenes` lists"
    if not name:
        raise InvalidScene(f"the name of the {what} is empty; give {form} or one of {shipped}")
    if name in known:
        return _shipped(folder, name), ""
    try:
        with nullcontext(sys.stdin.buffer) if name == "-" else Path(name).open("rb") as file:
            data = file.read(MAX_FORCED_BYTES + 1)
    except (OSError, ValueError) as error:
        near = difflib.get_close_matches(name, known, n=3, cutoff=0.6)
        remedy = f"did you mean {', '.join(near)}?" if near else f"give {form} or one of {shipped}"
        reason = getattr(error, "strerror", None) or str(error)
        raise InvalidScene(f"no {what} {str(Path(name))[:200]!r}: {reason}; {remedy}") from None
    named = "on standard input" if name == "-" else f"file {str(Path(name))!r}"
    most = MAX_FORCED_BYTES if any(f"[[{table}".encode() in data for table in _REPEATED) else MAX_BYTES
    if len(data) > most:
        raise InvalidScene(f"{what} {named} is larger than {most} bytes; a {what} needs a dozen lines")
    try:  # some editors on Windows begin a file with a byte order mark
        return data.decode("utf-8-sig"), "standard input" if name == "-" else repr(name)
    except UnicodeDecodeError:
        raise InvalidScene(f"{what} {named} is not UTF-8 text; save it as UTF-8") from None


def parse_scene(text: str, file: str = "") -> Scene:
    """Return the Scene that TOML `text` describes, numbers read as exact decimals; of lists a PlaneScene.

    Raises InvalidScene.
    """
    tables = _tables(text, "scene", file, _SCENE)
    pair, initial, run, force = tables["pair"], tables.get("initial", {}), tables["run"], tables.get("force", ())
    lists = [len(one) for one in (*pair.values(), *initial.values()) if isinstance(one, list)]
    law, pieces = read_law(run.get("law", Law.FILIPPOV)), _read("force", tables, _force_piece)
    if not (lists or "shape" in pair or any("axis" in one for one in force)):
        changes = _read("friction", tables, lambda one: Friction([(one["from"], one["b"])]).pieces[0])
        friction = Friction(changes, Weakening(**tables["weakening"]) if "weakening" in tables else None)
        return Scene(Pair(**pair), State(**initial), run["until"], law, Force(pieces), friction)
    if tables.get("weakening"):
        raise InvalidScene("[weakening] is for bodies on one line; leave it out, or give scalars in [pair]")
    if law is not Law.FILIPPOV:
        raise InvalidScene("on a surface the law is filippov; sgn(0) = 0 does not define a direction; leave it out")
    axes = [one.get("axis", "x") for one in force]
    for axis in axes:
        if axis not in AXES:
            raise InvalidScene(f"axis = {shown(axis)} is not one of {', '.join(AXES)}")
    n = max([2, *lists, *(AXES.index(axis) + 1 for axis in axes)])
    along = [Force(piece for axis, piece in zip(axes, pieces, strict=True) if axis == own) for own in AXES[:n]]
    changes = [(one["from"], one["b"]) for one in tables.get("friction", ())]
    surface = PlaneScene(PlanePair(**pair, axes=n), run["until"], **initial, force=along, friction=changes)
    return cast("Scene", surface)  # what is asked of a Scene is refused by type


def _tables(text: str, what: str, file: str, known: dict[str, tuple[str, str]]) -> dict[str, Any]:
    """Return the tables of a text, whose names and keys are known, with all keys that they must have."""
    try:
        # floats stay text until decimals.py has checked them: 0.005 must be 1/200, 1e999999999 must cost nothing
        tables = tomllib.loads(text, parse_float=lambda number: number.replace("_", ""))
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())[:200]
        raise InvalidScene(f"{f'{file} is ' if file else ''}not a TOML {what}: {reason}; correct that place") from None
    headed = {name: f"[[{name}]]" if name in _REPEATED else f"[{name}]" for name in known}
    for name in tables:
        if name not in known:
            raise InvalidScene(f"unknown table or key [{name[:40]!r}]; a {what} has {', '.join(headed.values())}")
    for name, keys in known.items():
        if name not in _REPEATED:
            _require_keys(tables.get(name, {}), keys, headed[name])
        elif not isinstance(tables.get(name, []), list):
            raise InvalidScene(
                f"{name} must be tables of its pieces; write {headed[name]} on a line of its own for each"
            )
        for number, one in enumerate(tables.get(name, ()) if name in _REPEATED else (), start=1):
            _require_keys(one, keys, f"{headed[name]} number {number}")
    return tables


def _read(name: str, tables: dict[str, Any], read: Callable[[dict[str, Any]], Any]) -> list[Any]:
    """Return what `read` makes of each of the tables [[name]]; an error says in which one it was."""
    found = []
    for number, one in enumerate(tables.get(name, []), start=1):
        try:
            found.append(read(one))
        except InvalidScene as error:
            raise InvalidScene(f"[[{name}]] number {number}: {error}") from None
    return found


def _force_piece(table: dict[str, Any]) -> Piece:
    sines = listed("sines", table.get("sines", ()))
    for one in sines:
        _require_keys(one, _SINE, "a sine { amplitude = A, omega = W, phase = P }")
    start = exact_decimal(table.get("from", 0), "from")
    return Piece(start, table.get("polynomial", ()), [Sine(**one) for one in sines])


def _require_keys(content: Any, keys: tuple[str, str], where: str) -> None:
    """Raise InvalidScene unless a table has the keys that it must have, and no unknown ones."""
    required, known = keys[0].split(), " ".join(sorted(" ".join(keys).split()))
    if not isinstance(content, dict):
        raise InvalidScene(f"{where} must be a table with the keys {known}, not {shown(content)}; give it its keys")
    for key in content:
        if key in _TWO_COEFFICIENTS:
            raise two_coefficients(key)
        if key not in known.split():
            raise InvalidScene(f"{where}: unknown key {key[:40]!r}; it takes {known}")
    for key in required:
        if key not in content:
            raise InvalidScene(f"{where}: missing key {key}; give it")


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
