"""Scene files: TOML in, a Scene out, nothing evaluated, and back. The paper's examples are found by a short name."""

from __future__ import annotations

import difflib
import os
import re
import sys
import tomllib
from collections.abc import Callable, Iterator, Sequence
from contextlib import nullcontext
from importlib import resources
from itertools import chain
from pathlib import Path
from typing import Any, cast

from numerics.errors import InvalidScene
from numerics.habits import right_word
from numerics.scene import Friction, Law, Pair, Piece, Scene, Signal, Sine, State, Weakening
from numerics.scene.decimals import decimal_text, listed, shown
from numerics.scene.model import BUILD, read_law, require_kind
from numerics.scene.plane import AXES, PlanePair, PlaneScene

MAX_BYTES = 2**25
"""Of a scene, or of a table of samples."""
_PIECE = "from polynomial sines"
_SIGNAL = f"{_PIECE} file kind"
_REFERENCE = {"reference": ("", _PIECE)}
_SURFACE = {
    "pair": ("m1 m2 a2 b", "a1 shape"),
    "initial": ("", "x1 v1 x2 v2"),
    "run": ("until", "law"),
    "force": ("", f"{_SIGNAL} axis"),
    "friction": ("from b", ""),
}
_LINE = _SURFACE | {
    "pair": ("m1 m2 a2 b", "a1 b_static"),
    "weakening": ("", "speed last_slope place"),
    "force": ("", f"{_SIGNAL} body"),
    "friction": ("", f"{_SIGNAL} b"),
    "belt": ("", _SIGNAL),
    "wall": ("", _SIGNAL),
}
"""The keys of each table: those that it must have, and others."""
_ON_A_LINE = ("weakening", "belt", "wall", "b_static", "body")
_SINE = ("amplitude omega", "phase")
_REPEATED = {"force", "friction", "belt", "wall", "reference"}
"""Tables of which there may be many."""
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
    tables = _tables(text, "reference", file)
    _require_tables(tables, "reference", _REFERENCE)
    return tuple(_read("reference", tables, _piece))


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
        return _shipped(folder, name), str(_FOLDER / folder / name)
    near = difflib.get_close_matches(name, known, n=3, cutoff=0.6)
    remedy = f"did you mean {', '.join(near)}?" if near else f"give {form} or one of {shipped}"
    return _content(name, what, remedy), name


def _content(name: str, what: str, remedy: str) -> str:
    """Return the text of a file, "-" for standard input. Raises InvalidScene."""
    path = str(Path(name))[:200]
    try:
        with nullcontext(sys.stdin.buffer) if name == "-" else Path(name).open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InvalidScene(f"no {what} {path!r}: {reason}; {remedy}") from None
    named = "on standard input" if name == "-" else repr(path)
    if len(data) > MAX_BYTES:
        raise InvalidScene(f"{what} {named} is larger than {MAX_BYTES} bytes; leave some of it out")
    try:  # some editors on Windows begin a file with a byte order mark
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InvalidScene(f"{what} {named} is not UTF-8 text; save it as plain text in UTF-8") from None


def parse_scene(text: str, file: str = "") -> Scene:
    """Return the Scene that TOML `text` describes, numbers read as exact decimals; of lists a PlaneScene.

    The name of its file is where the files of samples are looked for, and is said in errors. Raises InvalidScene.
    """
    tables, folder = _tables(text, "scene", file), Path(file).parent
    numbers = [table for name in ("pair", "initial") if isinstance(table := tables.get(name), dict)]
    lists = {key: one for table in numbers for key, one in table.items() if isinstance(one, list)}
    pieces = [one for one in _some(tables.get("force")) if isinstance(one, dict)]
    is_named = "shape" in _some(tables.get("pair")) or any("axis" in one for one in pieces)
    if len(lists) == 1 and lists.keys() <= tables["pair"].keys() and not is_named:
        ((key, one),) = lists.items()
        raise InvalidScene(
            f"{key} = {shown(one)} is a list; give one number on a line, arrays to "
            'solve_many, and a pair on a surface also shape = "ellipsoid"'
        )
    on_surface = bool(lists or is_named)
    given = [*tables, *_some(tables.get("pair")), *chain.from_iterable(pieces)] if on_surface else []
    for name in _ON_A_LINE:
        if name in given:
            raise InvalidScene(f"{name} is for bodies on one line; leave it out, or give scalars in [pair]")
    _require_tables(tables, "scene on a surface" if on_surface else "scene", _SURFACE if on_surface else _LINE)
    initial, until = tables.get("initial", {}), tables["run"]["until"]
    law = read_law(tables["run"].get("law", Law.FILIPPOV))

    def friction(table: dict[str, Any]) -> Sequence[Any]:
        found = _friction_pieces(table, folder)
        return found if on_surface else Friction(found).pieces  # an error says in which table it is

    steps = chain.from_iterable(_read("friction", tables, friction))
    if not on_surface:
        on_bodies = _signals(tables, "force", folder, "body", (1, 2))
        weakening = Weakening(**tables["weakening"]) if "weakening" in tables else None
        others = (_signals(tables, name, folder)[0] for name in ("belt", "wall"))
        start = Pair(**tables["pair"]), State(**initial), until, law
        return Scene(*start, on_bodies[0], Friction(steps, weakening), on_bodies[1], *others)
    if law is not Law.FILIPPOV:
        raise InvalidScene("on a surface the law is filippov; sgn(0) = 0 does not define a direction; leave it out")
    along = _signals(tables, "force", folder, "axis", AXES)
    n = max([2, *map(len, lists.values()), *(AXES.index(one.get("axis", "x")) + 1 for one in pieces)])
    surface = PlaneScene(PlanePair(**tables["pair"], axes=n), until, **initial, force=along[:n], friction=steps)
    return cast("Scene", surface)  # what is asked of a Scene is refused by type


def _some(given: Any) -> Any:
    """Return what can be looked through."""
    return given if isinstance(given, (dict, list)) else ()


def _signals(
    tables: dict[str, Any], name: str, folder: Path, key: str = "", values: tuple[Any, ...] = ("",)
) -> list[Signal]:
    """Return the signal of the tables [[name]] for each value of a key, which is the first where it is left out."""

    def read(table: dict[str, Any]) -> tuple[Any, tuple[Piece, ...]]:
        value = table.get(key, values[0])
        if value not in values:
            known = ", ".join(map(str, values))
            raise InvalidScene(f"{key} = {shown(value)} is not one of {known}; leave it out for the first")
        return value, _samples(table, folder) if "file" in table else (_piece(table),)

    found = _read(name, tables, read)
    try:
        return [Signal(piece for value, pieces in found if value == own for piece in pieces) for own in values]
    except InvalidScene as error:
        raise InvalidScene(f"[[{name}]]: {error}; give what acts at one time in one table") from None


def _samples(table: dict[str, Any], folder: Path) -> tuple[Piece, ...]:
    """Return the pieces of a file of two columns, t and u, with or without a line of their names."""
    file = table["file"]
    if not isinstance(file, str):
        raise InvalidScene(f"file = {shown(file)} must be a text; give the path of a file of samples")
    if others := ", ".join(sorted(table.keys() & {*_PIECE.split(), "b"})):
        raise InvalidScene(f"file = {shown(file)} has times and values of its own; leave {others} out")
    lines = _content(str(folder / file), "file of samples", "give its path from the scene file").rstrip().splitlines()
    names = "".join(lines[:1]).strip(' "#').lower()
    first = int(names[:1].isalpha() and not names.startswith(("nan", "inf")))
    rows = [line.replace('"', "").split(",") for line in lines[first:]]
    if not rows:
        raise InvalidScene(f"{shown(file)} holds no samples; give a line t, u for each")
    for number, row in enumerate(rows, first + 1):
        if len(row) != 2 or ";" in lines[number - 1]:
            place = f"row {number} of {shown(file)}, {shown(lines[number - 1])},"
            raise InvalidScene(f"{place} is not a t and a u; write 0.5, 1.25 with decimal points and one comma")
    t, u = zip(*rows, strict=True)
    try:
        return Signal.samples(t, u, table.get("kind", "linear"), first + 1).pieces
    except InvalidScene as error:
        raise InvalidScene(f"{shown(file)}: {error}") from None


def _tables(text: str, what: str, file: str) -> dict[str, Any]:
    """Return the tables of a text. Raises InvalidScene."""
    try:
        # floats stay text until decimals.py has checked them: 0.005 must be 1/200, 1e999999999 must cost nothing
        return tomllib.loads(text, parse_float=lambda number: number.replace("_", ""))
    except (ValueError, RecursionError) as error:
        reason = "a number has thousands of digits" if "integer string" in str(error) else " ".join(str(error).split())
        place = re.search(r"at line (\d+)", reason)
        line = f", {shown(text.splitlines()[int(place[1]) - 1])}" if place else ""
        named = {"": "", "-": "standard input is "}.get(file, f"{file!r} is ")
        remedy = "write key = 0.05, with a decimal point, texts in quotes"
        if file.lower().endswith((".csv", ".txt", ".dat")):
            remedy = f"samples are a file = {file!r} in a [[force]] of a scene"
        raise InvalidScene(f"{named}not a TOML {what}: {reason[:200]}{line}; {remedy}") from None


def _require_tables(tables: dict[str, Any], what: str, known: dict[str, tuple[str, str]]) -> None:
    """Raise InvalidScene unless names and keys of tables are known, and all are there that there must be."""
    headed = {name: f"[[{name}]]" if name in _REPEATED else f"[{name}]" for name in known}
    for name in tables:
        if name not in known:
            right = right_word(name, [*known], f"a {what} has {', '.join(headed.values())}")
            raise InvalidScene(f"unknown table or key [{name[:40]!r}]; {right}")
    for name, keys in known.items():
        given = tables.get(name, [] if name in _REPEATED else {})
        if name not in _REPEATED:
            _require_keys(given, keys, f"{headed[name]} of a {what}")
        elif not isinstance(given, list):
            raise InvalidScene(
                f"{name} must be tables of its pieces; write {headed[name]} on a line of its own for each"
            )
        else:
            for number, one in enumerate(given, start=1):
                _require_keys(one, keys, f"{headed[name]} number {number} of a {what}")


def _read(name: str, tables: dict[str, Any], read: Callable[[dict[str, Any]], Any]) -> list[Any]:
    """Return what `read` makes of each of the tables [[name]]; an error says in which one it was."""
    found = []
    for number, one in enumerate(tables.get(name, []), start=1):
        try:
            found.append(read(one))
        except InvalidScene as error:
            raise InvalidScene(f"[[{name}]] number {number}: {error}") from None
    return found


def _piece(table: dict[str, Any]) -> Piece:
    """Return one piece of a signal."""
    if "kind" in table:
        raise InvalidScene("kind is that of a file; give file, or leave kind out")
    sines = listed("sines", table.get("sines", ()))
    for one in sines:
        _require_keys(one, _SINE, "a sine { amplitude = A, omega = W, phase = P }")
    return Piece(table.get("from", 0), table.get("polynomial", ()), [Sine(**one) for one in sines])


def _friction_pieces(table: dict[str, Any], folder: Path) -> Sequence[Any]:
    """Return pieces of friction: each its start and a constant b, or a Piece; b may stand beside sines."""
    if "file" in table:
        return _samples(table, folder)
    if "from" not in table:
        raise InvalidScene("missing key from; give it")
    if len(table) < 2:
        raise InvalidScene("missing key b; give b, or polynomial and sines")
    if "b" not in table:
        return [_piece(table)]
    if "polynomial" in table:
        raise InvalidScene("b stands beside polynomial, whose first number it is; leave out either")
    if "sines" in table:
        return [_piece({"polynomial": [table["b"]], **{key: one for key, one in table.items() if key != "b"}})]
    return [(table["from"], table["b"])]


def _require_keys(content: Any, keys: tuple[str, str], where: str) -> None:
    """Raise InvalidScene unless a table has the keys that it must have, and no unknown ones."""
    required, known = keys[0].split(), sorted(" ".join(keys).split())
    if not isinstance(content, dict):
        raise InvalidScene(f"{where} must be a table with the keys {' '.join(known)}, not {shown(content)}; give it so")
    for key in content:
        if key not in known:
            raise InvalidScene(f"{where}: unknown key {key[:40]!r}; {right_word(key, known)}")
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
    start, friction = getattr(scene, "initial", scene), scene.friction
    yield from _table("[pair]", scene.pair, "m1 m2 a1 a2 b b_static shape")
    yield from (*_table("[initial]", start, "x1 v1 x2 v2"), *_table("[run]", scene, "until law"))
    if isinstance(scene, PlaneScene):
        forces = [("force", f'axis = "{axis}"', force.pieces) for axis, force in zip(AXES, scene.force, strict=False)]
        for begin, b in friction:
            yield from ("[[friction]]", f"from = {_text(begin)}", f"b = {_text(b)}")
    else:
        if friction.weakening is not None:
            yield from _table("[weakening]", friction.weakening, "last_slope speed place")
        forces = [(name, "body = 2" if name == "force_2" else "", some) for name, some in scene.pieces.items()]
    for name, more, pieces in forces:
        for piece in pieces:
            yield from filter(None, (f"[[{name.removesuffix('_2')}]]", more, f"from = {_text(piece.start)}"))
            if name == "friction" and piece.constant is not None:
                yield f"b = {_text(piece.constant)}"
            else:
                yield f"polynomial = {_text(piece.polynomial)}"
                sines = (", ".join(_table("", one, "amplitude omega phase")) for one in piece.sines)
                yield f"sines = [{', '.join(f'{{ {one} }}' for one in sines)}]"


def _table(head: str, of: Any, keys: str) -> Iterator[str]:
    """Yield a head, if there is one, and the keys that are there."""
    yield from filter(None, [head])
    values = ((key, getattr(of, key, None)) for key in keys.split())
    yield from (f"{key} = {_text(value)}" for key, value in values if value is not None)


def _text(value: Any) -> str:
    """Return a number, a word, or a list."""
    if isinstance(value, tuple):
        return f"[{', '.join(map(_text, value))}]"
    if isinstance(value, (float, str, Law)):
        return f'"{value.value if isinstance(value, Law) else value}"'
    text = decimal_text(value)
    return f'"{text}"' if "/" in text or len(text) > 18 else text  # TOML's whole numbers have 64 bits
