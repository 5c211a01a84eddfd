"""What happens: trajectories of the inertial pair as numbers with a stated error."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numerics.control.response import response
    from numerics.control.response_map import response_map
    from numerics.control.ring import ring_entry
    from numerics.control.thresholds import thresholds
    from numerics.control.tracking import track
    from numerics.control.transfer import fastest_transfer
    from numerics.scene import Force, Friction, Law, Pair, Piece, Scene, Sine, State, Weakening
    from numerics.scene.file import load_reference, load_scene
    from numerics.scene.writing import scene_text
    from numerics.solver.many import solve_many, solve_scenes
    from numerics.solver.prepared import Solver
    from numerics.solver.solve import solve
    from numerics.trajectory.sensitivity import sensitivities

__all__ = [
    "Force",
    "Friction",
    "Law",
    "Pair",
    "Piece",
    "Scene",
    "Sine",
    "Solver",
    "State",
    "Weakening",
    "fastest_transfer",
    "load_reference",
    "load_scene",
    "response",
    "response_map",
    "ring_entry",
    "scene_text",
    "sensitivities",
    "solve",
    "solve_many",
    "solve_scenes",
    "thresholds",
    "track",
]
_HOMES = {
    "Solver": "numerics.solver.prepared",
    "solve": "numerics.solver.solve",
    "sensitivities": "numerics.trajectory.sensitivity",
    "solve_many": "numerics.solver.many",
    "solve_scenes": "numerics.solver.many",
    "fastest_transfer": "numerics.control.transfer",
    "load_reference": "numerics.scene.file",
    "load_scene": "numerics.scene.file",
    "response": "numerics.control.response",
    "response_map": "numerics.control.response_map",
    "ring_entry": "numerics.control.ring",
    "thresholds": "numerics.control.thresholds",
    "track": "numerics.control.tracking",
    "scene_text": "numerics.scene.writing",
}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for: `--help` needs none of them."""
    if name not in __all__:
        raise AttributeError(f"module 'numerics' has no attribute {name!r}")
    value = getattr(importlib.import_module(_HOMES.get(name, "numerics.scene")), name)
    globals()[name] = value
    return value
