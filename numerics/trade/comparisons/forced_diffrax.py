"""diffrax under a force: one compiled `diffeqsolve` for all modes and spans, called from event to event."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from numerics.motion.modes import Mode
from numerics.scene import Scene
from numerics.trade.comparisons.diffrax_arc import Arc, Asked, DiffraxMethod
from numerics.trade.comparisons.forced_pair import ForcedPair, Span, run_by_spans
from numerics.trade.comparisons.peer import Extra, PeerRun


class ForcedDiffraxPeer(DiffraxMethod):
    """A pair under a force by diffrax; every arc begins with a tenth of a radian, so that its event can be seen."""

    use = "restarted by mode and at jumps, first steps set"
    settings: tuple[float, ...] = (1e-4, 1e-6, 1e-8, 1e-10, 1e-12)
    forced = True

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
    """The compiled arc; mode and force are runtime arguments in one array."""

    def __init__(self, pair: ForcedPair, method: str, tolerance: float) -> None:
        """Compile with room for the longest polynomial and the most sines."""
        self.steps, self.first = 0, 0.1 * math.sqrt(pair.m1 / pair.a2)
        self.degree = max(len(span.polynomial) for span in pair.spans)
        self.sines = max(len(span.sines) for span in pair.spans)
        length, speed = pair.scales
        load = _load(pair, self.degree, self.sines)
        self.compiled = Arc(
            method,
            tolerance,
            (length, speed, length, speed, pair.a2 * length**2),
            _field(pair, load),
            _guard(pair, load),
            _unpack,
            11 + self.degree + 3 * self.sines,
        )

    def arc(self, span: Span, mode: Mode, t: float, y: Extra) -> tuple[bool, float, Extra]:
        """Integrate to the guard or the end of the span. Raises PeerFailed."""
        first = min(self.first, span.end - t)
        polynomial = [*span.polynomial, *[0.0] * (self.degree - len(span.polynomial))]
        idle = [(0.0, 1.0, 0.0)] * (self.sines - len(span.sines))
        sines = [part for sine in (*span.sines, *idle) for part in sine]
        packed = [t, span.end - t, first, mode.sign, span.b, span.origin, *y, *polynomial, *sines]
        met, ended, steps, end = self.compiled(packed)
        self.steps += steps
        return met, t + ended if met else span.end, np.array(end)


def _unpack(packed: Extra) -> Asked:
    """Read an array: time, length, first step, sign, b, origin, the start, u's numbers.

    The arc starts at 0, lest the bisection works to a fraction of the time; the time comes last in what field and guard
    are told: sign, b, origin, u's numbers, time.
    """
    import jax.numpy as jnp

    return Asked(packed[1], packed[2], packed[6:11], jnp.concatenate([packed[3:6], packed[11:], packed[:1]]))


def _load(pair: ForcedPair, degree: int, sines: int) -> Callable[[Extra, Extra, Extra], Extra]:
    """Return u - a2 x1 - a1 v1, N."""
    import jax.numpy as jnp

    def load(since: Extra, y: Extra, args: Extra) -> Extra:
        t, u = args[-1] + since, jnp.zeros(())
        for k in reversed(range(degree)):
            u = u * (t - args[2]) + args[3 + k]
        for n in range(sines):
            amplitude, omega, phase = (args[3 + degree + 3 * n + k] for k in range(3))
            u = u + amplitude * jnp.sin(omega * t + phase)
        return u - pair.a2 * y[0] - pair.a1 * y[1]

    return load


def _field(pair: ForcedPair, load: Callable[[Extra, Extra, Extra], Extra]) -> Callable[..., Extra]:
    """Return the rates of (x1, v1, x2, v2, energy lost)."""
    import jax.numpy as jnp

    def field(t: Extra, y: Extra, args: Extra) -> Extra:
        rub, pull, slips = args[0] * args[1], load(t, y, args), args[0] != 0
        first = jnp.where(slips, (pull - rub) / pair.m1, pull / pair.mass)
        second = jnp.where(slips, rub / pair.m2, pull / pair.mass)
        return jnp.stack([y[1], first, y[3], second, rub * (y[1] - y[3]) + pair.a1 * y[1] ** 2])

    return field


def _guard(pair: ForcedPair, load: Callable[[Extra, Extra, Extra], Extra]) -> Callable[..., Extra]:
    """Return what falls to 0 at the event: the relative speed in slip, what friction has left in stick."""
    import jax.numpy as jnp

    def guard(t: Extra, y: Extra, args: Extra, **_: Extra) -> Extra:
        held = args[1] * (pair.mass / pair.m2)
        return jnp.where(args[0] != 0, args[0] * (y[1] - y[3]) / pair.scales[1], 1 - jnp.abs(load(t, y, args)) / held)

    return guard
