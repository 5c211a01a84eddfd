"""The motion that a scene starts with, in any arithmetic; which one is decided on exact rationals."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from flint import fmpq

from numerics.arithmetic.double_double import Double
from numerics.arithmetic.protocol import Arithmetic, Number
from numerics.errors import NoForceHere
from numerics.motion.modes import MODES, Mode
from numerics.motion.start import SI, Reduced, damped_start, first_mode, undamped_start
from numerics.motion.tellings import exact_signs, start_telling
from numerics.scene import Law, Scene


class Begun(NamedTuple):
    """The pair, the first motion, and the reduced numbers of a scene."""

    pair: Any
    start: Any
    reduced: Reduced

    @property
    def arguments(self) -> tuple[Any, Any, Number, Number, Number]:
        """Return pair, start, V1, V2 and horizon: what a run starts from."""
        return self.pair, self.start, self.reduced.V1, self.reduced.V2, self.reduced.horizon


def si_numbers(scene: Scene) -> SI:
    """Return the SI numbers of a scene without a force, exact; whatever is solved for such scenes only asks here.

    Raises NoForceHere.
    """
    if scene.is_forced:
        raise NoForceHere("this scene has a force or a friction that changes in time; here both must be left out")
    pair, at = scene.pair, scene.initial
    return SI(pair.m1, pair.m2, pair.a2, pair.b, at.x1, at.v1, at.x2, at.v2, scene.until, pair.a1)


def begin(scene: Scene, arithmetic: Arithmetic) -> Begun:
    """Return how a scene begins, in numbers of an arithmetic; call it in its context. Raises OutOfRange."""
    told = start_telling(arithmetic)(damped_start if scene.pair.a1 > 0 else undamped_start)
    wide = SI(*(_quick(number) for number in si_numbers(scene)))
    pair, start, reduced, _ = told(wide, scene.law is Law.THREE_VALUED_SGN)
    return Begun(pair, start, reduced)


def _quick(number: Any) -> Any:
    """Return a fraction as one of flint, which calculates several times as fast; dual numbers stay what they are."""
    return fmpq(number.numerator, number.denominator) if isinstance(number, Fraction) else number


def in_halves(record: Any, halves: Any) -> Any:
    """Return a record with every number as a double-double one: `halves` turns one into the other."""
    if isinstance(record, tuple) and not isinstance(record, Double):
        return type(record)(*(in_halves(one, halves) for one in record))
    return record if isinstance(record, (bool, int, float)) else halves(record)


def mode_at_start(scene: Scene) -> Mode:
    """Return the mode that follows the initial state of a scene; exact, every tie decided by the rules of modes.py."""
    sign, _, _ = exact_signs()(first_mode)(si_numbers(scene), scene.law is Law.THREE_VALUED_SGN)
    return MODES[sign]
