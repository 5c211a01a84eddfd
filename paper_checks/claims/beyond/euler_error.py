"""How far forward Euler is from the motion, whatever it takes for the sign at rest; and which steps show Fig. 5 (a)."""

from numerics.trajectory.events import Segment
from paper_checks.claims.section_4.starts import time
from paper_checks.claims.words import *
from paper_checks.decide.euler_in_balls import euler_in_balls
from paper_checks.decide.euler_in_balls import run as run_euler

SHOWS, LATEST = Fraction(2, 10**5), Fraction(1, 100)
"""A step (s) up to which Fig. 5 (a) is right, and by how much (s) its first adhesion is off then at most."""
RIGHT, WRONG = Fraction(57, 10**6), Fraction(58, 10**6)
"""Steps tried there, s: one that finds the first adhesion, and one that misses it."""
ALLOWED = Fraction(1, 1000)
"""What N is supposed to stay below, J^(1/2)."""


def local_error() -> Evidence:
    """What one step adds to the distance, whether its slip ends or not."""
    return argument(
        r"""
        The motion that begins at the step's beginning does not move apart from the other one. Along the slip with the friction of the step $B$ is constant, so the step, its
        tangent, ends within $\frac12h^2\omega_1B$ of it. Where the slip ends within the step, the friction of that motion differs by at most $2b$ for at most $h$.
        """,
        kernel.step("euler-slip-step"),
        kernel.step("contraction"),
    )


def shows_adhesion(step: Fraction = SHOWS) -> Evidence:
    """Fig. 5 (a), both masses 1 kg: up to this step the motion leaves the first adhesion no choice but where it is."""
    run, h, latest = solved(load_scene("velocities")), point(step), point(LATEST)
    first = next(n for n, one in enumerate(run.segments) if one.mode is Mode.STICK)
    slips, stick, pair = run.segments[:first], run.segments[first], run.scene.pair
    with run.arithmetic.context():
        spring, friction = point(pair.a2), point(pair.b)
        omega, last = spring.sqrt(), slips[-1]
        energies: list[arb] = [pair.energy(one.state(arb(0)), point) for one in slips]
        speeds = [(2 * one).sqrt() + point(ALLOWED) for one in energies]
        rates = [omega * one + friction for one in speeds]
        lengths = [one.length + h for one in slips[:-1]] + [last.length + latest + h]
        smooth = omega / 2 * sum(rate * length for rate, length in zip(rates, lengths, strict=True))
        distance = h * (smooth + 6 * len(slips) * friction * arb(2).sqrt())
        reach, relative = distance / omega, distance * arb(2).sqrt()
        slow, outside = relative + 2 * h * (rates[0] + friction), point(pair.half_width) + reach

        def apart(part: Segment, start: arb, end: arb) -> bool:
            place, speed, _, other = part.state(start.union(end))
            if abs(speed - other) > slow or abs(place) > outside:
                return True
            middle = (start + end) / 2
            return bool(end - start > h) and apart(part, start, middle) and apart(part, middle, end)

        before: arb = last.length - latest
        parts = [*((one, one.length) for one in slips[:-1]), (last, before)]
        away = [apart(one, arb(0), end) for one, end in parts]
        state = last.state(before)
        end, begun = last.state(before.union(last.length))[0], stick.state(arb(0).union(latest))[0]
        place = arb(end).union(begun)
        return argument(
            r"""
            Let $N$ stay below $N_1$ for a while. Where a slip of Euler may end within a step, $\dot z$ of the motion is small; so up to 0.01 s before the adhesion $|x_1|$ of both is beyond $S_0$.
            There $\dot z$ of Euler has a rate of the sign of $-x_1$, whatever friction is: it changes its sign once at each of the 20 crossings, in at most three steps that a turn disturbs, and
            not in $S_0$. After that $x_1$ of both lies in $S_0$, with $x_1>0$, and $\dot z>0$ falls fast enough to change its sign within 0.01 s of the adhesion. Added up, $N<N_1$ indeed. A smaller step only makes all
            bounds smaller.
            """,
            compare("$N_1$ ($\\sqrt{\\mathrm J}$), as added up", distance, "<", point(ALLOWED)),
            enclosed(
                r"up to 0.01 s before the adhesion $|\dot z|$ exceeds what $N_1$ and a step change, or $|x_1|$ exceeds $L$ by more than $N_1/\sqrt{a_2}$",
                all(away) or None,
                f"{len(away)} slips",
                len(away),
            ),
            compare("then $\\dot z$ (m/s) exceeds that, too", state[1] - state[3], ">", slow),
            compare("from then to 0.01 s after the adhesion $x_1-N_1/\\sqrt{a_2}$ (m)", place - reach, ">", arb(0)),
            compare("and $x_1+N_1/\\sqrt{a_2}$ (m)", place + reach, "<", point(pair.half_width)),
            compare(
                "that $\\dot z$ (m/s) is gone",
                (latest - h) * (spring * (place - reach) + 2 * friction),
                ">",
                relative,
            ),
            kernel.step("slip-rate"),
            local_error,
        )


def _tried() -> Steps:
    """Return what two steps give, in balls."""
    true = solved(load_scene("velocities")).events
    found = []
    for step, number in ((RIGHT, 0), (WRONG, 1)):
        euler = run_euler("velocities", step).adhesion_time
        entry = [one for one in true if one.after is Mode.STICK][number].t
        assert euler is not None
        near = compare(
            f"Fig. 5 (a), step {float(step):g} s: adhesion {number + 1} (s off)",
            abs(point(euler) - entry),
            "<",
            arb("0.001"),
        )
        found.append(replace(near, value=f"Euler {float(euler):.6g} s"))
    changes = euler_in_balls(load_scene("velocities"), RIGHT, Fraction("4.7")).chatter
    once = enclosed(
        f"Fig. 5 (a), step {float(RIGHT):g} s: up to 4.7 s $\\dot z$ changes its sign once in $S_0$",
        changes == 1,
        str(changes),
    )
    return (*found, once)


@theorem(
    "euler-error",
    clause(
        "law",
        r"""
        Let $u=0$ and $a_1\geqslant 0$, and let forward Euler take steps of $h$ with a friction in $[-b,b]$ that is
        $b\,\mathrm{sgn}(\dot z)$ where $\dot z\neq 0$. Its distance $N$ in the energy norm from a motion,
        $N^2=a_2\Delta x_1^2+m_1\Delta v_1^2+m_2\Delta v_2^2$, satisfies at the time $t$ of a step
        $N(t)^2\leqslant N(0)^2+h\,t\,C\,(C+C')$, where $C$ is the largest speed of its steps in this norm, and the motion
        moves at most at the speed $C'$ in it.
        """,
        kernel="euler-law",
    ),
    clause(
        "slip",
        r"""
        For $a_1=0$, $\omega_1^2=a_2/m_1$, a step adds to $N$ at most $\tfrac12h^2\omega_1B$, $B^2=a_2v_1^2+(a_2x_1+b\sigma)^2/m_1$, if the slip with its friction does not end within it;
        """,
        kernel="euler-slip-step",
    ),
    clause(
        "turn",
        r"if it does, at most $2hb\sqrt{1/m_1+1/m_2}$ more.",
    ),
    clause(
        "fig-5a",
        r"""
        Let a run adhere where $\dot z$ first changes its sign between two places in $S_0$. In Fig. 5 (a) each step of at most
        $2\cdot10^{-5}$ s adheres within 0.01 s of the true first adhesion, «first» s. Of the steps tried $5.7\cdot10^{-5}$ s does so
        there, too, once only, and slips on; $5.8\cdot10^{-5}$ s does not, and first adheres when the motion does so for the second
        time, «again» s.
        """,
        first=time("t", "4.5497", "velocities", 20),
        again=time("t", "4.7717", "velocities", 22),
    ),
    assuming=f"{POSITIVE} No force, $u=0$, $b$ constant; with or without a damper, $a_1\\geqslant 0$.",
)
def euler_error() -> Case:
    """The error of a step does not add up linearly, and is not forgotten."""
    return because(
        r"""
        The error of forward Euler is of the order $\sqrt{ht}$ at most: it converges, but slowly. Friction never enlarges
        the distance of two motions, but a step of Euler uses the friction and the forces at its beginning. Near $\dot z=0$
        that friction is off by up to $2b$, however small the step.
        """,
        carried("turn", local_error),
        carried("fig-5a", shows_adhesion, _tried),
    )
