"""Files: the folder in which what is needed again is kept, and writing a file whole or not at all."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO


def cache_folder() -> Path:
    """Return `inertial-pair` in the user's cache: that of XDG_CACHE_HOME, of LOCALAPPDATA (Windows), or ~/.cache.

    A relative path is ignored, as the XDG specification asks. A user without a home has a folder that cannot be made.
    """
    for variable in ("XDG_CACHE_HOME", "LOCALAPPDATA"):
        named = Path(os.environ.get(variable, ""))
        if named.is_absolute():
            return named / "inertial-pair"
    try:
        return Path.home() / ".cache" / "inertial-pair"
    except RuntimeError:  # neither HOME nor an entry in the list of users
        return Path(os.devnull) / "inertial-pair"


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Open a binary file that takes its name only when the block ends well; otherwise nothing is left behind.

    A temporary file in the same folder takes the bytes and then the name. Raises OSError, which names `path`.
    """
    temporary = None
    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=path.parent)
        temporary = Path(name)
        with os.fdopen(handle, "wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        temporary.chmod(0o644)  # mkstemp's own mode hides the file from other readers
        temporary.replace(path)
    except OSError as error:
        raise OSError(error.errno or errno.EIO, error.strerror or str(error), str(path)) from None
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
