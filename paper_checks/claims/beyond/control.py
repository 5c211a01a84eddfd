"""What a force can make body 2 do: follow a reference, go from rest to rest in the least time."""

from paper_checks.claims.beyond import transfers
from paper_checks.claims.letters import MASS
from paper_checks.claims.words import *
from theory import forced_control as control
from theory.forced_control import angle, duration, path, strength, velocity_gain
from theory.scaling import stick_frequency

RESPONSE, SPREAD = Symbol("g", positive=True), Symbol("s", real=True)
HALF, PART = Symbol("t_{1/2}", positive=True), Symbol("xi", positive=True)
PLACE_START, PLACE_END = Symbol("{x_2(0)}", real=True), Symbol("{x_2(T)}", real=True)
RATE_START, RATE_END = Symbol("{v_2(0)}", real=True), Symbol("{v_2(T)}", real=True)
FIRST_ANGLE, SECOND_ANGLE, PACE = symbols("alpha_1 alpha_2 Omega", positive=True)


def _arcs() -> dict[Basic, Basic]:
    first, second = map(sp.acos, control.switching_cosines())
    return {FIRST_ANGLE: first, SECOND_ANGLE: second, PACE: stick_frequency()}


def _off_centre() -> Expr:
    """How far body 2 is from the middle of the places that it can reach."""
    middle = RATE_START * duration + control.middle().subs(velocity_gain, RATE_END - RATE_START)
    return PLACE_END - PLACE_START - middle


OFFSET = Symbol("gamma", real=True)
WAY, WAY_RATE, WAY_BEND = symbols(r"x_{\mathrm{ref}} \dot{x}_{\mathrm{ref}} \ddot{x}_{\mathrm{ref}}", real=True)
THEN, LATER = symbols("t_1 t_2", nonnegative=True)
RATE_THEN, RATE_LATER = symbols(r"\dot{x}_{\mathrm{ref}}(t_1) \dot{x}_{\mathrm{ref}}(t_2)", real=True)
REFERENCE = {WAY: control.r_place, WAY_RATE: control.r_speed, WAY_BEND: control.r_acceleration}
START = {PLACE_START: x2_0, RATE_START: v2_0}
FIRST_PLACE, WAY_START = Symbol("{x_1(0)}", real=True), Symbol(r"{x_{\mathrm{ref}}(0)}", real=True)


@claim(
    "one-active-one-passive",
    "Abstract",
    "abstract, sixth sentence; I, first paragraph",
    HOLDS,
    clause(
        "freedoms",
        r"The system has one active degree of freedom (the driving body) and one passive degree of freedom (the driven body).",
    ),
)
def one_active_one_passive() -> Case:
    """Where the force stands in the equations of motion."""
    field = forced.forced_system(sigma)
    return because(
        "The force acts on body 1 alone. Nothing but friction acts on body 2, and friction is at most b.",
        carried(
            "freedoms",
            identity(
                r"$u$ stands in the equation of body 1 alone",
                [diff(entry, u) * mass for entry, mass in zip(field, (1, m1, 1), strict=True)],
                [0, 1, 0],
            ),
            transfers.gentle,
        ),
        reading(
            "active",
            r"that $u$ stands in $m_1\dot v_1=u-a_1v_1-a_2x_1-b\sigma$, and “passive” as that it does not stand in $m_2\dot v_2=b\sigma$",
        ),
    )


@claim(
    "target-or-set-point",
    "I",
    "paragraph after Fig. 1",
    NOT_JUDGED,
    """
    A controlled motion along a target trajectory, or (even simpler) towards a set-point reference, remains largely
    unexplored for the manipulation of objects that are solely connected via a frictional interface.
    """,
)
def target_or_set_point() -> Case:
    """Which targets and which set-points there are."""
    return because(
        r"""
        Not judged: a statement about the literature. What it presupposes was checked: that such control exists, and
        that a set-point is the simpler task. From rest every set-point can be reached, in no less than
        $2\sqrt{m_2D/b}$, and held; a target trajectory can be followed exactly if it never requires more acceleration
        than $b/m_2$. At exactly $b/m_2$ this holds under Coulomb's law, but not under (3)–(4); below it, under both: see
        trackable-references and minimum-transfer-time.
        """,
    )


@theorem(
    "trackable-references",
    clause(
        "iff",
        r"""
        Let «place» and «speed». Under Coulomb's law, from a suitable initial state of body 1, some force makes body 2
        follow the velocity $\dot x_{\mathrm{ref}}$ exactly if «gentle» for all times $t_1$, $t_2$: no force achieves
        more.
        """,
        place=equal(r"x_{\mathrm{ref}}(0)", PLACE_START, lambda: control.followed_start()[0], lambda: START),
        speed=equal(r"\dot x_{\mathrm{ref}}(0)", RATE_START, lambda: control.followed_start()[1], lambda: START),
        gentle=sharp(
            Abs(RATE_THEN - RATE_LATER),
            "<=",
            b / m2 * Abs(THEN - LATER),
            lambda: (Abs(RATE_THEN - RATE_LATER), "<=", control.strongest() * Abs(THEN - LATER)),
        ),
        kernel="trackable driven-acceleration",
    ),
    clause(
        "literal",
        r"Under (3)–(4) a pair that sticks follows exactly those of them with $|\ddot x_{\mathrm{ref}}|<b/m_2$ at almost all times.",
        kernel="literal-reference",
    ),
    clause(
        "sticks",
        r"While «slower» the pair must stick. So where that holds at the start, $v_1(0)=v_2(0)$ is necessary.",
        slower=sharp(Abs(WAY_BEND), "<", b / m2, lambda: (Abs(WAY_BEND), "<", control.strongest())),
        kernel="must-stick",
    ),
    clause(
        "force",
        r"A pair that always sticks has $v_1(0)=v_2(0)$, and follows $x_{\mathrm{ref}}$ under one force only, «force» with «offset».",
        force=equal(
            "u",
            MASS * WAY_BEND + a1 * WAY_RATE + a2 * (WAY + OFFSET),
            lambda: control.stuck_force().subs(control.r_place, control.r_place + OFFSET),
            lambda: REFERENCE,
        ),
        offset=equal(
            OFFSET,
            FIRST_PLACE - WAY_START,
            control.stuck_offset,
            lambda: {FIRST_PLACE: x1_0, WAY_START: control.r_start},
        ),
    ),
    assuming=UNDER_A_FORCE,
)
def trackable_references() -> Case:
    """Friction is the only force on body 2."""
    return because(
        "Body 2 can follow exactly the references that require no more force than the interface can transmit. A pair that sticks follows each of them, under an explicit force.",
        carried("force"),
    )


@theorem(
    "minimum-transfer-time",
    clause(
        "reach",
        r"""
        Whatever the force, at the time $T$ body 2 has «within», where «spread» and $\Delta v_2=v_2(T)-v_2(0)$.
        """,
        within=sharp(
            Abs(PLACE_END - PLACE_START - duration / 2 * (RATE_START + RATE_END)),
            "<=",
            SPREAD,
            lambda: (Abs(_off_centre()), "<=", SPREAD),
        ),
        spread=equal(
            SPREAD,
            b / (4 * m2) * (duration**2 - (m2 * velocity_gain / b) ** 2),
            control.spread,
        ),
        kernel="reach",
    ),
    clause(
        "least",
        r"From rest to rest over $D>0$ it takes at least «time», and under Coulomb's law a pair that sticks at the limit, $|\Lambda|=b$, attains that.",
        time=equal("T", 2 * sqrt(m2 * path / b), control.least_time),
        kernel="least-time least-time-attained",
    ),
    clause(
        "literal",
        r"(3)–(4) do not have that motion (sgn-three-valued); under them a stuck pair achieves it in every longer time.",
        kernel="literal-reference literal-transfer",
    ),
    clause(
        "stuck",
        r"From $x_1(0)=0$ that stuck transfer, and staying there, needs $|u|$ up to the largest of «turn», «hold», and, if «late», of «peak».",
        turn=equal(
            "u_1",
            b * MASS / m2 + a1 * sqrt(b * path / m2) + a2 * path / 2,
            lambda: control.stuck_amplitudes()[0],
        ),
        hold=equal("u_2", a2 * path, lambda: control.stuck_amplitudes()[1]),
        late=sharp(a2**2 * path - a1**2 * b / m2, ">=", 0, lambda: (control.late_peak(), ">=", 0)),
        peak=equal(
            "u_3",
            a2 * path + a1**2 * b / (2 * a2 * m2) - b * MASS / m2,
            lambda: control.stuck_amplitudes()[2],
        ),
        kernel="stuck-transfer-amplitude",
    ),
    clause(
        "slip",
        r"""
        The pair may slip on the way. Let «half», and let $g$, the position of body 1 on its spring and damper after a
        unit impulse, be nondecreasing on $[0,t_{1/2}]$. From rest at $x_1=0$ body 2 can be at rest at $D$ at the time
        $2t_{1/2}$ under some $|u|\leqslant U$ exactly if $U\geqslant U_{\min}$, «least» with $g=g(t_{1/2})$. Under
        Coulomb's law body 1 can be at rest then, too, if the pair can stick at the limit through the second half under
        such a force.
        """,
        half=equal(HALF, sqrt(m2 * path / b), lambda: control.least_time() / 2),
        least=equal(
            r"U_{\min}",
            b + b * HALF / (m2 * RESPONSE),
            control.slipping_amplitude,
            lambda: {HALF: control.half_time},
        ),
        kernel="least-amplitude rest-to-rest",
    ),
    clause(
        "slip-undamped",
        r"For $a_1=0$, $\theta=\omega_1t_{1/2}$ and «rising» that is «undamped».",
        rising=sharp(angle, "<=", pi / 2, lambda: (angle, "<=", control.response_peak())),
        undamped=equal(r"U_{\min}", b + b * m1 / m2 * angle / sin(angle), control.undamped_slipping_amplitude),
        kernel="least-amplitude-undamped",
    ),
    clause(
        "weak",
        r"""
        For a weak force, $|u|\leqslant U$, $a_1=0$, «weak» and «held», «share», from rest at $x_1=0$ no such force breaks
        adhesion within $\pi/\Omega$, and to rest at $D$ it takes at least «span», «pace», with «first» and «second»: $u=U$ over the first
        angle, $-U$ over the second attain that.
        """,
        weak=sharp(
            3 * strength, "<=", b * MASS / m2, lambda: (control.pressed().subs(angle, pi), "<=", load_threshold())
        ),
        held=sharp(a2 * path, "<=", strength, lambda: (control.stuck_amplitudes()[1], "<=", strength)),
        share=equal(PART, a2 * path / strength, lambda: control.stuck_amplitudes()[1] / strength),
        span=equal("T_w", (FIRST_ANGLE + SECOND_ANGLE) / PACE, control.weak_time, _arcs),
        pace=equal(PACE, sqrt(a2 / MASS), stick_frequency),
        first=equal(
            r"\cos\alpha_1",
            1 - PART / 2 - PART**2 / 4,
            lambda: control.switching_cosines()[0],
            lambda: {PART: control.reduced},
        ),
        second=equal(
            r"\cos\alpha_2",
            (1 + PART / 2 + PART**2 / 4) / (1 + PART),
            lambda: control.switching_cosines()[1],
            lambda: {PART: control.reduced},
        ),
        kernel="weak-sticks weak-takes weak-attained",
    ),
    open=(
        "The minimum transfer time for forces between the weak ones and those that attain the bound, and for weak forces with $a_2D>U$ or with a damper.",
    ),
    assuming=UNDER_A_FORCE,
)
def minimum_transfer_time() -> Case:
    """A bound for every control, and what attaining it costs."""
    return because(
        "The minimum time is set by the interface alone, whatever the force. The force amplitude needed is another matter: if body 1 slips ahead of body 2 in the first half, and both have the same velocity at half time, less is needed than if the pair sticks all the way.",
        transfers.gentle,
    )
