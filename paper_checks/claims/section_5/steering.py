"""Section V: control through the interface: damping, tracking, an interface that varies."""

from paper_checks.claims.beyond import tolerance
from paper_checks.claims.letters import S, either_sign
from paper_checks.claims.words import *

LIPSCHITZ = Symbol("ell", positive=True)
APART = {b: 2, forced.b_other: 1, v1: 1, v2: 0, v1_other: 3, v2_other: 0}
"""Two slips forwards, the slower one where friction is larger (N, m/s)."""


@claim(
    "driven-body-steered",
    "V",
    "V, first paragraph",
    HOLDS,
    clause(
        "unbounded",
        r"""
        The moved passive body has an unbounded motion space, and with it such an underactuated system could be
        controlled, the motion variables of interest being $(x_2,\dot x_2)$,
        """,
        kernel="literal-transfer literal-reference",
    ),
    clause(
        "source",
        r"when the active body appears as a single (external) energy source: «rate».",
        rate=equal(
            r"\dot E",
            u * v1 - a1 * v1**2 - b * sigma * (v1 - v2),
            forced.energy_rate,
        ),
        kernel="forced-energy-rate",
    ),
)
def driven_body_steered() -> Case:
    """Where body 2 can be brought, and what pays for it."""
    return because(
        """
        Body 2 can be brought from rest to rest over any distance, by a force on body 1 alone, under (3)–(4) and under
        Coulomb's law (in exactly the minimum time by a stuck pair: under the latter only). All energy comes from that
        force: damper and interface only dissipate.
        """,
        reading(
            "could be controlled, the motion variables of interest being $(x_2,\\dot x_2)$",
            "some force takes $(x_2,\\dot x_2)$ from $(y,0)$ to $(y+D,0)$ in each time $T>2\\sqrt{m_2|D|/b}$, for all $y$ and $D$, and along each absolutely continuous $\\dot x_2(t)$ with, both from $v_1=v_2$, $|\\ddot x_2|<b/m_2$ at almost every time",
        ),
        carried("source"),
    )


SINE = Scene(Pair(1, 1, 1, 1, 1), State(x2="-1/4", v2="-1/4"), until=60, force=Force.sine("1/2", 1))
"""A pair under u = sin(t)/2 N; body 2 starts with the place and the velocity of the stuck response, body 1 at rest."""


PLACE = -(sin(t) + cos(t)) / 4
"""That response, m: unit masses, a1 = a2 = b = 1 in SI units."""


@claim(
    "damping-for-tracking",
    "V",
    "V, third bullet",
    CORRECTED,
    r"A purposefully controlled viscous damping of the active body can be purposefully used for trajectory tracking, cf. Fig. 1.",
    correction=(
        clause(
            "approach",
            r"With a constant $a_1>0$ and a force that is bounded any two motions approach each other in $(x_1,v_1,v_2)$:",
            kernel="forced-approach",
        ),
        clause(
            "velocity",
            r"so under the force of trackable-references, if bounded, the velocity of every motion tends to that of the reference: $v_1$ and $v_2$ track it, and $x_1$ does except for the $\gamma$ of that force.",
            kernel="tracks",
        ),
        clause(
            "controlled",
            r"With a damper $a_1(t)\geqslant 0$, continuous from the right, that is itself controlled in time, and a force that is continuous from the right, two motions never move apart in the energy norm.",
            kernel="controlled-contraction",
        ),
        clause(
            "controlled-approach",
            r"If $0<\alpha\leqslant a_1(t)\leqslant A$ besides and the force is bounded, every motion tends to each one that is bounded, in the energy norm.",
            kernel="controlled-approach",
        ),
        clause(
            "damper",
            r"""
            A damper whose force on body 1 does not fall with the speed keeps the flow non-expansive, too
            (friction-in-any-direction). One that depends on $x_1$ need not: two motions in which friction is the same have
            «apart», which is positive where the faster one has the weaker damper, and by enough.
            """,
            apart=equal(
                r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                -(a1 * v1 - forced.a1_other * v1_other) * (v1 - v1_other),
                forced.place_dependent_damper_rate,
            ),
        ),
        clause(
            "place",
            r"The position $x_2$ does not: a motion that differs only in $x_2(0)$ keeps that difference permanently,",
            kernel="displacement-unseen forced-well-posed",
        ),
        clause(
            "offset",
            r"and one that starts with the position and the velocity of the reference, but with another motion of body 1, can keep an offset.",
            kernel="keeps-offset forced-well-posed",
        ),
    ),
)
def damping_for_tracking() -> Case:
    """What a damper adds to the force under which the stuck pair follows a reference, and what it leaves."""
    apart = solved(SINE).sol(SINE.until)[2] - ball(PLACE.subs(t, Rational(SINE.until)))
    return because(
        rf"""
        {rounded(1000 * abs(apart), 1)} mm of a reference of 354 mm stay between body 2 and its place in the counterexample: its
        velocity tracks, its position may keep an offset. With a damper and a bounded force every motion approaches, in
        $(x_1,v_1,v_2)$, the one that follows the reference (trackable-references), though not always sooner
        (damping-can-desynchronise); without a damper a free oscillation may persist. The damper costs
        $a_1\dot x_{{\mathrm{{ref}}}}$ in that force. All this is for forces that are given in time, none of which depends on
        $x_2$; one that depends on the motion may act against it.
        """,
        counterexample(
            (
                "$m_1=m_2=a_1=a_2=b=1$, $u=\\frac12\\sin t$, $x_{\\mathrm{ref}}=-\\frac14(\\sin t+\\cos t)$, $x_2(0)=x_{\\mathrm{ref}}(0)$, "
                "$v_2(0)=\\dot x_{\\mathrm{ref}}(0)$, body 1 at rest at $0$: after 60 s $v_2$ is right to $10^{-6}$ m/s, and $x_2-x_{\\mathrm{ref}}=$ "
                f"${rounded(1000 * apart, 1)}$ mm, where $x_{{\\mathrm{{ref}}}}$ has the amplitude 354 mm."
            ),
            kernel.step("keeps-offset"),
            compare(
                "after 60 s body 2 is far from the position of the reference (m)",
                abs(apart),
                ">",
                point(Rational(1, 4)),
            ),
        ),
        carried(
            "damper",
            kernel.step("system-contraction"),
            kernel.step("pair-inclusion"),
            exhibit(
                "the faster motion has half the damper, and the distance grows",
                {a1: 1, forced.a1_other: 2, v1: 3, v1_other: 2},
                (forced.place_dependent_damper_rate(), ">", 0),
            ),
        ),
        carried("place", tolerance.blind_to_x2),
    )


@claim(
    "varying-interface",
    "V",
    "V, sixth bullet",
    CORRECTED,
    r"""
    The effect of the time- and state-varying behaviour of the frictional interface, i.e. $b(\cdot)$, on the motion
    dynamics poses an interesting open problem.
    """,
    correction=(
        clause(
            "time",
            r"""
            For every $b(t)\geqslant 0$ that is the right derivative of a continuous function, for example constant on
            pieces of time, finitely many in every bounded time interval, there is one solution from every initial state,
            and the flow is non-expansive, with «contraction» where both frictions have a right derivative;
            """,
            contraction=equal(
                r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                -a1 * (v1 - v1_other) ** 2 - b * (sigma - sigma_other) * (v1 - v2 - v1_other + v2_other),
                forced.contraction_rate,
            ),
            kernel="interface-well-posed interface-contraction interface-distance-rate interface-one-strength",
        ),
        clause(
            "rule",
            r"where $b>0$ is constant for a while from a contact on, the mode rule is unchanged, with that value.",
            kernel="interface-rule",
        ),
        clause(
            "state",
            r"""
            Where $b$ depends on position, non-expansiveness is lost: for two slips of one sign $s$ under $b$ and
            $\tilde b$, $a_1=0$, it becomes «rate», which can be positive.
            """,
            rate=Formula(
                r"\tfrac{1}{2}\tfrac{d}{dt}N^2",
                "=",
                -(b - forced.b_other) * S * (v1 - v2 - v1_other + v2_other),
                either_sign(forced.place_dependent_rate),
            ),
        ),
        clause(
            "unique",
            r"""
            There is still one motion from every initial state where $b\geqslant 0$ depends on $x_1$, $z$ and $|\dot z|$ with
            bounded slopes. If $|b-\tilde b|\leqslant\ell\,|x_1-\tilde x_1|$, $N(t)\leqslant e^{\gamma t}N(0)$ with «place». For $b$ that depends on $z$ the same holds with $(z-\tilde
            z)^2$ added to $N^2$ and another $\gamma$, and for $b(|\dot z|)$ that falls by at most $\ell$ times the
            increase of the speed with «speed»: where $b$ does not fall with the speed, $\ell=0$, $N$ never grows.
            """,
            place=equal(
                r"\gamma",
                LIPSCHITZ * sqrt((m1 + m2) / (m1 * m2 * a2)),
                lambda: forced.growth_by_place(LIPSCHITZ),
            ),
            speed=equal(
                r"\gamma",
                LIPSCHITZ * (m1 + m2) / (m1 * m2),
                lambda: forced.growth_by_speed(LIPSCHITZ),
            ),
            kernel="state-well-posed growth-by-place growth-by-state growth-by-speed",
        ),
        clause(
            "synchronises",
            r"As long as $b$ stays between some $b_{\min}>0$ and some $b_{\max}$, whatever it depends on, $\dot E\leqslant-b_{\min}|\dot z|$ for $u=0$: $\dot z\to 0$, and $z$ has a limit.",
            kernel="interface-synchronises",
        ),
    ),
    open=(
        "The long-run motion for a friction that varies with time or place (which motions merge, how fast the others converge) is not decided here.",
    ),
)
def varying_interface() -> Case:
    """b(t) keeps the contraction; b(x) does not."""
    rate = forced.place_dependent_rate(1)
    return because(
        """
        Part of the problem is not open: with a friction that varies in time each initial state has one motion, and the
        flow is non-expansive. With a friction that varies with the state two motions may separate, but if it varies
        without jumps, with bounded slopes, each initial state still has one motion; and without a force, friction that
        stays above some positive value, whatever it depends on, brings every relative motion to rest. How it does so is
        known for a friction that depends on the speed of slip: see static-friction-stops-creeping.
        """,
        counterexample(
            "For $b(t)\\geqslant 0$ with a continuous integral this much of the effect is known: from every initial state there is one solution, and the flow is non-expansive in the norm $N^2=a_2(x_1-\\tilde x_1)^2+m_1(v_1-\\tilde v_1)^2+m_2(v_2-\\tilde v_2)^2$.",
            kernel.step("interface-well-posed"),
            kernel.step("interface-contraction"),
        ),
        carried(
            "state",
            exhibit(
                "both slip forwards; the slower pair has the larger friction, and their distance grows",
                APART,
                (rate, ">", 0),
                (v1 - v2, ">", 0),
                (v1_other - v2_other, ">", 0),
            ),
            identity(
                r"where both frictions are equal this is the contraction's friction term of two slips of one sign: 0",
                rate.subs(forced.b_other, b),
            ),
        ),
    )
