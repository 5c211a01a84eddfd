"""What a scene under a force is differentiated by: names, values, and its pieces over dual numbers."""

from __future__ import annotations

from bisect import bisect_right
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from numerics.arithmetic.dual import Dual
from numerics.arithmetic.dual_number import DualNumber
from numerics.flows.forced_records import Drive, Pair
from numerics.motion.forced_pair import pair_of
from numerics.motion.forced_pieces import ExactPiece, ExactPieces, drive_of
from numerics.scene import Pair as ScenePair
from numerics.scene import Scene, Sine
from numerics.scene.pieces import shifted
from numerics.sensitivity.duals import frozen, unit

START = ("x1", "v1", "x2", "v2", "local", "tau")
"""A segment's own numbers: the state at its start, the time in its piece there, and how long it lasts. In its gradients
they come first, and then the parameters that act in its piece."""
LOCAL, TAU, OWN = START.index("local"), START.index("tau"), len(START)


def parameters(scene: Scene) -> dict[str, Fraction]:
    """Return every number of a scene by its name, in the order of the last axis of all derivatives; exact.

    Pieces and what is in them are counted from 0, as in Python: `force[0].from`, `force[0].polynomial[1]`,
    `force[0].sines[0].amplitude` (`omega`, `phase`), `friction[0].from`, `friction[0].b`.
    """
    pair, at = scene.pair, scene.initial
    found = {name: getattr(at, name) for name in ("x1", "v1", "x2", "v2")}
    found |= {name: getattr(pair, name) for name in ("m1", "m2", "a2", "b", "a1")} | {"until": scene.until}
    for index in range(len(scene.force.pieces)):
        found |= _of_force(scene, index)
    for index, (start, b) in enumerate(scene.friction.pieces):
        found |= {f"friction[{index}].from": start, f"friction[{index}].b": b}
    return found


def _of_force(scene: Scene, index: int) -> dict[str, Fraction]:
    """Return the numbers of one piece of the force, by name."""
    piece, name = scene.force.pieces[index], f"force[{index}]"
    found = {f"{name}.from": piece.start}
    found |= {f"{name}.polynomial[{k}]": one for k, one in enumerate(piece.polynomial)}
    for k, sine in enumerate(piece.sines):
        found |= {f"{name}.sines[{k}].{key}": getattr(sine, key) for key in ("amplitude", "omega", "phase")}
    return found


class LocalPiece(NamedTuple):
    """One piece over dual numbers: pair, table, the names that follow `START` in its gradients."""

    pair: Pair
    drive: Drive
    names: list[str]


def local_piece(scene: Scene, piece: ExactPiece, arithmetic: Dual) -> LocalPiece:
    """Return a piece as the run knows it, each of its numbers with its unit vector; in the arithmetic's context."""
    of_force = bisect_right(scene.force.starts, piece.start) - 1
    of_friction = bisect_right(scene.friction.starts, piece.start) - 1
    pair, b_name = scene.pair, f"friction[{of_friction}].b" if of_friction >= 0 else "b"
    own = {"m1": pair.m1, "m2": pair.m2, "a2": pair.a2, "a1": pair.a1, b_name: piece.b}
    own |= _of_force(scene, of_force) if of_force >= 0 else {}
    dual: dict[str, Any] = {
        name: DualNumber(value, unit(OWN + k, OWN + len(own))) for k, (name, value) in enumerate(own.items())
    }
    polynomial: Any = ()
    sines: list[Any] = []
    if of_force >= 0:
        name, given = f"force[{of_force}]", scene.force.pieces[of_force]
        own_terms: Any = tuple(dual[f"{name}.polynomial[{k}]"] for k in range(len(given.polynomial)))
        polynomial = shifted(own_terms, piece.start - dual[f"{name}.from"]) if own_terms else ()
        keys = ("amplitude", "omega", "phase")
        sines = [
            frozen(Sine, **{key: dual[f"{name}.sines[{k}].{key}"] for key in keys}) for k in range(len(given.sines))
        ]
    over_duals = frozen(ScenePair, b=dual[b_name], **{name: dual[name] for name in ("m1", "m2", "a2", "a1")})
    whole = Scene.of(over_duals, scene.initial, scene.until, scene.law)
    here = ExactPiece(piece.start, piece.length, dual[b_name], polynomial, tuple(sines), is_jump=piece.is_jump)
    return LocalPiece(
        _without_series(pair_of(whole, arithmetic)),
        drive_of(whole, ExactPieces([here], with_seams=False), arithmetic),
        list(own),
    )


def _without_series(pair: Pair) -> Pair:
    """Return the pair with closed forms for short times, too, in balls: what a series leaves out has derivatives."""
    if not isinstance(pair.mass.value, arb):
        return pair
    return pair._replace(slip=pair.slip._replace(short=-1.0), stick=pair.stick._replace(short=-1.0))
