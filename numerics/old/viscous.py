"""Stick and slip for a1 > 0. The load P = X + 2 zeta V takes the place of X: the sliding region is |P| <= 1."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property

from numerics.arithmetic.protocol import Number, Sign, decide_sign
from numerics.motion.frame import Frame, ReducedState
from numerics.motion.modes import Mode, mode_after_contact, slip_mode
from numerics.old.motion import Motion
from numerics.old.oscillator import Oscillator
from numerics.old.viscous_contact import Guard, first_contact
from numerics.scene import Law


def stick_oscillator(frame: Frame) -> Oscillator:
    """Return X'' + 2 zeta X' + X = 0, the stick flow."""
    return _oscillator(
        frame,
        frame.two_zeta / 2,
        frame.arithmetic.number(1),
        frame.stick_discriminant,
        frame.arithmetic.number(1),
    )


def slip_oscillator(frame: Frame) -> Oscillator:
    """Return q y'' + 2 zeta y' + y = 0, the flow of y = X + r s in a slip of sign s."""
    return _oscillator(frame, frame.two_zeta / 2 / frame.q, 1 / frame.q, frame.slip_discriminant, frame.q)


def _oscillator(frame: Frame, decay: Number, stiffness: Number, discriminant: Fraction, scale: Number) -> Oscillator:
    arithmetic = frame.arithmetic
    regime = (discriminant > 0) - (discriminant < 0)
    frequency = arithmetic.sqrt(arithmetic.number(abs(discriminant))) / scale
    return Oscillator(arithmetic, decay, stiffness, regime, frequency)


class ViscousSlip:
    """A slip with a1 > 0, of the given sign. `rising` says whether the guard grows right after the start."""

    def __init__(
        self, frame: Frame, law: Law, sign: int, start: ReducedState, rising: bool, *, level: bool = False
    ) -> None:
        """Start a slip from a reduced state; on the switching surface V1 and V2 are the same number.

        `level` says that the guard's second derivative vanishes exactly at the start, which balls cannot see.
        """
        self.frame, self.law, self.sign, self.start, self.rising, self.level = frame, law, sign, start, rising, level
        self.mode, self.oscillator = slip_mode(sign), slip_oscillator(frame)
        self._y, self._v = sign * start.X + frame.r, sign * start.V1

    @cached_property
    def _contact(self) -> Number:
        guard = Guard(self.oscillator, self._y, self._v, self.sign * self.start.V2, level=self.level)
        return first_contact(guard, rising=self.rising)

    def duration(self) -> Number:
        """Return the reduced time of the first contact with the switching surface; it always comes."""
        return self._contact

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start."""
        frame, sign = self.frame, self.sign
        y, v = self.oscillator.propagate(self._y, self._v, tau)
        X, V1, V2 = sign * (y - frame.r), sign * v, self.start.V2 + sign * tau
        Z = self.start.Z + sign * self._slid(y, tau)
        return ReducedState(X, V1, V2, Z, frame.energy_ratio(X, V1, V2) - 1)

    def _slid(self, y: Number, tau: Number) -> Number:
        """Return the integral of |V1 - V2|."""
        return y - self._y - (self.sign * self.start.V2 + tau / 2) * tau

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return what friction and viscosity took from E/E_cr, both in closed form."""
        frame = self.frame
        y, _ = self.oscillator.propagate(self._y, self._v, tau)
        acceleration = -(frame.two_zeta * self._v + self._y) / frame.q
        viscous = self.oscillator.integral_of_square(self._v, acceleration, tau)
        return 2 * frame.r * self._slid(y, tau), 2 * frame.two_zeta * viscous

    def whole_losses(self) -> tuple[Number, Number]:
        """Return the losses up to the contact."""
        return self.losses(self._contact)

    def successor(self) -> Motion:
        """Return the stick phase, or the slip of the other sign, that follows the first contact."""
        frame, sign = self.frame, self.sign
        at = self.state(self._contact)
        landed = at._replace(V1=at.V2)
        load = landed.X + frame.two_zeta * landed.V1
        leaving = sign * (landed.V1 - frame.two_zeta * load)
        if mode_after_contact(frame.arithmetic, self.law, sign, sign * load - 1, leaving) is Mode.STICK:
            return ViscousStick(frame, self.law, landed)
        return ViscousSlip(frame, self.law, -sign, landed, rising=True)


class ViscousStick:
    """A stick phase with a1 > 0: the pair moves as one damped oscillator."""

    mode = Mode.STICK

    def __init__(self, frame: Frame, law: Law, start: ReducedState, *, level: bool = False) -> None:
        """Start a stick phase from a reduced state with V1 = V2; `level`: dP/dt vanishes exactly at the start."""
        self.frame, self.law, self.start, self.oscillator = frame, law, start, stick_oscillator(frame)
        self.level = level

    @cached_property
    def _exit(self) -> tuple[Number, int] | None:
        """Return (time, side) of the exit from |P| <= 1, None if there is none.

        P obeys the same damped equation, so its first extremum is its largest: if that stays inside, all do.
        """
        if self.law is Law.THREE_VALUED_SGN:
            return None
        arithmetic, two_zeta = self.frame.arithmetic, self.frame.two_zeta
        load = self.start.X + two_zeta * self.start.V1
        rate = arithmetic.number(0) if self.level else self.start.V1 - two_zeta * load
        if arithmetic.sign(1 - load * load - rate * rate) is Sign.POSITIVE:
            return None  # P^2 + P'^2 never grows
        # P = -X'', so the load turns where the third derivative of X vanishes
        slowest = self.oscillator.slow_rate if self.oscillator.regime < 0 else self.oscillator.decay
        late = (64 + load * load + rate * rate) / slowest  # by then the load has died away, which is proved below
        turning = self.oscillator.first_jerk_zero(self.start.X, self.start.V1, late, level=self.level)
        if turning is None:
            left, speed = self.oscillator.propagate(load, rate, late)
            question = "has the load on the interface died away?"
            decide_sign(arithmetic, 1 - left * left - speed * speed, question)
            return None
        extremum, _ = self.oscillator.propagate(load, rate, turning)
        side = 1 if arithmetic.to_float(extremum) > 0 else -1
        question = "does the load on the interface exceed what friction can hold?"
        if decide_sign(arithmetic, side * extremum - 1, question) <= 0:
            return None
        inside = lambda tau: 1 - side * self.oscillator.propagate(load, rate, tau)[0]  # noqa: E731
        slope = lambda tau: -side * self.oscillator.propagate(load, rate, tau)[1]  # noqa: E731
        return arithmetic.root(inside, slope, arithmetic.number(0), turning), side

    def duration(self) -> Number | None:
        """Return the reduced time to the exit from the sliding region, None if the pair sticks for ever."""
        return None if self._exit is None else self._exit[0]

    def state(self, tau: Number) -> ReducedState:
        """Return the state at reduced time tau after the start."""
        X, V = self.oscillator.propagate(self.start.X, self.start.V1, tau)
        return ReducedState(X, V, V, self.start.Z, self.frame.energy_ratio(X, V, V) - 1)

    def losses(self, tau: Number) -> tuple[Number, Number]:
        """Return (0, 4 zeta int V^2): viscosity only."""
        frame, V = self.frame, self.start.V1
        acceleration = -(frame.two_zeta * V + self.start.X)
        viscous = self.oscillator.integral_of_square(V, acceleration, tau)
        return frame.arithmetic.number(0), 2 * frame.two_zeta * viscous

    def whole_losses(self) -> tuple[Number, Number]:
        """Return the losses up to the exit."""
        assert self._exit is not None  # asked for only where the phase has ended
        return self.losses(self._exit[0])

    def successor(self) -> Motion:
        """Return the slip that starts on the edge P = side, which X is snapped to exactly."""
        assert self._exit is not None  # the loop asks for a successor only after a finite duration
        tau, side = self._exit
        at = self.state(tau)
        snapped = at._replace(X=side - self.frame.two_zeta * at.V1)
        return ViscousSlip(self.frame, self.law, -side, snapped, rising=True)
