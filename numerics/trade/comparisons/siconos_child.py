"""One Siconos run: a request as JSON on stdin, the answer as JSON in the last line of stdout.

It runs under an interpreter that has siconos and NumPy, and nothing of this repository.
"""

from __future__ import annotations

import json
import sys
import time
from typing import Any

import numpy as np


def build(request: dict[str, Any]) -> tuple[Any, ...]:
    """Return (simulation, state, multiplier) and everything that Siconos needs to be kept alive."""
    import siconos.kernel as sk
    import siconos.numerics as sn

    m1, m2, a1, a2, b = (request[name] for name in ("m1", "m2", "a1", "a2", "b"))
    matrix = np.array([[0, 1, 0, 0], [-a2 / m1, -a1 / m1, 0, 0], [0, 0, 0, 1], [0, 0, 0, 0]], dtype=float)
    system = sk.FirstOrderLinearTIDS(np.array(request["y"], dtype=float), matrix)
    relation = sk.FirstOrderLinearTIR(np.array([[0.0, 1.0, 0.0, -1.0]]), np.array([[0.0], [1 / m1], [0.0], [-1 / m2]]))
    law = sk.RelayNSL(1, -b, b)
    joint = sk.Interaction(law, relation)
    whole = sk.NonSmoothDynamicalSystem(0.0, request["until"])
    whole.insertDynamicalSystem(system)
    whole.link(joint, system)
    held = request["scheme"] == "ZeroOrderHold"
    if held:
        whole.setControlProperty(joint, True)
    scheme = sk.ZeroOrderHoldOSI() if held else sk.EulerMoreauOSI(0.5)
    relay = sk.Relay(sn.SICONOS_RELAY_LEMKE)
    clock = sk.TimeDiscretisation(0.0, request["step"])
    simulation = sk.TimeStepping(whole, clock, scheme, relay)
    return simulation, system.x(), joint.lambda_(0), (system, relation, law, joint, whole, scheme, relay, clock)


def march(request: dict[str, Any]) -> tuple[Any, Any, float]:
    """Return the multiplier of every step, the final state, and the wall time of the steps (s)."""
    simulation, state, multiplier, _alive = build(request)
    forces = []
    start = time.perf_counter()
    while simulation.hasNextEvent():
        simulation.computeOneStep()
        forces.append(multiplier[0])
        simulation.nextStep()
    return np.array(forces), np.array(state), time.perf_counter() - start


def events(forces: Any, b: float, step: float) -> tuple[list[str], list[float]]:
    """Return kinds and times: a step slips where its force is saturated at -b (slip+) or b (slip-), else it sticks.

    One step between slips of opposite signs is no stick: the implicit relay lands on the surface before it crosses.
    """
    modes = np.where(np.abs(forces) < b * (1 - 1e-9), 0, -np.sign(forces))
    landing = 1 + np.flatnonzero((modes[1:-1] == 0) & (modes[:-2] * modes[2:] < 0))
    modes[landing] = modes[landing + 1]
    changes = np.flatnonzero(np.diff(modes)) + 1
    kinds = ["entry" if modes[n] == 0 else "exit" if modes[n - 1] == 0 else "crossing" for n in changes]
    return kinds, [float(n * step) for n in changes]


def main() -> None:
    """Answer one request."""
    request = json.load(sys.stdin)
    march({**request, "until": min(request["until"], 10 * request["step"])})  # imports and first calls, untimed
    forces, state, elapsed = march(request)
    kinds, times = events(forces, request["b"], request["step"])
    answer = {"kinds": kinds, "times": times, "y": state.tolist(), "steps": len(forces), "elapsed": elapsed}
    print("\n" + json.dumps(answer))


if __name__ == "__main__":
    main()
