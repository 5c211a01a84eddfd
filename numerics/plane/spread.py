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

from collections.abc import Iterable

from flint import arb, arb_mat

from numerics.plane.system import System
from numerics.plane.vector import Vector

_MOST = 32
"""Steps whose defects are kept apart; then they are put into one box."""


class Spread:
    """A set of differences e = (q1, v1, v2), E [-1, 1]^k by the rows of E."""

    def __init__(self, system: System, rows: Iterable[list[arb]] = ()) -> None:
        """Take rows; without any there is no difference."""
        self.system, self.rows = system, list(rows) or [[] for _ in range(3 * system.n)]

    @property
    def weights(self) -> Vector:
        """Return bounds on the components where N = 1."""
        system = self.system
        return Vector((*system.soft, *(1 / system.root_m1), *(1 / system.root_m2)))

    def of_slip(self, i: int) -> arb:
        """Return a bound on what v1 - v2 is off on an axis."""
        return _most(self._slip(i))

    def of_load(self, i: int) -> arb:
        """Return a bound on what the load is off on an axis."""
        held = sum((Vector(self.rows[j]) * x for j, x in self.system.held[i]), Vector([arb(0)] * len(self.rows[0])))
        return _most(held * self.system.share[i])

    def _slip(self, i: int) -> Vector:
        n = self.system.n
        return Vector(x - y for x, y in zip(self.rows[n + i], self.rows[2 * n + i], strict=True))

    @property
    def norm(self) -> arb:
        """Return a bound on N."""
        n, sizes = self.system.n, [*map(_most, self.rows)]
        return self.system.norm(*(Vector(sizes[k : k + n]) for k in (0, n, 2 * n)))

    def grown(self, mode: str, by: arb, parts: Iterable[arb] | None = None) -> Spread:
        """Return the set with the differences added whose N is at most `by`, with s_i = 0 where an axis sticks.

        `parts`: bounds on their components.
        """
        system, n, rows = self.system, self.system.n, self.rows
        if len(rows[0]) > 3 * n * _MOST:
            rows = _diagonal(map(_most, rows))
        sizes = [x * by for x in self.weights]
        if parts is not None:
            sizes = [x.min(y) for x, y in zip(sizes, parts, strict=True)]
        added = _diagonal(sizes)
        for i, one in enumerate(mode):
            if one == "0":
                size = sizes[n + i].min(sizes[2 * n + i]).min(by / system.mass[i].sqrt())
                added[n + i][n + i] = added[2 * n + i][n + i] = size
                added[2 * n + i][2 * n + i] = arb(0)
        return Spread(system, (one + two for one, two in zip(rows, added, strict=True)))

    def stepped(self, mode: str, time: arb, by: arb, lacking: Vector, rounded: Vector) -> Spread:
        """Return the set after a step of which the defect and what the end is rounded by add at most `by` to N.

        Their components are given: what a defect d adds is at most exp(|A| time) int |d|, component by component.
        """
        rate = _rates(self.system, mode)
        moved = (rate * time).exp() * arb_mat(self.rows)
        sizes = arb_mat([[abs(x) * time for x in row] for row in rate.tolist()]).exp()
        n, defects = self.system.n, list(lacking)
        for i, one in enumerate(mode):
            if one == "0":  # friction shares it out: both bodies take the same
                whole = self.system.m1[i] * defects[n + i] + self.system.m2[i] * defects[2 * n + i]
                defects[n + i] = defects[2 * n + i] = whole / self.system.mass[i]
        parts = [Vector(row) @ defects + x for row, x in zip(sizes.tolist(), rounded, strict=True)]
        return Spread(self.system, moved.tolist()).grown(mode, by, parts)

    def switched(self, mode: str, i: int, late: arb, jump: arb, rate: arb) -> Spread:
        """Return the set where s_i came to 0 in a mode within `late`, at a rate, and f_i changes by a jump."""
        system, n = self.system, self.system.n
        kick = [arb(0)] * (3 * n)
        kick[n + i], kick[2 * n + i] = -jump / (rate * system.m1[i]), jump / (rate * system.m2[i])
        moved = (_rates(system, mode) * arb(0, late)).exp() * arb_mat([[x] for x in kick])
        off = self._slip(i)
        return Spread(system, (list(Vector(row) + off * moved[k, 0]) for k, row in enumerate(self.rows)))


def _most(row: Iterable[arb]) -> arb:
    """Return a bound on what a row of E times something in [-1, 1]^k may be."""
    return sum(map(abs, row), arb(0)).upper()


def _diagonal(sizes: Iterable[arb]) -> list[list[arb]]:
    given = list(sizes)
    return [[x if j == k else arb(0) for k in range(len(given))] for j, x in enumerate(given)]


def _rates(system: System, mode: str) -> arb_mat:
    """Return A."""
    n, masses = system.n, (system.m1, system.m2)
    rows = [[arb(j == n + i) for j in range(3 * n)] for i in range(n)]
    for body in range(2):
        for i, one in enumerate(mode):
            row = [arb(0)] * (3 * n)
            for j, x in system.held[i]:
                if one == "0" or body == 0:
                    row[j] = -x / (system.mass if one == "0" else masses[0])[i]
            rows.append(row)
    return arb_mat(rows)
