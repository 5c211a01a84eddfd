"""What is to be solved: a pair of bodies, its initial state, the reading of the friction law, and a horizon.

All quantities are SI and exact rationals (see decimals.py). A scene is frozen: it is the key to its trajectory.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import field, fields
from enum import Enum
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from numerics.errors import InvalidScene
from numerics.scene.decimals import Exact, exact_decimal, keep, nonnegative, positive, put, short, shown
from numerics.scene.friction import Friction, require_nonnegative
from numerics.scene.pieces import MAKERS, Piece, Signal
from numerics.scene.replaced import replaced
from numerics.scene.short_repr import ShortRepr, record

if TYPE_CHECKING:
    from numerics.scene.decimals import Quantity


class Law(Enum):
    """The reading of sgn(0) on the switching surface v1 = v2.

    >>> Law.FILIPPOV.value, Law.THREE_VALUED_SGN.value
    ('filippov', 'three-valued-sgn')
    """

    FILIPPOV = "filippov"
    """Set-valued: the pair sticks where friction can hold it, |a2 x1 + a1 v1| <= b (m1+m2)/m2 (Section III)."""
    THREE_VALUED_SGN = "three-valued-sgn"
    """sgn(0) = 0 as in eqs (11)-(12): whenever v1 = v2 the pair sticks, whatever force that takes (Section IV)."""


@record
class Pair(ShortRepr):
    """The two bodies, their spring, damper and friction.

    m1, m2 (kg) > 0; a1 (N s/m) >= 0 viscous damper and a2 (N/m) >= 0 spring, both from body 1 to the wall;
    b (N) >= 0 the Coulomb force of the interface. With m2 = "inf" (kept as math.inf) body 2 is the ground or a belt,
    whose velocity is given. `b_static` (N) >= b > 0: a stick ends only above it, and is kept up to it; a slip has b.
    Where b changes in time, b_static is scaled by b(t)/b. Exact. Raises InvalidScene.

    >>> pair = Pair(m1=1, m2=1, a2=200, b="0.05")
    >>> pair, pair.a1, pair.mass, pair.share, pair.share_2
    (Pair(m1=1, m2=1, a2=200, b=0.05), Fraction(0, 1), Fraction(2, 1), Fraction(1, 2), Fraction(1, 2))
    >>> pair.half_width, pair.critical_energy  # m, J
    (Fraction(1, 2000), Fraction(1, 40000))
    >>> pair.energy((Fraction(1, 10), 1, 0, 2)), pair.energy((0.1, 1.0, 0.0, 2.0), float)
    (Fraction(7, 2), 3.5)
    >>> block = Pair(m1=1, m2="inf", a2=200, b="0.5", b_static=1)
    >>> block, block.is_fixed, block.share_2, block.half_width, block.energy((0, 1, 0, 3))
    (Pair(m1=1, m2=inf, a2=200, b=0.5, b_static=1), True, Fraction(1, 1), Fraction(1, 400), Fraction(1, 2))
    >>> pair.extra, block.extra
    ('', 'm2 = "inf"')
    """

    m1: Fraction
    m2: Fraction
    a2: Fraction
    b: Fraction
    a1: Fraction
    b_static: Fraction | None

    def __init__(self, m1: Exact, m2: Exact, a2: Exact, b: Exact, a1: Exact = 0, b_static: Exact | None = None) -> None:
        """Read every parameter as an exact decimal and check its bound."""
        is_fixed = not isinstance(m2, int) and str(m2).strip().lower() in {"inf", "infinity"}
        put(self, m1=positive(m1, "m1"), m2=math.inf if is_fixed else positive(m2, "m2"))
        put(self, a1=nonnegative(a1, "a1", "leave it out for an undamped pair"), a2=nonnegative(a2, "a2"))
        most = None if b_static is None else exact_decimal(b_static, "b_static")
        put(self, b=nonnegative(b, "b"), b_static=most)
        if most is not None and not 0 < self.b <= most:
            raise InvalidScene(
                f"b_static = {short(most)} must be at least b = {short(self.b)} > 0; leave it out for one coefficient"
            )

    @property
    def is_fixed(self) -> bool:
        """Whether body 2 is the ground or a belt, m2 = inf."""
        return self.m2 == math.inf

    @property
    def extra(self) -> str:
        """What the pair has beyond a spring, two masses and one b > 0; "" for nothing."""
        is_static = self.b_static is not None
        return _first({"a2 = 0": not self.a2, "b = 0": not self.b, 'm2 = "inf"': self.is_fixed, "b_static": is_static})

    @property
    def mass(self) -> Fraction:
        """Total mass M = m1 + m2, kg, exact."""
        if self.is_fixed:
            raise InvalidScene("a pair with m2 = inf has no total mass; give m2 a number")
        return self.m1 + self.m2

    @property
    def share(self) -> Fraction:
        """Share q = m1/(m1 + m2) of the driving body in the total mass, dimensionless, exact; 0 for m2 = inf."""
        return Fraction(0) if self.is_fixed else self.m1 / self.mass

    @property
    def share_2(self) -> Fraction:
        """Share m2/(m1 + m2) of body 2, dimensionless, exact; 1 for m2 = inf."""
        return 1 - self.share

    @property
    def half_width(self) -> Fraction:
        """Half width L = b M/(a2 m2) of the sliding region, m, exact (Section III, S0)."""
        if not self.a2:
            raise InvalidScene("without a spring, a2 = 0, the sliding region has no half width; give a2 > 0")
        return self.b / (self.a2 * self.share_2)

    @property
    def critical_energy(self) -> Fraction:
        """E_cr = b^2 M^2/(2 a2 m2^2), J, exact (Section III)."""
        if not self.b:
            raise InvalidScene("without friction, b = 0, there is no critical energy; give b > 0")
        return self.a2 * self.half_width**2 / 2

    def energy(self, y: Iterable[Quantity], number: Callable[[Fraction], Quantity] = Fraction) -> Quantity:
        """E = (a2 x1^2 + m1 v1^2 + m2 v2^2)/2 of states (4, ...), J, without body 2 where m2 = inf.

        `number` reads the exact parameters.
        """
        x1, v1, _, v2 = y
        found = x1 * x1 * number(self.a2) + v1 * v1 * number(self.m1)
        return (found if self.is_fixed else found + v2 * v2 * number(self.m2)) / 2


@record
class State(ShortRepr):
    """Positions x1, x2 (m) and velocities v1, v2 (m/s) of the two bodies, exact. Raises InvalidScene.

    >>> State(x1="1/200", v1=0.15), State(v2=1).x2
    (State(x1=0.005, v1=0.15), Fraction(0, 1))
    >>> [*State(v1=2)]
    [Fraction(0, 1), Fraction(2, 1), Fraction(0, 1), Fraction(0, 1)]
    """

    x1: Fraction
    v1: Fraction
    x2: Fraction
    v2: Fraction

    def __init__(self, x1: Exact = 0, v1: Exact = 0, x2: Exact = 0, v2: Exact = 0) -> None:
        """Read every coordinate as an exact decimal."""
        keep(self, x1=x1, v1=v1, x2=x2, v2=v2)

    def __iter__(self) -> Iterator[Fraction]:
        """Yield x1, v1, x2, v2."""
        yield from (self.x1, self.v1, self.x2, self.v2)


def _first(found: dict[str, Any]) -> str:
    return next((name for name, is_so in found.items() if is_so), "")


def require_kind(asking: str, value: object, kind: type, remedy: str) -> None:
    """Raise TypeError, naming what was asked, unless a value is of a kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{asking} takes a {kind.__name__}, not {type(value).__name__}; {remedy}")


HORIZON = "give the horizon in seconds"
BUILD = "build Scene(Pair(...), State(...), until=...), or take load_scene(...)"
NO_FORCE, SAME_FRICTION = Signal(), Friction()


@record
class Scene(ShortRepr):
    """A pair, its state at t = 0, the horizon `until` (s) > 0, the reading of sgn(0), friction, and what acts on it.

    `force` is u(t) on body 1, `force_2` on body 2 (N), `belt` the velocity of body 2 where m2 = inf (m/s), `wall` the
    displacement of the far end of spring and damper (m); each is 0 if left out. `friction` gives b from later times on,
    and its dependence on the state (default: the pair's b). Raises InvalidScene.
    On a belt v2 is the belt's: leave it out.

    >>> scene = Scene(Pair(m1=1, m2=1, a2=200, b="0.5"), State(x1="0.005"), until=5)
    >>> scene.pair.half_width, scene.energy_excess, scene.energy
    (Fraction(1, 200), Fraction(0, 1), Fraction(1, 400))
    >>> scene.initial, scene.until, scene.law.value, scene.force, scene.friction, scene.is_forced
    (State(x1=0.005), Fraction(5, 1), 'filippov', Signal(), Friction(), False)
    >>> scene.changes_later, Scene(scene.pair, scene.initial, 5, force=Signal.sine(1, 2, start=8)).changes_later
    (False, True)
    >>> on_belt = Scene(Pair(m1=1, m2="inf", a2=200, b=1), State(), 5, belt=Signal.step(0, "0.1"))
    >>> on_belt.initial.v2, on_belt.is_forced, on_belt.extra
    (Fraction(1, 10), True, 'm2 = "inf"')
    >>> on_belt.belt.starts, on_belt.wall, on_belt.force_2
    ((Fraction(0, 1),), Signal(), Signal())
    """

    pair: Pair
    initial: State
    until: Fraction
    law: Law
    force: Signal
    friction: Friction
    force_2: Signal
    belt: Signal
    wall: Signal
    _hash: int = field(init=False, repr=False, compare=False)
    """The hash of all of it, formed once: what is derived from a scene is cached by the scene."""

    def __init__(
        self,
        pair: Pair,
        initial: State,
        until: Exact,
        law: Law | str = Law.FILIPPOV,
        force: Signal = NO_FORCE,
        friction: Friction = SAME_FRICTION,
        force_2: Signal = NO_FORCE,
        belt: Signal = NO_FORCE,
        wall: Signal = NO_FORCE,
    ) -> None:
        """Check the parts and read the horizon and the law."""
        parts = ((pair, Pair, "Pair(m1=..., m2=..., a2=..., b=...)"), (initial, State, "State(x1=..., v1=...)"))
        signals = ((one, Signal, f"Force() for none, else: {MAKERS}") for one in (force, force_2, belt, wall))
        for part, kind, remedy in (*parts, *signals, (friction, Friction, "Friction([(start, b)])")):
            if not isinstance(part, kind):
                given = "a function" if callable(part) else f"{str(part)[:40]!r}, {type(part).__name__}"
                raise InvalidScene(f"a scene needs a {kind.__name__}, not {given}; give {remedy}")
        put(self, pair=pair, initial=initial, law=read_law(law), force=force, friction=friction, _hash=0)
        put(self, until=positive(until, "until", HORIZON), force_2=force_2, belt=belt, wall=wall)
        require_nonnegative(friction, self.until)
        if friction.weakening and (pair.b_static is not None or not pair.b or not friction.is_stepwise):
            raise InvalidScene(
                "b_static, b = 0 and pieces that vary cannot stand beside [weakening], which scales b > 0 by constant "
                "steps; leave one out"
            )
        if pair.is_fixed:
            self._take_belt()
        elif belt.pieces:
            raise InvalidScene('a belt moves a body 2 of any mass; write m2 = "inf", or leave [[belt]] out')
        if pair.a1:
            self._require_continuous_wall()

    def _take_belt(self) -> None:
        """Give body 2 the belt's velocity at 0, if that is rational, and refuse what contradicts it."""
        if self.force_2.pieces:
            raise InvalidScene('a force on body 2 does not move it where m2 = "inf"; leave it out, or give m2 a number')
        first, given = self.belt.piece_at(Fraction(0)), self.initial
        velocity = sum(first.polynomial[:1], Fraction(0))
        is_exact = not any(one.phase for one in first.sines)
        if given.v2 not in (0, velocity if is_exact else 0):
            shown_as = short(velocity) if is_exact else f"{float(self.belt(0)):.6g}"
            raise InvalidScene(f"v2 = {short(given.v2)} is not the belt's velocity at 0, {shown_as}; leave v2 out")
        if is_exact and given.v2 != velocity:
            put(self, initial=State(given.x1, given.v1, given.x2, velocity))

    def _require_continuous_wall(self) -> None:
        """Raise InvalidScene for a jump of the wall, which a damper would turn into a blow."""
        for at in self.wall.starts:
            before, after = float(self.wall(at, -1)), float(self.wall(at))
            if at and abs(after - before) > 1e-12 * max(abs(before), abs(after)):
                raise InvalidScene(
                    f"the wall jumps from {before:.6g} m to {after:.6g} m at t = {short(at)} s, a blow through the "
                    "damper; make it continuous, or a1 = 0"
                )

    def __hash__(self) -> int:
        """Return the hash of all parts."""
        if not self._hash:
            put(self, _hash=hash(tuple(getattr(self, one.name) for one in fields(self) if one.init)) or 1)
        return self._hash

    def __reduce__(self) -> tuple[Any, ...]:
        """Return what pickles and copies are made of."""
        return Scene, tuple(getattr(self, one.name) for one in fields(self) if one.init)

    def replace(self, **changes: object) -> Scene:
        """Return the scene with other parts, or with other numbers of its pair and its initial state.

        >>> scene = Scene(Pair(1, 1, 200, "0.05"), State(v1="0.15"), 5)
        >>> scene.replace(b="0.06", x1=1, until=3)
        Scene(pair=Pair(m1=1, m2=1, a2=200, b=0.06), initial=State(x1=1, v1=0.15), until=3)
        """
        return replaced(self, changes, ("pair", "initial"))

    @property
    def pieces(self) -> dict[str, tuple[Piece, ...]]:
        """The pieces of each signal and of friction, by their names."""
        signals = {"force": self.force, "force_2": self.force_2, "belt": self.belt, "wall": self.wall}
        return {**{name: one.pieces for name, one in signals.items()}, "friction": self.friction.pieces}

    @property
    def extra(self) -> str:
        """What the scene has beyond a spring, two masses, one b > 0 by steps, and a force on body 1; "" for nothing."""
        found = {
            "b = 0": any(one.constant == 0 for one in self.friction.pieces),
            "a force on body 2": self.force_2.pieces,
            "a wall that moves": self.wall.pieces,
            "friction that varies within a piece": not self.friction.is_stepwise,
            "friction that depends on the state": self.friction.weakening,
        }
        return self.pair.extra or _first(found)

    @property
    def is_forced(self) -> bool:
        """Whether the scene has a force that is not 0, or friction other than one number b, or something `extra`."""
        pushes = any(piece.polynomial or piece.sines for piece in self.force.pieces)
        return bool(pushes or self.friction.pieces or self.extra)

    @property
    def changes_later(self) -> bool:
        """Whether another piece of a signal or of friction begins at the horizon or after it."""
        return any(one.start >= self.until for pieces in self.pieces.values() for one in pieces)

    def require_filippov(self, what: str) -> None:
        """Raise InvalidScene for sgn(0) = 0 read literally: such a stick never ends, whatever friction it requires."""
        if self.law is not Law.FILIPPOV:
            raise InvalidScene(f'law = "{self.law.value}" has no such theory; leave the law out for {what}')

    @property
    def energy(self) -> Fraction:
        """E at t = 0, J, exact."""
        return Fraction(self.pair.energy(self.initial))

    @property
    def energy_excess(self) -> Fraction:
        """w = E/E_cr - 1 at t = 0, dimensionless, exact: permanent stick needs w <= 0 (free pair)."""
        return self.energy / self.pair.critical_energy - 1


PLAIN = "give a2 > 0, b > 0 by steps, a finite m2, no b_static, and a force on body 1 alone"
"""What a plain scene has."""


def require_plain(asking: str, scene: Scene, what: str) -> None:
    """Raise InvalidScene, where only plain scenes are supported, for another one; TypeError for no scene."""
    require_kind(asking, scene, Scene, BUILD)
    if scene.extra:
        raise InvalidScene(f"{what} is not available for {scene.extra}; {PLAIN}, or use solve")


WRT = ("x1", "v1", "x2", "v2", "m1", "m2", "a2", "b", "a1")
"""The initial state and the parameters of a free pair, in the order of the last axis of every array of derivatives."""


MOST_PIECES = 100
"""A signal of more pieces is a table of samples, which nobody varies one by one."""


def parameters(scene: Scene, *, tables: bool = True) -> dict[str, Fraction]:
    """Return every number of a scene by its name, in the order of the last axis of all derivatives; exact.

    Those of `WRT` without m2 and v2 of a belt, and with b_static if it is given; under a force `until` too. Pieces and
    what is in them are counted from 0, as in Python: `force[0].from`, `force[0].polynomial[1]`,
    `force[0].sines[0].amplitude` (`omega`, `phase`), and likewise `force_2`, `belt`, `wall` and `friction`, whose
    constants are `friction[0].b`; `weakening.speed[0].w` (`b`), `weakening.place[0].z` (`c`), `weakening.last_slope`.
    Without `tables` those of a signal of more than 100 pieces are left out.
    """
    pair = scene.pair
    found = {name: getattr(scene.initial if name in WRT[:4] else pair, name) for name in WRT}
    if pair.is_fixed:
        del found["m2"], found["v2"]
    if pair.b_static is not None:
        found["b_static"] = pair.b_static
    if not (scene.force.pieces or scene.is_forced):
        return found
    found["until"] = scene.until
    for name, pieces in scene.pieces.items():
        for index, piece in enumerate(pieces if tables or len(pieces) <= MOST_PIECES else ()):
            found |= numbers_of(f"{name}[{index}]", piece)
    if scene.friction.weakening is not None:
        given = scene.friction.weakening
        for name, keys, points in (("speed", "wb", given.speed), ("place", "zc", given.place)):
            for index, point in enumerate(points):
                found |= {f"weakening.{name}[{index}].{key}": one for key, one in zip(keys, point, strict=True)}
        found["weakening.last_slope"] = given.last_slope
    return found


def numbers_of(name: str, piece: Piece) -> Iterator[tuple[str, Fraction]]:
    """Yield the numbers of a piece by their names, which begin with its own."""
    yield f"{name}.from", piece.start
    if name.startswith("friction") and piece.constant is not None:
        yield f"{name}.b", piece.constant
        return
    yield from ((f"{name}.polynomial[{k}]", one) for k, one in enumerate(piece.polynomial))
    for k, sine in enumerate(piece.sines):
        yield from ((f"{name}.sines[{k}].{key}", getattr(sine, key)) for key in ("amplitude", "omega", "phase"))


def read_law(law: object) -> Law:
    """Return the Law that `law` names; raises InvalidScene with the names that exist."""
    try:
        return Law(law)
    except ValueError:
        names = ", ".join(f'"{one.value}"' for one in Law)
        raise InvalidScene(f"law = {shown(law)} is not one of {names}; leave it out for the first") from None
