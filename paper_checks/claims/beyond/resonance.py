"""A force at the frequency of body 1 alone, without a damper: more than friction can take, less, and just as much."""

from paper_checks.claims.beyond.response import natural_frequency
from paper_checks.claims.words import *
from theory import critical_resonance as critical
from theory import forced_response as response
from theory.forced_response import natural

SIGMA = Symbol("sigma", real=True)


@cache
def most_friction() -> Evidence:
    """The mean of |cos| over a period."""
    return identity(r"the mean of $|\cos|$ is $2/\pi$", response.mean_absolute_cosine(), 2 / pi)


@cache
def grows() -> Evidence:
    """Above the bound every motion grows."""
    return argument(
        r"""
        Over a period $T$ the force adds $U_1T/(2m_1)$ to $A$ in one direction, and friction, $|b\sigma|\leqslant b$,
        removes at most $bT/m_1$ times the mean of $|\cos|$ in it. The rest of a period adds a bounded amount.
        """,
        most_friction,
    )


@cache
def stays_bounded() -> Evidence:
    """Below the bound the energy falls over periods in which it is large."""
    offset = Symbol("c", positive=True)
    slope = diff(response.path_beside(offset), offset)
    return argument(
        r"""
        Over $n$ periods $A$ and $v_2$ change by at most a constant, $|A|=R$. So the work of $u$ is at most $R\,U_1nT/2$
        and a constant (for $\omega_1T\notin 2\pi\mathbb Z$: $R\,\epsilon nT$, with $\epsilon$ arbitrarily small for
        large $n$), and the path of $\dot z$ is at least the integral of $|R\cos\omega_1t-v_2|$ with one $v_2$, less a
        constant: at least $(2/\pi)R\,nT$, and at least $(|v_2|-R)nT$. So over $n$ periods $E$ falls wherever it is
        large enough, and in between it rises by a bounded factor only.
        """,
        kernel.step("forced-energy-rate"),
        most_friction,
        identity(
            r"$\int|\cos s-c|\,ds$ over a turn is $4$ at $c=0$ and has the slope $4\arcsin c\geqslant 0$",
            [response.path_beside(offset).subs(offset, 0), slope],
            [4, 4 * sp.asin(offset)],
        ),
    )


@cache
def turns() -> Evidence:
    """What friction that turns late does to X, Y and P."""
    side, both = Symbol("s"), (1, -1)
    late = critical.beside + side * critical.faster + critical.own
    first = -2 * b * late / (natural * critical.ahead)
    square = b * late**2 / (m1 * natural * critical.ahead**2)
    level = m1 * critical.beside * first / m1 + m2 * critical.faster * side * first / m2
    return argument(
        r"""
        Let $X+iY$ and $P$ be what $A$ and $v_2$ are beyond their values in a motion whose friction is $b\,\mathrm{sgn}\cos\theta$,
        $\theta=\omega_1t$: those are periodic, as $U_1=4b/\pi$, and are determined but for constants. At the zeros of $\cos\theta$ let $s=\sin\theta$ and $-e_k$
        be $s\dot z$ of that motion with $X=Y=P=0$; the constants are such that $\sum e_k=0$ for each $s$, so $e_k=-d_k/m_1$. Then $\dot z=X\cos\theta+O(1)$ while $Y,P=O(1)$.
        For large $X$ its rate is not $0$ where $|\cos\theta|\leqslant\frac12$: $\dot z$ has one zero near each of $\cos\theta$, late by an angle of
        $-f/X+O(X^{-2})$, $f=Y+sP+e_k$, and none elsewhere; the pair does not stick. In between $X,Y,P$ are constant.
        """,
        identity(
            r"such a passage adds $bf^2/(m_1\omega_1X^2)$ to $X$, $-2bf/(\omega_1X)$ to $m_1Y$ and $s$ times that to $m_2P$, to first order in $1/X$",
            [entry for at in both for entry in critical.gain(at)],
            [entry.subs(side, at) for at in both for entry in (square, first / m1, side * first / m2)],
        ),
        identity(
            r"so $\frac12(m_1Y^2+m_2P^2)$ gains $-2b(Y+sP)(Y+sP+e_k)/(\omega_1X)$",
            [level.subs(side, at) for at in both],
            [(first * (late - critical.own)).subs(side, at) for at in both],
        ),
    )


@cache
def third_root() -> Evidence:
    """One motion is seen to grow so, and no other one leaves it."""
    return argument(
        r"""
        If all $d_k=0$, then $Y=P=0$ and a large constant $X$ are a motion: $\dot z=0$ at all zeros of $\cos\theta$, and in between $X\cos\theta$ is greater than the rest. It is
        bounded, so by contraction all are. Else let a motion begin with $Y=P=0$ and $X$ large. Over a period $\sum(Y+sP)e_k=0$, so $V=m_1Y^2+m_2P^2$ gains at most
        $-\kappa V/X+K/X^2$, $\kappa>0$, and $X$ gains $(c+O(\sqrt V+1/X))/X^2$ with $c=b\sum e_k^2/(m_1\omega_1)>0$: $V\leqslant 1$ always, $X\to\infty$, $V\to 0$ and $X^3/n\to 3c$. As $|A|-X$ is
        bounded, $|A|^3/t\to 3c/T$; by contraction $|A|$ of every other motion differs by a constant at most.
        """,
        turns,
        kernel.step("third-root-law"),
        kernel.step("forced-contraction"),
    )


@cache
def one_part() -> Evidence:
    """The moments of a single sine at a fraction of the frequency."""
    angle, part = critical.angle, critical.push * cos(critical.order * critical.angle + critical.phase)
    return argument(
        r"""
        At the zeros $\theta_k=\frac\pi2+k\pi$ the integral is $-\frac{pr}{\omega_1(1-r^2)}s\sin(r\theta_k+\psi)$. As $r\notin\mathbb Z$ and $rN\in\mathbb Z$, its sum over each direction is $0$,
        and $\sum\sin^2(r\theta_k+\psi)=N$ over a period, $T=2\pi N/\omega_1$.
        """,
        third_root,
        identity(
            r"its rate is $p\cos(r\theta+\psi)\sin\theta$",
            natural * diff(critical.moment(), angle),
            part * sin(angle),
        ),
    )


@theorem(
    "forced-resonance-bound",
    clause(
        "rate",
        r"""
        Let $a_1=0$, «natural», $u$ of period $T$, and $U_1$ its Fourier amplitude at $\omega_1$ ($0$ if
        $\omega_1T\notin 2\pi\mathbb Z$). The amplitude $A=e^{-i\omega_1t}(v_1+i\omega_1x_1)$ has «rate», where
        $\sigma$ is the value of $\mathrm{sign}(\dot z)$.
        """,
        natural=natural_frequency(),
        rate=equal(r"e^{i\omega_1t}\,\dot A", (u - b * SIGMA) / m1, response.amplitude_rate),
    ),
    clause(
        "grows",
        r"If $U_1>U_{\mathrm{res}}$, «threshold», every motion grows: $|A(t)|\geqslant\rho t-A_0$ with «growth», $U=U_1$, and a constant $A_0$.",
        threshold=equal(r"U_{\mathrm{res}}", 4 * b / pi, response.resonant_amplitude),
        growth=equal(r"\rho", (response.amplitude - 4 * b / pi) / (2 * m1), response.growth_rate),
    ),
    clause(
        "bounded",
        r"If $U_1<U_{\mathrm{res}}$, every motion has bounded $x_1,v_1,v_2$; body 2 may drift away nevertheless.",
    ),
    clause(
        "sine",
        r"For $u=U\sin\omega t$ the amplitude $U_{**}$ of entrainment-threshold has this limit: «limit» as $\omega\to\omega_1$.",
        limit=tends("U_{**}", 4 * b / pi, response.resonant_non_stop_amplitude),
    ),
    clause(
        "edge",
        r"""
        For $u=U_{\mathrm{res}}\sin\omega_1t$ every motion is bounded. For each $c\geqslant\frac{b}{m_2\omega_1}$, and for no smaller one, there
        is one that slips permanently, with $v_1=\bigl(c+\frac{2b}{\pi m_1}t\bigr)\sin\omega_1t-\frac{\pi
        b}{2m_2\omega_1}\cos\omega_1t$ and $\dot z>0$ for $0<t<\pi/\omega_1$, and half a period later is its own negative.
        """,
        kernel="resonance-edge resonance-edge-bounded",
    ),
    clause(
        "third-root",
        r"""
        Let $U_1=U_{\mathrm{res}}$, $T=2\pi N/\omega_1$ with an integer $N\geqslant 1$, $u$ be bounded, and $U_1\cos\omega_1t$ its part at $\omega_1$, $t=0$ being chosen so. Let $d_k$ be
        $\int_0^tu(s)\sin\omega_1s\,ds$ at the zeros of $\cos\omega_1t$ in a period, less its mean at those where $\sin\omega_1t$ is the same. If all
        $d_k=0$, as for $N=1$, every motion is bounded. Else every motion grows, «limit» as $t\to\infty$, $D=\sum_kd_k^2$.
        """,
        limit=tends("|A|^3/t", 3 * b * critical.moments / (m1**3 * natural * critical.period), critical.growth),
    ),
    clause(
        "one-part",
        r"For $u=U_{\mathrm{res}}\cos\omega_1t+p\cos(r\omega_1t+\psi)$ with a rational $r>0$ every motion is bounded if $r$ is an integer other than 1; if $r$ is none, «limit».",
        limit=tends(
            "|A|^3/t",
            3 * b / (2 * pi * m1) * (critical.push * critical.order / (m1 * natural * (1 - critical.order**2))) ** 2,
            critical.growth_by_one_part,
        ),
    ),
    assuming=f"{POSITIVE} No damper, $a_1=0$; a periodic force $u(t)$ on body 1.",
)
def forced_resonance_bound() -> Case:
    """What friction can take out of a resonant oscillation at most."""
    return because(
        r"Without a damper a resonant force makes every motion grow if it exceeds what the interface can dissipate: friction of magnitude $b$ takes at most the mean of $b|\cos|$ out of an oscillation. With just as much as that, all motions are bounded or all grow as $t^{1/3}$, as the rest of the force decides.",
        carried("rate"),
        carried("grows", grows),
        carried("bounded", stays_bounded),
        carried("sine"),
        carried("third-root", third_root),
        carried("one-part", one_part),
    )
