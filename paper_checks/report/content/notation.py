"""What the symbols mean: one place for all letters of the report."""

from __future__ import annotations

from paper_checks.report.content.blocks import Section, Table
from paper_checks.report.content.phrases import picture

ID, TITLE = "notation", "Notation"
SYMBOLS = {
    "masses": ("m_1,\\,m_2", "mass of the driving body 1 and of the driven body 2; $M=m_1+m_2$", "kg"),
    "states": ("x_i,\\,v_i", "position and velocity of body $i$; $\\dot x_i=v_i$. The spring is relaxed at $x_1=0$", "m, m/s"),
    "z": ("z", "$x_1-x_2$; $\\dot z=v_1-v_2$ is the relative velocity", "m, m/s"),
    "spring": ("a_1,\\,a_2", "damping and stiffness of body 1 against the ground; Section III writes $a$ for $a_2$", "N s/m, N/m"),
    "b": ("b", "largest friction force between the bodies (Coulomb's law)", "N"),
    "force": ("u", "external force on body 1; 0 in the free system", "N"),
    "sgn": ("\\mathrm{sgn}", "the three-valued signum of eq. (1); in Filippov's reading the value at 0 is the whole interval $[-1,1]$", "–"),
    "S": ("S", "the switching surface $v_1=v_2$; $\\Omega_\\pm$ is where $v_1-v_2$ has this sign", "–"),
    "S0": ("S_0", "the sliding region, $|x_1|\\leqslant L$ on $S$: there the bodies stick; $S_\\pm$ lies beyond it", "–"),
    "L": ("L", "half width of the sliding region, $b(m_1+m_2)/(a_2m_2)$", "m"),
    "rays": ("\\ell_\\pm", "the exit rays: edges $x_1=\\pm L$ of the sliding region, through which the pair leaves it", "–"),
    "fields": ("\\Phi_\\pm", "the velocity field of $(x_1,v_1,v_2)$ in $\\Omega_\\pm$; $n_S=(0,1,-1)$ is the normal of $S$", "–"),
    "E": ("E", "energy, $\\tfrac12(a_2x_1^2+m_1v_1^2+m_2v_2^2)$", "J"),
    "Ecr": ("E_{cr}", "the critical energy $\\tfrac12a_2L^2$: that of the largest orbit on which the bodies stick permanently", "J"),
    "w": ("w", "excess energy, $E/E_{cr}-1$; $w'$ after a slip", "–"),
    "Omega": ("\\Omega", "angular frequency of stick, $\\sqrt{a_2/M}$; $\\tau=\\Omega t$ is the reduced time", "rad/s"),
    "q": ("q,\\,r", "the masses' shares $m_1/M$ and $m_2/M$", "–"),
    "XV": ("X,\\,V_i", "reduced coordinates $x_1/L$ and $v_i/(L\\Omega)$", "–"),
    "y": ("y", "excess energy on an exit ray over its mass share, $w/q$", "–"),
    "theta": ("\\theta", "angle of a slip, $\\sqrt{a_2/m_1}$ times its duration", "rad"),
    "h": ("h", "$(\\theta-\\sin\\theta)/(1-\\cos\\theta)$: exit speed of the slip from a ray that ends at $\\theta$, over $L\\Omega\\sqrt q$", "–"),
    "c": ("c", "$2-\\theta\\cot(\\theta/2)$: depth of a slip from a ray, over $qL$", "–"),
    "d": ("d,\\,\\nu", "start of a slip on $S$: distance beyond the edge over $qL$, velocity over $L\\Omega\\sqrt q$", "–"),
    "R": ("r^*,\\,\\mu^*", "critical share $m_2/M$ and critical mass ratio $m_1/m_2$: below that share, beyond that ratio no slip from $S$ above $E_{cr}$ merges", "–"),
    "C": ("C,\\,B", "constants of the $1/t$ law: $C=4\\pi q/(9r)$ and $B=1-2/(5r)$", "–"),
    "load": ("\\Lambda", "the load: the friction force on body 2 that sticking needs, $m_2(u-a_2x_1-a_1v_1)/M$", "N"),
    "distance": ("N", "energy distance of two motions, $N^2=a_2(x_1-\\tilde x_1)^2+m_1(v_1-\\tilde v_1)^2+m_2(v_2-\\tilde v_2)^2$", "$\\sqrt{\\mathrm J}$"),
    "kappa": ("\\kappa", "$M/(m_1m_2)$: in slip of sign $s$, $\\ddot z=\\kappa(\\Lambda-sb)$", "1/kg"),
    "thresholds": ("U_*,\\,U_{**}", "amplitudes of $u=U\\sin\\omega t$ up to which the pair may stick permanently, and needed for a slip without a stop that reverses after each half period of the force", "N"),
}  # fmt: skip
"""The symbols by name, in the order in which a reader meets them: each in LaTeX, what it means, its unit."""


def section() -> Section:
    """Return the section that explains every symbol."""
    rows = tuple((f"${letter}$", meaning, unit) for letter, meaning, unit in SYMBOLS.values())
    caption = "The letters of this report, in SI units; – stands for dimensionless"
    letters = Table(("symbol", "meaning", "unit"), rows, caption, tuple(f"symbol-{name}" for name in SYMBOLS))
    return Section(ID, TITLE, (picture("two-bodies"), letters))
