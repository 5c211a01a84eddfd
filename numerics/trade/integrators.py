"""Integrators of the pair in its coordinates (switched.py), each in its best use: DOP853 of SciPy, and heyoka.

SciPy looks at the signs of its guards at step ends. So a stick arc stops at its event or where the load turns back,
whichever comes first: the lesser of both guards stays below 0 once the edge is past, so no step can jump over a short
stay beyond it. Every arc starts at time 0, lest its root is located to a fraction of the time since the start.

heyoka: three compiled Taylor integrators. At an exit g has a double zero, which its root isolation does not get past:
it loses the next root of that step. So a short step without events leads off the surface first, and in a short slip the
next step is cut to its length, so that the roots lie apart. Numbers of a span are runtime parameters: a scene with
another b, force or start compiles nothing.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.trade.switched import Arc, Extra, Number, PeerFailed, Span, SwitchedPair

NOTHING = 1e-300
"""Keeps a load that does not change from turning back."""
FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""


def scipy_arcs(pair: SwitchedPair, rtol: float) -> Arc:
    """Return the arcs of a pair; absolute tolerances are rtol times the pair's own sizes."""
    from scipy.integrate import solve_ivp

    options: Extra = {"method": "DOP853", "rtol": rtol, "atol": rtol * np.array(pair.sizes)}

    def arc(slip: bool, span: Span, s: int, t: Number, start: list[Number]) -> tuple[bool, Number, list[Number]]:
        def field(since: float, y: Extra) -> list[float]:
            return pair.rates(slip, span, s, pair.u(span, t + since, 1), y.tolist())

        def guards(since: float, y: Extra) -> tuple[float, float]:
            """Return what falls to 0 at the event, and where the load turns."""
            if slip:
                return s * y[2], np.inf
            return min(-s * y[0], 2 * span.held + s * y[0]), NOTHING + s * pair.quick * field(since, y)[0]

        def watched(since: float, y: Extra) -> float:
            return min(guards(since, y))

        watched.terminal, watched.direction = True, -1  # type: ignore[attr-defined]
        left, first = span.end - t, None
        if slip and start[2] == 0:
            first = min(pair.first_step(span, s, t, start[0], start[1])[0], left)
        found = solve_ivp(field, (0, left), np.array(start), events=watched, first_step=first, **options)
        since, end = float(found.t[-1]), found.y[:, -1]
        if found.status == -1:
            raise PeerFailed(f"SciPy at t = {t + since:.9g} s: {found.message}")
        if found.status == 0:
            return False, span.end, end.tolist()
        met, turning = guards(since, end)
        return met <= turning, t + since, end.tolist()

    return arc


class Placed:
    """A compiled integrator, and the span whose numbers it has."""

    def __init__(self, one: Extra) -> None:
        """Keep views of its parameters and its state."""
        self.one, self.pars, self.state, self.span = one, one.pars, one.state, None  # type: Any, Any, Any, Span | None

    def place(self, span: Span, s: int, t: Number, start: list[Number]) -> Extra:
        """Set parameters, time and state, and return the integrator."""
        if span is not self.span:
            self.pars[1:] = span.numbers[: len(self.pars) - 1]
            self.span = span
        self.pars[0], self.one.time, self.state[:] = s, t, start
        return self.one


def heyoka_arcs(pair: SwitchedPair, tol: float) -> Arc:
    """Compile slip, slip without events, and stick, in the numbers of a pair.

    The arcs serve every pair of the same masses, spring and damper with as many terms and sines.
    """
    import heyoka as hy

    last = pair.spans[0]
    formula = last._replace(numbers=[hy.par[1 + n] for n in range(len(last.numbers))])
    push = formula.u(hy.time, 1, (hy.sin, hy.cos)) if pair.driven else pair.zero
    y = hy.make_vars("r", "v", "g", "z")

    def compiled(slip: bool, *guards: Extra) -> Placed:
        system = list(zip(y, pair.rates(slip, formula, hy.par[0], push, y), strict=True))
        falling = [hy.t_event(one, direction=hy.event_direction.negative, fp_type=pair.kind) for one in guards]
        options: Any = {"t_events": falling, "fp_type": pair.kind, "tol": pair.kind(tol)}
        return Placed(hy.taylor_adaptive(system, [pair.zero] * len(y), **options))

    s = hy.par[0]
    leaving, slipping = compiled(True), compiled(True, s * y[2])
    sticking = compiled(False, -s * y[0], *[2 * formula.held + s * y[0]] * (len(last.numbers) > 3))
    cut = int(hy.taylor_outcome.time_limit)

    def arc(slip: bool, span: Span, s: int, t: Number, start: list[Number]) -> tuple[bool, Number, list[Number]]:
        where, first = slipping if slip else sticking, pair.zero
        if slip and start[2] == 0:
            step, back = pair.first_step(span, s, t, start[0], start[1])
            if back:
                off = leaving.place(span, s, t, start)
                off.step(min(span.end - t, pair.kind(step)))
                t, start = off.time, off.state.tolist()
                first = pair.kind(1.5 * back) if back < pair.quick else first
        one = where.place(span, s, t, start)
        one.reset_cooldowns()
        code = int(one.step(min(span.end - t, first))[0]) if first else FAILED
        if code <= FAILED:
            code = int(one.propagate_until(span.end)[0])
        if code <= FAILED and code != cut:
            raise PeerFailed(f"heyoka at t = {one.time:.9g} s: outcome {code}")
        return code > FAILED, one.time, where.state.tolist()

    return arc
