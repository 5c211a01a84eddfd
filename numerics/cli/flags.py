"""Whole numbers in flags."""

from __future__ import annotations

import argparse


def natural(text: str) -> int:
    """Return a whole number >= 0 of a flag."""
    return _whole(text, 0)


def positive(text: str) -> int:
    """Return a whole number > 0 of a flag."""
    return _whole(text, 1)


def _whole(text: str, least: int) -> int:
    if not (text.isascii() and text.isdigit() and len(text) < 10 and int(text) >= least):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} must be a whole number from {least} to 999999999")
    return int(text)
