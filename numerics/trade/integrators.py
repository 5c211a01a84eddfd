"""Integrators of a pair in its coordinates (switched.py), each in its best use: DOP853 of SciPy, and heyoka.

SciPy looks at the signs of its guards at step ends. So a stick arc stops at its event or where the load turns back,
whichever comes first: the lesser of both guards stays below 0 once the edge is past, so no step can jump over a short
stay beyond it. Every arc starts at time 0, lest its root is located to a fraction of the time since the start.

heyoka: three compiled Taylor integrators. At an exit v1 - v2 has a double zero, which its root isolation does not get
past: it loses the next root of that step. So a short step without events leads off the surface first, and in a short
slip the next step is cut to its length, so that the roots lie apart.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.trade.switched import APART, FAR, NEAR, SIGNALS, Arc, Matrices, Number, PeerFailed, SwitchedPair, dot

NOTHING = 1e-300
"""Keeps a load that does not change from turning back."""
FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""
Extra = Any
"""What a module of the extra `comparisons` makes; it is imported late and untyped."""


def scipy_arcs(pair: SwitchedPair, rtol: float) -> Arc:
    """Return the arcs of a pair; absolute tolerances are rtol times the pair's own sizes."""
    from scipy.integrate import solve_ivp

    def arc(own: Matrices, slip: bool, y: list[Number], left: Number) -> tuple[bool, Number, list[Number]]:
        rates = own.rates[not slip]
        nears = pair.quick * dot(rates[NEAR], y) < rtol * pair.sizes[NEAR]  # else b(t) brings the edge to the load

        def field(_: float, y: Extra) -> list[float]:
            at = y.tolist()
            return [dot(row, at) for row in rates]

        def guards(y: Extra) -> tuple[float, float]:
            """Return what falls to 0 at the event, and where the load turns."""
            if slip:
                return y[APART], np.inf
            turning = NOTHING - pair.quick * dot(rates[NEAR], y) if nears else np.inf
            return min(y[NEAR], y[FAR]), turning

        def watched(_: float, y: Extra) -> float:
            return min(guards(y))

        watched.terminal, watched.direction = True, -1  # type: ignore[attr-defined]
        first = min(pair.first_step(own, y)[0], left) if slip and y[APART] == 0 else None
        sizes = [*pair.sizes, *[max(map(abs, y[SIGNALS:]))] * (len(y) - SIGNALS)]
        options: Extra = {"method": "DOP853", "rtol": rtol, "atol": rtol * np.array(sizes), "first_step": first}
        found = solve_ivp(field, (0, left), np.array(y), events=watched, **options)
        since, end = float(found.t[-1]), found.y[:, -1]
        if found.status == -1:
            raise PeerFailed(f"SciPy after {since:.9g} s: {found.message}")
        met, turning = guards(end)
        return found.status == 1 and met <= turning, since, end.tolist()

    return arc


def heyoka_arcs(pair: SwitchedPair, tol: float) -> Arc:
    """Compile slip, slip without events, and stick, in the numbers of a pair."""
    import heyoka as hy

    zero, cut = pair.kind(0), int(hy.taylor_outcome.time_limit)

    def compiled(rates: Extra, *guards: int) -> Extra:
        y = [hy.expression(f"y{k}") for k in range(len(rates))]
        system = [(one, sum((c * y[k] for k, c in row), 0 * y[0])) for one, row in zip(y, rates, strict=True)]
        falling = [hy.t_event(y[k], direction=hy.event_direction.negative, fp_type=pair.kind) for k in guards]
        options: Any = {"t_events": falling, "fp_type": pair.kind, "tol": pair.kind(tol)}
        one = hy.taylor_adaptive(system, [zero] * len(y), **options)
        return one, one.state

    made = dict[int, Extra]()
    for *_, own, y in pair.spans:
        if id(own) not in made:
            (slip, stick), edges = own.rates, (NEAR, FAR) if len(y) > SIGNALS + 1 else (NEAR,)
            made[id(own)] = compiled(slip), compiled(slip, APART), compiled(stick, *edges)

    def arc(own: Matrices, slip: bool, y: list[Number], left: Number) -> tuple[bool, Number, list[Number]]:
        leaving, slipping, sticking = made[id(own)]
        (one, state), since, first = slipping if slip else sticking, zero, zero
        if slip and y[APART] == 0:
            step, back = pair.first_step(own, y)
            if back:
                off, there = leaving
                off.time, there[:] = zero, y
                off.step(min(left, pair.kind(step)))
                since, y = off.time, there
                first = pair.kind(1.5 * back) if back < pair.quick else first
        one.time, state[:] = since, y
        one.reset_cooldowns()
        code = int(one.step(min(left - since, first))[0]) if first else FAILED
        if code <= FAILED:
            code = int(one.propagate_until(left)[0])
        if code <= FAILED and code != cut:
            raise PeerFailed(f"heyoka after {one.time:.9g} s: outcome {code}")
        return code > FAILED, one.time, state.tolist() if pair.kind is float else list(state)

    return arc
