"""Each answer once more: the scene that it claims something of is solved in balls, and the claim is compared."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from numerics.arithmetic.ball import Ball
from numerics.control.orbit import Orbit
from numerics.control.rounding import KEPT_DIGITS, rounded
from numerics.control.signals import Derivative
from numerics.control.tracking import Tracking
from numerics.control.transfer import Road, Transfer
from numerics.errors import NumericsError
from numerics.motion.modes import Mode
from numerics.scene import Force, Piece, Scene, Sine, State
from numerics.solver.solve import solve
from numerics.trajectory.trajectory import Trajectory

_SPARE = 3


class SecondSolveDiffers(NumericsError):
    """The same scene solved by events does not do what an answer says of it: one of the two is wrong."""


def transfer_again(found: Transfer) -> Trajectory | None:
    """Return the transfer's scene solved in balls. Raises SecondSolveDiffers unless body 2 rests at the distance.

    What the exact decimals of a scene leave of it is below 10^-18 of the distance.
    """
    if found.scene is None:
        return None
    solved = solve(found.scene, digits=found.digits, arithmetic="ball")
    start, place = found.scene.initial.x2, solved.final_state[2]
    with Ball(found.digits + 20).context():
        _require_near("x2 at the end of the transfer", place, Ball.number(start + found.distance), abs(found.distance))
    if found.road is not Road.SLIP:
        _require_stuck(solved)
    elif solved.final_mode is not Mode.STICK:
        raise SecondSolveDiffers("the bodies do not rest together at the end of the transfer")
    return solved


def tracking_again(found: Tracking) -> Trajectory | None:
    """Return the scene solved in balls. Raises SecondSolveDiffers unless the pair sticks and x2 = r at the end.

    At the limit of friction a force with rounded phases may let the bodies slip by their error: there x2 alone counts.
    """
    if found.scene is None:
        return None
    solved = solve(found.scene, digits=found.digits, arithmetic="ball")
    if not (found.is_at_limit and found.force_error > 0):
        _require_stuck(solved)
    until, last = found.scene.until, found.demands[-1].number - 1
    with Ball(found.digits + 20).context():
        path = Derivative.of(found.reference[last], 0)(Ball.number(until))
        _require_near("x2 at the horizon", solved.final_state[2], path, max(Fraction(1), abs(rounded(path))))
    return solved


def orbit_again(orbit: Orbit, digits: int) -> Trajectory:
    """Return one period of a periodic motion, started inside its first leg, solved in balls.

    The time and the state of that start are rounded to decimals; by the contraction of N nothing of it grows. Raises
    SecondSolveDiffers unless the modes are those of the orbit and the state comes back.
    """
    leg, after = orbit.turns[0]
    with Ball(digits + 20).context():
        begin = rounded((leg.t + after.t) / 2)
    with Ball(2 * digits + 20).context():
        x1, v1, _, v2 = orbit.motion(leg).state(Ball.number(begin) - leg.t)
        number = [rounded(one, max(digits + _SPARE, KEPT_DIGITS)) for one in (x1, v1, v2)]
        # a constant part of a phase beyond a turn is kept: the sine is the same function of time
        piece = orbit.drive.piece
        sines = [Sine(one.amplitude, one.omega, one.phase + one.omega * begin) for one in piece.sines]
        until = rounded(orbit.drive.period, max(digits + _SPARE, KEPT_DIGITS))
    start = State(x1=number[0], v1=number[1], x2=0, v2=number[2] if leg.side else number[1])
    scene = Scene(orbit.drive.pair, start, until, force=Force((Piece(0, piece.polynomial, sines),)))
    solved = solve(scene, digits=digits, arithmetic="ball")
    sides = [mode.sign for mode in solved.modes]
    expected = [one.side for one in orbit.legs] + [leg.side]
    if sides != expected:
        raise SecondSolveDiffers(
            f"the modes of a period are {sides} when solved by events, {expected} by its equations"
        )
    x, v, _, other = solved.final_state
    scale = rounded(abs(x1) + abs(v1) + abs(v2), 3)
    with Ball(digits + 20).context():
        for name, came, went in (("x1", x, x1), ("v1", v, v1), ("v2", other, v2)):
            _require_near(f"{name} after a period", came, went, scale, digits)
    return solved


def _require_stuck(solved: Trajectory) -> None:
    if set(solved.modes) != {Mode.STICK}:
        raise SecondSolveDiffers("the pair does not stick all the way when the scene is solved by events")


def _require_near(what: str, found: arb, expected: arb, scale: Fraction, digits: int = 15) -> None:
    """Raise SecondSolveDiffers unless two enclosures are within 10^-digits of a scale."""
    off = abs(found - expected)
    if not off <= Ball.number(scale) * arb(10) ** (_SPARE - digits):
        raise SecondSolveDiffers(f"{what} is {found.str(12)} when solved by events, {expected.str(12)} by its formula")
