"""Flags: whole numbers in them are read here; errors are told in Python's words, where the command line has flags."""

from __future__ import annotations

import argparse
import re

_NAMES = "arithmetic|digits|max_digits|max_events|max_steps"
_CALL = re.compile(r"solve\(scene, ([^()]*)\)")
_ARGUMENT = re.compile(rf"\b({_NAMES})=(\.\.\.|\"([^\"]*)\"|[\w-]+)")
_CAP = re.compile(r"\bmax_(digits|events|steps)\b")


def in_flags(message: str) -> str:
    """Return a message with its arguments as flags: `max_digits` is --max-digits, `digits=...` is --digits N."""
    message = _CALL.sub(r"\1", message)
    message = _ARGUMENT.sub(_flag, message)
    message = message.replace("give amplitude and omega", "give --amplitude and --omega")
    return _CAP.sub(r"--max-\1", message)


def _flag(found: re.Match[str]) -> str:
    name, value = found[1].replace("_", "-"), found[3] if found[3] is not None else found[2]
    return f"--{name} {'N' if value == '...' else value}"


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
