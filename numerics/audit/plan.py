"""The whole audit at one of three sizes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

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


SIZES = {
    "small": Size(arguments=8, trials=150, scenes=5, bounded=10, symmetric=35, texts=600),
    "default": Size(arguments=200, trials=4000, scenes=120, bounded=300, symmetric=700, texts=10_000),
    "large": Size(arguments=2000, trials=40_000, scenes=1200, bounded=14_300, symmetric=7000, texts=100_000),
}


def audit(size: Size, seed: int, progress: Progress) -> Iterator[Row]:
    """Yield every row; the same seed and size give the same rows."""
    yield from audit_formulas(formulas(), seed, size.arguments, progress)
    yield from audit_enclosures(seed, size.trials, size.scenes, progress)
    yield from audit_trajectories(seed, size.scenes, progress)
    yield from audit_bounds(seed, size.bounded, progress)
    yield from audit_symmetries(seed, size.symmetric, progress)
    yield from audit_refusals(seed, size.texts, progress)
