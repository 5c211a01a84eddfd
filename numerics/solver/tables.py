"""The answers of a batch as tables of pandas and xarray."""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.errors import MissingTool
from numerics.solver.inputs import varying
from numerics.trajectory.columns import STATE
from numerics.trajectory.status import Status


def values_of(batch: Any, answer: str) -> Any:
    """Return an answer of a batch by its name, x1, v1, x2 and v2 at the end among them."""
    return batch.y[STATE.index(answer)] if answer in STATE else getattr(batch, answer)


def _columns(batch: Any) -> dict[str, Any]:
    """Return the inputs, how each run ended, and the answers; those of the end that an input is called like: x1_end."""
    status = np.vectorize(lambda one: Status(one).name, otypes=[object])(batch.status)
    answers = {name: values_of(batch, name) for name in batch.ANSWERS}
    inputs = batch.inputs
    return (
        inputs | {"status": status} | {f"{name}_end" if name in inputs else name: one for name, one in answers.items()}
    )


def dataframe(batch: Any) -> Any:
    """Return a pandas DataFrame; see Batch.to_dataframe."""
    try:
        import pandas as pd
    except ImportError:
        raise MissingTool("a data frame needs pandas, which is not installed; use inputs, y and dissipated") from None
    return pd.DataFrame({name: np.ravel(one) for name, one in _columns(batch).items()})


def dataset(batch: Any) -> Any:
    """Return an xarray Dataset; see Batch.to_xarray."""
    try:
        import xarray as xr
    except ImportError:
        raise MissingTool("a Dataset needs xarray, which is not installed; use inputs, y and dissipated") from None
    names, columns, axes = [f"axis_{k}" for k in range(len(batch.shape))], _columns(batch), {}
    for name, one in varying(batch.inputs).items():
        along = [k for k in range(one.ndim) if (one != one.take([0], axis=k)).any()]
        if len(along) == 1 and names[along[0]].startswith("axis_"):
            names[along[0]] = name
            axes[name] = np.moveaxis(one, along[0], 0).reshape(one.shape[along[0]], -1)[:, 0]
            del columns[name]
    return xr.Dataset({name: (names, one) for name, one in columns.items()}, axes)
