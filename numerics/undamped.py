"""Stick and slip for a1 = 0, chained through the variables in which each is free of cancellation."""

from __future__ import annotations

from functools import cached_property

from numerics.arithmetic.protocol import Number, decide_sign
from numerics.modes import Mode, mode_after_contact, slip_mode
from numerics.motion import Motion
from numerics.scaling import Frame, ReducedState
from numerics.scene import Law
from numerics.slip_flow import SlipFlow, refuse_unresolved
from numerics.surface_slip import contact


class UndampedSlip:
    """A slip with a1 = 0; `side` = -sign(v1 - v2) is the edge of S0 that its gap is measured from."""

    def __init__(
        self,
        frame: Frame,
        law: Law,
        side: int,
        flow: SlipFlow,
        Z: Number,
        w: Number,
        *,
        V2: Number | None = None,
        on_surface: bool = True,
        from_ray: bool = False,
    ) -> None:
        """Start a slip from its slip variables, its relative displacement and its energy excess.

        `on_surface` says that the guard is 0 and the gap >= 0 exactly, `from_ray` that the gap is 0 too. `V2` is needed
        off the surface, where its sum with push and guard would cancel for a slow body 2.
        """
        self.frame, self.law, self.side, self.flow, self.Z, self.w = frame, law, side, flow, Z, w
        self.on_surface, self.from_ray = on_surface, from_ray
        self._driven_at_start = flow.push_at_start if V2 is None else side * V2 / frame.sqrt_q
        self.mode = slip_mode(-side)

    @cached_property
    def _landing(self) -> tuple[Number, Number, Number]:
        """The slip angle at which the bodies meet in velocity again, the gap there, and K up to there."""
        flow, arithmetic = self.flow, self.frame.arithmetic
        if self.on_surface:
            end = contact(arithmetic, flow.gap_at_start, flow.push_at_start)
            gap, slid = -(flow.gap_at_start + end.depth), end.depth * (end.depth / 2 + flow.gap_at_start)
            landing = end.theta, gap, slid
        else:
            theta = flow.first_contact()
            landing = theta, flow.gap(theta), flow.slid(theta)
        refuse_unresolved(arithmetic, landing[0])
        return landing

    def duration(self) -> Number:
        """Return the reduced time of the first contact with the switching surface; it always comes."""
        return self.frame.sqrt_q * self._landing[0]

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start."""
        frame, flow, side = self.frame, self.flow, self.side
        theta = tau / frame.sqrt_q
        return ReducedState(
            X=side * (1 + frame.q * flow.gap(theta)),
            V1=side * frame.sqrt_q * flow.push(theta),
            V2=side * frame.sqrt_q * self._driven_push(theta),
            Z=self.Z - side * frame.q * flow.slid(theta),
            w=self.w - self.losses(tau)[0],
        )

    def _driven_push(self, theta: Number) -> Number:
        """Return sigma V2/sqrt(q): body 2 feels a constant force."""
        return self._driven_at_start - theta

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return (2 r q K, 0): friction only."""
        frame = self.frame
        return 2 * frame.r * frame.q * self.flow.slid(tau / frame.sqrt_q), frame.arithmetic.number(0)

    def successor(self) -> Motion:
        """Return the stick phase, or the slip of the other sign, that follows the first contact."""
        frame, side, (theta, gap, _) = self.frame, self.side, self._landing
        push = self._driven_push(theta)
        at = self.state(frame.sqrt_q * theta)._replace(X=side * (1 + frame.q * gap), w=self._excess_after_contact())
        beyond = -(2 + frame.q * gap)
        after = mode_after_contact(frame.arithmetic, self.law, -side, beyond, -push)
        if after is Mode.STICK:
            start = ReducedState(at.X, at.V2, at.V2, at.Z, at.w)
            return UndampedStick(frame, self.law, start, side, frame.q * gap)
        flow = SlipFlow(frame.arithmetic, frame.arithmetic.number(0), beyond / frame.q, -push)
        return UndampedSlip(frame, self.law, -side, flow, at.Z, at.w)

    def _excess_after_contact(self) -> Number:
        """Return w at the first contact, w - 2 r q K.

        From a ray everything is a function of w alone, and dw'/dw = 1 - r versine(theta) < 1: taken as that function,
        enclosures do not grow from one excursion to the next, however many there are.
        """
        frame, (theta, gap, slid) = self.frame, self._landing
        if not self.from_ray:
            return self._excess_on_surface(theta, gap, slid)
        arithmetic = frame.arithmetic

        def after(w: Number) -> Number:
            return w - 2 * frame.r * frame.q * ray_flow(frame, w).slid(theta)

        return arithmetic.mean_value(after, lambda _: 1 - frame.r * arithmetic.versine(theta), self.w)

    def _excess_on_surface(self, theta: Number, gap: Number, slid: Number) -> Number:
        """Return w at the contact: w - 2 r q K near E_cr, and V^2 + (X^2 - 1) from far above it.

        The difference would keep the rounding of the large w through every later crossing.
        """
        frame = self.frame
        if frame.arithmetic.to_float(self.w) <= 1:
            return self.w - 2 * frame.r * frame.q * slid
        V, beyond = frame.sqrt_q * self._driven_push(theta), frame.q * gap
        return V * V + beyond * (2 + beyond)


def ray_flow(frame: Frame, w: Number) -> SlipFlow:
    """Return the slip variables on an exit ray with energy excess w: gap 0 and guard 0 exactly, push sqrt(w/q)."""
    zero = frame.arithmetic.number(0)
    return SlipFlow(frame.arithmetic, zero, zero, frame.arithmetic.sqrt(w) / frame.sqrt_q)


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
        start = self.start
        cosine, sine = self.frame.arithmetic.cos_sin(tau)
        velocity = start.V1 * cosine - start.X * sine
        return ReducedState(start.X * cosine + start.V1 * sine, velocity, velocity, start.Z, start.w)

    def losses(self, tau: Number) -> tuple[Number, Number]:  # noqa: ARG002
        """Return (0, 0): stick conserves energy."""
        zero = self.frame.arithmetic.number(0)
        return zero, zero

    def successor(self) -> Motion:
        """Return the slip that starts on the exit ray."""
        start = self.start
        flow = ray_flow(self.frame, start.w)
        return UndampedSlip(self.frame, self.law, self._exit_side, flow, start.Z, start.w, from_ray=True)
