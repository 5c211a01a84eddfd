"""A picture of a batch: one of its answers over the inputs that vary."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from numerics.solver.inputs import is_of_state, varying
from numerics.trajectory.figures import BLUE, ORANGE, axes_for
from numerics.trajectory.units import unit


def draw_batch(batch: Any, answer: str, along: Any, ax: Any) -> Any:
    """Draw into matplotlib axes; see Batch.plot."""
    axes, ax = along_of(batch, along), axes_for(answer, batch.ANSWERS, ax, "answer")
    values = batch.values(answer)
    right, label = np.ravel(batch.success), _label(f"{answer} at the end" if is_of_state(answer) else answer, answer)
    if values.ndim > len(batch.shape):
        (name, given), *_ = axes.items()
        x = np.broadcast_to(given[..., None], values.shape)
        ax.plot(x.ravel(), values.ravel(), ".", color=BLUE, ms=1.5, alpha=0.6, rasterized=True)
        ax.set(xlabel=_label(name), ylabel=f"{answer}, once a period ({unit(answer)})")
        return ax
    points = [np.ravel(one) for one in axes.values()]
    if len(points) == 1:
        points.append(np.ravel(values))
        order = np.argsort(points[0], kind="stable")
        points, right = [one[order] for one in points], right[order]
        ax.plot(points[0], np.where(right, points[1], np.nan), ".-", color=BLUE, ms=3, lw=0.8)
        ax.set_ylabel(label)
    else:
        if values.ndim == 2 and {*map(_direction, axes.values())} == {0, 1}:
            found = ax.pcolormesh(*axes.values(), np.where(batch.success, values, np.nan), rasterized=True)
        else:
            found = ax.scatter(*(one[right] for one in points), c=np.ravel(values)[right], s=25, marker="s")
        ax.figure.colorbar(found, ax=ax, label=label)
        ax.set_ylabel(_label(list(axes)[1]))
    if not right.all():
        ax.plot(*(one[~right] for one in points), "x", color=ORANGE, ms=4, label="not at the horizon, or not certain")
        ax.legend(fontsize="small")
    ax.set_xlabel(_label(next(iter(axes))))
    return ax


def along_of(batch: Any, along: Any) -> dict[str, Any]:
    """Return one or two inputs by their names, in the shape of the batch. Raises ValueError."""
    given = batch.inputs
    if isinstance(along, str):
        if along not in given:
            raise ValueError(f"along = {along[:40]!r} is not one of {', '.join(given)}; or give an array")
        return {along: given[along]}
    if along is not None:
        try:
            return {"given": np.asarray(along, dtype=float).reshape(batch.shape)}
        except (TypeError, ValueError):
            raise ValueError(f"along must be the name of an input, or numbers of the shape {batch.shape}") from None
    changed = [*varying(given).items()][:2]
    if changed:
        return dict(changed)
    return {"scene": np.arange(math.prod(batch.shape)).reshape(batch.shape)}


def _direction(given: Any) -> int | None:
    """Return the axis along which alone an input varies, and only grows or only falls; None if there is none."""
    signs = [{*np.sign(np.diff(given, axis=axis)).flat} for axis in (0, 1)]
    return next((axis for axis in (0, 1) if signs[axis] in ({1}, {-1}) and signs[1 - axis] == {0}), None)


def _label(name: str, quantity: str = "") -> str:
    of = unit(quantity or name) or "sign of v1 - v2" * (name == "mode")
    return f"{name} ({of})" if of else name
