"""Writing a file whole or not at all, in a folder that is made where there is none."""

from __future__ import annotations

from pathlib import Path

from numerics.files import whole_file


def write(path: Path, content: str | bytes) -> None:
    """Write `content` (text as UTF-8) so that `path` is never seen half written.

    Interrupted before the end, `path` is as it was before. Raises OSError where the folder cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path) as file:
        file.write(content.encode() if isinstance(content, str) else content)
