"""Files: the folder in which what is needed again is kept, and writing a file whole or not at all."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO


def cache_folder() -> Path:
    """Return `inertial-pair` in the user's cache, where the system has it (platformdirs).

    What is kept there is believed: a folder that others own or can write is not used, as if it could not be made, and
    `cache_refused` says why. A user without a home, and one without platformdirs, has a folder that cannot be made.
    """
    folder = _user_cache()
    return NOWHERE if folder is None or _fault(folder) else folder


def cache_refused() -> str:
    """Return in one sentence why the user's cache is not used though it is there; "" where nothing is wrong with it."""
    folder = _user_cache()
    fault = "" if folder is None else _fault(folder)
    return fault and f"the cache is not used: {fault}; correct its owner or mode, or set XDG_CACHE_HOME to another"


NOWHERE = Path(os.devnull) / "inertial-pair"
"""A folder that cannot be made."""


def _user_cache() -> Path | None:
    try:
        from platformdirs import user_cache_path
    except ImportError:  # it comes with what keeps anything: the extras `compiled` and `checks`
        return None
    try:
        found = user_cache_path("inertial-pair", appauthor=False)
    except RuntimeError:  # neither HOME nor an entry in the list of users
        return None
    return found if found.is_absolute() else None


def _fault(folder: Path) -> str:
    """Return what lets others change what is in a folder; "" where nothing does, or the system has no such owners.

    As ssh asks of the folder of its keys: it and all folders above, also above a link to it, are written by their owner
    alone, who is this user or the system (root). Above, a folder with the sticky bit will do, as /tmp: nobody else can
    move what is ours there. A folder that is not there yet is made by us, for us alone.
    """
    if not hasattr(os, "getuid"):
        return ""
    real = Path(os.path.realpath(folder))
    for place in (real, *real.parents, *folder.parents):
        if place.exists():
            found = place.stat()
            if found.st_uid not in ({os.getuid()} if place == real else {os.getuid(), 0}):
                return f"{place} belongs to another user"
            if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH) and (place == real or not found.st_mode & stat.S_ISVTX):
                return f"others can write {place}"
    return ""


def make_private(folder: Path) -> None:
    """Make a folder of the cache, with those above it, so that nobody else can write it. Raises OSError."""
    for place in (*reversed(folder.parents), folder):
        if not place.is_dir():
            place.mkdir(mode=0o700, exist_ok=True)


A_DAY = 86400.0  # s


def forget_unused(folder: Path, most: int, idle: float = A_DAY) -> None:
    """Remove the folders in a folder of the cache that were used longest ago, all but so many.

    One that was used within the last `idle` seconds stays: a process with other sources may want it again.
    """
    try:
        used = sorted((one.stat().st_mtime, one) for one in folder.iterdir() if one.is_dir())
    except OSError:
        return
    for last, old in used[:-most]:
        if time.time() - last > idle:
            shutil.rmtree(old, ignore_errors=True)


def path_of(file: object) -> Path:
    """Return the path of what names a file. Raises TypeError."""
    try:
        return Path(file)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(f"file = {str(file)[:40]!r} is no name of a file; give one as text or a Path") from None


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Open a binary file that takes its name only when the block ends well; otherwise nothing is left behind.

    A temporary file in the same folder takes the bytes and then the name. A link stays a link; a device or a pipe takes
    the bytes when they are whole. Raises OSError, which names `path`.
    """
    temporary = None
    try:
        if path.exists() and not path.is_file():
            with path.open("wb") as device, tempfile.TemporaryFile() as file:  # a folder is refused here
                yield file
                file.seek(0)
                shutil.copyfileobj(file, device)
            return
        target = Path(os.path.realpath(path))
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=target.parent)
        temporary = Path(name)
        with os.fdopen(handle, "wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        temporary.chmod(0o644)  # mkstemp's own mode hides the file from other readers
        temporary.replace(target)
    except OSError as error:
        reason = f"{error.strerror or error}; name a file in a folder that is there and can be written"
        raise OSError(error.errno or errno.EIO, reason, str(path)) from None
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
