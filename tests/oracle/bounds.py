"""What the solver in floats does not know, frozen: bounds, and how large errors of a start lead into doubt.

From tests, `python -m oracle.bounds` freezes those of today.
"""

import json
import lzma
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import islice
from typing import Any

import numpy as np
from kernel_runs import BOUNDS, a_scene, errors, run
from sixty_digits import EXTREMES, extreme_scene

from numerics import (
    Force,
    Friction,
    Law,
    NumericsError,
    Piece,
    Scene,
    Sine,
    solve,
    solve_many,
)
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.linear.errors_of import errors_of
from numerics.linear.pieces import starts_of
from numerics.linear.record import AT
from oracle.reading import HERE

FROZEN = HERE / "bounds.json.xz"
Numbers = list[float]
Frozen = dict[str, dict[str, Numbers]]
ENDS = [*BOUNDS, AT["speed_error"], AT["ledger_error"]]
PROVE = "if a bound became smaller, or a doubt (number 0) begins later, prove it; if larger, it is a loss; then"
CHANGED = f"{PROVE} freeze anew with `python -m oracle.bounds`, from tests"
NEAR, HALVINGS, EVENTS = 1.003, 14, 8
WITHIN = {"floats": 1.001, "rounded floats": 1.1}
"""By which factor a number of each kind may change."""


def of_floats(scene: Scene, found: Any) -> Numbers:
    """Bounds of rows, of the end, and what is read off these."""
    pair = scene.pair
    weights = float(pair.a2), float(pair.m1), float(pair.m2)
    read = compiled(errors_of)(found.rows, found.end, starts_of(scene)[0], weights, 1.0, 2.0**-53)
    return [*found.rows[:EVENTS, BOUNDS].ravel(), *found.end[ENDS], *read[:2], max(read[2])]


def runs() -> Iterator[tuple[str, Scene, Any]]:
    """Seeded scenes, each with a direction of errors at the start."""
    for k in range(300 if can_compile() else 12):
        scene = a_scene(random := np.random.default_rng(k))
        scene = scene.replace(until=scene.until * (40 if k % 8 == 7 and k > 12 else 1))  # a stick may be stepped over
        by = np.array(errors(random, scene), dtype=float)
        yield f"{k} kernel", scene, by / max(abs(by).max(), 1e-9)


def batches() -> Iterator[tuple[str, Any]]:
    """Many scenes at once, of every engine and force."""
    v, paper = np.linspace(-0.3, 0.3, 40), {"m1": 1, "m2": 1, "a2": 200, "b": 0.05, "until": 3, "keep_events": 6}
    jumps = Friction([("0.3", "0.04"), ("0.9", "0.07"), (3, "0.02")])
    given = {
        "literal": {"v1": v, "law": Law.THREE_VALUED_SGN},
        "masses": {"v1": v, "v2": -v / 3, "m1": 1 + v, "m2": 2 - v, "b": 0.01 + v * v, "until": 1 + v},
        "sines": {"x1": v / 30, "sines": [(abs(v), 12 + v, v), (0.1, 7, 1)], "a1": 0.3},
        "polynomial and jumps": {"v1": v, "polynomial": [v, 2 * v], "friction": jumps},
        "pieces": {"v1": v, "force": [Force([Piece("0.2", [k], [Sine(k, 9)]), Piece("0.8")]) for k in range(len(v))]},
    }
    for name, numbers in given.items():
        yield name, solve_many(**paper | numbers)


def asked(frozen: Frozen, part: int = 0, of: int = 1) -> Iterator[tuple[str, str, Numbers]]:
    """Kind, name and numbers of every answer; the sizes that lead into doubt are sought next to the frozen ones."""
    for name, scene, by in islice(runs(), part, None, of):

        def follow(size: float, scene: Scene = scene, by: Any = by) -> Any:
            return run(scene, size * by)

        size = least_in_doubt(lambda size: follow(size).modes is not None, frozen.get("floats", {}).get(name, []))
        exact, some = ([] if found.modes is None else of_floats(scene, found) for found in map(follow, (0.0, size / 6)))
        yield "floats", name, [size, *some]
        yield "rounded floats", name, exact
    if part:
        return
    for name in EXTREMES:
        with suppress(NumericsError):
            found = solve(extreme_scene(name), arithmetic="float64", max_events=EVENTS).accuracy
            yield "rounded floats", f"{name} float64", parts(found, "t y final energy energy_excess dissipated digits")
    for name, found in batches():
        errors_of_it = "y_error event_t_error event_y_error energy_excess_error dissipated_error digits"
        yield "rounded floats", name, parts(found, errors_of_it)


def parts(found: Any, names: str) -> Numbers:
    return [float(one) for name in names.split() for one in np.ravel(getattr(found, name))]


def least_in_doubt(is_certain: Callable[[float], bool], known: Numbers) -> float:
    """The size of errors from which on a run is in doubt; that which is known, or by bisection of its exponent."""
    if known and is_certain(known[0] / NEAR) and not is_certain(known[0] * NEAR):
        return known[0]
    low, high = -20.0, 1.0
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if is_certain(10**middle) else (low, middle)
    return float(10**high)


def changes(part: int, of: int) -> Iterator[str]:
    """A sentence on every answer that is not the frozen one, of every so many-th run."""
    known: Frozen = json.loads(lzma.decompress(FROZEN.read_bytes()))
    for kind, name, numbers in asked(known, part, of):
        for sentence in changed(kind, np.array(known[kind][name]), np.array(numbers)):
            yield f"{kind}, {name}: {sentence}"


def changed(kind: str, known: Any, found: Any) -> Iterator[str]:
    if len(known) != len(found):
        yield f"{len(found)} numbers, not {len(known)}"
        return
    slack = 1e-13 * (kind == "floats")  # what rounding leaves
    off = np.where(np.isfinite(known), (WITHIN[kind] - 1) * abs(known) + slack, 0.0)
    same = (found >= known - off) & (found <= known + off) | np.isnan(found) & np.isnan(known)
    for k in np.flatnonzero(~same)[:1]:
        yield f"number {k}: {found[k]:.6g}, not {known[k]:.6g}: {CHANGED}"


def freeze() -> None:
    found: Frozen = {kind: {} for kind in WITHIN}
    for kind, name, numbers in asked({}):
        found[kind][name] = [float(f"{one:.5g}") for one in numbers]
    FROZEN.write_bytes(lzma.compress(json.dumps(found, separators=(",", ":")).encode(), preset=9))


if __name__ == "__main__":
    freeze()
