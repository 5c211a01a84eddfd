"""An independent solver of every scene on a line: Newton's equations, by SciPy, mode by mode, in binary64.

It shares nothing with the engines but the scene; its events and states are good to about 1e-11 of the scene's units.
"""

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from numerics import Law

NEXT_TO_NOTHING, ROUNDING = 1e-9, 1e-12
PRECISELY = {"method": "DOP853", "rtol": 3e-14, "atol": 1e-16, "max_step": 0.02}
"""What is shorter than a step is lost."""


def signal(pieces, t0, order=0):
    """Return a derivative of a signal as a function of time, with the piece that acts from t0 on."""
    acting = [one for one in pieces if one.start <= t0]
    if not acting:
        return lambda _: 0.0
    piece = acting[-1]
    polynomial = np.polynomial.Polynomial([float(c) for c in piece.polynomial] or [0.0]).deriv(order)
    start, sines = float(piece.start), [[float(x) for x in (s.amplitude, s.omega, s.phase)] for s in piece.sines]

    def value(t):
        turned = (a * w**order * math.sin(w * t + p + order * math.pi / 2) for a, w, p in sines)
        return float(polynomial(t - start)) + sum(turned)

    return value


class Tie(ArithmeticError):
    """Two events at once: which mode follows is not decided here."""


class Acting:
    """A scene between two changes of its signals."""

    def __init__(self, scene, t0):
        pair = scene.pair
        self.m1, self.a1, self.a2 = float(pair.m1), float(pair.a1), float(pair.a2)
        self.m2, self.is_fixed = float(pair.m2), pair.is_fixed
        self.u, self.f, self.c, self.y = (
            signal(one.pieces, t0) for one in (scene.force, scene.force_2, scene.belt, scene.wall)
        )
        self.c1, self.y1 = signal(scene.belt.pieces, t0, 1), signal(scene.wall.pieces, t0, 1)
        is_given = any(one.start <= t0 for one in scene.friction.pieces)
        self.b = signal(scene.friction.pieces, t0) if is_given else lambda _: float(pair.b)
        self.ratio = float(pair.b_static / pair.b) if pair.b_static else 1.0
        self.sticks_always, self.weakening = scene.law is not Law.FILIPPOV, scene.friction.weakening
        self.rest = float(pair.b)

    def most(self, t, z, is_slip):
        """Return the most that friction is: b(t) (B(|v1 - v2|) + C(x1 - x2))/b, in stick up to the static one."""
        b, table = self.b(t), self.weakening
        if table is None:
            return b if is_slip else self.ratio * b
        w, knots = abs(z[1] - z[3]) * is_slip, np.array([(0, self.rest), *table.speed], float).T
        of_place = np.interp(z[0] - z[2], *np.array(table.place, float).T) if table.place else 0.0
        beyond = max(w - knots[0, -1], 0.0) * float(table.last_slope)
        return b / self.rest * (np.interp(w, *knots) + beyond + of_place)

    def push(self, t, x1, v1):
        return self.u(t) - self.a2 * (x1 - self.y(t)) - self.a1 * (v1 - self.y1(t))

    def load(self, t, z):
        """Return the friction force on body 2 that sticking needs."""
        push = self.push(t, z[0], z[1])
        if self.is_fixed:
            return push - self.m1 * self.c1(t)
        together = (push + self.f(t)) / (self.m1 + self.m2)
        return self.m2 * together - self.f(t)

    def rate(self, t, z, mode):
        friction = mode * self.most(t, z, True) if mode else self.load(t, z)
        a1 = (self.push(t, z[0], z[1]) - friction) / self.m1
        a2 = self.c1(t) if self.is_fixed else (self.f(t) + friction) / self.m2
        return [z[1], a1, z[3], a2]

    def after_contact(self, t, z):
        load = self.load(t, z)
        return 0 if self.sticks_always or abs(load) <= self.most(t, z, False) else int(math.copysign(1, load))

    def guards(self, mode):
        """Return what is positive in a mode, for SciPy: where it falls through 0 the mode ends."""
        if mode:
            found = [lambda _, z, s: s * (z[1] - z[3])]
        elif self.sticks_always:
            found = []
        else:
            found = [lambda t, z, _, s=s: ROUNDING + self.most(t, z, False) - s * self.load(t, z) for s in (1, -1)]
        for one in found:
            one.terminal, one.direction = True, -1
        return found


def note(events, t, mode, z):
    """Keep an event. Raises Tie where it falls on the one before it, or on the start."""
    if t - (events[-1][0] if events else 0.0) < NEXT_TO_NOTHING:
        raise Tie
    events.append((t, mode, list(z)))


def follow(scene):
    """Return the first mode, the events (t, mode, state) and the state at the end. Raises Tie."""
    changes = {0, *(one.start for pieces in scene.pieces.values() for one in pieces)}
    times = [*sorted(one for one in changes if one < scene.until), scene.until]
    at = scene.initial
    z, mode, first, events = [float(one) for one in (at.x1, at.v1, at.x2, at.v2)], None, None, []
    for start, end in pairwise(times):
        acting, t, before = Acting(scene, start), float(start), mode
        if acting.is_fixed:
            z[3] = acting.c(t)
        if not mode or acting.is_fixed:
            w = z[1] - z[3]
            mode = acting.after_contact(t, z) if abs(w) < NEXT_TO_NOTHING else int(math.copysign(1, w))
        if before is None:
            first = mode
        elif mode != before:
            note(events, t, mode, z)
        while t < end:
            found = solve_ivp(acting.rate, (t, float(end)), z, events=acting.guards(mode), args=(mode,), **PRECISELY)
            t, z = float(found.t[-1]), list(found.y[:, -1])
            if found.status != 1:
                break
            if mode:
                z[1] = z[3]
                mode = acting.after_contact(t, z)
            else:
                mode = 1 if len(found.t_events[0]) else -1
            note(events, t, mode, z)
    return first, events, z


def require(run, answer, within):
    """Fail unless a run has the modes, events and last state of an answer of `follow`."""
    first, events, final = answer
    assert run.signs == [first, *(mode for _, mode, _ in events)]
    found = [[t, *y] for t, y in zip(run.floats(run.event_times), run.floats(run.event_states).T, strict=True)]
    assert found == [pytest.approx([t, *state], abs=within) for t, _, state in events]
    assert run.floats(run.final_state) == pytest.approx(final, abs=within)
