"""What a path of linear modes is off, by components: a set that every step and every event carries on.

N never grows, but it does not fall either where a damper or friction makes motions forget, and it knows no components.
In a mode of a box the difference e of (q1, v1, v2) of two motions is linear, e' = A e. So after a time h it is in
exp(A h) E [-1, 1]^k, if it was in E [-1, 1]^k, and the defect of the step, of which N is at most d, adds columns: it has
|q_i| <= soft_i d, |v_i| <= d/sqrt(m_i), and |v1_i| = |v2_i| <= d/sqrt(M_i) on an axis that sticks.

Where s_i comes to 0 the path changes its mode at t, the motion at t - tau. The motions in the mode before and in the one
after, which are one at t - tau, differ at t by

    tau exp(A tau') J (f_after - f_before),   J: -1/m1 on v1_i, 1/m2 on v2_i,   tau = e_s/s_i',   e_s of v1_i - v2_i

with tau', the forces and s_i' somewhere in between: an enclosed matrix times e. Of what comes after, e is the
difference to the motion in the mode after the event; within tau it is not yet there, or no more in the one before.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import arb, arb_mat

from numerics.plane.system import System
from numerics.plane.vector import Vector

_MOST = 24
"""Steps whose defects are kept apart; then they are put into one box."""


class Spread:
    """A set of differences e = (q1, v1, v2), E [-1, 1]^k by the rows of E."""

    def __init__(self, system: System, rows: Iterable[list[arb]] = ()) -> None:
        """Take rows; without any there is no difference."""
        self.system, self.rows = system, list(rows) or [[] for _ in range(3 * system.n)]

    def of(self, row: Iterable[arb]) -> arb:
        """Return a bound on |row e|."""
        columns = zip(*self.rows, strict=True)
        return sum((abs(Vector(row) @ one) for one in columns), arb(0)).upper()

    @property
    def norm(self) -> arb:
        """Return a bound on N."""
        n, sizes = self.system.n, [sum(map(abs, row), arb(0)) for row in self.rows]
        return self.system.norm(*(Vector(sizes[k : k + n]) for k in (0, n, 2 * n)))

    def grown(self, mode: str, by: arb) -> Spread:
        """Return the set with the differences added whose N is at most `by`, with s_i = 0 where an axis sticks."""
        system, n, rows = self.system, self.system.n, self.rows
        if len(rows[0]) > 3 * n * _MOST:
            rows = _diagonal(sum(map(abs, row), arb(0)).upper() for row in rows)
        added = _diagonal(x * by for x in (*system.soft, *(1 / system.root_m1), *(1 / system.root_m2)))
        for i, one in enumerate(mode):
            if one == "0":
                size = by / system.mass[i].sqrt()
                added[n + i][n + i] = added[2 * n + i][n + i] = size
                added[2 * n + i][2 * n + i] = arb(0)
        return Spread(system, (one + two for one, two in zip(rows, added, strict=True)))

    def moved(self, mode: str, time: arb) -> Spread:
        """Return the set after a time in a mode."""
        return Spread(self.system, (_flow(self.system, mode, time) * arb_mat(self.rows)).tolist())

    def switched(self, mode: str, i: int, late: arb, jump: arb, rate: arb) -> Spread:
        """Return the set where s_i came to 0 in a mode within `late`, at a rate, and f_i changes by a jump."""
        system, n = self.system, self.system.n
        kick = [arb(0)] * (3 * n)
        kick[n + i], kick[2 * n + i] = -jump / (rate * system.m1[i]), jump / (rate * system.m2[i])
        moved = _flow(system, mode, arb(0, late)) * arb_mat([[x] for x in kick])
        off = Vector(x - y for x, y in zip(self.rows[n + i], self.rows[2 * n + i], strict=True))
        return Spread(system, (list(Vector(row) + off * moved[k, 0]) for k, row in enumerate(self.rows)))


def _diagonal(sizes: Iterable[arb]) -> list[list[arb]]:
    given = list(sizes)
    return [[x if j == k else arb(0) for k in range(len(given))] for j, x in enumerate(given)]


def _flow(system: System, mode: str, time: arb) -> arb_mat:
    """Return exp(A time)."""
    n, masses = system.n, (system.m1, system.m2)
    rows = [[arb(j == n + i) for j in range(3 * n)] for i in range(n)]
    for body in range(2):
        for i, one in enumerate(mode):
            row = [arb(0)] * (3 * n)
            for j, x in system.held[i]:
                if one == "0" or body == 0:
                    row[j] = -x / (system.mass if one == "0" else masses[0])[i]
            rows.append(row)
    return (arb_mat(rows) * time).exp()
