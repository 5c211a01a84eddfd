"""What the solver says that it does not know, frozen: bounds, radii, and how large errors of a start lead into doubt.

From tests, `python -m oracle.bounds` freezes those of today.
"""

import json
import lzma
from collections.abc import Callable, Iterator
from contextlib import suppress
from fractions import Fraction
from functools import partial
from itertools import islice
from typing import Any, NamedTuple

import numpy as np
from kernel_runs import BOUNDS, a_scene, errors
from kernel_runs import run as run_kernel
from scene_files import scenes_in
from sixty_digits import EXTREMES, FORCED, extreme_scene, forced_scene

from numerics import (
    Force,
    Friction,
    Law,
    NumericsError,
    Piece,
    Scene,
    Sine,
    Trajectory,
    load_scene,
    sensitivities,
    solve,
    solve_many,
)
from numerics.arithmetic.ball import Ball, widened
from numerics.arithmetic.compiled import can_compile, compiled
from numerics.free.motion import run_free
from numerics.linear.enclosed import run_enclosed
from numerics.linear.errors_of import errors_of
from numerics.linear.pieces import starts_of
from numerics.linear.record import AT
from numerics.scene.file import described_scenes, shipped_scenes
from numerics.trajectory.run import free_scene
from oracle.reading import HERE

FROZEN = HERE / "bounds.json.xz"
Numbers = list[float]
Frozen = dict[str, dict[str, Numbers]]
ENDS = [*BOUNDS, AT["speed_error"], AT["ledger_error"]]
FOLDERS = [
    "differentiated",
    "followed",
    "followed-in-balls",
    "no-ties",
    "one-answer",
    "passed-over",
    "proved",
    "weakened",
]
PROVE = "if a bound became smaller, or a doubt (number 0) begins later, prove it; if larger, it is a loss; then"
CHANGED = f"{PROVE} freeze anew with `python -m oracle.bounds`, from tests"
NEAR, HALVINGS, EVENTS = 1.003, 14, 8
BALLS = Ball(40)
WITHIN = {"floats": 1.001, "rounded floats": 1.1, "balls": 1.001, "rounded balls": 1.5}
"""By which factor a number of each kind may change."""


class Run(NamedTuple):
    """How a scene is followed with errors of a size at the start (None: in doubt), and the bounds of that."""

    kind: str
    name: str
    follow: Callable[[float], Any]
    numbers: Callable[[Any], Numbers]


def runs() -> Iterator[Run]:
    for k in range(300 if can_compile() else 12):
        scene = a_scene(random := np.random.default_rng(k))
        scene = scene.replace(until=scene.until * (40 if k % 8 == 7 and k > 12 else 1))  # a stick may be stepped over
        by = np.array(errors(random, scene), dtype=float)
        by /= max(abs(by).max(), 1e-9)
        yield Run("floats", f"{k} kernel", partial(in_floats, scene, by), partial(of_floats, scene))
    for name, scene in scenes().items():
        for engine in [run_enclosed, *[run_free] * free_scene(scene)]:
            yield Run("balls", f"{name} {engine.__name__}", partial(in_balls, scene, engine), of_balls)


PROBLEMS = {name for name, what in described_scenes().items() if what.startswith("Your problem")}
"""Shipped after the freeze; tests/test_problems.py has their right values."""
STUCK = scenes_in("settling")["nothing-swings-freely"]


def scenes() -> dict[str, Scene]:
    found = {name: forced_scene(name) for name in FORCED}
    found |= {f"{folder}/{name}": scene for folder in FOLDERS for name, scene in scenes_in(folder).items()}
    found |= {name: load_scene(name) for name in shipped_scenes() if name not in PROBLEMS} | {"stuck": STUCK}
    return {name: scene for name, scene in found.items() if isinstance(scene, Scene)}


def in_floats(scene: Scene, by: Any, size: float) -> Any:
    found = run_kernel(scene, size * by)
    return None if found.modes is None else found


def of_floats(scene: Scene, found: Any) -> Numbers:
    """Bounds of rows, of the end, and what is read off these."""
    pair = scene.pair
    weights = float(pair.a2), float(pair.m1), float(pair.m2)
    read = compiled(errors_of)(found.rows, found.end, starts_of(scene)[0], weights, 1.0, 2.0**-53)
    return [*found.rows[:EVENTS, BOUNDS].ravel(), *found.end[ENDS], *read[:2], max(read[2])]


class Widened(Ball):
    """Balls in which every exact number is known within the radius."""

    def number(self, value: Any) -> Any:  # type: ignore[override]
        return widened(Ball.number(value), self.radius)


def in_balls(scene: Scene, engine: Any, size: float) -> Any:
    # what is larger the free engine refuses here and there
    of, size = (Ball, size) if engine is run_enclosed else (Widened, min(size, 1e-8))
    try:
        return Trajectory(scene, BALLS, engine(scene, of(BALLS.digits, Ball.number(Fraction(size))), EVENTS))
    except (NumericsError, ArithmeticError, ValueError):  # a large box holds what is no scene
        return None


def of_balls(found: Any) -> Numbers:
    """Of events, the end, the ledger, a state within, derivatives of all of them."""
    with found.arithmetic.context():
        ledger, at = found.ledger, 0.37 * float(found.end_time)
        parts = [found.event_times, found.event_states, found.final_state, found.sol(at)]
        parts.append([ledger.friction, ledger.viscous, ledger.work, ledger.residual])
        with suppress(NumericsError):
            _, *more = *vars(sensitivities(found)).values(), sensitivities(found, at)
            parts += more
        return [float(one.rad()) for part in parts for one in np.ravel(part)]


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
    for kind, name, follow, numbers in islice(runs(), part, None, of):
        size = least_in_doubt(lambda size, follow=follow: follow(size) is not None, frozen.get(kind, {}).get(name, []))
        exact, some = (
            [] if found is None else numbers(found)
            for found in (follow(0.0), follow(size / (6 if kind == "floats" else 20)))
        )
        yield kind, name, [size, *some]
        yield f"rounded {kind}", name, exact
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
