"""The whole audit at one of three sizes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from numerics.audit.formulas import audit_formulas
from numerics.audit.refusals import audit_refusals
from numerics.audit.solves import audit_solves
from numerics.audit.symmetries import audit_symmetries
from numerics.audit.table import Progress, Row


@dataclass(frozen=True)
class Size:
    """How many cases each part tries."""

    arguments: int
    """of a formula in a decade"""
    scenes: int
    """of each kind, in every arithmetic"""
    bounded: int
    """of each kind in float64"""
    symmetric: int
    """scenes for each symmetry"""
    texts: int
    """for each way to spoil a scene"""


SIZES = {
    "small": Size(arguments=3, scenes=5, bounded=10, symmetric=30, texts=600),
    "default": Size(arguments=40, scenes=60, bounded=300, symmetric=500, texts=10_000),
    "large": Size(arguments=200, scenes=600, bounded=10_000, symmetric=3000, texts=50_000),
}


def audit(size: Size, seed: int, progress: Progress) -> Iterator[Row]:
    """Yield every row; the same seed and size give the same rows."""
    yield from audit_formulas(seed, size.arguments, progress)
    yield from audit_solves(seed, size.scenes, size.bounded, progress)
    yield from audit_symmetries(seed, size.symmetric, progress)
    yield from audit_refusals(seed, size.texts, progress)
