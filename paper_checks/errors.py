"""What a check can fail of, apart from its mathematics."""

from __future__ import annotations


class ToolMissingError(RuntimeError):
    """A needed tool is not installed; the row stays unchecked."""


class NotPolynomialError(ValueError):
    """A statement that cannot be translated, exactly, into polynomial real arithmetic."""


class LedgerError(ValueError):
    """A claim's id is unknown or taken twice."""
