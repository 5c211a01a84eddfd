"""Saved trajectories with another header: what somebody may write on purpose."""

from pathlib import Path

import numpy as np


def header_of(path: Path) -> str:
    """Return the header of a saved trajectory."""
    with np.load(path) as archive:
        return archive["header"].tobytes().decode()


def write_header(path: Path, text: str | bytes) -> None:
    """Write an archive with this header as `save` does."""
    np.savez_compressed(path, header=np.frombuffer(text if isinstance(text, bytes) else text.encode(), np.uint8))
