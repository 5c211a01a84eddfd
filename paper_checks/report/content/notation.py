"""What the symbols mean: one place for all letters of the page, to which every row links."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from paper_checks.report.content.blocks import Section, Table
from paper_checks.report.content.phrases import picture

ID, TITLE = "notation", "Notation"


@dataclass(frozen=True)
class Symbol:
    """A symbol, what it means, its unit, and a pattern that finds it in LaTeX."""

    latex: str
    meaning: str
    unit: str
    pattern: str


def _letter(pattern: str) -> str:
    """Return the pattern of a letter, or of several, that is no part of a word or of a command."""
    return rf"(?<![A-Za-z\\])(?:{pattern})(?![A-Za-z])"


SYMBOLS = {
    "masses": Symbol("m_1,\\,m_2", "mass of the driving body 1 and of the driven body 2; $M=m_1+m_2$", "kg", _letter(r"m_\{?[12i]\}?|M")),
    "states": Symbol("x_i,\\,v_i", "position and velocity of body $i$; $\\dot x_i=v_i$. The spring is relaxed at $x_1=0$", "m, m/s", _letter(r"[xv]_\{?[12i]\}?")),
    "z": Symbol("z", "$x_1-x_2$; $\\dot z=v_1-v_2$ is the relative velocity", "m, m/s", _letter("z")),
    "spring": Symbol("a_1,\\,a_2", "damping and stiffness of body 1 against the ground; Section III writes $a$ for $a_2$", "N s/m, N/m", _letter(r"a_\{?[12]\}?|a(?!['_])")),
    "b": Symbol("b", "largest friction force between the bodies (Coulomb's law)", "N", _letter("b")),
    "force": Symbol("u", "external force on body 1; 0 in the free system", "N", _letter("u(?!')")),
    "sgn": Symbol("\\mathrm{sgn}", "the three-valued signum of eq. (1); in Filippov's reading the value at 0 is the whole interval $[-1,1]$", "–", r"sgn|sign"),
    "S": Symbol("S", "the switching surface $v_1=v_2$; $\\Omega_\\pm$ is where $v_1-v_2$ has this sign", "–", _letter("S(?!_)") + r"|\\Omega_"),
    "S0": Symbol("S_0", "the sliding region, $|x_1|\\leqslant L$ on $S$: there the bodies stick; $S_\\pm$ lies beyond it", "–", _letter("S_.+?")),
    "L": Symbol("L", "half width of the sliding region, $b(m_1+m_2)/(a_2m_2)$", "m", _letter("L")),
    "rays": Symbol("\\ell_\\pm", "the exit rays: edges $x_1=\\pm L$ of the sliding region, through which the pair leaves it", "–", r"\\ell"),
    "fields": Symbol("\\Phi_\\pm", "the velocity field of $(x_1,v_1,v_2)$ in $\\Omega_\\pm$; $n_S=(0,1,-1)$ is the normal of $S$", "–", r"\\Phi|n_\{?S"),
    "E": Symbol("E", "energy, $\\tfrac12(a_2x_1^2+m_1v_1^2+m_2v_2^2)$", "J", _letter("E(?!_.?c)")),
    "Ecr": Symbol("E_{cr}", "the critical energy $\\tfrac12a_2L^2$: that of the largest orbit on which the bodies stick permanently", "J", r"E_\{cr"),
    "w": Symbol("w", "excess energy, $E/E_{cr}-1$; $w'$ after a slip", "–", _letter("w")),
    "Omega": Symbol("\\Omega", "angular frequency of stick, $\\sqrt{a_2/M}$; $\\tau=\\Omega t$ is the reduced time", "rad/s", r"\\Omega(?!_)|\\tau(?!_k)"),
    "q": Symbol("q,\\,r", "the masses' shares $m_1/M$ and $m_2/M$", "–", _letter("[qr]")),
    "XV": Symbol("X,\\,V_i", "reduced coordinates $x_1/L$ and $v_i/(L\\Omega)$", "–", _letter("X|V")),
    "y": Symbol("y", "excess energy on an exit ray over its mass share, $w/q$", "–", _letter("y")),
    "theta": Symbol("\\theta", "angle of a slip, $\\sqrt{a_2/m_1}$ times its duration", "rad", r"\\theta"),
    "h": Symbol("h", "$(\\theta-\\sin\\theta)/(1-\\cos\\theta)$: exit speed of the slip from a ray that ends at $\\theta$, over $L\\Omega\\sqrt q$", "–", _letter("h(?!_)")),
    "c": Symbol("c", "$2-\\theta\\cot(\\theta/2)$: depth of a slip from a ray, over $qL$", "–", _letter("c(?!_)")),
    "d": Symbol("d,\\,\\nu", "start of a slip on $S$: distance beyond the edge over $qL$, velocity over $L\\Omega\\sqrt q$", "–", r"\\nu"),
    "R": Symbol("r^*,\\,\\mu^*", "critical share $m_2/M$ and critical mass ratio $m_1/m_2$: below that share, beyond that ratio no slip from $S$ above $E_{cr}$ merges", "–", r"r\^\*|\\mu\^\*"),
    "C": Symbol("C,\\,B", "constants of the $1/t$ law: $C=4\\pi q/(9r)$ and $B=1-2/(5r)$", "–", _letter("[CB](?!_)")),
    "load": Symbol("\\Lambda", "the load: the friction force on body 2 that sticking needs, $m_2(u-a_2x_1-a_1v_1)/M$", "N", r"\\Lambda"),
    "distance": Symbol("N", "energy distance of two motions, $N^2=a_2(x_1-\\tilde x_1)^2+m_1(v_1-\\tilde v_1)^2+m_2(v_2-\\tilde v_2)^2$", "$\\sqrt{\\mathrm J}$", _letter("N")),
    "kappa": Symbol("\\kappa", "$M/(m_1m_2)$: in slip of sign $s$, $\\ddot z=\\kappa(\\Lambda-sb)$", "1/kg", r"\\kappa"),
    "thresholds": Symbol("U_*,\\,U_{**}", "amplitudes of $u=U\\sin\\omega t$ up to which the pair may stick permanently, and needed for a slip without a stop that reverses after each half period of the force", "N", r"U_\{?\*"),
}  # fmt: skip
"""The symbols by name, in the order in which a reader meets them."""
OWN = {
    "return-alternatives": "w",
    "motions-on-a-surface": "w y",
    "forced-periodic-response": "h",
    "minimum-transfer-time": "theta",
    "uniform-rate": "distance",
    "tolerance-ring": "q",
    "static-friction-stops-creeping": "C",
    "friction-in-any-direction": "masses b w q c C distance",
    "stuck-ellipses": "q",
    "rotating-force": "XV",
}
"""Symbols whose letters a claim uses for something of its own, and says for what."""
_MATHEMATICS = re.compile(r"(?<!\\)\$+([^$]+)\$+")


def anchor(name: str) -> str:
    """Return the anchor of a symbol."""
    return f"symbol-{name}"


def used(texts: Iterable[str], row: str = "") -> tuple[str, ...]:
    """Return the names of the symbols in the mathematics of some texts of a row, in the order of the notation."""
    own = OWN.get(row, "").split()
    formulas = " ; ".join(formula for text in texts for formula in _MATHEMATICS.findall(text))
    return tuple(name for name, symbol in SYMBOLS.items() if name not in own and re.search(symbol.pattern, formulas))


def section() -> Section:
    """Return the section that explains every symbol."""
    letters = table(SYMBOLS, "The letters of this report, in SI units; – stands for dimensionless")
    return Section(ID, TITLE, (picture("two-bodies"), letters))


def table(names: Iterable[str], caption: str, *, anchored: bool = True) -> Table:
    """Return a table of these symbols; only one table of a page may be the one that links point to."""
    chosen = list(names)
    rows = tuple((f"${SYMBOLS[one].latex}$", SYMBOLS[one].meaning, SYMBOLS[one].unit) for one in chosen)
    return Table(("symbol", "meaning", "unit"), rows, caption, tuple(map(anchor, chosen)) if anchored else ())
