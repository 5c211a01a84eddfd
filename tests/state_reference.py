"""Friction of the state by an event-driven Runge-Kutta method: it shares nothing with the engine but the scene."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from numerics import Scene

_FIRST = 1e-7
"""A first step, s, without events: one that begins at an event does not find that again."""
_HOW = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}


class Found(NamedTuple):
    """Times of events, the modes before, between and after them (signs of v1 - v2), and the last state."""

    t: list[float]
    modes: list[int]
    y: np.ndarray


class _Motion:
    def __init__(self, scene: Scene) -> None:
        pair, given = scene.pair, scene.friction.weakening
        self.scene, self.m1, self.m2, self.a1, self.a2, self.b = (
            scene,
            *(float(getattr(pair, name)) for name in ("m1", "m2", "a1", "a2", "b")),
        )
        self.speed = np.array([(0.0, self.b), *given.speed], dtype=float)
        self.place = np.array(given.place or [(0, 0)], dtype=float)
        self.last_slope = float(given.last_slope)

    def friction(self, t: float, w: float, z: float) -> float:
        beyond = max(w - self.speed[-1, 0], 0.0)
        now = [self.b, *(float(b) for start, b in self.scene.friction.pieces if float(start) <= t)][-1]
        B = np.interp(w, *self.speed.T) + self.last_slope * beyond
        return now / self.b * (B + np.interp(z, *self.place.T))

    def load(self, t: float, y: np.ndarray) -> float:
        pull = float(self.scene.force(t)) - self.a2 * y[0] - self.a1 * y[1]
        return self.m2 / (self.m1 + self.m2) * pull

    def field(self, t: float, y: np.ndarray, mode: int, within: float) -> list[float]:
        x1, v1, x2, v2 = y
        F = self.load(t, y)
        if mode:
            F = mode * self.friction(within, max(mode * (v1 - v2), 0.0), x1 - x2)
        accelerated = (float(self.scene.force(t)) - self.a2 * x1 - self.a1 * v1 - F) / self.m1
        return [v1, accelerated, v2, F / self.m2 if mode else accelerated]

    def after(self, t: float, y: np.ndarray) -> int:
        load = self.load(t, y)
        return 0 if abs(load) <= self.friction(t, 0.0, y[0] - y[2]) else int(np.sign(load))


def reference(scene: Scene) -> Found:
    """Integrate a scene from event to event, stopping at every knot on the way."""
    motion, at, t = _Motion(scene), scene.initial, 0.0
    y = np.array([at.x1, at.v1, at.x2, at.v2], dtype=float)
    times, modes = [], [int(np.sign(y[1] - y[3])) or motion.after(0.0, y)]
    starts = {float(one) for one in (*scene.force.starts, *scene.friction.starts) if 0 < one < scene.until}
    for end in (*sorted(starts), float(scene.until)):
        if modes[-1] == 0 and motion.after(t, y):
            times.append(t)
            modes.append(motion.after(t, y))
        while t < end:
            t, y, over = _leg(motion, t, y, end, modes[-1])
            if over:
                if modes[-1]:
                    y[1] = y[3]
                times.append(t)
                modes.append(motion.after(t, y) if modes[-1] else int(np.sign(motion.load(t, y))))
    return Found(times, modes, y)


def _leg(motion: _Motion, t: float, y: np.ndarray, end: float, mode: int) -> tuple[float, np.ndarray, bool]:
    """Return time and state at an event, a knot or the end, and whether it is an event."""
    within = (t + end) / 2

    def field(s: float, y: np.ndarray) -> list[float]:
        return motion.field(s, y, mode, within)

    def guard(s: float, y: np.ndarray) -> float:
        return mode * (y[1] - y[3]) if mode else motion.friction(within, 0.0, y[0] - y[2]) - abs(motion.load(s, y))

    guards = [guard]
    if mode:
        guards += [lambda _, y, v=v: abs(y[1] - y[3]) - v for v in motion.speed[1:, 0]]
        guards += [lambda _, y, z=z: y[0] - y[2] - z for z in motion.place[:, 0]]
    for one in guards:
        one.terminal = True
    guard.direction = -1
    begun = min(t + _FIRST, end)
    y = solve_ivp(field, (t, begun), y, **_HOW).y[:, -1]
    if begun == end:
        return end, y, False
    found = solve_ivp(field, (begun, end), y, events=guards, max_step=0.03, **_HOW)
    return float(found.t[-1]), found.y[:, -1], found.status == 1 and len(found.t_events[0]) > 0
