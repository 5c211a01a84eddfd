"""How the texts of both kinds of motion are told in every arithmetic."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from types import ModuleType
from typing import Any

from flint import fmpq

from numerics.arithmetic.float64 import FLOAT64
from numerics.arithmetic.protocol import Arithmetic
from numerics.arithmetic.telling import Telling
from numerics.contact.enclosed import enclosed_contact
from numerics.contact.enclosed_root import EnclosedRoot
from numerics.contact.free import double_guess, guessed_contact
from numerics.contact.root import root
from numerics.contact.surface import bracketed_contact, contact, refined_contact
from numerics.flows.slip import slid_at
from numerics.motion import damped, undamped
from numerics.motion.enclosed import enclosed_ray_landing, enclosed_slid
from numerics.motion.start import damped_start, narrow, sure, undamped_start, wide_sign

_MOTION = ("locate", "arrive", "follow", "mode_of", "velocity", "flow")
_OWN: dict[str, dict[Any, Any]] = {
    "double-double": {contact: refined_contact, guessed_contact: double_guess},
    "mpmath": {contact: bracketed_contact},
    "ball": {
        contact: enclosed_contact,
        root: EnclosedRoot,
        undamped.ray_landing: enclosed_ray_landing,
        slid_at: enclosed_slid,
    },
}
"""What an arithmetic does in its own way."""


def namesakes(texts: ModuleType, others: ModuleType, names: tuple[str, ...]) -> dict[Any, Any]:
    """Return which texts of a module those of the same name in another one replace."""
    return {getattr(texts, name): getattr(others, name) for name in names}


@cache
def motion_telling(base: Telling, *, is_damped: bool) -> Telling:
    """Return the telling of undamped or damped motions in one arithmetic, whose own telling is `base`."""
    instead = dict(_OWN.get(base.name, {}))
    if is_damped:
        instead |= namesakes(undamped, damped, _MOTION) | {undamped_start: damped_start}
    return base.but("damped" if is_damped else "undamped", instead) if instead else base


def start_telling(arithmetic: Arithmetic) -> Telling:
    """Return the telling of the start from exact rationals: every sign is known, each number is narrowed once."""
    return _start_telling(arithmetic.telling, arithmetic.number)


@cache
def _start_telling(base: Telling, number: Any) -> Telling:
    def narrowed(x: Any) -> Any:
        return number(Fraction(int(x.p), int(x.q)) if isinstance(x, fmpq) else x)

    return base.but("exact", {narrow: narrowed, wide_sign: _exact_sign, sure: _always})


@cache
def exact_signs() -> Telling:
    """Return a telling for what the start decides, without narrowing anything."""
    return FLOAT64.but("exact", {wide_sign: _exact_sign, sure: _always})


def _exact_sign(x: Any) -> int:
    return int(x > 0) - int(x < 0)


def _always(difference: Any, size: Any) -> bool:  # noqa: ARG001
    return True
