"""Rows of z over long times: a polynomial, and terms C exp(lambda t) of which none grows.

Signals are polynomials and sines. A body that they alone accelerate answers by integrals; body 1 on its spring, at one
time alone in a slip and with body 2 in stick, by a particular polynomial, the steady answer to each sine, and a free
motion, exp(lambda t) with lambda^2 + r lambda + k = 0. A term that is fast counts by its amplitude |C|.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from flint import acb, arb, arb_poly

from numerics.linear.flow import BEND, FEW, Curve, Flow
from numerics.linear.model import FIRST, V1, V2, X1
from numerics.linear.pieces import particular
from numerics.linear.system import BallRow, length

_I = acb(0, 1)


class Swings:
    """A motion from z on: of each place its polynomial, and the C of each term; the lambdas are `rates`."""

    def __init__(self, flow: Flow, z: Sequence[arb]) -> None:
        """Form them; what has no such form, a resonance or double rates, is left with infinite numbers."""
        places = flow.mode.sine_places
        self.rates = [acb(0, flow.generator[place][0][1]) for place in places]
        self.curves: dict[int, arb_poly] = {}
        self.terms: dict[int, dict[int, acb]] = {}
        for block in flow.norm.blocks:
            for k in block:
                terms = [z[m] / math.factorial(m - k) for m in range(k, block.stop)]
                self.curves[k], self.terms[k] = arb_poly(terms), {}
        for n, k in enumerate(places):
            turned = acb(z[k + 1], z[k])
            self.curves[k] = self.curves[k + 1] = arb_poly([])
            self.terms[k], self.terms[k + 1] = {n: -_I * turned}, {n: turned}
        for X, V in ((X1, V1), (X1 + 2, V2)):
            own = {place: c for place, c in flow.generator[V] if place < FIRST}
            push, pushes = self.of([(place, c) for place, c in flow.generator[V] if place >= FIRST])
            if not own:
                for place, start in ((V, z[V]), (X, z[X])):
                    pushes = {n: c / self.rates[n] for n, c in pushes.items()}
                    push = push.integral() + (start - _now(pushes))
                    self.curves[place], self.terms[place] = push, pushes
            elif X == X1:
                self.swing(-own.get(X1, arb(0)), -own.get(V1, arb(0)), push, pushes, z)
            else:
                self.curves[V], self.terms[V] = self.curves[V1], self.terms[V1]

    def swing(self, k: arb, r: arb, push: arb_poly, pushes: dict[int, acb], z: Sequence[arb]) -> None:
        """Form body 1, of which x'' + r x' + k x is what pushes it."""
        x = arb_poly(particular(push.coeffs(), arb(1), r, k))
        steady = {n: c / (k + self.rates[n] * (self.rates[n] + r)) for n, c in pushes.items()}
        y, w = z[X1] - x(0) - _now(steady), z[V1] - x.derivative()(0) - _now(self.derived(steady))
        count, curves = len(self.rates), [x, x.derivative(), x.derivative().derivative()]
        if abs(r * r - 4 * k) < k:
            # rates that are nearly one: of y, k y^2 + y'^2 never grows, and so on
            stiff = k.sqrt()
            sizes = [length(stiff * a, b) for a, b in ((y, w), (w, -k * y - r * w))]
            free = [{count: acb(one)} for one in (sizes[0] / stiff, *sizes)]
            self.rates.append(acb("inf"))
        else:
            fast = -(r + acb(r * r - 4 * k).sqrt()) / 2
            slow = k / fast
            self.rates += [fast, slow]
            free = [{count: (w - slow * y) / (fast - slow), count + 1: (fast * y - w) / (fast - slow)}]
            free += [self.derived(free[0]), self.derived(self.derived(free[0]))]
        for place, curve, one in zip((X1, V1, BEND), curves, free, strict=True):
            self.curves[place], self.terms[place] = curve, steady | one
            steady = self.derived(steady)

    def derived(self, terms: dict[int, acb]) -> dict[int, acb]:
        """Return the terms of a derivative."""
        return {n: self.rates[n] * c for n, c in terms.items()}

    def of(self, row: BallRow) -> tuple[arb_poly, dict[int, acb]]:
        """Return the polynomial and the terms of a row."""
        polynomial, terms = arb_poly([]), dict[int, acb]()
        for place, c in row:
            polynomial += self.curves[place] * c
            for n, one in self.terms[place].items():
                terms[n] = terms[n] + one * c if n in terms else one * c
        return polynomial, terms

    def taken(self, row: BallRow, limit: arb) -> Curve:
        """Return a row with the terms of rates below a limit as polynomials; its margin is what the others reach."""
        polynomial, terms = self.of(row)
        slow = [(c, self.rates[n]) for n, c in terms.items() if abs(self.rates[n]) < limit]
        amplitude = sum((abs(c) for n, c in terms.items() if not abs(self.rates[n]) < limit), arb(0)).upper()
        coefficients = polynomial.coeffs() or [arb(0)]
        if slow:
            coefficients += [arb(0)] * (FEW - len(coefficients))
        count = len(coefficients)
        for k in range(count):
            coefficients[k] += sum(((c * rate**k).real for c, rate in slow), arb(0)) / math.factorial(k)
        rest = sum((abs(c) * abs(rate) ** count for c, rate in slow), arb(0)) / math.factorial(count)
        return Curve(arb_poly(coefficients), rest.upper(), count, amplitude)


def _now(terms: dict[int, acb]) -> arb:
    """Return the sum of terms at once."""
    return sum((c.real for c in terms.values()), arb(0))
