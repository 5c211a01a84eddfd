"""Inputs and results of many scenes, as tables of pandas and xarray."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from numerics.exits import tool
from numerics.habits import Helpful
from numerics.solver.inputs import varying
from numerics.trajectory.columns import STATE, Array, Floats
from numerics.trajectory.units import unit

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset


class Tabled(Helpful):
    """What has `inputs` and `results` by their names, in its `shape`; results may have points along one axis more."""

    shape: tuple[int, ...]
    inputs: dict[str, Floats]
    results: dict[str, Array]

    def __len__(self) -> int:
        """Return how many scenes there were."""
        return math.prod(self.shape)

    def _columns(self) -> dict[str, Array]:
        return self.inputs | {f"{name}_at_t" if name in STATE else name: one for name, one in self.results.items()}

    def to_dataframe(self) -> DataFrame:
        """Return inputs and results as a pandas DataFrame, a row for each scene, or point of it. Raises MissingTool.

        `.attrs["units"]` has the units. x1, v1, x2, v2 are those at the start, x1_at_t, ... those at `t`.
        """
        columns = self._columns()
        whole = max((one.shape for one in columns.values()), key=len)
        wide = {name: one.reshape(one.shape + (1,) * (len(whole) - one.ndim)) for name, one in columns.items()}
        found: DataFrame = tool("pandas").DataFrame(
            {name: np.broadcast_to(one, whole).ravel() for name, one in wide.items()}
        )
        found.attrs["units"] = {name: unit(name) for name in columns}
        return found

    def to_xarray(self) -> Dataset:
        """Return the same as an xarray Dataset. Raises MissingTool.

        An axis is named by the input whose values label it, if one alone varies along it and no value comes twice;
        else it is `scene`, of a grid `axis_0`, `axis_1`, ...
        """
        make, columns, axes = tool("xarray").Dataset, self._columns(), {}
        names = ["scene"] if len(self.shape) == 1 else [f"axis_{k}" for k in range(len(self.shape))]
        moving = {
            name: [k for k in range(one.ndim) if (one != one.take([0], axis=k)).any()]
            for name, one in varying(self.inputs).items()
        }
        for k in range(len(names)):
            along = [name for name, places in moving.items() if places == [k]]
            if len(along) != 1:
                continue
            values = np.moveaxis(columns[along[0]], k, 0).reshape(self.shape[k], -1)[:, 0]
            if len(np.unique(values)) == len(values):
                names[k], axes[along[0]] = along[0], values
                del columns[along[0]]
        found: Dataset = make({name: ((*names, "point")[: one.ndim], one) for name, one in columns.items()}, axes)
        for name in found.variables:
            found[name].attrs["units"] = unit(name)
        return found
