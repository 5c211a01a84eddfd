"""What both diffrax peers do alike: one compiled `diffeqsolve` from a start to an event, all numbers in one array.

Events are found where a condition changes sign over a step, and located by bisection of the dense output (Newton's
method, the documentation's choice, runs away from wide steps). What goes in and out of the compiled function is packed
into one array each way: transfers cost more than steps.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from typing import NamedTuple

import numpy as np

from numerics.trade.comparisons.peer import Extra, PeerFailed

MAX_STEPS = 1_000_000


class DiffraxMethod:
    """One of diffrax's explicit methods with a PID controller, in float64, compiled and warm."""

    knob = "rtol"

    def __init__(self, method: str) -> None:
        """Take one of diffrax's solvers: "Dopri8", "Tsit5"."""
        self.method, self.name = method, f"diffrax {method}"

    def missing(self) -> str | None:
        """Name diffrax if it is not installed."""
        return None if find_spec("diffrax") else "diffrax (extra `comparisons`)"


class Asked(NamedTuple):
    """What one arc is asked: how far at most, its first step, its start, what field and guard are told beside."""

    left: Extra
    first: Extra
    start: Extra
    args: Extra


class Arc:
    """An arc, compiled for arrays of one width."""

    def __init__(
        self,
        method: str,
        tolerance: float,
        sizes: Extra,
        field: Callable[..., Extra],
        guard: Callable[..., Extra],
        unpack: Callable[[Extra], Asked],
        width: int,
    ) -> None:
        """Compile; `sizes` times the tolerance are the absolute tolerances, the event is where the guard falls to 0.

        `unpack` reads the array, of `width` numbers. Its arc starts at time 0.
        """
        import diffrax
        import jax
        import jax.numpy as jnp
        import optimistix

        event = diffrax.Event(guard, optimistix.Bisection(1e-15, 1e-14), direction=False)
        controller = diffrax.PIDController(rtol=tolerance, atol=tolerance * jnp.array(sizes))
        solver = getattr(diffrax, method)()

        def arc(packed: Extra) -> Extra:
            """Return the length, 1 if met, steps, 1 if it got there, and the end."""
            asked = unpack(packed)
            out = diffrax.diffeqsolve(
                diffrax.ODETerm(field),
                solver,
                0.0,
                asked.left,
                asked.first,
                asked.start,
                args=asked.args,
                stepsize_controller=controller,
                event=event,
                max_steps=MAX_STEPS,
                throw=False,
            )
            stopped = out.result == diffrax.RESULTS.event_occurred
            good = stopped | (out.result == diffrax.RESULTS.successful)
            return jnp.concatenate([jnp.stack([out.ts[-1], stopped, out.stats["num_steps"], good]), out.ys[-1]])

        self._compiled = jax.jit(arc).lower(np.zeros(width)).compile()

    def __call__(self, packed: Extra) -> tuple[bool, float, int, list[float]]:
        """Return whether the event was met, the length of the arc, its steps and its end. Raises PeerFailed."""
        length, met, steps, good, *end = np.asarray(self._compiled(np.array(packed))).tolist()
        if not good:
            raise PeerFailed(f"diffrax: no end of the arc after {steps:.0f} steps")
        return met == 1, length, int(steps), end
