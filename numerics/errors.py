"""Everything that can go wrong, as types: a caller can tell a bad scene from an undecided event."""

from __future__ import annotations


class NumericsError(Exception):
    """Base of every error that this package raises on purpose."""


class InvalidScene(NumericsError, ValueError):
    """A scene that describes no pair: the message names the quantity, its value, the bound and the remedy."""


class EventUndecided(NumericsError):
    """An order or a sign that the working precision does not settle.

    Attributes: `question` is what had to be decided, `enclosure` the number whose sign is not known (as text),
    `digits` the working precision in decimal digits.
    """

    def __init__(self, question: str, enclosure: str, digits: int) -> None:
        """Keep the question, the enclosure that does not answer it, and the precision it was asked at."""
        self.question, self.enclosure, self.digits = question, enclosure, digits
        super().__init__(
            f"undecided at {digits} working digits: {question} (enclosure {enclosure}); "
            "leave arithmetic out, ask for more digits or raise max_digits, unless the data sit exactly on the boundary"
        )


class PrecisionExhausted(NumericsError):
    """The digits asked for were not reached below the cap on the working precision."""


class NotSettled(NumericsError):
    """No motion that lasts for ever was found, or proved, within a cap on work; the message says what may help."""


class OutOfRange(NumericsError, OverflowError):
    """A number of this scene does not fit the arithmetic; another arithmetic may hold it.

    Attributes: `beyond` is the name of the arithmetic and its range, where a number is beyond that.
    """

    beyond: tuple[str, float, float] | None = None

    @classmethod
    def of(cls, what: str, arithmetic: str, least: float = 5e-324, most: float = 1.79e308) -> OutOfRange:
        """Return the error for a number, which `what` names with its value."""
        found = cls(
            f"{what} is beyond the range of {arithmetic} ({least:.2g} to {most:.2g}); choose units that bring it into "
            'range, or use arithmetic="ball"'
        )
        found.beyond = arithmetic, least, most
        return found


class NoForceHere(NumericsError, ValueError):
    """A question that is answered for a pair without a force only, asked of a scene with one."""


class NotDifferentiable(NumericsError, ValueError):
    """A scene whose motion has no derivative by its data: it differs to first order on either side of what it meets."""


class NoProof(NumericsError):
    """A trajectory that is not written as a theorem: the message says what the checker does not cover."""


class InvalidFile(NumericsError, ValueError):
    """A file that holds no saved trajectory: the message says why."""


class MissingTool(NumericsError):
    """An optional package that was asked for and is not there."""
