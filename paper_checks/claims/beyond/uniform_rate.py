"""The $1/t$ law with an error term, and what of it the energy at the start alone fixes."""

from paper_checks.claims.beyond.rate import one_step
from paper_checks.claims.beyond.rate_error import ranges
from paper_checks.claims.letters import R, of_share
from paper_checks.claims.words import *
from theory.long_time import leading_coefficient, logarithm_weight
from theory.rate_bounds import first_depth, first_excess
from theory.return_map import depth
from theory.symbols import r as share_of_q
from theory.uniform_rate import (
    crossing_loss,
    crossings,
    crossings_bound,
    first_contact_bound,
    gain,
    late,
    upper_bound,
)

EXCESS, SHARE, LOST = symbols("y_0 r s", positive=True)


@cache
def quotients() -> Evidence:
    """The bounds of both quotients."""
    low, high, long = ranges()
    texts = [f"{end.str(5, radius=False)}" for end in (low, high, long)]
    return enclosed(
        r"""
        for $0<\theta\leqslant\pi/2$ and every $r\in(0,1)$: bounds of $\pi G/c^2$ from below, of $\pi G/(r\,c^2)$ and of
        $F\,(1+\sqrt{1-rs})/(h\,s)$ from above, with $s=c^2/h^2$,
        $G=\frac{4}{9}\frac{s/h^2}{1-rs}-1+(1-\frac{2}{5r})\ln(1-rs)$ and $F=\sqrt q\,\theta-\arctan(\sqrt
        q\,h\sqrt{1-rs})-\arctan\frac{\sqrt q\,(\theta-h)}{1-q\,c}$, by Taylor polynomials with Cauchy's estimate near
        $\theta=0$ and centred forms beyond
        """,
        all(end.is_finite() for end in (low, high, long)),
        ", ".join(texts),
        3,
    )


def bounds_error(formula: Formula) -> Evidence:
    """Decide a bound of R_n of the form A y0 (above), (A y0 + B sqrt(y0))/r (below): the cycles can add no more, no less."""
    below = formula.relation == ">="
    scaled = expand(sp.sympify(formula.right) * (SHARE if below else 1))
    factors = [scaled.coeff(EXCESS), scaled.coeff(sqrt(EXCESS))]
    rest = sp.simplify(scaled - factors[0] * EXCESS - factors[1] * sqrt(EXCESS))
    low, high, long = ranges()
    with precision(25):
        passed = None
        if rest == 0 and all(one.is_Rational for one in factors) and formula.relation in ("<=", ">="):
            first, second = map(point, factors)
            passed = bool(first <= low and second <= -long) if below else bool(first >= high and second >= 0)
        said = ", ".join(text(end, 6) for end in (low, high, -long))
    return enclosed(f"${formula.latex}$", passed, f"least and largest: {said}", 2)


DEEP, GAP, EDGE = symbols("c d k", positive=True)  # k = 1/q


@cache
def few_crossings() -> Evidence:
    """Each slip that crosses S loses a fixed part of y."""
    crosses = [DEEP + GAP >= 2 * EDGE]
    return argument(
        r"""
        A slip that crosses has $c+d\geqslant 2/q$ and loses $r\,c\,(c+2d)$ of $y$. If $d\leqslant 1/q$ that is at
        least $2r/q^2$. If $d\geqslant 1/q$ it is at least $2r\,c/q$, and $c$ is not small: for $\theta\leqslant\pi$,
        $d\cot(\theta/2)=h-u\leqslant\frac{\pi}{2}+\sqrt{y_0}$, as $h\leqslant\pi/2$ and $u^2\leqslant y\leqslant
        y_0$; beyond, $c\geqslant 2$. So there are at most $N$ of them, each shorter than $2\pi\sqrt q$.
        """,
        *map(kernel.step, ("one-contact", "gap-slip", "excursion-depth")),
        prove(
            r"$c+d\geqslant 2/q$ and $d\leqslant 1/q$ give $c\,(c+2d)\geqslant 2/q^2$ (here $k=1/q$)",
            [*crosses, GAP <= EDGE],
            sp.Ge(DEEP * (DEEP + 2 * GAP), 2 * EDGE**2, evaluate=False),
        ),
        prove(
            r"$d\geqslant 1/q$ gives $c\,(c+2d)\geqslant 2c/q$",
            [GAP >= EDGE],
            sp.Ge(DEEP * (DEEP + 2 * GAP), 2 * DEEP * EDGE, evaluate=False),
        ),
    )


@cache
def from_above() -> Evidence:
    """The bound of w from above."""
    return argument(
        r"""
        $S$ is met by $\tau_1$. From ray to ray $1/y$ gains at least $\rho$, as $y-y'\geqslant r\,c^2$ after the first
        slip, $c/y$ falls with $y$, and $y\leqslant y_0$; it takes at most $\pi(1+2\sqrt q)$, but for slips that
        cross, of which there are at most $N$ in all. So the $n$-th exit is not after $\tau^*+(n+1)\,\pi(1+2\sqrt q)$,
        and $w$ never grows.
        """,
        kernel.step("contact"),
        identity(
            r"the bound of a stay, in units of $1/\Omega$, is $2\sqrt{(1+w)/r}$",
            first_contact_bound() ** 2,
            4 * (1 + w) / r,
        ),
        few_crossings,
        one_step,
    )


RHO, LATE_TIME, CONTACT, LOSS = symbols("rho tau^* tau_1 l", positive=True)
DEPTH = sp.Function("c")


def _contact_by() -> Expr:
    """Return the reduced time up to which S is met by what starts with w = q y0."""
    return first_contact_bound().subs(w, q * first_excess)


def _depths() -> dict[Basic, Basic]:
    """Return what the letters r and c(...) of the least loss stand for."""
    angle = 2 * sp.acot(q * (sqrt(first_excess) + pi / 2))
    return {R: share_of_q, DEPTH(angle): depth().subs(theta, angle)}


@theorem(
    "rate-with-error",
    clause(
        "error",
        r"""
        Let the pair leave $S_0$ by a ray at $\tau=\Omega t=0$ with $w_0=q\,y_0$, $y_0\leqslant(\pi/2-1)^2$. With
        «leading» and «weight», at the $n$-th exit after it, at $\tau_n$, $\frac{C}{w_n}+\pi
        B\ln\frac{w_n}{w_0}=\frac{C}{w_0}+\tau_n+R_n$ with «lower» and «upper» for all $n$.
        """,
        leading=of_share("C", 4 * pi * q / (9 * R), leading_coefficient),
        weight=of_share("B", 1 - 2 / (5 * R), logarithm_weight),
        lower=Formula("R_n", ">=", -Rational(9, 20) * (first_excess + sqrt(first_excess)) / R, bounds_error),
        upper=Formula("R_n", "<=", 5 * first_excess, bounds_error),
    ),
)
def rate_with_error() -> Case:
    """What one cycle adds to both sides of the law, enclosed and summed."""
    return because(
        r"""
        The next term of the $1/t$ law is a logarithm, and the remainder is bounded by the initial state alone. One
        cycle adds $\pi G-F$ to the remainder. Each of the two is at most a constant, the same for every mass ratio,
        times a difference that telescopes along the exits; so the sum is bounded.
        """,
        carried("error", kernel.step("law-with-error"), quotients),
    )


@theorem(
    "uniform-rate",
    clause(
        "one",
        r"Some $c_2$ that $E(0)$ alone fixes has $E(t)/E_{cr}-1\leqslant c_2/t$ for all $t>0$ along every trajectory that never merges.",
        kernel="uniform-upper-rate",
    ),
    clause(
        "upper",
        r"""
        Along every trajectory that starts with $w_0=q\,y_0>0$ and never merges, $w(\tau)\leqslant w_+$, «bound», with
        «gain», «late», «contact» and «loss», where $h(\theta_0)^2=y_0$, $c_0=c(\theta_0)$ and «count»: an upper bound
        that $E(0)$ alone fixes.
        """,
        bound=equal(
            "w_+",
            q / (1 / first_excess + RHO * sp.Max(0, (tau - LATE_TIME) / (pi * (1 + 2 * sqrt(q))) - 2)),
            upper_bound,
            lambda: {RHO: gain(), LATE_TIME: late()},
        ),
        gain=of_share(r"\rho", R * (first_depth / first_excess) ** 2, gain),
        late=equal(
            r"\tau^*",
            CONTACT + 2 * pi * sqrt(q) * crossings,
            late,
            lambda: {CONTACT: _contact_by()},
        ),
        contact=of_share(r"\tau_1", 2 * sqrt((1 + q * first_excess) / R), _contact_by),
        count=equal(
            crossings,
            sp.ceiling(first_excess / LOSS),
            crossings_bound,
            lambda: {LOSS: crossing_loss()},
        ),
        loss=equal(
            LOSS,
            2 * R / q * sp.Min(DEPTH(2 * sp.acot(q * (sqrt(first_excess) + pi / 2))), 1 / q),
            crossing_loss,
            _depths,
        ),
    ),
    clause(
        "lower",
        r"""
        No lower bound is fixed by $E(0)$: for every $w_0>0$ and $\delta>0$ there is a trajectory with $w(0)=w_0$ that
        never merges and has $w\leqslant\delta$ from $\tau_1$ on.
        """,
        kernel="no-uniform-lower-rate",
    ),
)
def uniform_rate() -> Case:
    """An upper bound that E(0) fixes; a family that shows that there is no lower one."""
    return because(
        """
        $E(0)$ fixes an upper bound of $E-E_{cr}$ over all trajectories that never merge, and no lower one. From above:
        $S$ is met within a bounded time, few slips cross, and every other cycle adds to $1/w$. From below: trajectories
        of one $E(0)$ may lose arbitrarily much of the excess $E(0)-E_{cr}$ in their first slip. For starts on $S_0$
        slightly above $E_{cr}$ both constants exist (rate-one-over-t).
        """,
        carried("upper", from_above),
    )
