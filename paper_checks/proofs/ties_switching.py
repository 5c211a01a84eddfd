"""The tie of the paper's equations (3), (4), whose signs switch between the two modes."""

from __future__ import annotations

from collections.abc import Iterator

from paper_checks.proofs.gallina import term
from paper_checks.proofs.tie import NAMES, Tie
from theory.model import RELATIVE_SIGN, STICTION_SIGN, driven_equation, driving_equation
from theory.symbols import acceleration1, acceleration2, u, v1, v2, x1


def ties() -> Iterator[Tie]:
    """Both equations at one time, without a control."""
    along = NAMES | {x1: "(x t)", v1: "(v1 t)", v2: "(v2 t)", acceleration1: "a", acceleration2: "a'"}
    driving, driven = (term(one.subs(u, 0), along) for one in (driving_equation(), driven_equation()))
    relative, stiction = (term(one.args[0], along) for one in (RELATIVE_SIGN, STICTION_SIGN))
    signs = f"""assert (E1 : {relative} = v1 t - v2 t) by ring; assert (E2 : {stiction} = Rabs a - b / m2) by (field; lra)"""
    yield Tie(
        "tie_switching",
        "Equations (3) and (4) of the paper at one time, without a control.",
        f"""forall m1 m2 a1 a2 b (x v1 v2 : R -> R) t, 0 < m2 -> Switching.switched m1 m2 a1 a2 b x v1 v2 t <->
  exists a a' : R, is_derive x t (v1 t) /\\ is_derive v1 t a /\\ is_derive v2 t a' /\\ {driving} = 0 /\\ {driven} = 0""",
        f"""intros m1 m2 a1 a2 b x v1 v2 t Hm; split; intros (a & a' & X & V & W & E3 & E4); exists a, a'; {signs};
  rewrite ?E1, ?E2 in *; repeat (split; [assumption|]); split; lra.""",
    )
