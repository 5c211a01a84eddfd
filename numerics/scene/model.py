"""What is to be solved: a pair of bodies, its initial state, the reading of the friction law, and a horizon.

All quantities are SI and exact rationals (see decimals.py). A scene is frozen: it is the key to its trajectory.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction
from typing import Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, keep, positive, put, short, shown
from numerics.scene.pieces import Force, Friction
from numerics.scene.short_repr import ShortRepr


class Law(Enum):
    """The reading of sgn(0) on the switching surface v1 = v2.

    >>> Law.FILIPPOV.value, Law.THREE_VALUED_SGN.value
    ('filippov', 'three-valued-sgn')
    """

    FILIPPOV = "filippov"
    """Set-valued: the pair sticks where friction can hold it, |a2 x1 + a1 v1| <= b (m1+m2)/m2 (Section III)."""
    THREE_VALUED_SGN = "three-valued-sgn"
    """sgn(0) = 0 as in eqs (11)-(12): whenever v1 = v2 the pair sticks, whatever force that takes (Section IV)."""


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Pair(ShortRepr):
    """The two bodies, their spring, damper and friction.

    m1, m2 (kg) > 0; a1 (N s/m) >= 0 viscous damper and a2 (N/m) > 0 spring, both from body 1 to the ground;
    b (N) > 0 the Coulomb force of the interface. Exact. Raises InvalidScene.

    >>> pair = Pair(m1=1, m2=1, a2=200, b="0.05")
    >>> pair, pair.a1, pair.mass, pair.share
    (Pair(m1=1, m2=1, a2=200, b=0.05), Fraction(0, 1), Fraction(2, 1), Fraction(1, 2))
    >>> pair.half_width, pair.critical_energy  # m, J
    (Fraction(1, 2000), Fraction(1, 40000))
    >>> pair.energy((Fraction(1, 10), 1, 0, 2)), pair.energy((0.1, 1.0, 0.0, 2.0), float)
    (Fraction(7, 2), 3.5)
    """

    m1: Fraction
    m2: Fraction
    a2: Fraction
    b: Fraction
    a1: Fraction

    def __init__(self, m1: Exact, m2: Exact, a2: Exact, b: Exact, a1: Exact = 0) -> None:
        """Read every parameter as an exact decimal and check its bound."""
        keep(self, a1=a1)
        for name, value in (("m1", m1), ("m2", m2), ("a2", a2), ("b", b)):
            put(self, **{name: positive(value, name)})
        if self.a1 < 0:
            raise InvalidScene(f"a1 = {short(self.a1)} must be >= 0; leave it out for an undamped pair")

    @property
    def mass(self) -> Fraction:
        """Total mass M = m1 + m2, kg, exact."""
        return self.m1 + self.m2

    @property
    def share(self) -> Fraction:
        """Share q = m1/(m1 + m2) of the driving body in the total mass, dimensionless, exact."""
        return self.m1 / self.mass

    @property
    def half_width(self) -> Fraction:
        """Half width L = b M/(a2 m2) of the sliding region, m, exact (Section III, S0)."""
        return self.b * self.mass / (self.a2 * self.m2)

    @property
    def critical_energy(self) -> Fraction:
        """E_cr = b^2 M^2/(2 a2 m2^2), J, exact (Section III)."""
        return self.a2 * self.half_width**2 / 2

    def energy(self, y: Any, number: Callable[[Fraction], Any] = Fraction) -> Any:
        """E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2 of states (4, ...), J; `number` reads the exact parameters."""
        x1, v1, _, v2 = y
        return (x1 * x1 * number(self.a2) + v1 * v1 * number(self.m1) + v2 * v2 * number(self.m2)) / 2


@dataclass(frozen=True, slots=True, init=False, repr=False)
class State(ShortRepr):
    """Positions x1, x2 (m) and velocities v1, v2 (m/s) of the two bodies, exact. Raises InvalidScene.

    >>> State(x1="1/200", v1=0.15), State(v2=1).x2
    (State(x1=0.005, v1=0.15), Fraction(0, 1))
    """

    x1: Fraction
    v1: Fraction
    x2: Fraction
    v2: Fraction

    def __init__(self, x1: Exact = 0, v1: Exact = 0, x2: Exact = 0, v2: Exact = 0) -> None:
        """Read every coordinate as an exact decimal."""
        keep(self, x1=x1, v1=v1, x2=x2, v2=v2)


def require_kind(asking: str, value: object, kind: type, remedy: str) -> None:
    """Raise TypeError, naming what was asked, unless a value is of a kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{asking} takes a {kind.__name__}, not {type(value).__name__}; {remedy}")


HORIZON = "give the horizon in seconds"
BUILD = "build Scene(Pair(...), State(...), until=...), or take load_scene(...)"
NO_FORCE, SAME_FRICTION = Force(), Friction()


@dataclass(frozen=True, slots=True, init=False, repr=False)
class Scene(ShortRepr):
    """A pair, its state at t = 0, the horizon `until` (s) > 0, the reading of sgn(0), force and friction.

    `force` is u(t) on body 1 (default 0). `friction` gives b from later times on, and its dependence on the state
    (default: the pair's b). Raises InvalidScene.

    >>> scene = Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(x1="0.005"), until=5)
    >>> scene.pair.half_width, scene.energy_excess, scene.energy
    (Fraction(1, 200), Fraction(0, 1), Fraction(1, 400))
    >>> scene.initial, scene.until, scene.law.value, scene.force, scene.friction, scene.is_forced
    (State(x1=0.005), Fraction(5, 1), 'filippov', Force(), Friction(), False)
    >>> scene.changes_later, Scene(scene.pair, scene.initial, 5, force=Force.sine(1, 2, start=8)).changes_later
    (False, True)
    """

    pair: Pair
    initial: State
    until: Fraction
    law: Law
    force: Force
    friction: Friction
    made: dict[object, Any] = field(init=False, repr=False, compare=False)
    """What the engines read instead of exact numbers, made when it is first needed, and not pickled."""

    def __init__(
        self,
        pair: Pair,
        initial: State,
        until: Exact,
        law: Law | str = Law.FILIPPOV,
        force: Force = NO_FORCE,
        friction: Friction = SAME_FRICTION,
    ) -> None:
        """Check the parts and read the horizon and the law."""
        parts = ((pair, Pair, "Pair(m1=..., m2=..., a2=..., b=...)"), (initial, State, "State(x1=..., v1=...)"))
        laws = ((force, Force, "Force.sine(amplitude, omega)"), (friction, Friction, "Friction([(start, b)])"))
        for part, kind, remedy in (*parts, *laws):
            if not isinstance(part, kind):
                given = f"{str(part)[:40]!r}, {type(part).__name__}"
                raise InvalidScene(f"a scene needs a {kind.__name__}, not {given}; build one, such as {remedy}")
        put(self, pair=pair, initial=initial, law=read_law(law), force=force, friction=friction, made={})
        put(self, until=positive(until, "until", HORIZON))

    def __reduce__(self) -> tuple[Any, ...]:
        """Return what pickles and copies are made of."""
        return Scene, (self.pair, self.initial, self.until, self.law, self.force, self.friction)

    @property
    def is_forced(self) -> bool:
        """Whether the scene has a force that is not 0, or friction other than one number b."""
        pushes = any(piece.polynomial or piece.sines for piece in self.force.pieces)
        return bool(pushes or self.friction.pieces or self.friction.weakening)

    @property
    def changes_later(self) -> bool:
        """Whether another piece of force or friction begins at the horizon or after it."""
        return any(at >= self.until for at in (*self.force.starts, *self.friction.starts))

    def require_one_b(self, what: str) -> None:
        """Raise InvalidScene, where only Coulomb friction is supported, if friction depends on the state."""
        if self.friction.weakening:
            raise InvalidScene(f"{what} is not available for friction that depends on the state; leave [weakening] out")

    def require_filippov(self, what: str) -> None:
        """Raise InvalidScene for sgn(0) = 0 read literally: such a stick never ends, whatever friction it requires."""
        if self.law is not Law.FILIPPOV:
            raise InvalidScene(f'law = "{self.law.value}" has no such theory; leave the law out for {what}')

    @property
    def energy(self) -> Fraction:
        """E at t = 0, J, exact."""
        at = self.initial
        return Fraction(self.pair.energy((at.x1, at.v1, at.x2, at.v2)))

    @property
    def energy_excess(self) -> Fraction:
        """w = E/E_cr - 1 at t = 0, dimensionless, exact: permanent stick needs w <= 0 (free pair)."""
        return self.energy / self.pair.critical_energy - 1


WRT = ("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1")
"""The initial state and the parameters of a free pair, in the order of the last axis of every array of derivatives."""


def parameters(scene: Scene) -> dict[str, Fraction]:
    """Return every number of a scene by its name, in the order of the last axis of all derivatives; exact.

    Without a force those of `WRT`, else `until` too. Pieces and what is in them are counted from 0, as in Python:
    `force[0].from`, `force[0].polynomial[1]`, `force[0].sines[0].amplitude` (`omega`, `phase`), `friction[0].from`,
    `friction[0].b`; `weakening.speed[0].w` (`b`), `weakening.place[0].z` (`c`), `weakening.last_slope`.
    """
    found = {name: getattr(scene.initial if name in WRT[:4] else scene.pair, name) for name in WRT}
    if not (scene.force.pieces or scene.is_forced):
        return found
    found["until"] = scene.until
    for index, piece in enumerate(scene.force.pieces):
        name = f"force[{index}]"
        found[f"{name}.from"] = piece.start
        found |= {f"{name}.polynomial[{k}]": one for k, one in enumerate(piece.polynomial)}
        for k, sine in enumerate(piece.sines):
            found |= {f"{name}.sines[{k}].{key}": getattr(sine, key) for key in ("amplitude", "omega", "phase")}
    for index, (start, b) in enumerate(scene.friction.pieces):
        found |= {f"friction[{index}].from": start, f"friction[{index}].b": b}
    if scene.friction.weakening is not None:
        given = scene.friction.weakening
        for name, keys, points in (("speed", "wb", given.speed), ("place", "zc", given.place)):
            for index, point in enumerate(points):
                found |= {f"weakening.{name}[{index}].{key}": one for key, one in zip(keys, point, strict=True)}
        found["weakening.last_slope"] = given.last_slope
    return found


def read_law(law: object) -> Law:
    """Return the Law that `law` names; raises InvalidScene with the names that exist."""
    try:
        return Law(law)
    except ValueError:
        names = ", ".join(f'"{one.value}"' for one in Law)
        raise InvalidScene(f"law = {shown(law)} is not one of {names}; leave it out for the first") from None
