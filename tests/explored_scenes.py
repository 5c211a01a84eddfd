"""Scenes in reduced coordinates, for the page as numbers and for `numerics.solve` as exact rationals."""

from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from numerics import Pair, Scene, State

GRID = [
    (Fraction(ratio), Fraction(zeta), *(Fraction(one) for one in start))
    for ratio, zeta, start in product(
        ("1/20", "1/3", "1", "4"),
        ("0", "1/50", "0.4", "1", "5/2"),
        (("0", "3", "0"), ("-1.6", "0", "-1.6"), ("2.5", "-1", "-1"), ("1", "0.01", "0.01"), ("0.3", "-7", "11")),
    )
]
TIES = [
    # ratio, zeta, X, V1, V2: on the edge at rest (sticks for ever), on a ray, turning back from the edge, outside
    (Fraction(ratio), Fraction(0), Fraction(x), Fraction(v), Fraction(v))
    for ratio in ("1", "1/4")
    for x, v in (("1", "0"), ("-1", "0"), ("1", "0.001"), ("1", "-0.25"), ("-1", "-2"), ("-1", "1"), ("1.2", "0"))
]
UNTIL = Fraction(60)


@dataclass(frozen=True)
class Reduced:
    """A scene of the grid: mass ratio m1/m2, damping ratio, X, V1, V2, and the reading of the law."""

    ratio: Fraction
    zeta: Fraction
    X: Fraction
    V1: Fraction
    V2: Fraction
    literal: bool = False

    def for_page(self) -> dict[str, float | bool]:
        numbers = {name: float(getattr(self, name)) for name in ("ratio", "zeta", "X", "V1", "V2")}
        return numbers | {
            "constant": 0.0,
            "amplitude": 0.0,
            "omega": 1.0,
            "until": float(UNTIL),
            "literal": self.literal,
        }

    def scene(self) -> Scene:
        """The pair with L = Omega = M = 1: its SI numbers are the reduced ones."""
        q = self.ratio / (1 + self.ratio)
        pair = Pair(q, 1 - q, 1, 1 - q, 2 * self.zeta)
        law = "three-valued-sgn" if self.literal else "filippov"
        return Scene(pair, State(self.X, self.V1, 0, self.V2), UNTIL, law)


SCENES = [Reduced(*row) for row in (*GRID, *TIES)] + [Reduced(*GRID[0], literal=True), Reduced(*TIES[-1], literal=True)]
