"""heyoka's Taylor integrator: three compiled integrators, and no event function with a root at the start of a step.

At an exit g has a double zero, which heyoka's root isolation does not get past: it loses the next root of that step. So
a short step without events leads off the surface first, and in a short slip the next step is cut to its length, so that
the roots lie apart. Numbers of a span are runtime parameters: a scene with another b, force or start compiles nothing.
"""

from __future__ import annotations

from typing import Any

from numerics.trade.comparisons.peer import Extra, PeerFailed
from numerics.trade.comparisons.switched import Arc, Asked, Ended, Number, Span, SwitchedPair

FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""


def heyoka_arcs(pair: SwitchedPair, tol: float) -> Arc:
    """Compile slip, slip without events, and stick, in the numbers of a pair.

    The arcs serve every pair of the same masses, spring and damper with as many terms and sines.
    """
    import heyoka as hy

    zero, last = pair.zero, pair.spans[0]
    span = last._replace(numbers=[hy.par[1 + n] for n in range(len(last.numbers))])
    push = span.u(hy.time, 1, (hy.sin, hy.cos)) if pair.driven else zero
    y = hy.make_vars(*["room", "v", "g", "z", "viscous"][: len(pair.sizes)])

    def compiled(slip: bool, *guards: Extra) -> Placed:
        system = list(zip(y, pair.rates(slip, span, hy.par[0], push, y), strict=True))
        falling = [hy.t_event(one, direction=hy.event_direction.negative, fp_type=pair.kind) for one in guards]
        options: Any = {"t_events": falling, "fp_type": pair.kind, "tol": pair.kind(tol)}
        return Placed(hy.taylor_adaptive(system, [zero] * len(y), **options))

    leaving, slipping = compiled(True), compiled(True, y[2])
    sticking = compiled(False, y[0], *[2 * span.held - y[0]] * (len(last.numbers) > 3))
    cut = int(hy.taylor_outcome.time_limit)

    def arc(asked: Asked) -> tuple[Ended, Number, list[Number]]:
        slip, span, s, t, start, until, _ = asked
        where, first = slipping if slip else sticking, zero
        if slip and start[2] == 0:
            step, back = pair.first_step(span, s, t, start[0], start[1])
            if back:
                off = leaving.place(span, s, t, start)
                off.step(min(until - t, pair.kind(step)))
                t, start = off.time, leaving.coordinates()
                first = pair.kind(1.5 * back) if back < pair.quick else zero
        one = where.place(span, s, t, start)
        one.reset_cooldowns()
        code = int(one.step(min(until - t, first))[0]) if first else FAILED
        if code <= FAILED:
            code = int(one.propagate_until(until)[0])
            if code <= FAILED and code != cut:
                raise PeerFailed(f"heyoka at t = {one.time:.9g} s: outcome {code}")
        return (Ended.MET if code > FAILED else Ended.TIME), one.time, where.coordinates()

    return arc


class Placed:
    """A compiled integrator, and the span whose numbers it has."""

    def __init__(self, one: Extra) -> None:
        """Keep views of its parameters and its state."""
        self.one, self.pars, self.state, self.span = one, one.pars, one.state, None  # type: Any, Any, Any, Span | None

    def place(self, span: Span, s: int, t: Number, start: list[Number]) -> Extra:
        """Set parameters, time and state, and return the integrator."""
        if span is not self.span:
            for index, value in enumerate(span.numbers[: len(self.pars) - 1], start=1):
                self.pars[index] = value
            self.span = span
        self.pars[0], self.one.time = s, t
        for index, value in enumerate(start):
            self.state[index] = value
        return self.one

    def coordinates(self) -> list[Number]:
        """Return a copy of the state."""
        return self.state.tolist() if self.state.dtype == float else list(self.state)
