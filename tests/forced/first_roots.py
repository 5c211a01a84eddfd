"""Zeros of a polynomial on (0, 1], touches included: between two zeros of its derivative it is monotone.

A zero of the k-th derivative is excluded where its value at the middle exceeds what the next derivative can change;
else the zeros of the next derivative cut the interval into monotone pieces. So nothing is sampled. A value below
`tiny` counts as zero: exact touches and zeros of any order are found as zeros of a derivative, to full precision.
"""

from flint import arb, arb_poly, ctx

DEEPEST = 9


class Zeros:
    """Zeros of one polynomial."""

    def __init__(self, polynomial: arb_poly, tiny: arb):
        self.tiny = tiny
        self.chain, self.bounds = [polynomial], [self.bound(polynomial)]

    @staticmethod
    def bound(polynomial: arb_poly) -> arb:
        """No less than |polynomial| on [0, 1]."""
        return sum((abs(one.mid()) for one in polynomial.coeffs()), arb(0))

    def derivative(self, k: int) -> tuple[arb_poly, arb]:
        while len(self.chain) <= k:
            self.chain.append(self.chain[-1].derivative())
            self.bounds.append(self.bound(self.chain[-1]))
        return self.chain[k], self.bounds[k]

    def first(self) -> arb | None:
        """The first zero in (0, 1], sign changes and touches alike; None if there is none."""
        if self.bounds[0] <= self.tiny:
            return None  # zero identically: nothing to decide
        found = self.within(0, arb(0), arb(1))
        return found[0] if found else None

    def free(self, k: int, low: arb, high: arb) -> bool:
        """Whether the k-th derivative has certainly no zero in [low, high]."""
        f, bound = self.derivative(k)
        reach = (high - low) / 2 * self.derivative(k + 1)[1]
        return bool(bound <= self.tiny or abs(f((low + high) / 2).mid()) > reach + self.tiny)

    def within(self, k: int, low: arb, high: arb) -> list[arb]:
        """The zeros of the k-th derivative in (low, high], in order."""
        if self.free(k, low, high):
            return []
        if k == DEEPEST and not self.free(k + 1, low, high):
            middle = (low + high) / 2
            if high - low < arb(10) ** -20:
                raise ArithmeticError(f"a zero of order {DEEPEST} near {middle}: this program stops here")
            return self.within(k, low, middle) + self.within(k, middle, high)
        f = self.chain[k]
        cuts = self.within(k + 1, low, high) if k < DEEPEST else []
        if not cuts or cuts[-1] < high:
            cuts.append(high)
        found, left, at_left = [], low, f(low).mid()
        for right in cuts:
            at_right = f(right).mid()
            if abs(at_right) <= self.tiny:
                found.append(right)
            elif abs(at_left) > self.tiny and (at_left > 0) != (at_right > 0):
                found.append(refined(f, left, right, at_right))
            left, at_left = right, at_right
        return found


def refined(f: arb_poly, low: arb, high: arb, at_high: arb) -> arb:
    """The zero of a monotone piece: ten bisections, then Newton's steps as long as they stay inside."""
    slope, close, rising = f.derivative(), arb(2) ** (8 - ctx.prec), at_high > 0
    guess = (low + high) / 2
    for n in range(8 * ctx.prec):
        value = f(guess).mid()
        if value == 0 or high - low <= close:
            break
        low, high = (low, guess) if (value > 0) == rising else (guess, high)
        steep = slope(guess).mid()
        step = (value / steep).mid() if n >= 10 and steep != 0 else arb(0)
        if 0 < abs(step) <= close:
            return (guess - step).mid()
        guess = (guess - step).mid()
        if step == 0 or not low < guess < high:
            guess = ((low + high) / 2).mid()
    return guess
