"""What happens: trajectories of the inertial pair, two masses joined by dry friction, as numbers with a stated error.

A scene, exact:
    Pair                the two bodies, their spring, damper and friction (kg, N/m, N s/m, N)
    State               positions and velocities at t = 0 (m, m/s)
    Scene               a pair, a state, a horizon (s), and what acts in time
    Force               the force u(t) on body 1, N, by pieces; Force.sine, .step, .ramp, .trapezoid, .sweep
    Piece, Sine         what a force is made of
    Friction            the friction force b by pieces, N
    Weakening           how friction depends on the speed of the slip and on the place
    PlanePair           two bodies on a surface: lists for numbers
    PlaneScene          such a pair, where it starts, and what acts on each axis
    Law                 how sgn(0) is read where v1 = v2
    load_scene          the scene of a TOML file, or a shipped one such as "velocities"
    scene_text          a scene as TOML text
Solving:
    solve               one scene: its Trajectory, in the cheapest arithmetic that has the digits
    solve_many          arrays in, arrays out, on all cores: a Batch
    solve_scenes        the same from a list of scenes, one by one, on a line or on a surface
Answers:
    Trajectory          events, state at any time, energy, error bounds; plot, animate, save, load
    PlaneTrajectory     the same of a scene on a surface
    Batch, PlaneBatch   the ends of many runs as arrays, on a line and on a surface
    Mode                slip+, slip- or stick
    sensitivities       derivatives of a trajectory by every number of its scene
Control through the interface:
    response            the motion in the long run under a periodic force
    thresholds          the amplitudes up to which the pair may stick, which slip with two reversals a period needs
    fastest_transfer    the force that brings body 2 from rest to rest
    track               the force under which body 2 follows a reference
    load_reference      a reference of a TOML file, or a shipped one such as "s-curve"
    ring_entry          when the relative motion has settled
What is raised:
    NumericsError       the base of all
    InvalidScene        a number or a file that describes no scene; also a ValueError
    EventUndecided      an order of events that the digits allowed do not settle
    PrecisionExhausted  digits that were not reached
    OutOfRange          a number that float64 cannot hold
    NotDifferentiable   a motion without a derivative by its data
    NotSettled          a long-time motion that was not found
    MissingTool         an optional package that is not installed

`help(numerics.solve)` tells one of them in full. Import them by name: `from numerics import *` brings none.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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
    from numerics.scene import Sine as Sine
    from numerics.scene import State as State
    from numerics.scene import Weakening as Weakening
    from numerics.scene.file import load_reference as load_reference
    from numerics.scene.file import load_scene as load_scene
    from numerics.scene.file import scene_text as scene_text
    from numerics.scene.plane import PlanePair as PlanePair
    from numerics.scene.plane import PlaneScene as PlaneScene
    from numerics.solver.batch import Batch as Batch
    from numerics.solver.many import solve_many as solve_many
    from numerics.solver.many import solve_scenes as solve_scenes
    from numerics.solver.plane_batch import PlaneBatch as PlaneBatch
    from numerics.solver.solve import solve as solve
    from numerics.trajectory.sensitivity import sensitivities as sensitivities
    from numerics.trajectory.trajectory import Trajectory as Trajectory

# without __all__, in whose presence help() would print every method of every class here
_NAMES = {
    "scene": "Force Friction Law Pair Piece Scene Sine State Weakening",
    "scene.file": "load_reference load_scene scene_text",
    "scene.plane": "PlanePair PlaneScene",
    "solver.solve": "solve",
    "solver.many": "solve_many solve_scenes",
    "solver.batch": "Batch",
    "solver.plane_batch": "PlaneBatch",
    "trajectory.trajectory": "Trajectory",
    "plane.trajectory": "PlaneTrajectory",
    "trajectory.sensitivity": "sensitivities",
    "linear.modes": "Mode",
    "control.response": "response",
    "control.ring": "ring_entry",
    "control.thresholds": "thresholds",
    "control.tracking": "track",
    "control.transfer": "fastest_transfer",
    "errors": "EventUndecided InvalidScene MissingTool NotDifferentiable NotSettled NumericsError OutOfRange "
    "PrecisionExhausted",
}
"""The public names by the modules where they are."""
_HOMES = {name: f"numerics.{module}" for module, names in _NAMES.items() for name in names.split()}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for: `--help` needs none of them."""
    if name not in _HOMES:
        raise AttributeError(f"module 'numerics' has no attribute {name!r}; dir(numerics) lists those it has")
    value = getattr(importlib.import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Return the public names, and nothing else."""
    return sorted(_HOMES)
