"""Title and caption of each figure, as they stand in `captions.toml`."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path


@cache
def caption(name: str) -> tuple[str, str]:
    """Return the title and the caption of a figure; one without has its name as title."""
    known = tomllib.loads(Path(__file__).with_suffix(".toml").read_text("utf-8")).get(name, {})
    return known.get("title", name.replace("-", " ").capitalize()), " ".join(known.get("caption", "").split())
