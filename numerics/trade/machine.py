"""On what it was measured: versions and processor, no paths and no dates."""

from __future__ import annotations

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from numerics.batch.parallel import available_cores

PACKAGES = ("numpy", "python-flint", "mpmath", "numba", "scipy", "heyoka", "jax", "diffrax")


def machine() -> dict[str, Any]:
    """Return the processor, its cores, its load, and the versions of Python and of the packages that are installed."""
    return {
        "processor": _processor(),
        "cores": available_cores(),
        "load": _load(),
        "system": platform.system(),
        "python": platform.python_version(),
        "packages": {name: found for name in PACKAGES if (found := _version(name)) is not None},
    }


def _load() -> float | None:
    """Return how many processes wanted to run in the last minute, where the system tells it: 0 where it was idle."""
    return round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None


def _processor() -> str:
    """Return the model of the processor where Linux tells it, its architecture elsewhere."""
    try:
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
    except OSError:
        lines = []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor() or platform.machine()
