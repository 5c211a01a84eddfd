"""Section III, the model as a Filippov system: equivalence, fields, energy rates."""

from __future__ import annotations

import sympy as sp

from paper_checks.checks.registry import Context, check
from paper_checks.engines.exact import identity
from paper_checks.evidence.evidence import Evidence, argument
from paper_checks.evidence.finding import Finding, Verdict, carried, conclude
from paper_checks.evidence.formula import latex
from paper_checks.ledger import claim_named
from paper_checks.solvers.polynomial import cleared
from paper_checks.solvers.smt import prove
from paper_checks.steps import solutions
from theory.energy import slip_rate
from theory.filippov import half_width, load_threshold, phi, sliding_field, transversality
from theory.model import branches, free_system, slip, stick
from theory.symbols import a1, a2, b, free, m1, m2, undamped, v1, x1


def printed_field(sign: int) -> sp.ImmutableMatrix:
    """Return Phi_+ (sign 1) or Phi_- (sign -1) as the paper prints it."""
    return sp.ImmutableMatrix([v1, -a2 / m1 * x1 - sign * b / m1, sign * b / m2])


@check("vector-fields")
def vector_fields(context: Context, printed=printed_field) -> Finding:  # type: ignore[no-untyped-def]
    """Compare the printed components with the slip branches of (3), (4)."""
    evidence = [
        identity(
            f"$\\Phi_{name}$ is the slip branch of (3), (4) in $\\Omega_{name}$",
            phi(sign),
            printed(sign),
            seed=context.seed,
        )
        for name, sign in (("-", -1), ("+", 1))
    ]
    jump = identity(
        r"$\Phi_+-\Phi_-=(0,-2b/m_1,2b/m_2)\neq 0$: discontinuous on $S$",
        phi(1) - phi(-1),
        sp.ImmutableMatrix([0, -2 * b / m1, 2 * b / m2]),
        seed=context.seed,
    )
    return conclude(
        Verdict.HOLDS,
        "Solving (3) and (4) for the accelerations with the sign of the relative velocity put to 1 and to -1 gives the "
        "printed components; they jump across the switching surface.",
        carried("fields", *evidence),
        carried("jump", jump),
        derivation=tuple(f"$$\\Phi_{name}={latex(phi(sign).T)}$$" for name, sign in (("-", -1), ("+", 1))),
    )


@check("filippov-equivalence")
def filippov_equivalence(context: Context) -> Finding:
    """Compare the two systems off S, inside S0, and on the rest of S."""
    literal = undamped(free_system(sp.Integer(0)))
    adhesion = sp.Lt(cleared(undamped(stick().field)[1] ** 2 - (b / m2) ** 2), 0, evaluate=False)
    inside = sp.Lt(cleared(x1**2 - half_width() ** 2), 0, evaluate=False)
    spurious = [one for one in branches() if one.name in ("half adhesion", "broken adhesion")]
    off_surface = [
        identity(
            f"off $S$ the field of (3), (4) with $a_1=u=0$ is that of (5)–(7), sign {sign:+d}",
            undamped(slip(sign).field),
            undamped(free_system(sp.Integer(sign))),
            seed=context.seed,
        ).as_correction()
        for sign in (1, -1)
    ]
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "Read with the three-valued signum of eq. (1), which the text prefers, (5)–(7) has no solution through the "
        "interior of $S_0$ with $x_1\\neq 0$; read in Filippov's sense, as Section III does, it has the same solutions as "
        "(2)–(4). With sgn(0) = 0 a solution would have to stay on $S$, but its accelerations differ there. On $S$ outside "
        "the open strip the right sides of (3)–(4) and of Filippov's system differ too, at isolated instants only.",
        *off_surface,
        identity(
            "on $S_0$ the adhesion branch of (3), (4) is Filippov's sliding field",
            undamped(stick().field),
            sliding_field(),
            seed=context.seed,
        ).as_correction(),
        prove("adhesion, $|\\ddot x_1|<b/m_2$, implies $|x_1|<L$", [adhesion], inside).as_correction(),
        prove("$|x_1|<L$ implies adhesion, $|\\ddot x_1|<b/m_2$", [inside], adhesion).as_correction(),
        *(_leaves_surface(one, context).as_correction() for one in spurious),
        solutions.spurious_branches_leave().as_correction(),
        solutions.edge_is_isolated().as_correction(),
        identity(
            "with sgn(0) = 0 in (5)–(7), $\\dot v_1-\\dot v_2=-a x_1/m_1$ on $S$: not 0 where $x_1\\neq 0$",
            literal[1] - literal[2],
            -a2 * x1 / m1,
            seed=context.seed,
        ).as_counterexample(),
        prove(
            r"nor can it leave $S$ there: $\Phi_+\cdot n_S<0<\Phi_-\cdot n_S$ where $|x_1|<L$",
            [inside],
            sp.And(*(sp.Lt(cleared(sign * transversality(sign)), 0, evaluate=False) for sign in (1, -1))),
        ).as_counterexample(),
        corrected=claim_named("filippov-equivalence").corrected,
        counterexample="$m_1=m_2=1$, $a=200$, $b=0.5$, $x_1=0.004$, $v_1=v_2=0$: (3)–(4) sticks; (5)–(7) with "
        "sgn(0) = 0 asks for $\\dot v_1=-0.8$, $\\dot v_2=0$ on $S$ and for a return to $S$ off it.",
        derivation=(
            "A solution of (3)–(4) spends almost every instant of $\\{t:\\dot z=0\\}$ with $\\ddot z=0$, so only a branch "
            "with $\\ddot x_1=\\ddot x_2$ can last: adhesion, which is Filippov's sliding field.",
            f"$$\\text{{sliding field}}={latex(sliding_field().T)}$$",
            "Conversely the Filippov solution slides only in $S_0$, and at $|x_1|=L$ only at isolated times, where "
            "$v_1\\neq 0$ or $\\ddot x_1\\neq 0$.",
        ),
    )


def _leaves_surface(branch, context: Context) -> Evidence:  # type: ignore[no-untyped-def]
    """Return that a spurious branch has x1'' - x2'' a nonzero multiple of x1'': it cannot last on S."""
    share = {"half adhesion": sp.Rational(1, 2), "broken adhesion": sp.Integer(1)}[branch.name]
    return identity(
        f"in the branch with {branch.name}, $\\ddot x_1-\\ddot x_2={latex(share)}\\,\\ddot x_1$",
        branch.acceleration1 - branch.acceleration2,
        share * branch.acceleration1,
        seed=context.seed,
    )


@check("viscous-no-direct-effect")
def viscous_no_direct_effect(context: Context) -> Finding:
    """Show that the sliding region and the adhesion force depend on a1."""
    from numerics.linear.exact_start import mode_at_start
    from numerics.linear.modes import Mode
    from numerics.scene import Pair, Scene, State
    from paper_checks.evidence.evidence import EvidenceKind

    start = State(x1="0.006", v1="-0.3", v2="-0.3")
    modes = [mode_at_start(Scene(Pair(m1=1, m2=1, a1=damping, a2=200, b="0.5"), start, until=1)) for damping in (0, 1)]
    example = Evidence(
        EvidenceKind.EXACT,
        "rational arithmetic",
        "at $x_1=0.006$, $v_1=v_2=-0.3$ ($m_1=m_2=1$, $a_2=200$, $b=0.5$) the pair slips with $a_1=0$ and sticks with $a_1=1$",
        modes == [Mode.SLIP_MINUS, Mode.STICK],
        2,
        ", ".join(mode.value for mode in modes),
    )
    force = stick().force_on_second
    return conclude(
        Verdict.HOLDS_CORRECTED,
        "The damper tilts the sliding region and so decides at which states the pair sticks: the force that adhesion needs "
        "contains $a_1$. That it is dissipative is right, and the friction force of slip does not contain $a_1$.",
        example.as_counterexample(),
        carried(
            "tilted-strip",
            argument(
                "Adhesion lasts where friction can give the force that it needs, at most $b$ in absolute value.",
                identity(
                    "adhesion needs the interface force $-m_2(a_2x_1+a_1v_1)/(m_1+m_2)$ on body 2 (at $u=0$)",
                    free(force),
                    -m2 * (a2 * x1 + a1 * v1) / (m1 + m2),
                    seed=context.seed,
                ),
                identity(
                    "the edge of $S_0$ is at the load $b(m_1+m_2)/m_2$",
                    load_threshold(),
                    b * (m1 + m2) / m2,
                    seed=context.seed,
                ),
            ).as_correction(),
        ),
        carried(
            "friction-of-slip",
            identity(
                "in slip the force on body 2 is $\\pm b$, without $a_1$",
                sp.Matrix([free(slip(sign).force_on_second) for sign in (1, -1)]),
                sp.Matrix([b, -b]),
                seed=context.seed,
            ).as_correction(),
            identity(
                "the damper changes $\\dot E$ by $-a_1v_1^2\\leqslant 0$",
                slip_rate(1) - undamped(slip_rate(1)),
                -a1 * v1**2,
                seed=context.seed,
            ).as_correction(),
        ),
        corrected=claim_named("viscous-no-direct-effect").corrected,
        counterexample="$m_1=m_2=1$, $a_2=200$, $b=0.5$, $x_1=0.006$, $v_1=v_2=-0.3$: $a_2x_1=1.2>1$ slips without the "
        "damper; with $a_1=1$ the load is $1.2-0.3=0.9<1$ and the pair sticks.",
        derivation=(f"$$f_{{\\text{{adhesion}}}}={latex(force)}$$",),
    )
