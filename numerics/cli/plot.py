"""`solve --plot F`: one figure that shows a trajectory from all sides."""

from __future__ import annotations

from typing import Any

from numerics.scene import Law
from numerics.trajectory.curve import sampled
from numerics.trajectory.figures import draw
from numerics.trajectory.trajectory import Trajectory

FREE = ("velocities", "positions", "load", "phase", "excess", "energy")
FORCED = ("force", "load", "velocities", "positions", "phase", "energy")
COMMON = ("body 1", "body 2", "entry", "exit", "crossing", "stick")
"""What means the same in every picture, and is explained once, below all of them."""


def overview(trajectory: Trajectory) -> Any:
    """Return a matplotlib figure: velocities, positions, load, phase portrait and energy, titled by the scene.

    Under a force it shows u(t) too.
    """
    from matplotlib.figure import Figure

    figure, curve = Figure(figsize=(11, 11), layout="constrained"), sampled(trajectory)
    common: dict[str, Any] = {}
    kinds = FORCED if trajectory.scene.is_forced else FREE
    if trajectory.scene.friction.weakening:
        kinds = ("friction", "relative", *FORCED[1:4], "energy")
    for kind, ax in zip(kinds, figure.subplots(3, 2).flat, strict=True):
        draw(trajectory, kind, ax, curve)
        common |= _moved_out(ax)
    chosen = {name: common[name] for name in COMMON if name in common}
    figure.legend(chosen.values(), chosen, loc="outside lower center", ncols=len(chosen) or 1, fontsize="small")
    scene, count, law = trajectory.scene, len(trajectory.events), ""
    if scene.law is Law.THREE_VALUED_SGN:
        law = "; sgn(0) = 0 read literally"
    course = f"{count} event{'' if count == 1 else 's'} in {curve.t[-1]:g} s; {trajectory.message}"
    figure.suptitle(f"{scene.pair} from {scene.initial}{law}\n{course}", fontsize="medium")
    return figure


def _moved_out(ax: Any) -> dict[str, Any]:
    """Take the common marks out of the legend of axes, and return them by their labels."""
    handles = {name: handle for handle, name in zip(*ax.get_legend_handles_labels(), strict=True)}
    own = {name: handle for name, handle in handles.items() if name not in COMMON}
    if ax.get_legend() is not None:
        place = ax.get_legend()._loc  # the public way to read it does not exist
        ax.get_legend().remove()
        if own:
            ax.legend(own.values(), own, loc=place, fontsize="small", framealpha=0.9)
    return {name: handle for name, handle in handles.items() if name in COMMON}
