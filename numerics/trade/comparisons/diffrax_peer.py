"""diffrax: one compiled `diffeqsolve` by Dopri8 for both modes, called from event to event.

Events are found where a condition changes sign over a step, so first steps and peaks are watched as with SciPy; they
are located by bisection of the dense output (Newton's method, the documentation's choice, runs away from wide steps).
What goes in and out of the compiled function is packed into one array each way: transfers cost more than steps.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from numerics.trade.comparisons.peer import Extra, PeerFailed
from numerics.trade.comparisons.switched import Arc, Asked, Ended, Number, SwitchedPair


def diffrax_arcs(pair: SwitchedPair, rtol: float) -> Arc:
    """Compile the arc of a pair in float64; mode, span and start are runtime arguments."""
    import diffrax
    import jax
    import jax.numpy as jnp
    import optimistix

    jax.config.update("jax_enable_x64", True)
    width, sizes = len(pair.sizes), jnp.array(pair.sizes)

    def rates(since: Extra, y: Extra, args: Extra) -> Extra:
        slip, _, s, start, *numbers = args
        span = pair.spans[0]._replace(numbers=numbers)
        push = span.u(start + since, 1, (jnp.sin, jnp.cos))
        return jnp.where(slip, *(jnp.stack(pair.rates(one, span, s, push, list(y))) for one in (True, False)))

    def guards(t: Extra, y: Extra, args: Extra) -> Extra:
        """Return what falls to 0 at the event, and where the load turns."""
        slip, still, held = args[0], args[1], args[4]
        met = jnp.where(slip, y[2] / sizes[2], jnp.minimum(y[0], 2 * held - y[0]) / sizes[0])
        return met, jnp.where(slip | still, jnp.inf, -pair.quick * rates(t, y, args)[0] / sizes[0])

    options: Any = {
        "stepsize_controller": diffrax.PIDController(rtol=rtol, atol=rtol * sizes),
        "event": diffrax.Event(
            lambda t, y, args, **_: jnp.minimum(*guards(t, y, args)),
            optimistix.Bisection(1e-15, 1e-14),
            direction=False,
        ),
        "max_steps": 1_000_000,
        "throw": False,
    }
    term = diffrax.ODETerm(rates)

    def packed_arc(packed: Extra) -> Extra:
        """Take first step, time left, slip, still, s, t, span, start; return length, stopped, good, turned, end."""
        args = (packed[2] == 1, packed[3] == 1, *packed[4:-width])
        out = diffrax.diffeqsolve(term, diffrax.Dopri8(), 0.0, packed[1], packed[0], packed[-width:], args, **options)
        stopped = out.result == diffrax.RESULTS.event_occurred
        met, turning = guards(out.ts[-1], out.ys[-1], args)
        good = stopped | (out.result == diffrax.RESULTS.successful)
        return jnp.concatenate([jnp.stack([out.ts[-1], stopped, good, turning < met]), out.ys[-1]])

    compiled = jax.jit(packed_arc).lower(np.zeros(6 + len(pair.spans[0].numbers) + width)).compile()

    def arc(asked: Asked) -> tuple[Ended, Number, list[Number]]:
        slip, span, s, t, start, until, still = asked
        off = slip and start[2] == 0
        first = pair.first_step(span, s, t, start[0], start[1])[0] if off else pair.quick
        packed = [min(first, until - t), until - t, slip, still, s, t, *span.numbers, *start]
        length, stopped, good, turned, *end = np.asarray(compiled(np.array(packed))).tolist()
        if not good:
            raise PeerFailed(f"diffrax: the arc from t = {t:.9g} s has no end")
        if not stopped:
            return Ended.TIME, until, end
        return (Ended.TURNED if turned else Ended.MET), t + length, end

    return arc
