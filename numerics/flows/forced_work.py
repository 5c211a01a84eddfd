"""The work of u and the square of v1 in one mode, int u v1 dt and int v1^2 dt, by Gauss's rule on short panels.

Closed forms of these integrals would need a case for each pair of polynomial, sine and oscillator, in each regime and
next to each resonance. A panel of the motion needs none, has all digits with a dozen nodes in binary64, and its
remainder is bounded, as the integrands are of exponential type: with rho >= all rates, at the start of a panel

    |u^(k)| <= U rho^k    U = sum_k |p^(k)|/rho^k + sum A                  of polynomial and sines
    |v1^(k)| <= V rho^k   V = rho (max(|x1|, |v1|/rho) + (U_p + b)/(m rho^2) + sum A/(m rho (rho - omega)))

since m x^(k+2) = u^(k) - a1 x^(k+1) - a2 x^(k). In the panel both grow by e^(rho h) at most, so Gauss's remainder
h^(2n+1) n!^4/((2n+1) (2n)!^3) |f^(2n)| is at most h U V e^(2 rho h) (2 rho h)^(2n) n!^4/((2n+1) (2n)!^3).
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numerics.arithmetic.float64 import ZERO, exactly, rough, size
from numerics.arithmetic.protocol import Number
from numerics.arithmetic.telling import text, text_apart
from numerics.flows.forced import coefficient_at
from numerics.flows.forced_jet import push_at, state_at
from numerics.flows.forced_records import HEAD, SINE, Drive, Pair, Start


class Integrals(NamedTuple):
    """Both integrals; of U, V, U V and V^2 over the panels, each with its value at a panel's start; and int v1's sizes.

    `rounded` is a float: the integral of |u| times the size of what v1 is a sum of, and of its square.
    """

    work: Number
    square: Number
    of_u: Number
    of_v: Number
    of_uv: Number
    of_vv: Number
    rounded_work: float
    rounded_square: float


@text
def exponential_type(
    pair: Pair, drive: Drive, start: Start, rho: Number, local: Number, state: tuple[Number, Number]
) -> tuple[Number, Number]:
    """Return U and V at a time in a piece, where x1 and v1 are `state`."""
    swing = pair.stick if start.mode == 0 else pair.slip
    numbers, first = drive.numbers, drive.places[start.piece][0]
    count, sines = drive.places[start.piece][1], drive.places[start.piece][2]
    (x, v), power, polynomial, peaks, answer = state, exactly(1.0), ZERO, ZERO, ZERO
    for k in range(count):
        if k > 0:
            power = power * k / rho
        polynomial = polynomial + size(coefficient_at(numbers, first + HEAD, count, k, local)) * power
    at = first + HEAD + 3 * count
    for _ in range(sines):
        amplitude = size(numbers[at])
        peaks = peaks + amplitude
        answer = answer + amplitude / (swing.mass * (rho - numbers[at + 1]))
        at += SINE
    pushed = (polynomial + numbers[first + 2]) / (swing.mass * rho)
    return polynomial + peaks, rho * size(x) + size(v) + pushed + answer


@text_apart
def integrals(
    pair: Pair, drive: Drive, start: Start, length: Number, panels: int, rho: float, rule: tuple[Any, Any]
) -> Integrals:
    """Return the integrals over the first `length` s of a mode; `rule`: nodes in (0, 1) and their weights."""
    nodes, weights = rule
    rate, h, empty = exactly(rho), length / panels, 0 * length
    work, square, of_u, of_v, of_uv, of_vv = empty, empty, empty, empty, empty, empty
    rounded_work, rounded_square = 0.0, 0.0
    for panel in range(panels):
        begun = h * panel
        at = state_at(pair, drive, start, begun)
        u_bound, v_bound = exponential_type(pair, drive, start, rate, start.local + begun, (at.x, at.v))
        of_u, of_v = of_u + u_bound, of_v + v_bound
        of_uv, of_vv = of_uv + u_bound * v_bound, of_vv + v_bound * v_bound
        for k in range(len(nodes)):
            tau = h * (panel + nodes[k])
            here, u = state_at(pair, drive, start, tau), push_at(drive, start.piece, start.local + tau)
            work, square = work + weights[k] * u.u0 * here.v, square + weights[k] * here.v * here.v
            rounded_work += rough(weights[k]) * u.height * here.v_size
            rounded_square += rough(weights[k]) * here.v_size * here.v_size
    short = rough(h)
    return Integrals(
        work * h,
        square * h,
        of_u * h,
        of_v * h,
        of_uv * h,
        of_vv * h,
        rounded_work * short,
        rounded_square * short,
    )
