"""Starts the process that those for rows are started from, before this one has loaded sympy: both load at the same time."""

from __future__ import annotations

import pkgutil

from paper_checks import checks
from paper_checks.running import processes


def begin() -> None:
    """Let that process load the checks, and what sympy loads when it first simplifies, while this one does something else."""
    names = (f"{checks.__name__}.{one.name}" for one in pkgutil.iter_modules(checks.__path__))
    processes.begin([*names, "sympy.physics.units"])
