"""SciPy's solve_ivp by DOP853: an arc for each mode, its first step inside the slip, the peaks of the load watched.

It looks at the signs of its guards at step ends. So a stick arc stops at its event or where the load turns back,
whichever comes first: the lesser of both guards stays below 0 once the edge is past, so no step can jump over a short
stay beyond it. Every arc starts at time 0, lest its root is located to a fraction of the time since the start.
"""

from __future__ import annotations

import numpy as np

from numerics.trade.comparisons.peer import Extra, PeerFailed
from numerics.trade.comparisons.switched import Arc, Asked, Ended, Number, SwitchedPair


def scipy_arcs(pair: SwitchedPair, rtol: float, method: str = "DOP853") -> Arc:
    """Return the arcs of a pair; absolute tolerances are rtol times the pair's own sizes."""
    import scipy.integrate

    options: Extra = {"method": method, "rtol": rtol, "atol": rtol * np.array(pair.sizes)}

    def arc(asked: Asked) -> tuple[Ended, Number, list[Number]]:
        slip, span, s, t, start, until, still = asked
        held = span.held

        def field(since: float, y: Extra) -> list[float]:
            return pair.rates(slip, span, s, pair.u(span, t + since, 1) if pair.driven else 0.0, y.tolist())

        def guards(since: float, y: Extra) -> tuple[float, float]:
            """Return what falls to 0 at the event, and where the load turns."""
            if slip:
                return y[2], np.inf
            return min(y[0], 2 * held - y[0]), np.inf if still else -pair.quick * field(since, y)[0]

        def watched(since: float, y: Extra) -> float:
            return min(guards(since, y))

        watched.terminal, watched.direction = True, -1  # type: ignore[attr-defined]
        first = None
        if slip and start[2] == 0:
            first = min(pair.first_step(span, s, t, start[0], start[1])[0], until - t)
        found = scipy.integrate.solve_ivp(
            field, (0, until - t), np.array(start), events=watched, first_step=first, **options
        )
        if found.status == -1:
            raise PeerFailed(f"SciPy at t = {t + found.t[-1]:.9g} s: {found.message}")
        end, since = found.y[:, -1], float(found.t[-1])
        if found.status == 0:
            return Ended.TIME, until, end.tolist()
        met, turning = guards(since, end)
        return (Ended.TURNED if turning < met else Ended.MET), t + since, end.tolist()

    return arc
