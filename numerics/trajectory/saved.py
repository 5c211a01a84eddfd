"""A trajectory in plain data, and in a file without a pickle: what comes back equals what was there, to the last bit.

The file is a NumPy archive. Its `header` is JSON in UTF-8: the scene as TOML text, the arithmetic, how the run ended,
and the numbers of mpmath and of balls, their mantissas as hexadecimal texts. `rows` and `end` are the record of a run
in floats (linear/record.py).
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
from flint import arb, arb_poly
from mpmath.libmp import from_man_exp

from numerics.arithmetic.by_name import arithmetic_named
from numerics.errors import InvalidFile, InvalidScene
from numerics.files import whole_file
from numerics.linear.pieces import pieces_of
from numerics.linear.record import END_ROW, ROW, How, Knot, Record
from numerics.scene import Scene
from numerics.scene.decimals import require_whole
from numerics.scene.file import parse_scene
from numerics.scene.writing import scene_text
from numerics.trajectory.columns import ball_of, parts_of
from numerics.trajectory.solution import Solution

FORMAT = "inertial-pair trajectory 1"
_REMEDY = "give a file that Trajectory.save has written"
_ARITHMETICS = ("float64", "double-double", "mpmath", "ball")


def save(trajectory: Solution, file: str | Path) -> None:
    """Write a trajectory to a file. Raises OSError, InvalidScene for a scene that no text of 1000 characters holds."""
    write(file, *contents(trajectory))


def load(file: str | Path, kind: Any) -> Any:
    """Return the trajectory in a file, an object of the class `kind`. Raises OSError, InvalidFile."""
    return read(file, lambda header, arrays: restored(header, arrays, kind))


def contents(trajectory: Solution) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return header and arrays of a trajectory in a file."""
    header, arrays = run_of(trajectory)
    return {"format": FORMAT, "scene": kept_scene(trajectory.scene), **header}, arrays


def run_of(trajectory: Solution) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return what a run wrote, without its scene: what JSON holds, and arrays."""
    rows, end, how, *rest = trajectory.record
    arrays = {"rows": rows, "end": end} if isinstance(rows, np.ndarray) else {}
    return {
        "arithmetic": [trajectory.arithmetic.name, trajectory.arithmetic.digits],
        "how": int(how),
        "rest": plain(rest),
        "knots": None if arrays else plain([*rows, end]),
        "digits": trajectory.digits,
        "tried": trajectory.tried,
        "t_eval": None if trajectory.t_eval is None else plain(trajectory.t_eval),
    }, arrays


def restored(header: dict[str, Any], arrays: dict[str, Any], kind: Any) -> Any:
    """Return the trajectory of header and arrays. Raises ValueError, and what else others' files can bring about."""
    require_format(header, FORMAT)
    return of_run(kind, parse_scene(header["scene"]), header, arrays)


def unpickled(kind: Any, scene: Scene, header: str, arrays: dict[str, Any]) -> Any:
    """Return the trajectory that a pickle holds: flint has no pickles of balls, so its header is JSON there, too."""
    return of_run(kind, scene, header_of(header), arrays)


def of_run(kind: Any, scene: Scene, header: dict[str, Any], arrays: dict[str, Any]) -> Any:
    """Return the trajectory of the class `kind` with what a run wrote; raises as `restored`."""
    (name, digits), right = header["arithmetic"], header["digits"]
    if name not in _ARITHMETICS:
        raise ValueError(f"its arithmetic is {str(name)[:40]!r}")
    for what, count in (("digits", digits), ("right digits", right)):
        if count is not None:
            require_whole(what, count, 1)
    if bool(arrays) != (name in _ARITHMETICS[:2]):
        raise ValueError(f"its numbers are not those of {name}")
    record = _record(header, arrays, len(pieces_of(scene)))
    arithmetic = arithmetic_named(name, digits)
    return kind(scene, arithmetic, record, digits=right, tried=str(header["tried"]), t_eval=header["t_eval"])


def kept_scene(scene: Any) -> str:
    """Return the text of a scene from which it comes back. Raises InvalidScene if none of 1000 characters does."""
    text = scene_text(scene)
    if parse_scene(text) != scene:
        raise InvalidScene("a number of this scene does not fit into a scene file; round it before it is saved")
    return text


def require_format(header: dict[str, Any], wanted: str) -> None:
    """Refuse a header of something else, by a ValueError."""
    if header["format"] != wanted:
        raise ValueError(f"its format is {str(header['format'])[:40]!r}, not {wanted!r}")


def header_text(header: dict[str, Any]) -> str:
    """Return a header as JSON."""
    return json.dumps(header)


def header_of(text: str) -> dict[str, Any]:
    """Return the header of a text of JSON, the very same numbers in it."""
    found: dict[str, Any] = json.loads(text, object_hook=_number)
    return found


def write(file: str | Path, header: dict[str, Any], arrays: dict[str, Any]) -> None:
    """Write header and arrays as one archive. Raises OSError."""
    text = np.frombuffer(header_text(header).encode(), dtype=np.uint8)
    with whole_file(Path(file)) as opened:
        np.savez_compressed(opened, header=text, **arrays)


def read(file: str | Path, restore: Callable[[dict[str, Any], dict[str, Any]], Any]) -> Any:
    """Return what `restore` makes of header and arrays of a file. Raises OSError, InvalidFile."""
    path = Path(file)
    with path.open("rb") as opened:
        is_archive = zipfile.is_zipfile(opened)
    if not is_archive:
        raise InvalidFile(f"{str(path)!r} is no NumPy archive; {_REMEDY}")
    try:
        with np.load(path, allow_pickle=False) as archive:
            header = header_of(archive["header"].tobytes().decode())
            arrays = {name: archive[name] for name in ("rows", "end") if name in archive}
        return restore(header, arrays)
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, EOFError, zipfile.BadZipFile) as error:
        reason = " ".join(str(error).split())[:200]
        raise InvalidFile(f"{str(path)!r} holds no saved trajectory: {reason}; {_REMEDY}") from None


def _record(header: dict[str, Any], arrays: dict[str, Any], pieces: int) -> Record:
    """Return what a run wrote. Raises ValueError, and what else a file that nobody saved can bring about."""
    if arrays:
        rows, end = arrays["rows"], arrays["end"]
        if rows.dtype != float or rows.shape[1:] != (ROW,) or end.dtype != float or end.shape != (END_ROW,):
            raise ValueError("its arrays have other shapes")
        codes = rows[:, [0, 4]]
    else:
        *rows, end = (Knot(*one) for one in header["knots"])
        codes = np.array([(one.mode, one.piece) for one in rows], dtype=float)
    modes, indices = codes.T
    if not len(codes) or not np.isin(modes, (-1, 0, 1)).all() or not np.isin(indices, range(pieces)).all():
        raise ValueError("its rows are not those of a run of its scene")
    events, certain, *lost = header["rest"]
    if not isinstance(events, int) or not 0 <= events < len(codes) or not isinstance(certain, bool):
        raise ValueError("its count of events is not that of its rows")
    if any(isinstance(one, (str, dict)) for one in lost):
        raise ValueError("what friction took is no number")
    return Record(rows, end, How(header["how"]), events, certain, *lost)


def plain(value: Any) -> Any:
    """Return numbers as what JSON holds; a list for every sequence."""
    if isinstance(value, arb_poly):
        return {"polynomial": [plain(one) for one in value.coeffs()]}
    if isinstance(value, arb):
        return {"ball": [*_hexadecimal(*parts_of(value.mid())), *_hexadecimal(*parts_of(value.rad()))]}
    if isinstance(value, mpmath.mpf):
        mantissa, exponent = value.man_exp  # without the sign
        return {"mpf": _hexadecimal(-mantissa if value < 0 else mantissa, exponent)}
    if isinstance(value, (Decimal, Fraction)):
        return {"ratio": [hex(one) for one in value.as_integer_ratio()]}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(one) for one in value]
    return value.item() if isinstance(value, np.generic) else value


def _hexadecimal(mantissa: int, exponent: int) -> list[Any]:
    return [hex(mantissa), int(exponent)]


def _number(found: dict[str, Any]) -> Any:
    """Return the number that an object of the JSON text stands for, else the object."""
    for name, read in _READ.items():
        if list(found) == [name]:
            return read(*(int(one, 16) if isinstance(one, str) else one for one in found[name]))
    return found


_READ: dict[str, Any] = {
    "ball": ball_of,
    "mpf": lambda mantissa, exponent: mpmath.make_mpf(from_man_exp(mantissa, exponent)),
    "ratio": Fraction,
    "polynomial": lambda *coefficients: arb_poly(list(coefficients)),
}
