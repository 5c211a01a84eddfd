"""diffrax under a force: one compiled `diffeqsolve` for all modes and spans, called from event to event."""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib.util import find_spec

import numpy as np

from numerics.motion.modes import Mode
from numerics.scene import Scene
from numerics.trade.comparisons.diffrax_peer import MAX_STEPS
from numerics.trade.comparisons.forced_pair import ForcedPair, Span, run_by_spans
from numerics.trade.comparisons.peer import Extra, PeerFailed, PeerRun


class ForcedDiffraxPeer:
    """diffeqsolve by one explicit method; every arc begins with a tenth of a radian, so that its event can be seen."""

    use = "restarted by mode and at jumps, first steps set"
    knob = "rtol"
    settings: tuple[float, ...] = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    forced = True

    def __init__(self, method: str) -> None:
        """Take one of diffrax's solvers: "Dopri8", "Tsit5"."""
        self.method, self.name = method, f"diffrax {method}"

    def missing(self) -> str | None:
        """Name diffrax if it is not installed."""
        return None if find_spec("diffrax") else "diffrax (extra `comparisons`)"

    def prepare(self, scene: Scene, setting: float) -> Callable[[], PeerRun]:
        """Compile the arc. Raises Unsupported."""
        import jax

        pair = ForcedPair.of(scene)
        with jax.enable_x64(True):
            arcs = DiffraxSpans(pair, self.method, setting)

        def run() -> PeerRun:
            with jax.enable_x64(True):
                return run_by_spans(pair, arcs)

        return run


class DiffraxSpans:
    """The compiled arc; mode and force are runtime arguments in one array, as transfers cost more than steps."""

    def __init__(self, pair: ForcedPair, method: str, tolerance: float) -> None:
        """Compile with room for the longest polynomial and the most sines."""
        import jax

        self.steps, self.first = 0, 0.1 * math.sqrt(pair.m1 / pair.a2)
        self.degree = max(len(span.polynomial) for span in pair.spans)
        self.sines = max(len(span.sines) for span in pair.spans)
        arc = arc_function(pair, method, tolerance, self.degree, self.sines)
        self.compiled = jax.jit(arc).lower(np.zeros(11 + self.degree + 3 * self.sines)).compile()

    def arc(self, span: Span, mode: Mode, t: float, y: Extra) -> tuple[bool, float, Extra]:
        """Integrate to the guard or the end of the span. Raises PeerFailed."""
        first = min(self.first, span.end - t)
        polynomial = [*span.polynomial, *[0.0] * (self.degree - len(span.polynomial))]
        idle = [(0.0, 1.0, 0.0)] * (self.sines - len(span.sines))
        sines = [part for sine in (*span.sines, *idle) for part in sine]
        packed = np.array([t, span.end - t, first, mode.sign, span.b, span.origin, *y, *polynomial, *sines])
        ended, met, steps, good, *end = np.asarray(self.compiled(packed)).tolist()
        if not good:
            raise PeerFailed(f"diffrax: no end of the arc after {steps:.0f} steps")
        self.steps += int(steps)
        return met == 1, t + ended if met == 1 else span.end, np.array(end)


def arc_function(pair: ForcedPair, method: str, tolerance: float, degree: int, sines: int) -> Callable[..., Extra]:
    """Return the arc as a function of one array: time, length, first step, sign, b, origin, the start, u's numbers.

    It returns one array: its length, 1 if the event was met, steps, 1 if it got there, the state there. An arc starts
    at 0, lest the bisection works to a fraction of the time.
    """
    import diffrax
    import jax.numpy as jnp
    import optimistix

    a1, a2, m1, m2, mass = pair.a1, pair.a2, pair.m1, pair.m2, pair.mass
    length, speed = pair.scales

    def loaded(since: Extra, y: Extra, args: Extra) -> Extra:
        t, u = args[-1] + since, jnp.zeros(())
        for k in reversed(range(degree)):
            u = u * (t - args[2]) + args[3 + k]
        for n in range(sines):
            amplitude, omega, phase = (args[3 + degree + 3 * n + k] for k in range(3))
            u = u + amplitude * jnp.sin(omega * t + phase)
        return u - a2 * y[0] - a1 * y[1]

    def field(t: Extra, y: Extra, args: Extra) -> Extra:
        rub, load, slips = args[0] * args[1], loaded(t, y, args), args[0] != 0
        pull = jnp.where(slips, (load - rub) / m1, load / mass)
        other = jnp.where(slips, rub / m2, load / mass)
        return jnp.stack([y[1], pull, y[3], other, rub * (y[1] - y[3]) + a1 * y[1] ** 2])

    def guard(t: Extra, y: Extra, args: Extra, **_: Extra) -> Extra:
        held = args[1] * (mass / m2)
        return jnp.where(args[0] != 0, args[0] * (y[1] - y[3]) / speed, 1 - jnp.abs(loaded(t, y, args)) / held)

    event = diffrax.Event(guard, optimistix.Bisection(1e-15, 1e-14), direction=False)
    atol = tolerance * jnp.array([length, speed, length, speed, a2 * length**2])
    controller = diffrax.PIDController(rtol=tolerance, atol=atol)
    solver = getattr(diffrax, method)()

    def arc(packed: Extra) -> Extra:
        out = diffrax.diffeqsolve(
            diffrax.ODETerm(field),
            solver,
            0.0,
            packed[1],
            packed[2],
            packed[6:11],
            args=jnp.concatenate([packed[3:6], packed[11:], packed[:1]]),
            stepsize_controller=controller,
            event=event,
            max_steps=MAX_STEPS,
            throw=False,
        )
        stopped = out.result == diffrax.RESULTS.event_occurred
        good = stopped | (out.result == diffrax.RESULTS.successful)
        return jnp.concatenate([jnp.stack([out.ts[-1], stopped, out.stats["num_steps"], good]), out.ys[-1]])

    return arc
