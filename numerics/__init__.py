"""Trajectories of the inertial pair, two masses coupled by dry friction, with bounds on their errors.

A scene, exact:
    Pair                the two bodies, their spring, damper and friction (kg, N/m, N s/m, N)
    State               positions and velocities at t = 0 (m, m/s)
    Scene               a pair, a state, a horizon (s), forces, changes of friction, and a belt or a wall that moves
    Signal              a function of time by pieces: a force, N, the velocity of a belt, the displacement of the wall
    Force               the same; Force.sine, .step, .ramp, .trapezoid, .sweep, .samples
    Piece, Sine         the parts of a signal
    Friction            the friction force b(t) by pieces, N
    Weakening           friction that depends on slip speed and displacement
    PlanePair           two bodies on a surface: one number per axis
    PlaneScene          such a pair, its initial state, and the force on each axis
    Law                 the reading of sgn(0) where v1 = v2
    load_scene          a scene from a TOML file, or a shipped one such as "velocities"
    scene_text          a scene as TOML text
Solving:
    solve               one scene: its Trajectory, in the cheapest arithmetic that has the digits
    solve_many          many scenes given as arrays, on all cores: a Batch
    solve_scenes        many scenes given as a list, on a line or on a surface
    bifurcation         their states once a period, and the diagram of them
    check               what every number of a run is really off by: solved again in balls
Results:
    Trajectory          events, state at any time, energy, error bounds; plot, animate, save, load
    PlaneTrajectory     the same for a scene on a surface
    Batch               final states of many runs as arrays, on a line or on a surface
    Bifurcation         states once a period, of many scenes
    Mode                slip+, slip- or stick
    sensitivities       derivatives of a trajectory by every number of its scene
Control through the interface:
    response            the long-time response to a periodic force
    thresholds          amplitudes: the largest for permanent stick, the smallest for slip with two reversals a period
    fastest_transfer    the force that moves body 2 from rest to rest
    cheapest_transfer   the one with the least int u^2 dt in a given time
    track               the force under which body 2 follows a reference
    load_reference      a reference from a TOML file, or a shipped one such as "s-curve"
    ring_entry          when the relative motion has settled
    damping             when a free pair sticks permanently, when it rests, and its best damper
Exceptions:
    NumericsError       the base class
    InvalidScene        numbers or a file that are not a valid scene; also a ValueError
    EventUndecided      an order of events that the permitted digits do not decide
    PrecisionExhausted  the requested digits were not reached
    OutOfRange          a number outside the range of float64
    NotDifferentiable   a motion without a derivative by its data
    NotSettled          a long-time motion that was not found
    MissingTool         an optional package that is not installed

`help(numerics.solve)` describes one of them in full, and `numerics.__version__` is the version.
"""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from types import FunctionType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    __version__: str
    from numerics.control.cheapest import cheapest_transfer as cheapest_transfer
    from numerics.control.damping import damping as damping
    from numerics.control.response import response as response
    from numerics.control.ring import ring_entry as ring_entry
    from numerics.control.thresholds import thresholds as thresholds
    from numerics.control.tracking import track as track
    from numerics.control.transfer import fastest_transfer as fastest_transfer
    from numerics.errors import EventUndecided as EventUndecided
    from numerics.errors import InvalidScene as InvalidScene
    from numerics.errors import MissingTool as MissingTool
    from numerics.errors import NotDifferentiable as NotDifferentiable
    from numerics.errors import NotSettled as NotSettled
    from numerics.errors import NumericsError as NumericsError
    from numerics.errors import OutOfRange as OutOfRange
    from numerics.errors import PrecisionExhausted as PrecisionExhausted
    from numerics.linear.modes import Mode as Mode
    from numerics.plane.trajectory import PlaneTrajectory as PlaneTrajectory
    from numerics.scene import Force as Force
    from numerics.scene import Friction as Friction
    from numerics.scene import Law as Law
    from numerics.scene import Pair as Pair
    from numerics.scene import Piece as Piece
    from numerics.scene import Scene as Scene
    from numerics.scene import Signal as Signal
    from numerics.scene import Sine as Sine
    from numerics.scene import State as State
    from numerics.scene import Weakening as Weakening
    from numerics.scene.file import load_reference as load_reference
    from numerics.scene.file import load_scene as load_scene
    from numerics.scene.file import scene_text as scene_text
    from numerics.scene.plane import PlanePair as PlanePair
    from numerics.scene.plane import PlaneScene as PlaneScene
    from numerics.solver.batch import Batch as Batch
    from numerics.solver.bifurcation import Bifurcation as Bifurcation
    from numerics.solver.bifurcation import bifurcation as bifurcation
    from numerics.solver.check import check as check
    from numerics.solver.many import solve_many as solve_many
    from numerics.solver.many import solve_scenes as solve_scenes
    from numerics.solver.solve import solve as solve
    from numerics.trajectory.sensitivity import sensitivities as sensitivities
    from numerics.trajectory.trajectory import Trajectory as Trajectory

_IMPORTS = re.compile(r"^    from (numerics\S+) import (\w+) as \2$", re.MULTILINE)
_HOMES = {name: module for module, name in _IMPORTS.findall(Path(__file__).read_text("utf-8"))}
"""The modules of the public names: the imports above, which only type checkers follow."""

__all__ = sorted(_HOMES)  # noqa: PLE0605 - a list, of the names above


if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        """Import a public name when it is first asked for: `--help` needs none of them. Functions are `helpful`."""
        from numerics.habits import helpful, right_word

        if name == "__version__":
            from numerics.exits import version

            return version() or "0+source"
        if name not in _HOMES:
            known = right_word(name, [*_HOMES], "dir(numerics) lists what it has")
            raise AttributeError(f"module 'numerics' has no attribute {name!r}; {known}")
        value = getattr(importlib.import_module(_HOMES[name]), name)
        if isinstance(value, FunctionType):
            value = helpful(value)
            value.__module__ = __name__  # where a pickle finds it
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    """Return the public names, and nothing else."""
    return sorted(_HOMES)
