"""A checkpoint: one JSON line says what is computed, each further one holds a finished part."""

from __future__ import annotations

import json
from pathlib import Path

from numerics.errors import InvalidMap


class Checkpoint:
    """Finished parts by name, kept in a file (or nowhere). A last line torn by a crash is dropped."""

    def __init__(self, path: Path | None, title: dict[str, object]) -> None:
        """Read what is there, or begin the file with the title. Raises InvalidMap if it belongs to something else."""
        self.finished: dict[str, str] = {}
        self._path = path
        if path is None:
            return
        whole = _whole_lines(path)
        if not whole:
            path.write_text(_line(title), "utf-8")
            return
        if _parsed(whole[0], path, 1) != title:
            raise InvalidMap(f"checkpoint {path.name} is of another map ({whole[0].strip()[:120]}); name another file")
        for number, text in enumerate(whole[1:], start=2):
            part = _parsed(text, path, number)
            if set(part) != {"part", "result"} or not all(isinstance(one, str) for one in part.values()):
                raise InvalidMap(f"checkpoint {path.name}, line {number} is no finished part; remove the line")
            self.finished[part["part"]] = part["result"]
        # what is appended next must not continue a torn line
        path.write_text("".join(whole), "utf-8")

    def add(self, part: str, result: str) -> None:
        """Append a finished part as one whole line."""
        if self._path is not None:
            with self._path.open("a", encoding="utf-8") as file:
                file.write(_line({"part": part, "result": result}))


def _line(record: dict[str, object]) -> str:
    return json.dumps(record) + "\n"


def _whole_lines(path: Path) -> list[str]:
    """Return the lines that end in a newline; none if there is no file."""
    if not path.exists():
        return []
    lines = path.read_bytes().decode("utf-8", errors="replace").splitlines(keepends=True)
    return [line for line in lines if line.endswith("\n")]


def _parsed(text: str, path: Path, number: int) -> dict[str, str]:
    try:
        record = json.loads(text)
    except ValueError:
        record = None
    if not isinstance(record, dict):
        raise InvalidMap(f"checkpoint {path.name}, line {number} is damaged; remove the line, or name another file")
    return record
