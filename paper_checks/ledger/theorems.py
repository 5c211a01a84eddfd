"""Past the paper: theorems about the free undamped pair, each for all mass ratios m1/m2."""

from paper_checks.evidence import Verdict
from paper_checks.ledger.claim import Claim, Kind

SECTION = "Theorems"
WHERE = "past the paper"


def _theorem(name: str, statement: str) -> Claim:
    return Claim(name, SECTION, WHERE, statement, Verdict.HOLDS, Kind.THEOREM)


THEOREMS = (
    _theorem(
        "excursion-closed-form",
        r"Every slip that starts on $S$, mirrored to $x_1=L(1+q\,d)$, $v_1=v_2=L\Omega\sqrt q\,u$ with $d\geqslant 0$, $v_1<v_2$ "
        r"(and $u>0$ if $d=0$), ends at the one angle $\theta=\sqrt{a/m_1}\,t\in(0,2\pi)$ with $u+d\cot(\theta/2)=h(\theta)$, "
        r"$h=\frac{\theta-\sin\theta}{1-\cos\theta}$. There $d'=-(d+c)$, $u'=u-\theta$, $w'=w-q\,r\,c\,(c+2d)$ with "
        r"$c=2-\theta\cot(\theta/2)$, $q=m_1/M$, $r=m_2/M$, $M=m_1+m_2$, $w=E/E_{cr}-1$. From a ray it re-enters $S_0$ if "
        r"$c(\theta)\leqslant 2/q$ and crosses $S$ otherwise; having re-entered with $w'>0$ the pair leaves by the opposite ray "
        r"if $\theta<\theta_v$, $\tan\theta_v=\theta_v$, $\theta_v=4.4934\ldots$, and by the same ray if $\theta>\theta_v$.",
    ),
    _theorem(
        "excursion-monotone",
        r"$h$ increases from $0$ to $\infty$ on $(0,2\pi)$ and is convex; the condition that ends a slip is monotone in $\theta$ for "
        r"every start on $S$; the depth $c$ increases from $0$ to $\infty$ and is concave as a function of $y=h^2$. Exit speed, "
        r"duration, depth and energy lost of an excursion from a ray increase together.",
    ),
    _theorem(
        "return-map-expansion",
        r"With $y=w/q$ the return map from ray to ray is $y'=y-r\,c(y)^2$, where $c(y)=\tfrac{3}{2}y-\tfrac{27}{40}y^2+\tfrac{243}{560}y^3-"
        r"\cdots$ is one power series with rational coefficients, the same for every mass ratio. What the terms after $y^8$ add to $y'$ is at most "
        r"$\tfrac{r}{3}(9y/4)^9$ for $0<y\leqslant 4/9$, and the reduced time of a cycle is $\pi+\frac{9r}{8q}w^{3/2}+\cdots$.",
    ),
    _theorem(
        "sharp-rate-constant",
        r"Along every trajectory that never merges $t\,(E(t)-E_{cr})\to E_{cr}\,\frac{4\pi}{9}\,\frac{m_1}{m_2}\sqrt{\frac{m_1+m_2}{a}}$ "
        r"as $t\to\infty$: a limit, the same for every $E(0)$.",
    ),
    _theorem(
        "rate-bounds-explicit",
        r"Let the pair leave $S_0$ by a ray at $t_0$ with $w_0=q\,y_0$, $y_0\leqslant(\pi/2-1)^2$, $h(\theta_0)^2=y_0$, $c_0=c(\theta_0)$. "
        r"Then for all $t\geqslant t_0$, with $s=\Omega(t-t_0)$: $\frac{q}{1/y_0+A\,(s/T_-+1)}\leqslant\frac{E(t)-E_{cr}}{E_{cr}}\leqslant"
        r"\frac{q}{1/y_0+a'(s/T_+-1)}$, where $a'=r\,c_0^2/y_0^2$, $A=\frac{9r}{4}\bigl(1-r\,c_0^2/y_0\bigr)^{-1}$, "
        r"$T_+=\pi+\sqrt q\,\theta_0$, $T_-=\pi-\sqrt q\,(\theta_0-\sqrt{y_0})\frac{q\,c_0}{1-q\,c_0}$.",
    ),
    _theorem(
        "merging-set",
        r"Let $r=m_2/M$ exceed $r^*$ of critical-mass-ratio. Then $h(\theta)=\sqrt r\,c(\theta)$ has exactly two roots "
        r"$\theta_a<\theta_b$ in $(0,2\pi)$, and a trajectory from $S_0$ above $E_{cr}$ merges at its first re-entry exactly if "
        r"$w_a\leqslant w\leqslant w_b$, $w_{a,b}=q\,h(\theta_{a,b})^2$. Below $w_a$ it never merges. Above $w_b$ later slips decide; "
        r"for $r=\tfrac{3}{5},\tfrac{7}{10},\tfrac{4}{5},\tfrac{9}{10}$ bands of energies that merge there are certified. For $r<r^*$ no energy on $S_0$ above $E_{cr}$ merges. As $m_1/m_2\to 0$ "
        r"the interval $[w_a,w_b]/q$ tends to that of $r=1$; as $m_1/m_2\to\infty$ nothing merges after its first contact with $S$.",
    ),
    _theorem(
        "critical-mass-ratio",
        r"Let $\varphi^*$ be the one root in $(0,\pi)$ of $\varphi-\sin\varphi\cos\varphi=\sqrt2\,(\sin\varphi-\varphi\cos\varphi)$ and "
        r"$\theta^*=2\varphi^*$. If $m_1/m_2>-\cos\theta^*=0.79263\ldots$, no slip that starts on $S$ above $E_{cr}$, from a ray or beyond an "
        r"edge, ends with $E\leqslant E_{cr}$: whether a trajectory merges is decided by its energy at its first contact with $S$. If "
        r"$m_1/m_2<-\cos\theta^*$, an interval of energies on $S_0$ merges at the first re-entry; if they are equal, just one energy does.",
    ),
    _theorem(
        "long-time-expansion",
        r"With $\tau=\Omega t$, at the exits of a trajectory that never merges, $w=\frac{C}{\tau}\Bigl(1-\frac{\pi B\ln(\alpha\tau/\pi)+K}"
        r"{\tau}+O(\tau^{-3/2})\Bigr)$ with $C=\frac{4\pi q}{9r}$, $\alpha=\frac{9r}{4}$, $B=1-\frac{2}{5r}$ and one number $K$ that "
        r"alone depends on the start. At other times the time to the next exit is added to $K$ during stick. The logarithm vanishes "
        r"for $m_1/m_2=3/2$.",
    ),
)
