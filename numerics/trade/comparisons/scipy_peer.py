"""SciPy's solve_ivp by DOP853: an arc for each mode, its first step inside the slip, the peaks of the load watched.

It looks at the signs of its guards at step ends. So a stick arc stops at its event or where the load turns back,
whichever comes first: the lesser of both guards stays below 0 once the edge is past, so no step can jump over a short
stay beyond it. Every arc starts at time 0, lest its root is located to a fraction of the time since the start.
"""

from __future__ import annotations

import numpy as np

from numerics.trade.comparisons.peer import Extra, PeerFailed
from numerics.trade.comparisons.switched import Arc, Number, Span, SwitchedPair

NOTHING = 1e-300
"""Keeps a load that does not change from turning back."""


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
                return y[2], np.inf
            return min(y[0], 2 * span.held - y[0]), NOTHING - pair.quick * field(since, y)[0]

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
