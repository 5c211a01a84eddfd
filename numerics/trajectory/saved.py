"""A trajectory in plain data, and in a file without a pickle: what comes back equals what was there, to the last bit.

The file is a NumPy archive. Its `header` is JSON in UTF-8: the scene as TOML text, the arithmetic, how the run ended,
and what it wrote; numbers of mpmath and of balls have their mantissas as hexadecimal texts, arrays of floats their
bytes as base64, column by column: decimals take three times as long.
"""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from decimal import Decimal
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
from flint import arb, arb_poly
from mpmath.libmp import from_man_exp

from numerics.arithmetic.ball import ball_of
from numerics.errors import InvalidFile, InvalidScene
from numerics.files import path_of, whole_file
from numerics.scene.file import parse_scene, scene_text
from numerics.trajectory.comparison import as_fraction

_REMEDY = "give a file that `save` of such a run has written"
_SAID = {
    "pickle": "it is no npz archive",
    "No data left": "it is empty",
    "is not a file": "it is an archive of plain arrays, as of --npz, which np.load reads",
    "'inertial-pair surface trajectory 5'": "it is a run on a surface, which PlaneTrajectory.load reads",
    "'inertial-pair trajectory 6'": "it is a run on a line, which Trajectory.load reads",
    "'inertial-pair ": "it is of another version; solve its scene again",
}
"""What is wrong with a file where an error says this."""


def save(trajectory: Any, file: str | Path) -> None:
    """Write a trajectory to a file. Raises OSError, ValueError for another ending of its name than .npz.

    Raises InvalidScene for a scene that no text of 1000 characters holds.
    """
    path = path_of(file)
    if path.suffix not in {"", ".npz"}:
        raise ValueError(f"{str(path)!r} is a name of another kind of file; end it in .npz, or write to_csv() to it")
    text = json.dumps(contents(trajectory)).encode()
    header, digest = (np.frombuffer(one, dtype=np.uint8) for one in (text, sha256(text).digest()))
    with whole_file(path) as opened:
        np.savez_compressed(opened, header=header, digest=digest)


def load(file: str | Path, kind: Any) -> Any:
    """Return the trajectory in a file, an object of the class `kind`. Raises OSError, InvalidFile."""
    path = path_of(file)
    try:
        opened = path.open("rb")
    except OSError as error:
        raise OSError(error.errno, f"{error.strerror}; {_REMEDY}", str(path)) from None
    try:
        with opened, np.errstate(invalid="raise"), np.load(opened, allow_pickle=False) as archive:
            text = archive["header"].tobytes()
            if archive["digest"].tobytes() != sha256(text).digest():
                raise ValueError("it was changed")
            return restored(_tuples(json.loads(text, object_hook=_number)), kind)
    except Exception as error:  # noqa: BLE001 - whatever may come of what somebody wrote or changed
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        reason = next((said for word, said in _SAID.items() if word in reason), reason)
        raise InvalidFile(f"{str(path)!r} holds no saved trajectory: {reason}; {_REMEDY}") from None


def contents(trajectory: Any) -> dict[str, Any]:
    """Return a trajectory with its scene as what JSON holds."""
    text = scene_text(trajectory.scene)
    if parse_scene(text) != trajectory.scene:
        raise InvalidScene("a number of this scene does not fit into a scene file; round it before it is saved")
    return {"format": trajectory.FORMAT, "scene": text, **run_of(trajectory)}


def run_of(trajectory: Any) -> dict[str, Any]:
    """Return what a run wrote, without its scene, as what JSON holds."""
    header = {"arithmetic": [trajectory.arithmetic.name, trajectory.arithmetic.digits], "digits": trajectory.digits}
    return header | {"tried": trajectory.tried, "t_eval": plain(trajectory.t_eval), **trajectory.kept()}


def restored(header: dict[str, Any], kind: Any) -> Any:
    """Return the trajectory of a header, of the class `kind`. Raises ValueError for that of another one."""
    if header["format"] != kind.FORMAT:
        raise ValueError(f"its format is {str(header['format'])[:40]!r}, not that of a {kind.__name__}")
    found = kind.restored(parse_scene(header["scene"]), header)
    return found.but(digits=header["digits"], tried=header["tried"], t_eval=header["t_eval"])


def plain(value: Any) -> Any:
    """Return numbers as what JSON holds; a list for every sequence."""
    if isinstance(value, arb_poly):
        return {"polynomial": plain(value.coeffs())}
    for name, (kind, parts, _) in _KINDS.items():
        if isinstance(value, kind):
            return {name: [hex(int(one)) for one in parts(value)]}
    if isinstance(value, np.ndarray) and value.dtype == float:
        return {"floats": [b64encode(value.astype("<f8").tobytes("F")).decode(), *value.shape]}
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.dtype == object):
        return [plain(one) for one in value]
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value


def _number(found: dict[str, Any]) -> Any:
    """Return the number that an object of the JSON text stands for, or the array of floats; else the object."""
    (name, *more), (parts, *_) = found, found.values()
    if more:
        return found
    if name == "floats":
        text, *shape = parts
        return np.frombuffer(b64decode(text), dtype="<f8").reshape(shape, order="F").astype(float, order="C")
    return arb_poly(parts) if name == "polynomial" else _KINDS[name][2](*(int(one, 16) for one in parts))


def _tuples(given: Any) -> Any:
    """Return a tuple for every list."""
    if isinstance(given, dict):
        return {name: _tuples(one) for name, one in given.items()}
    return tuple(map(_tuples, given)) if isinstance(given, list) else given


_KINDS: dict[str, Any] = {
    "ball": (arb, lambda x: (*x.mid().man_exp(), *x.rad().man_exp()), lambda *parts: ball_of(parts[:2], parts[2:])),
    "mpf": (
        mpmath.mpf,
        lambda x: as_fraction(x).as_integer_ratio(),
        lambda p, q: mpmath.make_mpf(from_man_exp(p, 1 - q.bit_length())),  # q is a power of 2
    ),
    "ratio": ((Decimal, Fraction), lambda x: x.as_integer_ratio(), Fraction),
}
"""Of each kind of exact number its whole numbers, and what makes it of them."""
