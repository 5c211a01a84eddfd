"""`solve --plot F`: one figure that shows a trajectory from all sides."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from numerics.scene import Law, Scene
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
    figure.suptitle(f"{_pair(trajectory.scene)}\n{_course(trajectory, curve.t[-1])}", fontsize="medium")
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


def _pair(scene: Scene) -> str:
    """Return the parameters of a pair, and the law if it is not Filippov's."""
    pair = scene.pair
    named = [("m_1", pair.m1, "kg"), ("m_2", pair.m2, "kg"), ("a_2", pair.a2, "N/m"), ("b", pair.b, "N")]
    if pair.a1 > 0:
        named.append(("a_1", pair.a1, "N s/m"))
    if scene.friction.pieces:
        named = [one for one in named if one[0] != "b"]
    by_pieces = ", $b$ by pieces" if scene.friction.pieces else ""
    literal = "; sgn(0) = 0 read literally" if scene.law is Law.THREE_VALUED_SGN else ""
    return ", ".join(_quantity(*one) for one in named) + by_pieces + literal


def _course(trajectory: Trajectory, end: float) -> str:
    """Return where a trajectory starts, how many events it has up to its end (s), and how it ends."""
    scene, count = trajectory.scene, len(trajectory.events)
    at, units = scene.initial, {"x": "m", "v": "m/s"}
    moved = [(f"{name[0]}_{name[1]}", getattr(at, name), units[name[0]]) for name in ("x1", "v1", "x2", "v2")]
    start = ", ".join(_quantity(*one) for one in moved if one[1] != 0) or "rest"
    events = f"{count} event{'' if count == 1 else 's'} in {end:g} s"
    return f"from {start}: {events}; {trajectory.message}"


def _quantity(name: str, value: Fraction, unit: str) -> str:
    return f"${name}$ = {float(value):g} {unit}"
