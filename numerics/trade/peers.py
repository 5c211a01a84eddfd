"""SciPy and heyoka on a scene, as their user writes it down: z' = A z of linear/model.py, from event to event.

An arc is a slip +, or as its mirror image a slip -, until v1 - v2 falls to 0, or a stick, until the load meets an edge.
Every arc starts at time 0, lest its root is located to a fraction of the time since the start.

SciPy looks at the signs of its guards at step ends. So a stick arc also stops where the load turns back: the lesser of
both guards stays below 0 once an edge is past, and no step can jump over a short stay beyond it.

heyoka: Taylor integrators, compiled once. At an exit v1 - v2 has a double zero, which its root isolation does not get
past: it loses the next root of that step. So a short step without events leads off the surface first, and in a short
slip the next step is cut to its length, so that the roots lie apart.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from numerics.errors import NumericsError
from numerics.linear.exact_start import mode_at_start
from numerics.linear.model import BELT, FIRST, FRICTION, SLIP, STICK, V1, V2, Layout, exact_rows
from numerics.linear.modes import MODES
from numerics.linear.pieces import pieces_of
from numerics.linear.sine_form import SineForm
from numerics.linear.ties import exact_z, signal_form
from numerics.scene import Law, Pair, Scene
from numerics.trade.judge import Call, Outcome

Row = list[tuple[int, Any]]
"""A linear function of z: places and coefficients, of the integrator's numbers: float or numpy.longdouble."""
Vector = Any
"""An array of such numbers."""
Extra = Any
"""What a module of the extra `comparisons` makes; it is imported late and untyped."""
MAX_ARCS = 300_000
NOTHING = 1e-300
"""Keeps a load that does not change from turning back."""
FAILED = -(2**32)
"""Outcomes down here are heyoka's own; -1 - i says that terminal event i has stopped the run."""
_BITS = 192


class PeerFailed(NumericsError):
    """A run that does not get to the horizon: too many steps or events, or its own error."""


def unknown(scene: Any) -> str | None:
    """Return in words what is written down here of no such scene; None where it is known."""
    if not isinstance(scene, Scene):
        return "a surface"
    if scene.law is not Law.FILIPPOV:
        return f'law = "{scene.law.value}"'
    if not (scene.pair.a2 and scene.pair.b):
        return "a2 = 0 or b = 0"
    return "friction that depends on the state" if scene.friction.weakening else None


class Matrices(NamedTuple):
    """What a pair, and number and frequencies of the terms of its signals, make of stick [0] and of slip + [1].

    A slip - is the mirror image of a slip +: all of z but friction has the opposite sign.
    """

    rates: list[Any]
    """A (n, n)."""
    guards: list[list[Row]]
    """What falls to 0 at the event: b_static - Lambda and b_static + Lambda; v1 - v2."""
    bends: list[list[Row]]
    """The first three derivatives of the first guard."""
    mirror: Vector
    """By what z is multiplied in a slip -, (n,)."""

    def after_contact(self, z: Sequence[Any]) -> int:
        """Return the mode after v1 = v2."""
        near, far = (dot(row, z) for row in self.guards[0])
        return int(near < 0) - int(far < 0)


def dot(row: Row, z: Sequence[Any]) -> Any:
    """Return the value of a row."""
    value = 0 * z[0]
    for k, c in row:
        value += c * z[k]
    return value


@cache
def matrices(pair: Pair, layout: Layout, kind: type) -> Matrices:
    """Return the matrices of a pair under signals of a layout: formed exactly, and rounded once."""
    rows, found = exact_rows(pair, layout), Matrices([], [], [], -np.ones(layout.size, dtype=int))
    first, terms, sines, waves = layout.blocks[FRICTION]
    found.mirror[[*range(first, first + terms), *range(sines, sines + 2 * waves)]] = 1
    rounded = np.vectorize(lambda c: kind(str(c.numerator)) / kind(str(c.denominator)), otypes=[kind])
    for A, guards in ((rows.A[STICK], rows.guards[STICK]), (rows.A[SLIP], rows.guards[SLIP][:1])):
        bends = [guards[0] @ A, guards[0] @ A @ A, guards[0] @ A @ A @ A]
        for own, some in ((found.guards, guards), (found.bends, bends)):
            own.append([[(k, kind(c)) for k, c in enumerate(row) if c] for row in rounded(np.array(some))])
        found.rates.append(rounded(A))
    return found


class Span(NamedTuple):
    """A piece of the signals in an integrator's numbers: when, the jump of the belt, components of z, matrices."""

    start: Any
    length: Any
    jump: Any
    signals: list[Any]
    own: Matrices


class SwitchedPair:
    """A scene of Filippov's law in an integrator's own numbers, SI units; the mode at t = 0 is decided exactly."""

    def __init__(self, scene: Scene, kind: type = float) -> None:
        """Round what is exact, once."""
        pair, at, self.kind, self.mode = scene.pair, scene.initial, kind, mode_at_start(scene).sign
        self.quick = 0.5 * math.sqrt(pair.m1 / pair.a2)
        """Half a radian of slip, s."""

        def rounded(*exact: SineForm) -> list[Any]:
            return [kind(one.enclosed(_BITS).str(40, radius=False)) for one in exact]

        self.state, self.spans = rounded(*map(SineForm, at)), list[Span]()
        begin, belt = Fraction(0), SineForm(at.v2) if pair.is_fixed else SineForm()
        for piece in pieces_of(scene):
            jump = signal_form(piece, BELT, begin) - belt
            start, length, move = rounded(SineForm(piece.start), SineForm(piece.length), jump)
            signals = rounded(*exact_z(piece, 1, begin, ()))
            self.spans.append(Span(start, length, move, signals, matrices(pair, piece.layout, kind)))
            belt = signal_form(piece, BELT, piece.length)
        loads = ((dot(row, self.state + one.signals) for row in one.own.guards[0]) for one in self.spans)
        length = max(float(sum(map(abs, one))) for one in loads) / float(pair.a2)
        self.sizes = [length, length / self.quick] * 2
        """Of the state: what absolute tolerances are measured by."""

    def first_step(self, own: Matrices, z: Sequence[Any]) -> tuple[float, float]:
        """Return a step off the surface that ends within the slip, and when v1 - v2 comes back by its series, s.

        It starts as c1 t + c2 t^2/2 + c3 t^3/6; where it leaves steeply that is not asked.
        """
        c1, c2, c3 = (float(dot(row, z)) for row in own.bends[1])
        inner = c2 * c2 / 4 - 2 * c1 * c3 / 3
        if c1 > abs(c2) * self.quick or not c3 < 0 <= inner:
            return self.quick, math.inf
        back = 3 * (-c2 / 2 - math.sqrt(inner)) / c3
        return min(back / 2, self.quick), back


Arc = Callable[[Matrices, bool, Vector, Any], tuple[bool, Any, Vector]]
"""An integrator of stick and of slip +: from matrices, whether it slips, z and the time that is left (s), to whether it
met its event, the time that has passed and z there. Raises PeerFailed."""


def switched(integrator: Callable[[SwitchedPair, float], Arc], kind: type = float) -> Callable[[Scene, float], Call]:
    """Return what prepares an integrator, in numbers of a format: it compiles once, and each call solves the scene."""

    def prepare(scene: Scene, setting: float) -> Call:
        pair = SwitchedPair(scene, kind)
        arc = integrator(pair, setting)
        return lambda: run(pair, arc)

    return prepare


def run(pair: SwitchedPair, arc: Arc) -> Outcome:
    """Run from event to event and from jump to jump. Raises PeerFailed."""
    mode, z, arcs, modes, times = pair.mode, pair.state, 0, [pair.mode], list[Any]()
    states = [tuple(z)]
    for start, length, jump, signals, own in pair.spans:
        z, t = [*z[:FIRST], *signals], pair.kind(0)
        z[V1], z[V2] = z[V1] if mode else z[V2], z[V2] + jump
        apart = z[V1] - z[V2]
        after = int(np.sign(apart)) or own.after_contact(z) if start else mode
        while True:
            if after != mode:
                modes.append(after)
                times.append(start + t)
                states.append(tuple(z[:FIRST]))
            mode, arcs = after, arcs + 1
            if t >= length:
                break
            if arcs > MAX_ARCS:
                raise PeerFailed(f"{len(times)} events by t = {start + t:.9g} s in {arcs} arcs")
            left, image = length - t, own.mirror if mode < 0 else 1
            met, taken, z = arc(own, mode != 0, np.multiply(image, z), left)
            z = image * z
            t = length if taken >= left else t + taken
            if met:
                near, far = (dot(row, z) for row in own.guards[0])
                after = own.after_contact(z) if mode else 1 if near < far else -1
                z[V1] = z[V1] if after == -mode else z[V2]  # what crosses steeply is not off the surface: let it be
    return Outcome([MODES[one].value for one in modes], times, [*states, tuple(z[:FIRST])])


def scipy_arcs(pair: SwitchedPair, rtol: float) -> Arc:
    """Return the arcs of a pair by DOP853; absolute tolerances are rtol times the pair's own sizes."""
    from scipy.integrate import solve_ivp

    def arc(own: Matrices, slips: bool, z: Vector, left: float) -> tuple[bool, float, Vector]:
        first = min(pair.first_step(own, z)[0], left) if slips and z[V1] == z[V2] else None
        sizes, turn = [*pair.sizes, *[max(map(abs, z[FIRST:]))] * (len(z) - FIRST)], own.bends[0][0]
        since, sign = 0.0, 0 if slips else np.sign(dot(turn, z))
        how: Extra = {"method": "DOP853", "rtol": rtol, "atol": rtol * np.array(sizes)}
        while True:

            def guards(z: Extra, sign: int = sign) -> tuple[float, float]:
                """Return what falls to 0 at the event, and where the load turns."""
                turning = NOTHING + sign * dot(turn, z) if sign else math.inf
                return min(dot(row, z) for row in own.guards[slips]), turning

            def watched(_: float, z: Extra, guards: Any = guards) -> float:
                return min(guards(z))

            watched.terminal, watched.direction = True, -1  # type: ignore[attr-defined]
            span = 0, left - since
            found = solve_ivp(lambda _, z: own.rates[slips] @ z, span, z, events=watched, first_step=first, **how)
            since, z = since + float(found.t[-1]), found.y[:, -1]
            if found.status == -1:
                raise PeerFailed(f"SciPy after {since:.9g} s: {found.message}")
            met, turning = guards(z)
            if found.status == 0 or met <= turning:
                return found.status == 1, since, z
            sign, first = -sign, None

    return arc


def heyoka_arcs(pair: SwitchedPair, tol: float) -> Arc:
    """Compile stick, and each slip with and without events, in the numbers of a pair."""
    import heyoka as hy

    zero, cut = pair.kind(0), int(hy.taylor_outcome.time_limit)

    def compiled(own: Matrices, slips: int, *, has_events: bool = True) -> Extra:
        z = [hy.expression(f"z{k}") for k in range(len(own.rates[0]))]
        options: Any = {"direction": hy.event_direction.negative, "fp_type": pair.kind}
        events = [hy.t_event(dot(row, z), **options) for row in own.guards[slips] if has_events]
        system = [(one, dot([*enumerate(row)], z)) for one, row in zip(z, own.rates[slips], strict=True)]
        one = hy.taylor_adaptive(system, [zero] * len(z), tol=pair.kind(tol), t_events=events, fp_type=pair.kind)
        return one, one.state

    made = {
        key: [(compiled(own, slips), compiled(own, slips, has_events=False)) for slips in (0, 1)]
        for key, own in {id(one.own): one.own for one in pair.spans}.items()
    }

    def arc(own: Matrices, slips: bool, z: Vector, left: Any) -> tuple[bool, Any, Vector]:
        ((one, state), (off, there)), since, length = made[id(own)][slips], zero, zero
        if slips and z[V1] == z[V2]:
            step, back = pair.first_step(own, z)
            off.time, there[:] = zero, z
            off.step(min(left, pair.kind(step)))
            since, z = off.time, there
            length = pair.kind(1.5 * back) if back < pair.quick else length
        one.time, state[:] = since, z
        one.reset_cooldowns()
        code = int(one.step(min(left - since, length))[0]) if length else FAILED
        if code <= FAILED:
            code = int(one.propagate_until(left)[0])
        if code <= FAILED and code != cut:
            raise PeerFailed(f"heyoka after {one.time:.9g} s: outcome {code}")
        return code > FAILED, one.time, state

    return arc
