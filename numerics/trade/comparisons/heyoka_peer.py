"""heyoka's Taylor integrator: three compiled integrators, and no event function with a root at the start of a step.

At an exit g has a double zero, which heyoka's root isolation does not get past: it loses the next root of that step. So
a short step without events leads off the surface first, and in a short slip the next step is cut to its length, so that
the roots lie apart. Numbers of a span are runtime parameters: a scene with another b, force or start compiles nothing.
"""

from __future__ import annotations

from typing import Any

from numerics.trade.comparisons.peer import Extra, PeerFailed
from numerics.trade.comparisons.switched import Arc, Number, Span, SwitchedPair

FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""


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
    y = hy.make_vars(*["room", "v", "g", "z", "viscous"][: len(pair.sizes)])

    def compiled(slip: bool, *guards: Extra) -> Placed:
        system = list(zip(y, pair.rates(slip, formula, hy.par[0], push, y), strict=True))
        falling = [hy.t_event(one, direction=hy.event_direction.negative, fp_type=pair.kind) for one in guards]
        options: Any = {"t_events": falling, "fp_type": pair.kind, "tol": pair.kind(tol)}
        return Placed(hy.taylor_adaptive(system, [pair.zero] * len(y), **options))

    leaving, slipping = compiled(True), compiled(True, y[2])
    sticking = compiled(False, y[0], *[2 * formula.held - y[0]] * (len(last.numbers) > 3))
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
