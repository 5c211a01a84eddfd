"""Where every free motion goes: it meets the switching surface again and again, and the critical energy decides there."""

from paper_checks.claims.letters import in_strip, past_edge
from paper_checks.claims.section_3 import energy as dissipation
from paper_checks.claims.section_3 import filippov
from paper_checks.claims.words import *
from theory.energy import dwell_time_bound, energy


def energy_decreases() -> Steps:
    """E never increases, and falls wherever the bodies slide."""
    return dissipation.energy_rate(), dissipation.energy_never_grows()


def contraction() -> Steps:
    """Two solutions never move apart: forward uniqueness, continuity in the start, stability of every orbit."""
    return filippov.contraction(), filippov.never_apart()


@cache
def meets_surface() -> Steps:
    """A stay in one half-space lasts at most 2 sqrt(2 E m2)/b: body 2 accelerates steadily, its energy is bounded."""
    gained = Symbol("k", nonnegative=True)  # v2 gained during the stay
    bounds = [m2 * speed**2 <= 2 * E0 for speed in (v2, v2 + gained)]
    return (
        identity(r"$\dot v_2=\pm b/m_2$ in $\Omega_\pm$", [phi(1)[2], phi(-1)[2]], Matrix([b, -b]) / m2),
        prove(r"$m_2v_2^2\leqslant 2E$", [2 * energy() <= 2 * E0], m2 * v2**2 <= 2 * E0),
        prove(r"so $v_2$ can gain at most $\sqrt{8E/m_2}$", bounds, m2 * gained**2 <= 8 * E0),
        identity(
            r"a stay in $\Omega_\pm$ lasts at most $2\sqrt{2Em_2}/b$", dwell_time_bound(), 2 * sqrt(2 * E0 * m2) / b
        ),
    )


@cache
def stays_below_critical() -> Evidence:
    """On S, E <= E_cr implies |x1| <= L: the pair can only stick, for ever, as E never increases."""
    level = signed(on_surface() - critical_energy(), "<=")
    inside = signed(x1**2 - half_width() ** 2, "<=")
    return prove(r"on $S$, $E\leqslant E_{cr}$ implies $|x_1|\leqslant L$", [level], inside)


@cache
def leaves_above_critical() -> Steps:
    """No trajectory stays on S with E > E_cr: outside S0 both fields leave, in S0 the level reaches an exit ray."""
    above = signed(on_surface() - critical_energy(), ">")
    leaving = (signed(transversality(sign), "<") for sign in (1, -1))
    return (
        prove(
            r"in $S_0$ with $E>E_{cr}$: $v_1\neq 0$, so $x_1$ moves monotonically to an edge",
            [above, *in_strip()],
            sp.Ne(v1, 0, evaluate=False),
        ),
        prove(
            r"$\Phi_\pm\cdot n_S<0$ on $S_+$ (on $S_-$ by the mirror image): no stay on $S$ outside $S_0$",
            [past_edge(1)],
            And(*leaving),
        ),
    )


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
