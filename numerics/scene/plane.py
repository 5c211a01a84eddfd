"""What is given where the pair moves on a surface: lists for numbers, a force for each axis, the shape of K.

    M1 q1'' + A1 q1' + A2 q1 = u - f,   M2 q2'' = f,   f in K with f.(v1 - v2) greatest

on the axes x, y and, with three, the angle phi (rad; its m are moments of inertia, kg m^2, its b a torque, N m).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations
from math import inf
from typing import TYPE_CHECKING, Any

from flint import fmpq, fmpq_mat

from numerics.errors import InvalidScene
from numerics.scene import decimals
from numerics.scene.decimals import Exact, as_printed, exact_decimal, listed, put, require_one_of, short, shown
from numerics.scene.friction import friction_pieces
from numerics.scene.model import HORIZON, NO_FORCE
from numerics.scene.pieces import Force, require_all
from numerics.scene.replaced import replaced
from numerics.scene.short_repr import ShortRepr, record

if TYPE_CHECKING:
    from numerics.scene.decimals import Exacts

AXES = ("x", "y", "phi")
SHAPES = ("ellipsoid", "box")
Vector = tuple[Fraction, ...]
Matrix = tuple[Vector, ...]


@record
class PlanePair(ShortRepr):
    """Two bodies on a surface, n = 2 or 3 axes: m1, m2, b > 0 (n,), a1 >= 0 and a2 > 0 symmetric (n, n). Exact.

    SI units as in Pair; on the angle axis kg m^2, N m s, N m, N m. One number means n equal ones, n numbers a
    diagonal matrix. Raises InvalidScene.
    `shape` "ellipsoid": sum (f_i/b_i)^2 <= 1; "box": |f_i| <= b_i.

    >>> pair = PlanePair(m1=1, m2=1, a2=[200, 120], b=["0.5", "0.25"], a1=0, shape="box")
    >>> pair.axes, pair.is_diagonal, pair.parts, pair.shape, [str(one) for one in pair.b]
    (2, True, ((0,), (1,)), 'box', ['1/2', '1/4'])
    """

    m1: Vector
    m2: Vector
    a1: Matrix
    a2: Matrix
    b: Vector
    shape: str

    def __init__(
        self,
        m1: Exacts,
        m2: Exacts,
        a2: Exacts,
        b: Exacts,
        a1: Exacts = 0,
        shape: str = "ellipsoid",
        axes: int | None = None,
    ) -> None:
        """Read every number as an exact decimal and check its bound."""
        m1, m2, a2, b, a1 = map(_listed, (m1, m2, a2, b, a1))
        if m2 in ("inf", inf):
            raise InvalidScene('m2 = "inf", ground or belt, is for scenes on one line; give a finite m2')
        if axes is not None and axes not in (2, 3):
            raise InvalidScene(
                f"axes = {shown(axes)} must be 2 (x, y) or 3 (x, y, phi), as in the lists; on one line give numbers"
            )
        n = axes or max([2, *(len(one) for one in (m1, m2, a2, b, a1) if isinstance(one, list))])
        if n > len(AXES):
            raise InvalidScene(f"a list of {n} numbers in [pair]; there are at most 3 axes: {', '.join(AXES)}")
        require_one_of("shape", shape, SHAPES, InvalidScene)
        for name, given in (("m1", m1), ("m2", m2), ("b", b)):
            put(self, **{name: positive(given, name, n)})
        put(self, a1=_matrix(a1, "a1", n), a2=_matrix(a2, "a2", n), shape=shape)
        for rows in (rows for size in range(1, n + 1) for rows in combinations(range(n), size)):
            for name, matrix, least, remedy in (
                ("a1", self.a1, ">= 0", "give a damper that takes energy from every motion"),
                ("a2", self.a2, "> 0", "give springs that hold every axis"),
            ):
                minor, along = _determinant(matrix, rows), ", ".join(AXES[i] for i in rows)
                if minor < 0 or (minor == 0 and least == "> 0"):
                    raise InvalidScene(
                        f"{name} has the minor {short(minor)} on {along}, which must be {least}; {remedy}"
                    )

    @property
    def axes(self) -> int:
        """The number of axes n."""
        return len(self.b)

    @property
    def is_diagonal(self) -> bool:
        """Whether neither springs nor dampers couple the axes."""
        return len(self.parts) == self.axes

    @property
    def parts(self) -> tuple[tuple[int, ...], ...]:
        """The indices of the axes, in groups that springs and dampers do not couple to each other."""
        axes = range(self.axes)
        near = [{j for j in axes if i == j or self.a1[i][j] or self.a2[i][j]} for i in axes]
        groups = (set[int]().union(*(near[j] for j in one)) for one in near)  # three axes: two couplings at most
        return tuple(sorted({tuple(sorted(one)) for one in groups}))


@record
class PlaneScene(ShortRepr):
    """A pair on a surface, x1, v1, x2, v2 (n,) at t = 0, the horizon `until` (s), a force per axis, b by pieces. Exact.

    >>> from numerics import Force, solve
    >>> pair = PlanePair(m1=1, m2=1, a2=200, b="0.5")
    >>> along_x, softer = [Force.sine(1, 5)], [("0.5", "0.4")]
    >>> pushed = PlaneScene(pair, 1, x1=[0.012, 0.002], v1=0, x2=0, v2=0, force=along_x, friction=softer)
    >>> pushed.pair.axes, pushed.until, pushed.is_forced
    (2, Fraction(1, 1), True)
    >>> pushed.replace(b=1, until=2).pair.b
    (Fraction(1, 1), Fraction(1, 1))
    >>> run = solve(PlaneScene(pair, 1, x1=[0.012, 0.002]), digits=12)
    >>> run.modes[:2], run.events[0].after, run.sol(0.5).shape
    (('slip', 'stick'), 'stick', (8,))
    """

    pair: PlanePair
    x1: Vector
    v1: Vector
    x2: Vector
    v2: Vector
    until: Fraction
    force: tuple[Force, ...]
    friction: tuple[tuple[Fraction, Vector], ...]

    def __init__(
        self,
        pair: PlanePair,
        until: Exact,
        x1: Exacts = 0,
        v1: Exacts = 0,
        x2: Exacts = 0,
        v2: Exacts = 0,
        force: Iterable[Force] = (),
        friction: Iterable[tuple[Exact, Exacts]] = (),
    ) -> None:
        """Check the parts; raises InvalidScene."""
        if not isinstance(pair, PlanePair):
            raise InvalidScene(f"pair must be a PlanePair, not {type(pair).__name__}; build it first")
        n, forces = pair.axes, tuple(listed("force", force, " of one Force for each axis"))
        require_all("force", forces, Force, "one Force for each axis")
        if len(forces) > n:
            raise InvalidScene(f"{len(forces)} forces for {n} axes; give one Force for each axis")
        put(self, until=decimals.positive(until, "until", HORIZON))
        state = {name: vector(one, name, n) for name, one in (("x1", x1), ("v1", v1), ("x2", x2), ("v2", v2))}
        changes = friction_pieces(listed("friction", friction, " of pairs (start, b)"), lambda b: positive(b, "b", n))
        put(self, pair=pair, force=forces + (NO_FORCE,) * (n - len(forces)), friction=changes, **state)

    def replace(self, **changes: object) -> PlaneScene:
        """Return the scene with other parts, or with other numbers of its pair."""
        return replaced(self, changes, ("pair",))

    @property
    def is_forced(self) -> bool:
        """Whether there is a force or a change of friction."""
        return bool(self.friction or any(one.pieces for one in self.force))


def _listed(given: Any) -> Any:
    """Return a list for a tuple or an array, and everything else as it is."""
    made = as_printed(given).tolist() if hasattr(given, "tolist") else given
    return list(made) if isinstance(made, tuple) else made


def vector(given: Any, name: str, n: int) -> Vector:
    """Return n exact numbers from a list of n, or from one number."""
    given = _listed(given)
    if not isinstance(given, list):
        return (exact_decimal(given, name),) * n
    if len(given) != n:
        raise InvalidScene(f"{name} has {len(given)} numbers and the scene {n} axes; give {n}")
    return tuple(exact_decimal(one, f"{name}[{k}]") for k, one in enumerate(given))


def positive(given: Any, name: str, n: int) -> Vector:
    """Return n exact numbers > 0."""
    found = vector(given, name, n)
    for axis, one in zip(AXES, found, strict=False):
        if one <= 0:
            raise InvalidScene(f"{name} = {short(one)} on {axis} must be > 0; give a positive {name} on every axis")
    return found


def _matrix(given: Any, name: str, n: int) -> Matrix:
    """Return a symmetric matrix from one, from its diagonal, or from one number."""
    if not (isinstance(given, list) and any(isinstance(row, list | tuple) for row in given)):
        diagonal = vector(given, name, n)
        return tuple(tuple(one if i == j else Fraction(0) for j in range(n)) for i, one in enumerate(diagonal))
    if len(given) != n:
        raise InvalidScene(f"{name} has {len(given)} rows and the scene {n} axes; give {n}")
    for k, row in enumerate(given):
        if not isinstance(row, list | tuple):
            raise InvalidScene(
                f"{name}[{k}] = {str(row)[:40]} must be a row of {n} numbers; give a list, as the others"
            )
    found = tuple(vector(row, f"{name}[{k}]", n) for k, row in enumerate(given))
    for i, j in combinations(range(n), 2):
        one, two = found[i][j], found[j][i]
        if one != two:
            raise InvalidScene(
                f"{name}[{i}][{j}] = {short(one)} and {name}[{j}][{i}] = {short(two)} must be equal; "
                "give a symmetric matrix"
            )
    return found


def _determinant(matrix: Matrix, rows: Sequence[int]) -> Fraction:
    """Return a principal minor."""
    kept = [[fmpq(*matrix[i][j].as_integer_ratio()) for j in rows] for i in rows]
    found = fmpq_mat(kept).det()
    return Fraction(int(found.p), int(found.q))
