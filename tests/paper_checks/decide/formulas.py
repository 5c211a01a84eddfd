"""The formulas of formulas.toml, and what has to be found of them."""

import tomllib
from pathlib import Path

import sympy as sp

ASKED = tomllib.loads(Path(__file__).with_suffix(".toml").read_text("utf-8"))
FOUND = {"hold": True, "fail": False, "open": None}
x, y, z = sp.symbols("x y z", real=True)
m, n = sp.symbols("m_1 n", positive=True)
k, v = sp.Symbol("k", integer=True), sp.Symbol("v", negative=True)
C, D = map(sp.Function, "CD")
LETTERS = {"x": x, "y": y, "z": z, "m": m, "n": n, "k": k, "v": v, "root": sp.sqrt(m + n), "C": C, "D": D}


def formula(text):
    return sp.sympify(text, locals=LETTERS)


def asked(kind):
    """What is asked, and what has to be found."""
    return [(row, FOUND[found]) for found, rows in ASKED[kind].items() for row in rows]
