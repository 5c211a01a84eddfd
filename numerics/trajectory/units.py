"""SI units, by the names that numbers of scenes and of results have everywhere."""

from __future__ import annotations

import re

_TEXT = (
    "m1: kg, m2: kg, a1: N s/m, a2: N/m, b: N, b_static: N, until: s, x1: m, v1: m/s, x2: m, v2: m/s, from: s, "
    "omega: rad/s, phase: rad, last_slope: N s/m, w: m/s, c: N, z: m, t: s, load: N, energy: J, dissipated: J, "
    "friction: J, viscous: J, work: J, residual: J"
)
_UNITS = dict(one.split(": ") for one in _TEXT.split(", "))
_OF_SIGNALS = {"belt": "m/s", "wall": "m"}
_OF_ANGLES = {"m": "rad", "m/s": "rad/s", "N": "N m", "kg": "kg m^2", "N/m": "N m", "N s/m": "N m s"}
_OF_COUPLINGS = {"N/m": "N", "N s/m": "N s"}


def unit(name: str) -> str:
    """Return the unit of a number of a scene or of a result, or of its radius; "" for none.

    A signal without another name is a force; x1_phi is an angle.

    >>> unit("a1"), unit("a2"), unit("sines[0].amplitude"), unit("belt[0].sines[0].omega")
    ('N s/m', 'N/m', 'N', 'rad/s')
    >>> unit("weakening.last_slope"), unit("weakening.speed[0].w"), unit("weakening.place[0].c")
    ('N s/m', 'm/s', 'N')
    >>> [unit(f"wall[1].polynomial[{order}]") for order in range(3)]
    ['m', 'm/s', 'm/s^2']
    >>> unit("v1 - v2"), unit("x1_at_t"), unit("m1_phi"), unit("load_x_radius"), unit("events")
    ('m/s', 'm', 'kg m^2', 'N', '')
    >>> unit("a2_xy"), unit("a2_xphi"), unit("a2_phi"), unit("force_phi[0].polynomial[1]"), unit("friction[0].b_phi")
    ('N/m', 'N', 'N m', 'N m/s', 'N m')
    """
    whole, axes = re.fullmatch(r"(.*?)(?:_(x|y|phi|xy|xphi|yphi))?(?:_radius|_at_t)?", name).groups()  # type: ignore[union-attr]
    word = whole.partition(" ")[0]
    last = word.rpartition(".")[2]
    of = _OF_COUPLINGS if axes in {"xphi", "yphi"} else _OF_ANGLES if axes == "phi" or "_phi[" in name else {}
    own, (key, _, order) = _OF_SIGNALS.get(word.partition("[")[0], "N"), last.rstrip("]").partition("[")
    own = of.get(own, own)
    if key == "polynomial":
        return own + ("" if order == "0" else "/s" if order == "1" else f"/s^{order}")
    found = own if last == "amplitude" else _UNITS.get(last, "")
    return of.get(found, found)
