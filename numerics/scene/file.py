"""Scene files: TOML in, a Scene out, nothing evaluated. The paper's examples are found by a short name."""

from __future__ import annotations

import difflib
import os
import sys
import tomllib
from collections.abc import Set
from contextlib import nullcontext
from fractions import Fraction
from importlib import resources
from pathlib import Path
from typing import Any, cast

from numerics.errors import InvalidScene
from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, Weakening
from numerics.scene.decimals import exact_decimal
from numerics.scene.plane import PlaneScene, is_plane, plane_scene
from numerics.scene.weakening import two_coefficients

MAX_BYTES, MAX_FORCED_BYTES = 65536, 2**25
"""Of a scene without a force, and of one with."""
_KEYS = {
    "pair": {"m1", "m2", "a1", "a2", "b"},
    "initial": {"x1", "v1", "x2", "v2"},
    "run": {"law", "until"},
    "weakening": {"speed", "last_slope", "place"},
}
_PIECES = {"force": {"from", "polynomial", "sines"}, "friction": {"from", "b"}}
_TWO_COEFFICIENTS = {"b_s", "b_k", "b_static", "b_kinetic", "mu_s", "mu_k"}
_SINE = {"amplitude", "omega", "phase"}
_REFERENCE = "reference"
_REQUIRED = (("pair", "m1"), ("pair", "m2"), ("pair", "a2"), ("pair", "b"), ("run", "until"))


def shipped_scenes() -> tuple[str, ...]:
    """Return the short names of the scenes in the repository, sorted: the paper's examples and a few more."""
    return _names_in("shipped")


def described_scenes() -> dict[str, str]:
    """Return the shipped scenes by their names, with the sentence that each file begins with."""
    folder = resources.files("numerics") / "scene" / "shipped"
    return {
        name: (folder / f"{name}.toml").read_text("utf-8").partition("\n")[0].lstrip("# ") for name in shipped_scenes()
    }


def _names_in(folder: str) -> tuple[str, ...]:
    files = (resources.files("numerics") / "scene" / folder).iterdir()
    return tuple(sorted(one.name.removesuffix(".toml") for one in files if one.name.endswith(".toml")))


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


def _text_and_file(name_or_path: Any, folder: str, what: str, form: str) -> tuple[str, str]:
    """Return the text of a shipped file, or of one that somebody named and that name. Raises InvalidScene."""
    if not isinstance(name_or_path, (str, os.PathLike)):
        shown = f"{str(name_or_path)[:40]!r}, {type(name_or_path).__name__}"
        raise InvalidScene(f"a {what} is named by text or a path, not {shown}; give {form} or a shipped name")
    name, known = os.fspath(name_or_path), _names_in(folder)
    shipped = ", ".join(known) if len(known) < 9 else "those that `inertial-pair scenes` lists"
    if not name:
        raise InvalidScene(f"the name of the {what} is empty; give {form} or one of {shipped}")
    if name in known:
        return (resources.files("numerics") / "scene" / folder / f"{name}.toml").read_text("utf-8"), ""
    near = difflib.get_close_matches(name, known, n=3, cutoff=0.6)
    remedy = f"did you mean {', '.join(near)}?" if near else f"give {form} or one of {shipped}"
    return _text_of(Path(name), what, remedy), "standard input" if name == "-" else repr(name)


def _text_of(path: Path, what: str, remedy: str) -> str:
    """Return the text of a file that somebody named, "-" for standard input. Raises InvalidScene."""
    try:
        with nullcontext(sys.stdin.buffer) if str(path) == "-" else path.open("rb") as file:
            data = file.read(MAX_FORCED_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InvalidScene(f"no {what} {str(path)[:200]!r}: {reason}; {remedy}") from None
    named = "on standard input" if str(path) == "-" else f"file {str(path)!r}"
    most = MAX_FORCED_BYTES if any(b"[[" + table.encode() in data for table in (*_PIECES, _REFERENCE)) else MAX_BYTES
    if len(data) > most:
        raise InvalidScene(f"{what} {named} is larger than {most} bytes; a {what} needs a dozen lines")
    try:
        return data.decode("utf-8-sig")  # some editors on Windows begin a file with a byte order mark
    except UnicodeDecodeError:
        raise InvalidScene(f"{what} {named} is not UTF-8 text; save it as UTF-8") from None


def load_reference(name_or_path: str | Path) -> tuple[Piece, ...]:
    """Return the pieces of a reference r(t) (m), of a shipped short name or a TOML file of [[reference]] tables.

    They are written as those of a force. Raises InvalidScene.

    >>> [float(piece.start) for piece in load_reference("s-curve")]
    [0.0, 2.0]
    """
    form = "a TOML file of [[reference]] tables"
    return parse_reference(*_text_and_file(name_or_path, "references", "reference", form))


def parse_reference(text: str, file: str = "") -> tuple[Piece, ...]:
    """Return the pieces that TOML `text` of [[reference]] tables describes, exact. Raises InvalidScene."""
    tables = _parsed(text, "reference", file)
    for table in tables:
        if table != _REFERENCE:
            raise InvalidScene(f"unknown table or key [{table[:40]!r}]; a reference has [[{_REFERENCE}]] only")
    found = _pieces_of(tables, _REFERENCE)
    return tuple(_in_place(_force_piece, one, number, _REFERENCE) for number, one in enumerate(found, start=1))


def _parsed(text: str, what: str, file: str) -> dict[str, Any]:
    try:
        # floats stay text until decimals.py has checked them: 0.005 must be 1/200, 1e999999999 must cost nothing
        return tomllib.loads(text, parse_float=_float_text)
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())[:200]
        raise InvalidScene(f"{f'{file} is ' if file else ''}not a TOML {what}: {reason}") from None


def parse_scene(text: str, file: str = "") -> Scene:
    """Return the Scene that TOML `text` describes, numbers read as exact decimals; of lists a PlaneScene.

    Raises InvalidScene.
    """
    tables = _parsed(text, "scene", file)
    on_surface = is_plane(tables)
    _check_keys(tables, {"shape"} if on_surface else set())
    pair, initial, run, weakening = (tables.get(name, {}) for name in _KEYS)
    force, friction = (_pieces_of(tables, name, {"axis"} if on_surface else set()) for name in _PIECES)
    if on_surface:  # what is asked of a Scene is refused by its type
        if weakening:
            raise InvalidScene("[weakening] is for bodies on one line; leave it out, or give scalars in [pair]")
        changes = [_in_place(_start_and_b, one, number, "friction") for number, one in enumerate(friction, start=1)]
        return cast("Scene", plane_scene(tables, lambda one, number: _in_place(_force_piece, one, number), changes))
    return Scene(
        Pair(**pair),
        State(**initial),
        until=run["until"],
        law=run.get("law", Law.FILIPPOV),
        force=Force(_in_place(_force_piece, one, number) for number, one in enumerate(force, start=1)),
        friction=Friction(
            (_in_place(_friction_piece, one, number, "friction") for number, one in enumerate(friction, start=1)),
            Weakening(**weakening) if "weakening" in tables else None,
        ),
    )


def _pieces_of(tables: dict[str, Any], name: str, more: Set[str] = frozenset()) -> list[dict[str, Any]]:
    """Return the tables [[name]], in their order; none is an empty list."""
    found = tables.get(name, [])
    if not isinstance(found, list) or not all(isinstance(one, dict) for one in found):
        raise InvalidScene(f"{name} must be tables of its pieces; write [[{name}]] on a line of its own for each")
    for one in found:
        _require_known(one, _PIECES.get(name, _PIECES["force"]) | more, f"[[{name}]]")
    return found


def _in_place(read: Any, table: dict[str, Any], number: int, name: str = "force") -> Any:
    """Return what `read` makes of a table [[name]]; an error says in which one it was."""
    try:
        return read(table)
    except InvalidScene as error:
        raise InvalidScene(f"[[{name}]] number {number}: {error}") from None


def _force_piece(table: dict[str, Any]) -> Piece:
    sines = []
    for one in _list(table, "sines"):
        if not isinstance(one, dict):
            raise InvalidScene("a sine must be { amplitude = A, omega = W, phase = P }")
        _require_known(one, _SINE, "a sine")
        sines.append(Sine(_given(one, "amplitude", "a sine"), _given(one, "omega", "a sine"), one.get("phase", 0)))
    return Piece(exact_decimal(table.get("from", 0), "from"), _list(table, "polynomial"), sines)


def _friction_piece(table: dict[str, Any]) -> tuple[Fraction, Fraction]:
    """Return one piece of friction, checked by itself."""
    ((start, b),) = Friction([_start_and_b(table)]).pieces
    return start, b


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


def _float_text(text: str) -> str:
    return text.replace("_", "")


def _check_keys(tables: dict[str, Any], more: Set[str]) -> None:
    for table, content in tables.items():
        if table in _PIECES:
            continue
        if table not in _KEYS:
            raise InvalidScene(
                f"unknown table or key [{table[:40]!r}]; a scene has [pair], [initial], [run], "
                "[weakening], [[force]], [[friction]]"
            )
        if not isinstance(content, dict):
            raise InvalidScene(f"{table} must be a table; write [{table}] on a line of its own")
        _require_known(content, _KEYS[table] | (more if table == "pair" else set()), f"[{table}]")
    for table, key in _REQUIRED:
        if key not in tables.get(table, {}):
            raise InvalidScene(f"missing key {key} in [{table}]; every scene must give it")


def _require_known(content: dict[str, Any], keys: Set[str], where: str) -> None:
    for key in content:
        if key in _TWO_COEFFICIENTS:
            raise two_coefficients(key)
        if key not in keys:
            raise InvalidScene(f"unknown key {key[:40]!r} in {where}; it takes {', '.join(sorted(keys))}")
