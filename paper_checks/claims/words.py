"""What a claim is written with, from one place: every module of this room begins with `from paper_checks.claims.words import *`.

A claim and its clauses; what decides a formula, a step and a scene in balls; the letters of `theory.symbols`, the fields and
energies that most claims speak of, and what formulas are made of.
"""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise

import sympy as sp
from flint import arb
from sympy import (
    Abs,
    And,
    Basic,
    Expr,
    Integer,
    Matrix,
    Rational,
    Symbol,
    cos,
    expand,
    oo,
    pi,
    sin,
    sqrt,
    symbols,
)

from numerics.linear.modes import EventKind, Mode
from numerics.scene import Force, Law, Pair, Scene, State
from numerics.scene.file import load_scene
from numerics.trajectory.trajectory import Trajectory
from paper_checks.claims.section_5.points import AT_4MM, AT_5MM, EXAMPLE_PAIR, PULL, START_AT_6MM, at_rest, scene_at
from paper_checks.decide import kernel
from paper_checks.decide.balls import point, precision
from paper_checks.decide.deciders import Decide, decimal, equal, equals, fails_at, implied, sharp, tends
from paper_checks.decide.enclosure import ball, compare, itinerary, rounded, solved, stuck_for_ever, text
from paper_checks.decide.exact import identity
from paper_checks.decide.exhibit import exhibit, value_at
from paper_checks.decide.polynomial import cleared, signed
from paper_checks.decide.smt import prove
from paper_checks.evidence.claim import (
    CORRECTED,
    HOLDS,
    NOT_JUDGED,
    POSITIVE,
    REFUTED,
    UNDER_A_FORCE,
    Case,
    Claim,
    because,
    claim,
    correction,
    counterexample,
    theorem,
)
from paper_checks.evidence.clause import Clause, Formula, clause
from paper_checks.evidence.evidence import Evidence, EvidenceKind, Steps, argument, enclosed, reading
from paper_checks.evidence.finding import carried
from paper_checks.evidence.formula import latex
from theory import forced
from theory.closed_forms import DampingRegime, residual, solution
from theory.energy import critical_energy, energy, on_surface, sigma, sigma_other, slip_rate, stick_rate
from theory.filippov import derivative_along, half_width, load, load_threshold, phi, sliding_field, transversality
from theory.linear import root
from theory.model import (
    CASE_STUDY,
    RELATIVE_SIGN,
    STICTION_SIGN,
    branch_named,
    case_study_mode,
    driven_equation,
    driving_equation,
    free_system,
    slip,
    stick,
)
from theory.power_series import taylor
from theory.symbols import *
