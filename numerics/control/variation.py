"""How small differences of (x1, v1, v2) pass along a motion and across the event that ends it (saltation)."""

from __future__ import annotations

from flint import arb, arb_mat

from numerics.control.linear import V1, V2, X1, Motion

PLACES = (X1, V1, V2)


def part(flow: arb_mat) -> arb_mat:
    """Return the rows and columns of a flow that belong to (x1, v1, v2)."""
    return arb_mat([[flow[row, column] for column in PLACES] for row in PLACES])


def across(motion: Motion, length: arb, after: Motion) -> arb_mat:
    """Return the derivative of (x1, v1, v2) after the event that ends a motion by that at its start.

    Both at fixed times: a later event lets the earlier mode act longer. `after` is the motion that the event begins.
    """
    flow = motion.flow(length)
    if motion.mode.side == 0:
        return part(flow)  # at an exit both modes have the same accelerations
    before, behind = motion.rate(flow * motion.begin), after.rate(after.begin)
    closing = before[V1, 0] - before[V2, 0]
    jump = [(before[place, 0] - behind[place, 0]) / closing for place in PLACES]
    mixed = [[arb(int(row == column)) - jump[row] * (0, 1, -1)[column] for column in range(3)] for row in range(3)]
    return arb_mat(mixed) * part(flow)
