"""Where every free motion goes: it meets the switching surface again and again, and the critical energy decides there."""

from paper_checks.claims.words import *


@cache
def meets_surface() -> Evidence:
    """A stay in one half-space lasts at most 2 sqrt(2 E m2)/b: body 2 accelerates steadily, its energy is bounded."""
    gained = Symbol("k", nonnegative=True)
    bounds = [2 * energy().subs(v2, speed) <= 2 * E0 for speed in (v2, v2 + gained)]
    return prove(
        r"in a stay in $\Omega_\pm$ $v_2$ gains at most $\sqrt{8E/m_2}$, at the constant rate $b/m_2$",
        bounds,
        m2 * gained**2 <= 8 * E0,
    )


@cache
def stays_below_critical() -> Evidence:
    """On S, E <= E_cr implies |x1| <= L: the pair can only stick, for ever, as E never increases."""
    level = signed(on_surface() - critical_energy(), "<=")
    inside = signed(x1**2 - half_width() ** 2, "<=")
    return prove(r"on $S$, $E\leqslant E_{cr}$ implies $|x_1|\leqslant L$", [level], inside)


@cache
def stick_is_a_motion() -> Evidence:
    """The closed form of stick solves the stick mode of (3), (4), and E is constant along it."""
    return identity(
        "stick, $x_1=x_{10}\\cos\\Omega t+\\cdots$, solves the stick mode of (3), (4), and $\\dot E=0$ along it",
        [*residual(solution("stick", DampingRegime.UNDAMPED)), undamped(stick_rate())],
    )


@cache
def mirror_image() -> Evidence:
    """(x, v) -> (-x, -v) takes one half-space's field to the other's: what is shown on one side holds on both."""
    turned = phi(-1).subs({x1: -x1, v1: -v1, v2: -v2}, simultaneous=True)
    return identity(
        r"""
        the mirror image $(x,v)\to(-x,-v)$ takes $\Phi_-$ to $\Phi_+$: the same holds with $\ell_-$, $\Omega_+$ and
        $\ell_+$, $\Omega_-$ exchanged
        """,
        -turned,
        phi(1),
    )
