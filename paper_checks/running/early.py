"""Starts the process that those for rows are started from, before this one has loaded sympy: both load at the same time."""

from __future__ import annotations

import argparse


def begin_for(options: argparse.Namespace) -> None:
    """Let another process load the checks as early as can be, where all rows will be decided in several."""
    if options.program and not options.ids and options.jobs != 1:
        from numerics.tasks import available_cores
        from paper_checks.running.kept import Kept

        if (options.jobs or available_cores()) > 1 and (options.fresh or Kept(options.seed).is_empty()):
            begin()


def begin() -> None:
    """Let that process load the checks, while this one does something else."""
    from paper_checks.running import processes

    processes.begin(["paper_checks.claims"])
