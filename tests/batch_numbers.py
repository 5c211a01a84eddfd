"""Numbers of a batch, on a line and on a surface, each beside the true one and its bound."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from numerics.trajectory.comparison import distance


def against_truth(found: Any, k: int, truth: Any) -> Iterator[tuple[float, Any, float]]:
    """Yield each number of a row, how far it is off a run in balls, and its bound; first the counts must agree."""
    assert (found.events[k], found.status[k]) == (len(truth.events), truth.status)
    kept = min(found.event_t.shape[-1], len(truth.events))
    assert np.isnan(found.event_t[k, kept:]).all()
    assert np.isnan(found.event_y[:, k, kept:]).all()
    states = np.reshape(truth.y, (4, -1, len(truth.events) + 2)).swapaxes(1, 2)
    answers = ("energy",) if hasattr(found, "energy") else ("energy_excess", "dissipated")
    with truth.context():
        numbers = [
            (found.y[:, k], states[:, -1], found.y_error[:, k]),
            (found.event_y[:, k, :kept], states[:, 1 : kept + 1], found.event_y_error[:, k, :kept]),
            (found.event_t[k, :kept], truth.event_times[:kept], found.event_t_error[k, :kept]),
            *((getattr(found, name)[k], getattr(truth, name), getattr(found, f"{name}_error")[k]) for name in answers),
        ]
        for near, true, bound in numbers:
            last = np.ravel(true)[-np.size(near) :] if np.size(near) else ()
            for x, y, most in zip(np.ravel(near), last, np.ravel(bound), strict=True):
                if not np.isnan(x):
                    yield float(x), distance(float(x), y).upper(), float(most)
