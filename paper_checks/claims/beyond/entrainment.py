"""A periodic force: when the pair sticks for ever, stops twice a period, or never."""

from paper_checks.claims.beyond.response import natural_frequency
from paper_checks.claims.beyond.stuck import tends_to_stuck, undamped_stuck
from paper_checks.claims.beyond.two_stops import near_first, near_last, only_one
from paper_checks.claims.letters import MASS
from paper_checks.claims.words import *
from theory import forced_response as response
from theory.forced_response import decayed, decline, multiple, natural, omega, swing
from theory.scaling import stick_frequency


@cache
def below_non_stop() -> Evidence:
    """Whatever slips for ever by halves of the force's period makes a motion that is its own negative half a period later."""
    return argument(
        r"""
        Let $\dot z>0$ for half a period, $T/2=\pi/\omega$, and $\dot z<0$ for the next, and so on. Friction is the
        square wave then. If $a_1>0$ or $\omega_1/\omega$ is no integer, the motion is one of the period $T$ and a free
        oscillation of body 1, and the mean of its shifts by $T,2T,\ldots$ removes the latter: what remains has the same
        friction, $\dot z\geqslant 0$ and $\dot z\leqslant 0$. If $\omega_1/\omega$ is even it has the period $T$
        itself. Half of the difference between that and itself half a period later has the same friction and, as
        $u(t+T/2)=-u(t)$, the same force, and is its own negative half a period later. At its turn $\Lambda\geqslant b$,
        which needs $U\geqslant U_{**}$ whatever $\dot z$ does at $U_{**}$. For a motion of the period $T$ itself this
        is the kernel's theorem, whose condition $A>0$ is $-c_*>0$.
        """,
        *map(kernel.step, ("nonstop-by-halves-needs", "nonstop-damped", "nonstop-undamped")),
    )


@cache
def over_damped() -> Evidence:
    """The closed forms hold for a body 1 that does not oscillate."""
    return argument(
        r"""
        The steps are identities in $\lambda$ and $\omega_d$, so they hold for $\omega_d=i\nu$, where $\cos$ and
        $\frac{1}{\omega_d}\sin$ become $\cosh$ and $\frac1\nu\sinh$: real, and all terms of
        $1-\delta^2+2\delta\frac\lambda\nu\sinh\frac{\pi\nu}{\omega}$ and
        $1+2\delta\cosh\frac{\pi\nu}{\omega}+\delta^2$ positive. At $\omega_d=0$ they have limits, to which the
        conditions tend. That $U_{**}$ is the threshold above critical damping, too, is the kernel's theorem.
        """,
        below_non_stop,
        kernel.step("nonstop-overdamped"),
    )


@cache
def two_ends() -> Evidence:
    """Both ends of the branch of two stops."""
    first, second = response.short_slip()
    load_rate = Symbol(r"\dot{\Lambda}", real=True)
    return argument(
        r"""
        At $t_s=\pi/\omega$ the end is the next turn, $v_1=-v_0$. As $t_s\to 0$, $\dot z(t_s)/t_s^2\to\dddot
        z(0)/2=0$: the load is $b$ and turns there. A stuck motion that is its own negative half a period later is the
        stuck response, unless a free oscillation is so, too, which is $a_1=0$ and $\Omega$ an odd multiple of
        $\omega$; so the amplitude of its load is $b$, and its own is $U_*$.
        """,
        identity(
            r"where $\Lambda=b$, $\ddot z=0$ and $\dddot z=\kappa\dot\Lambda$",
            [first, second],
            [0, forced.coupling() * load_rate],
        ),
    )


GAIN, K, K_RATE = Symbol("G", positive=True), Symbol("k", real=True), Symbol("k'", real=True)
RINGING = Symbol("omega_d", positive=True)
WAVE = {K: response.square_place, K_RATE: response.square_speed}
TURN = pi * RINGING / omega
LEFT = 1 + 2 * decayed * cos(TURN) + decayed**2


def _gain() -> Expr:
    return 1 / sqrt(response.size_squared(response.slip_impedance()))


LIGHT = Scene(Pair(m1="0.1", m2=1, a1="0.02", a2=90, b="0.01"), State(), 1, force=Force.sine(1, 10))
"""A light damper, and a body 1 alone of three times the frequency of its force: U** is far above the amplitudes at which stops end."""


@cache
def six_turns() -> Evidence:
    """A motion that never stops, at an amplitude far below U**."""
    from numerics.control.response import Regime, response

    found = response(LIGHT, digits=4)
    turns = [leg.side for leg in found.orbit.legs] if found.orbit else []
    return enclosed(
        "the periodic motion of that pair slips in each of its six modes, with signs in turn",
        found.regime is Regime.NON_STOP and turns in ([1, -1] * 3, [-1, 1] * 3),
        f"{found.regime.value}; {found.attraction}; signs {turns}",
        engine="numerics, balls",
    )


def _above_six_turns() -> arb:
    """Return U** of that pair, N."""
    from numerics.control.thresholds import thresholds

    return thresholds(LIGHT.pair, 10).non_stop


@theorem(
    "entrainment-threshold",
    clause(
        "stuck",
        r"""
        Let $u=U\sin\omega t$ and $a_1>0$. Some motion sticks permanently exactly if $U\leqslant U_*$, «threshold». Then
        every motion tends to the stuck response, and if $U<U_*$, it sticks permanently after a finite time.
        """,
        threshold=equal(
            "U_*",
            b / (m2 * omega**2) * sqrt((a2 - MASS * omega**2) ** 2 + a1**2 * omega**2),
            response.entrained_amplitude,
        ),
        kernel="stuck-iff entrains synchronises",
    ),
    clause(
        "undamped",
        r"""
        For $a_1=0$ some motion sticks permanently exactly if $U\leqslant U_*$, «threshold», unless «pace» is an odd
        multiple of $\omega$. If $\Omega=n\omega$, $n=3,5,\ldots$, some do exactly if $U\leqslant U_n$, «harmonic», as a
        free oscillation flattens the peaks of $\ddot x_1$; if $\Omega=\omega$, none does for $U>0$.
        """,
        threshold=equal(
            "U_*",
            b / m2 * Abs(a2 / omega**2 - MASS),
            lambda: sqrt(sp.factor(response.entrained_amplitude().subs(a1, 0) ** 2)),
        ),
        pace=equal(r"\Omega", sqrt(a2 / MASS), stick_frequency),
        harmonic=equal(r"U_n/U_*", 1 / cos(pi / (2 * multiple)), response.harmonic_amplitude),
    ),
    clause(
        "undamped-approach",
        r"""
        For $a_1=0$ and $U<U_*$ every motion tends to one that sticks permanently, and the path of its slip is
        bounded: $\int_0^\infty|\dot z|\,dt\leqslant N^2/\bigl(2b\,(1-U/U_*)\bigr)$, with $N^2/2$ its energy
        distance from the stuck response at $t=0$.
        """,
        kernel="undamped-entrained",
    ),
    clause(
        "undamped-edge",
        "Without a damper every motion tends to one that sticks permanently wherever some motion does so, thus at $U=U_*$, too.",
    ),
    clause(
        "letters",
        """
        Let «decline», «ringing» (positive or imaginary) and «left». Body 1 alone has the gain «gain», and under a
        square wave of 1 N, where its sign changes to $1$, the position «place» and the velocity «speed».
        """,
        decline=equal(decline, a1 / (2 * m1), lambda: response.rates()[0]),
        ringing=equal(
            RINGING,
            sqrt(a2 / m1 - decline**2),
            lambda: response.rates()[1],
            lambda: {decline: response.rates()[0]},
        ),
        left=equal(decayed, sp.exp(-pi * decline / omega), response.left_after_half),
        gain=equal(GAIN, 1 / sqrt((a2 - m1 * omega**2) ** 2 + a1**2 * omega**2), _gain),
        place=equal(
            K,
            (2 * decayed * decline / RINGING * sin(TURN) - 1 + decayed**2) / (m1 * (decline**2 + RINGING**2) * LEFT),
            lambda: response.square_wave()[0],
            lambda: {RINGING: swing},
        ),
        speed=equal(
            K_RATE,
            -2 * decayed * sin(TURN) / (m1 * RINGING * LEFT),
            lambda: response.square_wave()[1],
            lambda: {RINGING: swing},
        ),
    ),
    clause(
        "non-stop",
        r"""
        Let $0<a_1^2<4m_1a_2$, or $a_1=0$ and $\omega_1$ be no odd multiple of $\omega$. If $\dot z>0$
        between the turns at $U=U_{**}$, the pair has a motion that slips without a stop, one way for half a period,
        and half a period later is its own negative, exactly if $U\geqslant U_{**}$, «threshold». For $a_1>0$ every
        motion then tends to it.
        """,
        threshold=equal(
            "U_{**}^2",
            b**2
            / (GAIN * omega) ** 2
            * ((pi / (2 * m2 * omega) - K_RATE) ** 2 + ((MASS / m2 - a2 * K - a1 * K_RATE) / (m1 * omega)) ** 2),
            response.non_stop_amplitude_squared,
            lambda: {GAIN: _gain(), **WAVE},
        ),
        kernel="nonstop-damped nonstop-undamped nonstop-attracts",
    ),
    clause(
        "halves",
        """
        A motion of the force's period that slips permanently, one way for half a period and then the other way, exists
        exactly if one that is its own negative half a period later does; each for some phase of the force.
        """,
        kernel="nonstop-by-halves",
    ),
    clause(
        "below",
        r"Under the same condition on $a_1$ and $\omega_1$, below $U_{**}$ no motion slips permanently, one way for half a period of the force and then the other way, whatever its own period is, whatever $\dot z$ does at $U_{**}$ and whether it is its own negative or not,",
    ),
    clause(
        "over-damped",
        r"and all that holds for $a_1^2>4m_1a_2$, too; for $a_1^2=4m_1a_2$ with the limits as $\omega_d\to 0$.",
    ),
    clause(
        "more-turns",
        r"""
        A motion that turns more often may need less. For $m_1=0.1$, $m_2=1$, $a_1=0.02$, $a_2=90$, $b=0.01$ and
        $\omega=10$, with «threshold» N, every motion tends at $U=1$ N to one that never stops and turns six times in
        each period: so none of this period has two stops.
        """,
        threshold=decimal("U_{**}", "5.1814", _above_six_turns),
    ),
    clause(
        "non-stop-undamped",
        r"For $a_1=0$, «natural» no odd multiple of $\omega$: «threshold»; and for $\omega>\omega_1$ that is so without the condition.",
        natural=natural_frequency(),
        threshold=equal(
            "U_{**}^2",
            b**2
            / omega**4
            * (natural**2 - omega**2) ** 2
            * ((omega / natural * sp.tan(pi * natural / (2 * omega)) + pi * m1 / (2 * m2)) ** 2 + (MASS / m2) ** 2),
            response.undamped_non_stop_amplitude_squared,
        ),
        kernel="nonstop-undamped nonstop-above-resonance",
    ),
    clause(
        "two-stops",
        r"""
        In between: let $u=U_{\sin}\sin\omega t+U_{\cos}\cos\omega t$ from an exit $(x_0,v_0)$ on, and a slip of sign
        1 last for $t_s<\pi/\omega$. The conditions «exit» at the exit, «end» at $t_s$, and $(x_1,v_1)=-(x_0,v_0)$ at
        $\pi/\omega$ are linear in $x_0,v_0,U_{\sin},U_{\cos}$. A solution of them is a motion with two stops of amplitude
        $U=\sqrt{U_{\sin}^2+U_{\cos}^2}$ that is its own negative half a period later exactly if $\dot z>0$ in the
        slip and $|\Lambda|\leqslant b$ in the stick.
        """,
        exit=equal(
            r"U_{\cos}-a_1v_0-a_2x_0",
            b * MASS / m2,
            lambda: (
                response.cosine_part
                - a1 * response.exit_speed
                - a2 * response.exit_place
                - MASS / m2 * response.two_stop_conditions()[0]
            ),
        ),
        end=equal(
            "v_1",
            response.exit_speed + b / m2 * response.slip_length,
            lambda: response.end_speed - response.two_stop_conditions()[1],
        ),
        kernel="two-stop-exists two-stop-needs",
    ),
    clause(
        "two-ends",
        r"Let $a_1>0$, or neither $\Omega$ nor $\omega_1$ be an odd multiple of $\omega$. As $t_s\to\pi/\omega$ these conditions become those of $U_{**}$, with «last»; as $t_s\to 0$ the load only touches $b$, which is $U_*$.",
        last=equal(
            "v_0",
            -pi * b / (2 * m2 * omega),
            lambda: response.exit_speed + response.two_stop_conditions()[2] / 2,
        ),
    ),
    clause(
        "near-ends",
        r"""
        Then all $U$ slightly above $U_*$ have a motion with two stops and short slips; and all slightly below $U_{**}$ have
        one with two stops and short sticks, if at $U_{**}$ $\dot z>0$ between the turns and $\dot\Lambda>0$ at the first one.
        """,
    ),
    clause(
        "only-one",
        r"""
        Where a motion with two stops exists, every motion tends to it, and no other has the force's period, if $a_1>0$,
        or if $a_1=0$ and not both $\omega_1t_s\in 2\pi\mathbb Z$ and $\Omega\,(\pi/\omega-t_s)\in\pi\mathbb Z$.
        """,
    ),
    open=(
        "At which amplitudes further from both thresholds motions with two stops exist (at that of the example above there is none), and from which on those that slip permanently and turn at other times than after each half period of the force.",
    ),
    assuming=f"{POSITIVE} A sine $u(t)$ on body 1; $a_1\\geqslant 0$, as each part states.",
)
def entrainment_threshold() -> Case:
    """Stuck, two stops, and no stop."""
    return because(
        "The amplitude up to which the pair can stick permanently has a closed form, and so has that below which no motion of the force's period slips permanently with two reversals. Without a damper a stuck motion above the first one exists exactly where the stuck pair's own frequency is an odd multiple of the force's, from the third on.",
        carried("undamped", undamped_stuck),
        carried("letters"),
        carried("below", below_non_stop),
        carried("over-damped", over_damped),
        carried("more-turns", six_turns, kernel.step("periodic-response")),
        carried("undamped-edge", tends_to_stuck),
        carried("two-ends", two_ends),
        carried("near-ends", near_first, near_last),
        carried("only-one", kernel.step("periodic-response"), only_one),
    )
