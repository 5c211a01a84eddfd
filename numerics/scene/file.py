"""Scene files: TOML in, a Scene out, nothing evaluated. The paper's examples are found by a short name."""

from __future__ import annotations

import difflib
import os
import sys
import tomllib
from collections.abc import Callable, Set
from contextlib import nullcontext
from importlib import resources
from pathlib import Path
from typing import Any, cast

from numerics.errors import InvalidScene
from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, Weakening
from numerics.scene.decimals import exact_decimal
from numerics.scene.plane import PlaneScene, plane_scene
from numerics.scene.weakening import two_coefficients

MAX_BYTES, MAX_FORCED_BYTES = 65536, 2**25
"""Of a scene without a force, and of one with."""
_PIECE = {"from", "polynomial", "sines"}
_REFERENCE = {"reference": _PIECE}
_SCENE = {
    "pair": {"m1", "m2", "a1", "a2", "b", "shape"},
    "initial": {"x1", "v1", "x2", "v2"},
    "run": {"law", "until"},
    "weakening": {"speed", "last_slope", "place"},
    "force": {*_PIECE, "axis"},
    "friction": {"from", "b"},
}
_REPEATED = {"force", "friction", "reference"}
"""Tables of which there may be many."""
_TWO_COEFFICIENTS = {"b_s", "b_k", "b_static", "b_kinetic", "mu_s", "mu_k"}
_SINE = {"amplitude", "omega", "phase"}
_REQUIRED = (("pair", "m1"), ("pair", "m2"), ("pair", "a2"), ("pair", "b"), ("run", "until"))
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
        raise InvalidScene(
            "a scene on a surface can be solved, and asked for its response; this is known on one line only"
        )
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
        shown = f"{str(name_or_path)[:40]!r}, {type(name_or_path).__name__}"
        raise InvalidScene(f"a {what} is named by text or a path, not {shown}; give {form} or a shipped name")
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
    for table, key in _REQUIRED:
        if key not in tables.get(table, {}):
            raise InvalidScene(f"missing key {key} in [{table}]; every scene must give it")
    pair, run = tables["pair"], tables["run"]
    initial, weakening, force = (tables.get(name, {}) for name in ("initial", "weakening", "force"))
    lists = [one for one in (*pair.values(), *initial.values()) if isinstance(one, list)]
    if lists or "shape" in pair or any("axis" in one for one in force):  # what is asked of a Scene is refused by type
        if weakening:
            raise InvalidScene("[weakening] is for bodies on one line; leave it out, or give scalars in [pair]")
        pieces = [
            (one.get("axis", "x"), read) for one, read in zip(force, _read("force", tables, _force_piece), strict=True)
        ]
        changes = _read("friction", tables, _start_and_b)
        return cast("Scene", plane_scene(pair, initial, run, pieces, changes))
    return Scene(
        Pair(**pair),
        State(**initial),
        until=run["until"],
        law=run.get("law", Law.FILIPPOV),
        force=Force(_read("force", tables, _force_piece)),
        friction=Friction(
            _read("friction", tables, lambda one: Friction([_start_and_b(one)]).pieces[0]),
            Weakening(**weakening) if "weakening" in tables else None,
        ),
    )


def _tables(text: str, what: str, file: str, known: dict[str, set[str]]) -> dict[str, Any]:
    """Return the tables of a text, whose names and keys are known."""
    try:
        # floats stay text until decimals.py has checked them: 0.005 must be 1/200, 1e999999999 must cost nothing
        tables = tomllib.loads(text, parse_float=lambda number: number.replace("_", ""))
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())[:200]
        raise InvalidScene(f"{f'{file} is ' if file else ''}not a TOML {what}: {reason}") from None
    shown = {name: f"[[{name}]]" if name in _REPEATED else f"[{name}]" for name in known}
    for name, content in tables.items():
        if name not in known:
            raise InvalidScene(f"unknown table or key [{name[:40]!r}]; a {what} has {', '.join(shown.values())}")
        if name in _REPEATED and not isinstance(content, list):
            raise InvalidScene(
                f"{name} must be tables of its pieces; write {shown[name]} on a line of its own for each"
            )
        for one in content if name in _REPEATED else [content]:
            if not isinstance(one, dict):
                raise InvalidScene(f"{name} must be a table; write {shown[name]} on a line of its own")
            _require_known(one, known[name], shown[name])
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
    sines = []
    for one in _list(table, "sines"):
        if not isinstance(one, dict):
            raise InvalidScene("a sine must be { amplitude = A, omega = W, phase = P }")
        _require_known(one, _SINE, "a sine")
        sines.append(Sine(_given(one, "amplitude", "a sine"), _given(one, "omega", "a sine"), one.get("phase", 0)))
    return Piece(exact_decimal(table.get("from", 0), "from"), _list(table, "polynomial"), sines)


def _start_and_b(table: dict[str, Any]) -> tuple[Any, Any]:
    return _given(table, "from", "friction"), _given(table, "b", "friction")


def _list(table: dict[str, Any], key: str) -> list[Any]:
    found = table.get(key, [])
    if not isinstance(found, list):
        raise InvalidScene(f"{key} must be a list; write {key} = [...]")
    return found


def _given(table: dict[str, Any], key: str, where: str) -> Any:
    if key not in table:
        raise InvalidScene(f"missing key {key} in {where}; give it")
    return table[key]


def _require_known(content: dict[str, Any], keys: Set[str], where: str) -> None:
    for key in content:
        if key in _TWO_COEFFICIENTS:
            raise two_coefficients(key)
        if key not in keys:
            raise InvalidScene(f"unknown key {key[:40]!r} in {where}; it takes {', '.join(sorted(keys))}")
