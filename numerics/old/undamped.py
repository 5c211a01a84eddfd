"""Stick and slip for a1 = 0, chained through the variables in which each is free of cancellation."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

from numerics.arithmetic.dual import differentiated
from numerics.arithmetic.protocol import Number, decide_sign
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode, mode_after_contact, slip_mode
from numerics.old import tangent
from numerics.old.motion import Motion
from numerics.old.ray_slip import ray_flow, ray_landing
from numerics.old.slip_flow import SlipFlow, refuse_unresolved
from numerics.scene import Law


class Landing(NamedTuple):
    """The end of a slip: its angle, the gap there, K up to there, and the energy excess there."""

    theta: Number
    gap: Number
    slid: Number
    w: Number


class UndampedSlip:
    """A slip with a1 = 0; `side` = -sign(v1 - v2) is the edge of S0 that its gap is measured from."""

    def __init__(
        self,
        frame: Frame,
        law: Law,
        side: int,
        flow: SlipFlow,
        start: ReducedState,
        *,
        on_surface: bool = True,
        from_ray: bool = False,
    ) -> None:
        """Start a slip from its slip variables and the same state in reduced coordinates.

        `on_surface` says that the guard is 0 and the gap >= 0 exactly, `from_ray` that the gap is 0 too.
        """
        self.frame, self.law, self.side, self.flow, self.start = frame, law, side, flow, start
        self.on_surface, self.from_ray = on_surface, from_ray
        # on the surface the guard is 0 and both velocities are one, but their derivatives may differ
        driven = flow.push_at_start + flow.guard_at_start if on_surface else side * start.V2 / frame.sqrt_q
        self.driven_at_start = driven
        self.mode = slip_mode(-side)

    @classmethod
    def from_exit_ray(cls, frame: Frame, law: Law, side: int, Z: Number, w: Number) -> UndampedSlip:
        """Return the slip that leaves S0 by the ray on this side, where X = side and V = side sqrt(w)."""
        arithmetic, flow = frame.arithmetic, ray_flow(frame, w)
        X, V = differentiated(
            arithmetic,
            lambda: (arithmetic.number(side), side * arithmetic.sqrt(w)),
            lambda _: (side * (1 + frame.q * flow.gap_at_start), side * frame.sqrt_q * flow.push_at_start),
        )
        return cls(frame, law, side, flow, ReducedState(X, V, V, Z, w), from_ray=True)

    @property
    def w(self) -> Number:
        """Return the energy excess at the start."""
        return self.start.w

    @cached_property
    def landing(self) -> Landing:
        """Return where and how the bodies meet in velocity again."""
        arithmetic, derived = self.frame.arithmetic, tangent.ray_landing if self.from_ray else tangent.slip_landing
        landing: Landing = differentiated(arithmetic, self._landing, lambda at: derived(self, at))
        refuse_unresolved(arithmetic, landing.theta)
        return landing

    def _landing(self) -> Landing:
        frame, flow = self.frame, self.flow
        if self.from_ray:
            theta, depth, w = ray_landing(frame, self.start.w)
            return Landing(theta, -depth, depth * depth / 2, w)
        if not self.on_surface:
            theta = flow.first_contact()
            gap, slid = flow.gap(theta), flow.slid(theta)
        else:
            theta, depth, _ = frame.arithmetic.contact(flow.gap_at_start, flow.push_at_start)
            gap, slid = -(flow.gap_at_start + depth), depth * (depth / 2 + flow.gap_at_start)
        return Landing(theta, gap, slid, self._excess_after(theta, gap, slid))

    def _excess_after(self, theta: Number, gap: Number, slid: Number) -> Number:
        """Return w at the contact: w - 2 r q K near E_cr, and V^2 + (X^2 - 1) from far above it.

        The difference would keep the rounding of the large w through every later crossing.
        """
        frame = self.frame
        if frame.arithmetic.to_float(self.w) <= 1:
            return self.w - 2 * frame.r * frame.q * slid
        return self.excess_from_above(theta, gap)

    def excess_from_above(self, theta: Number, gap: Number) -> Number:
        """Return w at the contact from the state there."""
        V, beyond = self.frame.sqrt_q * self._driven_push(theta), self.frame.q * gap
        return V * V + beyond * (2 + beyond)

    def duration(self) -> Number:
        """Return the reduced time of the first contact with the switching surface; it always comes."""
        return self.frame.sqrt_q * self.landing.theta

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start."""
        values, formula = lambda: self._state(tau), lambda _: tangent.slip_state(self, tau)
        return differentiated(self.frame.arithmetic, values, formula)

    def _state(self, tau: Number) -> ReducedState:
        frame, flow, side = self.frame, self.flow, self.side
        theta = tau / frame.sqrt_q
        return ReducedState(
            X=side * (1 + frame.q * flow.gap(theta)),
            V1=side * frame.sqrt_q * flow.push(theta),
            V2=side * frame.sqrt_q * self._driven_push(theta),
            Z=self.start.Z - side * frame.q * flow.slid(theta),
            w=self.w - self.losses(tau)[0],
        )

    def _driven_push(self, theta: Number) -> Number:
        """Return sigma V2/sqrt(q): body 2 feels a constant force."""
        return self.driven_at_start - theta

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return (2 r q K, 0): friction only."""
        frame = self.frame
        return 2 * frame.r * frame.q * self.flow.slid(tau / frame.sqrt_q), frame.arithmetic.number(0)

    def whole_losses(self) -> tuple[Number, Number]:
        """Return the losses up to the landing, which has K already."""
        frame = self.frame
        return 2 * frame.r * frame.q * self.landing.slid, frame.arithmetic.number(0)

    def successor(self) -> Motion:
        """Return the stick phase, or the slip of the other sign, that follows the first contact."""
        frame, side, (theta, gap, slid, w) = self.frame, self.side, self.landing
        push, offset = self._driven_push(theta), frame.q * gap
        V = side * frame.sqrt_q * push
        start = ReducedState(side * (1 + offset), V, V, self.start.Z - side * frame.q * slid, w)
        beyond = -(2 + offset)
        after = mode_after_contact(frame.arithmetic, self.law, -side, beyond, -push)
        if after is Mode.STICK:
            return UndampedStick(frame, self.law, start, side, offset)
        flow = SlipFlow(frame.arithmetic, frame.arithmetic.number(0), beyond / frame.q, -push)
        return UndampedSlip(frame, self.law, -side, flow, start)


class UndampedStick:
    """A stick phase with a1 = 0: one rotation. Its start is X = edge (1 + offset), V1 = V2."""

    mode = Mode.STICK

    def __init__(self, frame: Frame, law: Law, start: ReducedState, edge: int, offset: Number) -> None:
        """Start a stick phase; `offset` is kept apart from X because X - edge would cancel next to the edge."""
        self.frame, self.law, self.start, self.edge, self.offset = frame, law, start, edge, offset

    def duration(self) -> Number | None:
        """Return the reduced time to the exit ray, None for E <= E_cr (or the law that never lets go).

        The exit on side sigma is at e = (1, sqrt w) in (sigma X, sigma V), as far from 0 as the start p = (a, v). So
        p - e is at right angles to p + e, and the tangent of half the angle between p and e is (1 - a)/(v + sqrt w).
        In float64 within 3 ulp: sqrt w, the sum, and 1 - a where it is the far edge, 1 u each at most; atan2 0.52 ulp.
        """
        if self.law is Law.THREE_VALUED_SGN or self._excess_sign <= 0:
            return None
        formula = lambda tau: self._exit() + tangent.stick_exit(self, tau, self._exit_side)  # noqa: E731
        return differentiated(self.frame.arithmetic, self._exit, formula)

    def _exit(self) -> Number:
        side, root = self._exit_side, self.frame.arithmetic.sqrt(self.start.w)
        below = -self.offset if side == self.edge else 2 + self.offset  # 1 - a
        return 2 * self.frame.arithmetic.atan2(below, side * self.start.V1 + root)

    @cached_property
    def _excess_sign(self) -> int:
        return decide_sign(self.frame.arithmetic, self.start.w, "is the energy above the critical energy?")

    @cached_property
    def _exit_side(self) -> int:
        return decide_sign(self.frame.arithmetic, self.start.V1, "which way does the stuck pair move?")

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau: a rotation of (X, V)."""
        values, formula = lambda: self._state(tau), lambda _: tangent.stick_state(self, tau)
        return differentiated(self.frame.arithmetic, values, formula)

    def _state(self, tau: Number) -> ReducedState:
        start = self.start
        cosine, sine = self.frame.arithmetic.cos_sin(tau)
        velocity = start.V1 * cosine - start.X * sine
        return ReducedState(start.X * cosine + start.V1 * sine, velocity, velocity, start.Z, start.w)

    def losses(self, tau: Number) -> tuple[Number, Number]:  # noqa: ARG002
        """Return (0, 0): stick conserves energy."""
        zero = self.frame.arithmetic.number(0)
        return zero, zero

    def whole_losses(self) -> tuple[Number, Number]:
        """Return (0, 0)."""
        return self.losses(self.frame.arithmetic.number(0))

    def successor(self) -> Motion:
        """Return the slip that starts on the exit ray."""
        w = differentiated(self.frame.arithmetic, lambda: self.start.w, lambda w: tangent.excess_at_exit(self, w))
        return UndampedSlip.from_exit_ray(self.frame, self.law, self._exit_side, self.start.Z, w)
