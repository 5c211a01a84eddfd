"""The whole audit at one of three sizes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from numerics.audit.bounds import audit_bounds
from numerics.audit.catalogue import formulas
from numerics.audit.enclosures import audit_enclosures
from numerics.audit.formulas import audit_formulas
from numerics.audit.refusals import audit_refusals
from numerics.audit.symmetries import audit_symmetries
from numerics.audit.table import Progress, Row
from numerics.audit.trajectories import audit_trajectories


@dataclass(frozen=True)
class Size:
    """How many cases each part tries."""

    arguments: int
    """of a formula in a decade; 20 times as many from 1e-3 to 1e3"""
    trials: int
    """of the enclosures of a function"""
    scenes: int
    """of each kind, in the three arithmetics"""
    bounded: int
    """of each kind, whose float64 error bounds are held against the truth"""
    symmetric: int
    """scenes for each symmetry"""
    texts: int
    """for each way to spoil a scene"""


# large is five times the default, but for the bounds: there it is rates of 1e-5 that are looked for
SIZES = {
    "small": Size(arguments=8, trials=150, scenes=5, bounded=10, symmetric=35, texts=600),
    "default": Size(arguments=200, trials=4000, scenes=120, bounded=300, symmetric=700, texts=10_000),
    "large": Size(arguments=1000, trials=20_000, scenes=600, bounded=10_000, symmetric=3500, texts=50_000),
}


def audit(size: Size, seed: int, progress: Progress) -> Iterator[Row]:
    """Yield every row; the same seed and size give the same rows."""
    parts: tuple[Callable[[Progress], Iterator[Row]], ...] = (
        lambda told: audit_formulas(formulas(), seed, size.arguments, told),
        lambda told: audit_enclosures(seed, size.trials, size.scenes, told),
        lambda told: audit_trajectories(seed, size.scenes, told),
        lambda told: audit_bounds(seed, size.bounded, told),
        lambda told: audit_symmetries(seed, size.symmetric, told),
        lambda told: audit_refusals(seed, size.texts, told),
    )
    for number, part in enumerate(parts, start=1):
        yield from part(partial(_told, progress, f"part {number} of {len(parts)}"))


def _told(progress: Progress, part: str, what: str) -> None:
    progress(f"{part}: {what}")
