"""Every number of a row of a batch, on a line or on a surface, with its bound and the true one."""

from collections.abc import Iterator
from typing import Any

import numpy as np


def row_numbers(batch: Any, row: int, truth: Any) -> Iterator[tuple[str, Any, float, Any]]:
    """Yield name, number, bound and the number of a run in balls; the events must be as many, in the same modes."""
    assert batch.events[row] == len(truth.events)
    kept = min(batch.event_t.shape[-1], len(truth.events))
    assert np.isnan(batch.event_t[row, kept:]).all()
    assert np.isnan(batch.event_y[:, row, kept:]).all()
    modes = [getattr(one.after, "sign", one.after) for one in truth.events]
    assert batch.event_mode[row].tolist()[:kept] == modes[:kept]
    states, times = np.reshape(truth.y, (4, -1, len(truth.t))).swapaxes(1, 2), truth.event_times[:kept]
    late = batch.event_t_error[row, :kept]
    found = [
        ("t", batch.t[row], 2.0**-52 * batch.t[row] + late.max(initial=0.0), truth.end_time),
        ("y", batch.y[:, row], batch.y_error[:, row], states[:, -1]),
        ("event_t", batch.event_t[row, :kept], late, times),
        ("event_y", batch.event_y[:, row, :kept], batch.event_y_error[:, row, :kept], states[:, 1 : kept + 1]),
    ]
    for name in ("energy",) if "energy" in batch.ANSWERS else ("energy_excess", "dissipated"):
        found.append((name, getattr(batch, name)[row], getattr(batch, f"{name}_error")[row], end_of(truth, name)))
    for name, *three in found:
        yield from ((name, *one) for one in zip(*map(np.ravel, three), strict=True) if not np.isnan(one[0]))


def end_of(truth: Any, name: str) -> Any:
    """Return an energy at the end of a run."""
    return truth.dissipated if name == "dissipated" else getattr(truth, name)[-1]
