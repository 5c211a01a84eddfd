"""The whole audit at one of three sizes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from numerics.audit.formulas import audit_formulas
from numerics.audit.rows import Progress, Row
from numerics.audit.solves import audit_solves, audit_symmetries


class Size(NamedTuple):
    """How many cases: arguments of a formula; scenes of a kind, in all arithmetics and in float64; of a symmetry."""

    arguments: int
    scenes: int
    bounded: int
    symmetric: int


SIZES = {
    "small": Size(500, 5, 10, 30),
    "default": Size(5_000, 60, 300, 500),
    "large": Size(20_000, 600, 10_000, 3000),
}


def audit(size: Size, seed: int, progress: Progress) -> Iterator[Row]:
    """Yield every row; the same seed and size give the same rows."""
    yield from audit_formulas(seed, size.arguments, progress)
    yield from audit_solves(seed, size.scenes, size.bounded, progress)
    yield from audit_symmetries(seed, size.symmetric, progress)
