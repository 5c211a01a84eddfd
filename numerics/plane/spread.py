"""What a path of linear modes is off, by components: a set that every step and every event carries on.

N never grows, but it does not fall either where a damper or friction makes motions forget, and it knows no components.
In a mode of a box the difference e of (q1, v1, v2) of two motions is linear, e' = A e. What was in E [-1, 1]^k is in
exp(A h) E [-1, 1]^k after a time h, and the defect of the step, of which N is at most d, adds columns: there
|q_i| <= soft_i d, |v_i| <= d/sqrt(m_i), and |v1_i| = |v2_i| <= d/sqrt(M_i) on an axis that sticks.

Where s_i comes to 0 the path changes its mode at t, the motion at t - tau. The motions in the mode before and in the
one after, which are one at t - tau, differ at t by

    tau exp(A tau') J (f_after - f_before),   J: -1/m1 on v1_i, 1/m2 on v2_i,   tau = e_s/s_i',   e_s of v1_i - v2_i

with tau', the forces and s_i' somewhere in between: an enclosed matrix times e. Of what comes after, e is the
difference to the motion in the mode after the event; within tau it is not yet there, or no more in the one before.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from flint import arb, arb_mat

from numerics.plane.system import System
from numerics.plane.vector import Vector

_MOST = 32
"""Steps whose defects are kept apart; then they are put into one box."""


class Spread:
    """A set of differences e = (q1, v1, v2), E [-1, 1]^k by the columns of E."""

    def __init__(self, system: System, columns: Sequence[Vector] = ()) -> None:
        """Take columns; without any there is no difference."""
        self.system = system
        self.columns = columns or [self.unit(0, arb(0))]

    def bound(self, of: Sequence[tuple[int, arb]]) -> arb:
        """Return a bound on what a linear function is off, given by its coefficients."""
        return sum((abs(sum(x * one[j] for j, x in of)) for one in self.columns), arb(0)).upper()

    def slip(self, i: int) -> Sequence[tuple[int, arb]]:
        """Return v1 - v2 on an axis, as a linear function."""
        n = self.system.n
        return [(n + i, arb(1)), (2 * n + i, arb(-1))]

    def load(self, i: int) -> Sequence[tuple[int, arb]]:
        """Return the load on an axis, as a linear function; of the other sign."""
        return [(j, x * self.system.share[i]) for j, x in self.system.held[i]]

    @property
    def sizes(self) -> Vector:
        """Return bounds on the components."""
        return sum(map(abs, self.columns), Vector([arb(0)] * (3 * self.system.n)))

    @property
    def norm(self) -> arb:
        """Return a bound on N."""
        n, sizes = self.system.n, self.sizes
        return self.system.norm(*(Vector(sizes[k : k + n]) for k in (0, n, 2 * n)))

    def grown(self, mode: str, by: arb, parts: Iterable[arb] | None = None) -> Spread:
        """Return the set with the differences added whose N is at most `by`, with s_i = 0 where an axis sticks.

        `parts`: bounds on their components.
        """
        system, n = self.system, self.system.n
        sizes = system.weights * by
        if parts is not None:
            sizes = Vector(x.min(y) for x, y in zip(sizes, parts, strict=True))
        columns = self.columns
        if len(columns) > 3 * n * _MOST:
            columns = [self.unit(j, x) for j, x in enumerate(self.sizes)]
        added = [self.unit(j, x) for j, x in enumerate(sizes)]
        for i, one in enumerate(mode):
            if one == "0":
                size = sizes[n + i].min(sizes[2 * n + i]).min(by / system.mass[i].sqrt())
                added[n + i] = self.unit(n + i, size) + self.unit(2 * n + i, size)
                added[2 * n + i] = self.unit(0, arb(0))
        return Spread(system, [*columns, *added])

    def unit(self, k: int, size: arb) -> Vector:
        """Return a difference in one component."""
        return Vector(size if j == k else arb(0) for j in range(3 * self.system.n))

    def stepped(self, mode: str, time: arb, by: arb, lacking: Vector, rounded: arb) -> Spread:
        """Return the set after a step of which the defect and what the end is `rounded` by add at most `by` to N.

        Of the defect, by components: what a defect d adds is at most exp(|A| time) int |d|.
        """
        rate = _rates(self.system, mode)
        sizes = arb_mat([[abs(x) * time for x in row] for row in rate.tolist()]).exp()
        n, defects = self.system.n, list(lacking)
        for i, one in enumerate(mode):
            if one == "0":  # friction shares it out: both bodies take the same
                whole = self.system.m1[i] * defects[n + i] + self.system.m2[i] * defects[2 * n + i]
                defects[n + i] = defects[2 * n + i] = whole / self.system.mass[i]
        parts = _times(sizes, [defects])[0] + self.system.weights * rounded
        return Spread(self.system, _times((rate * time).exp(), self.columns)).grown(mode, by.upper(), parts)

    def switched(self, mode: str, i: int, late: arb, jump: arb, rate: arb) -> Spread:
        """Return the set where s_i came to 0 in a mode within `late`, at a rate, and f_i changes by a jump."""
        system, n, slip = self.system, self.system.n, self.slip(i)
        kick = self.unit(n + i, -jump / (rate * system.m1[i])) + self.unit(2 * n + i, jump / (rate * system.m2[i]))
        (moved,) = _times((_rates(system, mode) * arb(0, late)).exp(), [kick])
        return Spread(system, [one + moved * sum(x * one[j] for j, x in slip) for one in self.columns])


def _times(matrix: arb_mat, columns: Sequence[Sequence[arb]]) -> list[Vector]:
    """Return a matrix times columns."""
    found = matrix * arb_mat([[*row] for row in zip(*columns, strict=True)])
    return [*map(Vector, found.transpose().tolist())]


def _rates(system: System, mode: str) -> arb_mat:
    """Return A."""
    n = system.n
    rows = [[arb(j == n + i) for j in range(3 * n)] for i in range(n)]
    for body in range(2):
        for i, one in enumerate(mode):
            row = [arb(0)] * (3 * n)
            for j, x in system.held[i]:
                if one == "0" or body == 0:
                    row[j] = -x / (system.mass if one == "0" else system.m1)[i]
            rows.append(row)
    return arb_mat(rows)
