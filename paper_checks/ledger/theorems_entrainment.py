"""Past the paper: the pair under u = U sin(omega t), stuck, with two stops in a period, or slipping without a stop."""

from __future__ import annotations

import sympy as sp

from paper_checks.engines.deciders import equals
from paper_checks.evidence.clause import Formula, clause
from paper_checks.ledger.theorem import theorem
from theory import forced_response as response
from theory.forced_response import decayed, decline, multiple, natural, omega, swing
from theory.scaling import stick_frequency
from theory.symbols import a1, a2, b, m1, m2, u, undamped

MASS = m1 + m2
GAIN, K, K_RATE = sp.Symbol("G", positive=True), sp.Symbol("k", real=True), sp.Symbol("k'", real=True)
RINGING = sp.Symbol("omega_d", positive=True)
WAVE = {K: response.square_place, K_RATE: response.square_speed}
SIGMA = sp.Symbol("sigma", real=True)
TURN = sp.pi * RINGING / omega
LEFT = 1 + 2 * decayed * sp.cos(TURN) + decayed**2


def _gain() -> sp.Expr:
    return 1 / sp.sqrt(response.size_squared(response.slip_impedance()))


OPEN = (
    "That each amplitude between $U_*$ and $U_{**}$ has just one motion with two stops, and that its conditions hold on the whole branch, is not proved.",
    "Motions that slip for ever, half a period each way, and have another period than the force are not treated for $a_1=0$.",
)


def _natural() -> Formula:
    """The frequency of body 1 alone without a damper."""
    return Formula(natural, "=", sp.sqrt(a2 / m1), equals(lambda: undamped(response.rates()[1])))


RESONANCE = theorem(
    "forced-resonance-bound",
    clause(
        "rate",
        r"Let $a_1=0$, «natural», $u$ of period $T$, and $U_1$ its Fourier amplitude at $\omega_1$ ($0$ if $\omega_1T\notin 2\pi\mathbb Z$). "
        r"The amplitude $A=e^{-i\omega_1t}(v_1+i\omega_1x_1)$ has «rate», where $\sigma$ is the value of $\mathrm{sign}(\dot z)$.",
        natural=_natural(),
        rate=Formula(r"e^{i\omega_1t}\,\dot A", "=", (u - b * SIGMA) / m1, equals(response.amplitude_rate)),
    ),
    clause(
        "grows",
        r"If $U_1>U_{\mathrm{res}}$, «threshold», every motion grows: $|A(t)|\geqslant\rho t-A_0$ with «growth», $U=U_1$, and a constant $A_0$.",
        threshold=Formula(r"U_{\mathrm{res}}", "=", 4 * b / sp.pi, equals(response.resonant_amplitude)),
        growth=Formula(r"\rho", "=", (response.amplitude - 4 * b / sp.pi) / (2 * m1), equals(response.growth_rate)),
    ),
    clause("bounded", r"If $U_1<U_{\mathrm{res}}$, every motion is bounded."),
    clause(
        "sine",
        r"For $u=U\sin\omega t$ the amplitude $U_{**}$ of entrainment-threshold has this limit: «limit» as $\omega\to\omega_1$.",
        limit=Formula("U_{**}", "->", 4 * b / sp.pi, equals(response.resonant_non_stop_amplitude)),
    ),
    open=("What happens at $U_1=U_{\\mathrm{res}}$.",),
)

ENTRAINMENT = theorem(
    "entrainment-threshold",
    clause(
        "stuck",
        r"Let $u=U\sin\omega t$ and $a_1>0$. Some motion sticks for ever exactly if $U\leqslant U_*$, «threshold». Then every motion tends to the stuck "
        r"response, and if $U<U_*$, it sticks for ever after a finite time.",
        threshold=Formula(
            "U_*",
            "=",
            b / (m2 * omega**2) * sp.sqrt((a2 - MASS * omega**2) ** 2 + a1**2 * omega**2),
            equals(response.entrained_amplitude),
        ),
        kernel=("stuck-iff", "entrains", "synchronises"),
    ),
    clause(
        "undamped",
        r"For $a_1=0$ some motion sticks for ever exactly if $U\leqslant U_*$, «threshold», unless «pace» is an odd multiple of $\omega$. If "
        r"$\Omega=n\omega$, $n=3,5,\ldots$, some do exactly if $U\leqslant U_n$, «harmonic», as a free oscillation flattens the peaks of $\ddot x_1$; if "
        r"$\Omega=\omega$, none does for $U>0$.",
        threshold=Formula(
            "U_*",
            "=",
            b / m2 * sp.Abs(a2 / omega**2 - MASS),
            equals(lambda: sp.sqrt(sp.factor(response.entrained_amplitude().subs(a1, 0) ** 2))),
        ),
        pace=Formula(r"\Omega", "=", sp.sqrt(a2 / MASS), equals(stick_frequency)),
        harmonic=Formula(r"U_n/U_*", "=", 1 / sp.cos(sp.pi / (2 * multiple)), equals(response.harmonic_amplitude)),
    ),
    clause(
        "letters",
        r"Let «decline», «ringing» (positive or imaginary) and «left». Body 1 alone has the gain "
        r"«gain», and under a square wave of 1 N, where its sign turns to $1$, the place and the velocity «place» and «speed».",
        decline=Formula(decline, "=", a1 / (2 * m1), equals(lambda: response.rates()[0])),
        ringing=Formula(
            RINGING,
            "=",
            sp.sqrt(a2 / m1 - decline**2),
            equals(lambda: response.rates()[1], lambda: {decline: response.rates()[0]}),
        ),
        left=Formula(decayed, "=", sp.exp(-sp.pi * decline / omega), equals(response.left_after_half)),
        gain=Formula(GAIN, "=", 1 / sp.sqrt((a2 - m1 * omega**2) ** 2 + a1**2 * omega**2), equals(_gain)),
        place=Formula(
            K,
            "=",
            (2 * decayed * decline / RINGING * sp.sin(TURN) - 1 + decayed**2) / (m1 * (decline**2 + RINGING**2) * LEFT),
            equals(lambda: response.square_wave()[0], lambda: {RINGING: swing}),
        ),
        speed=Formula(
            K_RATE,
            "=",
            -2 * decayed * sp.sin(TURN) / (m1 * RINGING * LEFT),
            equals(lambda: response.square_wave()[1], lambda: {RINGING: swing}),
        ),
    ),
    clause(
        "non-stop",
        r"Let $0<a_1^2<4m_1a_2$, or $a_1=0$ and $\omega_1$ be no odd multiple of $\omega$. If $\dot z$ keeps its sign between the turns at $U=U_{**}$, the pair has a motion that slips without a stop, one way for half a "
        r"period, and half a period later is its own negative, exactly if $U\geqslant U_{**}$, «threshold». For $a_1>0$ every motion then tends to it.",
        threshold=Formula(
            "U_{**}^2",
            "=",
            b**2
            / (GAIN * omega) ** 2
            * ((sp.pi / (2 * m2 * omega) - K_RATE) ** 2 + ((MASS / m2 - a2 * K - a1 * K_RATE) / (m1 * omega)) ** 2),
            equals(response.non_stop_amplitude_squared, lambda: {GAIN: _gain(), **WAVE}),
        ),
        kernel=("nonstop-damped", "nonstop-undamped", "nonstop-attracts"),
    ),
    clause(
        "halves",
        r"A motion of the force's period that slips for ever, one way for half a period and then the other way, exists exactly if one "
        r"that is its own negative half a period later does; each for some phase of the force.",
        kernel=("nonstop-by-halves",),
    ),
    clause(
        "below",
        r"Below $U_{**}$ no motion of the force's period slips for ever, one way for half a period and then the other way, whatever $\dot z$ does at $U_{**}$ and whether it is its own negative or not,",
    ),
    clause(
        "over-damped",
        r"and all that holds for $a_1^2>4m_1a_2$, too; for $a_1^2=4m_1a_2$ with the limits as $\omega_d\to 0$.",
    ),
    clause(
        "non-stop-undamped",
        r"For $a_1=0$, «natural» no odd multiple of $\omega$: «threshold»; and for $\omega>\omega_1$ $\dot z$ does keep its sign.",
        natural=_natural(),
        threshold=Formula(
            "U_{**}^2",
            "=",
            b**2
            / omega**4
            * (natural**2 - omega**2) ** 2
            * (
                (omega / natural * sp.tan(sp.pi * natural / (2 * omega)) + sp.pi * m1 / (2 * m2)) ** 2
                + (MASS / m2) ** 2
            ),
            equals(response.undamped_non_stop_amplitude_squared),
        ),
        kernel=("nonstop-undamped", "nonstop-above-resonance"),
    ),
    clause(
        "two-stops",
        r"In between: let $u=U_{\sin}\sin\omega t+U_{\cos}\cos\omega t$ from an exit $(x_0,v_0)$ on, and a slip of sign 1 last for $t_s<\pi/\omega$. The conditions «exit» "
        r"at the exit, «end» at $t_s$, and $(x_1,v_1)=-(x_0,v_0)$ at $\pi/\omega$ are linear in $x_0,v_0,U_{\sin},U_{\cos}$. Their solution is a motion of amplitude "
        r"$U=\sqrt{U_{\sin}^2+U_{\cos}^2}$ that is its own negative half a period later exactly if $\dot z>0$ in the slip and $|\Lambda|\leqslant b$ in the stick.",
        exit=Formula(
            r"U_{\cos}-a_1v_0-a_2x_0",
            "=",
            b * MASS / m2,
            equals(
                lambda: (
                    response.cosine_part
                    - a1 * response.exit_speed
                    - a2 * response.exit_place
                    - MASS / m2 * response.two_stop_conditions()[0]
                )
            ),
        ),
        end=Formula(
            "v_1",
            "=",
            response.exit_speed + b / m2 * response.slip_length,
            equals(lambda: response.end_speed - response.two_stop_conditions()[1]),
        ),
        kernel=("two-stop-exists", "two-stop-needs"),
    ),
    clause(
        "two-ends",
        r"As $t_s\to\pi/\omega$ these conditions become those of $U_{**}$, with «last»; as $t_s\to 0$ the load only touches $b$, which is $U_*$.",
        last=Formula(
            "v_0",
            "=",
            -sp.pi * b / (2 * m2 * omega),
            equals(lambda: response.exit_speed + response.two_stop_conditions()[2] / 2),
        ),
    ),
    open=OPEN,
)

DRIVEN = (RESONANCE, ENTRAINMENT)
