"""Exceptions: one type for each way in which a question can fail."""

from __future__ import annotations


class NumericsError(Exception):
    """Base of every error that this package raises on purpose."""


class InvalidScene(NumericsError, ValueError):
    """An invalid scene: the message names the quantity, its value, the bound and the remedy."""


class EventUndecided(NumericsError):
    """An order or a sign that the working precision does not decide.

    Attributes: `question` is what had to be decided, `enclosure` the number whose sign is not known (as text),
    `digits` the working precision in decimal digits.
    """

    def __init__(self, question: str, enclosure: str, digits: int) -> None:
        """Keep the question, the enclosure that does not decide it, and the precision used."""
        self.question, self.enclosure, self.digits = question, enclosure, digits
        super().__init__(
            f"undecided at {digits} working digits: {question} (enclosure {enclosure}); "
            "request more digits or raise max_digits (leave arithmetic='float64' out); where that does not help, "
            "the data lie exactly on the boundary: change one of them slightly"
        )


class PrecisionExhausted(NumericsError):
    """The requested digits were not reached within the limit on the working precision."""


class NotSettled(NumericsError):
    """No long-time motion was found, or proved, within a limit on the work; the message says what may help."""


class OutOfRange(NumericsError, OverflowError):
    """A number of this scene is outside the range of the arithmetic; another arithmetic may hold it.

    Attributes: `beyond` is the name of the arithmetic and its range, if a number is outside it.
    """

    beyond: tuple[str, float, float] | None = None

    @classmethod
    def of(cls, what: str, arithmetic: str, least: float = 5e-324, most: float = 1.79e308) -> OutOfRange:
        """Return the error for a number; `what` is its name and value."""
        found = cls(
            f"{what} is beyond what {arithmetic} takes here ({least:.2g} to {most:.2g}); choose units that bring it "
            'into that range, or use arithmetic="ball"'
        )
        found.beyond = arithmetic, least, most
        return found


class NoForceHere(NumericsError, ValueError):
    """The scene has a force, and the question is answered only without one."""


class NotDifferentiable(NumericsError, ValueError):
    """The motion of the scene has no derivative by its data: the one-sided derivatives differ."""


class NoProof(NumericsError):
    """A trajectory that cannot be written as a theorem: the message says what the checker does not cover."""


class InvalidFile(NumericsError, ValueError):
    """A file that is not a saved trajectory: the message says why."""


class MissingTool(NumericsError):
    """An optional package that is required and missing."""
