"""The paper's integrator: explicit Euler with a fixed step, for both readings of the friction law.

It is here to be compared with, not to be trusted: it meets v1 = v2 exactly at most at its start, so its stick is
chatter, and in stick its energy grows by a factor of 1 + (step Omega)^2 each step. The trade judges it as its user
would read it, chatter inside the sliding region being sticking: from the signs of v1 - v2 and the loads at its steps,

    slip of sign s ends    at the first step where v1 - v2 no longer has sign s: an entry if the load lies in the
                           sliding region there, else a crossing;
    stick (chatter) ends   at the first step where the load lies outside the region: an exit;
    a new slip             may have to wait for its sign, as after chatter: it can end only once v1 - v2 has had its
                           sign, or the load is back inside.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from numerics.arithmetic.compiled import compiled
from numerics.linear.exact_start import mode_at_start
from numerics.linear.modes import MODES
from numerics.scene import Law, Scene
from numerics.trade.judge import Call, Outcome
from numerics.trade.peers import unknown

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class EulerRun:
    """Samples of a forward Euler run: t (n,) s, y (4, n) with rows x1, v1, x2, v2; approximate."""

    scene: Scene
    t: Vector
    y: Vector

    @property
    def sign(self) -> Vector:
        """Return sgn(v1 - v2) at every step."""
        return np.sign(self.y[1] - self.y[3])

    @property
    def load(self) -> Vector:
        """Return a2 x1 + a1 v1 by the largest one that stick holds, at every step."""
        pair = self.scene.pair
        return (float(pair.a2) * self.y[0] + float(pair.a1) * self.y[1]) / float(pair.b / pair.share_2)

    @property
    def chatter(self) -> int:
        """Return how often sgn(v1 - v2) flips between consecutive steps whose loads lie in the sliding region."""
        sign, inside = self.sign, np.abs(self.load) <= 1
        return int(np.count_nonzero((sign[1:] * sign[:-1] < 0) & inside[1:] & inside[:-1]))

    @property
    def exact_contacts(self) -> int:
        """Return at how many steps v1 = v2 holds exactly."""
        return int(np.count_nonzero(self.y[1] == self.y[3]))

    @property
    def energy(self) -> Vector:
        """Return E at every step, J."""
        return np.asarray(self.scene.pair.energy(self.y, float))


def march(y: Vector, step: float, literal: bool, m1: float, m2: float, a1: float, a2: float, b: float) -> None:
    """Fill the columns of y, (4, n), from the first one on: plain arithmetic, fit for a compiler."""
    x1, v1, x2, v2 = float(y[0, 0]), float(y[1, 0]), float(y[2, 0]), float(y[3, 0])
    for n in range(1, y.shape[1]):
        load = a2 * x1 + a1 * v1
        sign = (v1 > v2) * 1 - (v1 < v2) * 1
        if sign == 0 and not literal and abs(load) > b * (m1 + m2) / m2:
            sign = -1 if load > 0 else 1
        if sign != 0:
            dv1, dv2 = -(load + b * sign) / m1, b * sign / m2
        else:
            dv1 = dv2 = -load / (m1 + m2)
        x1, v1, x2, v2 = x1 + step * v1, v1 + step * dv1, x2 + step * v2, v2 + step * dv2
        y[0, n], y[1, n], y[2, n], y[3, n] = x1, v1, x2, v2


def forward_euler(scene: Scene, step: float) -> EulerRun:
    """Integrate a scene without a force by the explicit Euler method of the given step (s) > 0. Raises ValueError.

    Where v1 = v2 holds exactly: the law `three-valued-sgn` uses the stick branch of eqs (11)-(12), generalised to any
    masses; the law `filippov` uses it inside the sliding region only, and the slip field that leads away outside.
    """
    steps = round(float(scene.until) / step) if step > 0 else 0
    if steps < 1:
        raise ValueError(f"step = {step:g} s must lie between 0 and the horizon {float(scene.until):g} s")
    pair = scene.pair
    y = np.empty((4, steps + 1))
    y[:, 0] = [*map(float, scene.initial)]
    t = np.linspace(0.0, step * steps, steps + 1)
    numbers = [float(one) for one in (pair.m1, pair.m2, pair.a1, pair.a2, pair.b)]
    compiled(march)(y, step, scene.law is Law.THREE_VALUED_SGN, *numbers)
    return EulerRun(scene, t, y)


def not_marched(scene: Any) -> str | None:
    """Return in words what forward Euler is not written down for: all but the paper's equations."""
    return unknown(scene) or scene.extra or ("a force" if scene.is_forced else None)


def euler_peer(scene: Scene, steps: float) -> Call:
    """Prepare a run of so many steps, its first mode known."""
    first, step = mode_at_start(scene).sign, float(scene.until) / steps
    return lambda: read(first, forward_euler(scene, step))


@np.errstate(over="ignore", invalid="ignore")  # a coarse step may blow up, and says so by its result
def read(first: int, euler: EulerRun) -> Outcome:
    """Return what a forward Euler run says, its first mode known, read by the rules above."""
    events = list(events_of(euler.sign, euler.load, first))
    at = [step for step, _ in events]
    modes = [MODES[mode].value for mode in (first, *(mode for _, mode in events))]
    return Outcome(modes, euler.t[at], euler.y[:, [0, *at, -1]].T)


def events_of(sign: Vector, load: Vector, mode: int) -> Iterator[tuple[int, int]]:
    """Yield the step of each event and the mode after it; a mode is the sign of the slip, 0 in stick."""
    inside, begun = np.abs(load) <= 1, False
    changes = np.flatnonzero((sign[1:] != sign[:-1]) | (inside[1:] != inside[:-1])) + 1
    for step in (0, *changes.tolist()):  # between them nothing can begin or end
        begun = begun or bool(inside[step]) or sign[step] == mode
        if mode == 0 and not inside[step]:
            mode = -1 if load[step] > 0 else 1
            begun = sign[step] == mode
            yield step, mode
        elif mode != 0 and begun and sign[step] != mode:
            mode = 0 if inside[step] else -mode
            begun = sign[step] == mode
            yield step, mode
