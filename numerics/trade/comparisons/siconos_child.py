"""One Siconos run: a request as JSON on stdin, the answer as JSON in the last line of stdout.

It runs under an interpreter that has siconos and NumPy, and nothing of this repository.
"""

from __future__ import annotations

import json
import math
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
    push = [np.zeros(4)] if request.get("spans") else []
    system = sk.FirstOrderLinearTIDS(np.array(request["y"], dtype=float), matrix, *push)
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


def march(request: dict[str, Any]) -> tuple[Any, Any, float, Any, float]:
    """Return the multiplier of every step, the final state, the wall time of the steps (s), every b, and u's work."""
    simulation, state, multiplier, alive = build(request)
    system, law, spans, step = alive[0], alive[2], request.get("spans"), request["step"]
    forces: list[float] = []
    frictions: list[float] = []
    push, work, now = system.b() if spans else np.empty(0), 0.0, 0
    start = time.perf_counter()
    while simulation.hasNextEvent():
        if spans:
            t = (len(forces) + 0.5) * step
            while now + 1 < len(spans) and spans[now + 1]["start"] <= t:
                now += 1
            u, b, before = force(spans[now], t), spans[now]["b"], float(state[1])
            push[1] = u / request["m1"]
            law.setLb(-b)
            law.setUb(b)
            frictions.append(b)
        simulation.computeOneStep()
        forces.append(multiplier[0])
        simulation.nextStep()
        if spans:
            work += u * step * (before + float(state[1])) / 2
    elapsed = time.perf_counter() - start
    return np.array(forces), np.array(state), elapsed, np.array(frictions or request["b"]), work


def force(span: dict[str, Any], t: float) -> float:
    """Return u(t) on a span."""
    value = 0.0
    for coefficient in reversed(span["polynomial"]):
        value = value * (t - span["origin"]) + coefficient
    return value + sum(a * math.sin(omega * t + phase) for a, omega, phase in span["sines"])


def events(forces: Any, b: Any, step: float) -> tuple[list[str], list[float]]:
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
    forces, state, elapsed, frictions, work = march(request)
    kinds, times = events(forces, frictions, request["step"])
    answer = {
        "kinds": kinds,
        "times": times,
        "y": state.tolist(),
        "steps": len(forces),
        "elapsed": elapsed,
        "work": work,
    }
    print("\n" + json.dumps(answer))


if __name__ == "__main__":
    main()
