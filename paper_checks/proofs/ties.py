"""Tie.v, written anew from `theory/`: every definition of the proofs equals the expression that the theory derives.

The right side of each equation is printed from sympy, so a changed sign in `theory/` or in a proof file breaks its proof.
"""

from __future__ import annotations

from collections.abc import Iterator

from paper_checks.proofs import ties_excursion, ties_forced, ties_pair, ties_switching
from paper_checks.proofs.sources import LIBRARY
from paper_checks.proofs.tie import Tie

HEADER = f"""(** Written by paper_checks/proofs/ties.py: each definition of the proofs is what the theory derives. *)
From Coq Require Import Reals Lra Psatz Nsatz.
From {LIBRARY} Require Import Dini Pair Stick Excursion Rate Turning Cycle Orbit Gap Alternate Sharp Surface Viscous.
Local Open Scope R_scope.

(** every square root of a parameter as a letter of its own *)
Ltac root y := let w := fresh "w" in let E := fresh "E" in let P := fresh "P" in
  assert (P : 0 < sqrt y) by (apply sqrt_lt_R0; lra); assert (E : sqrt y * sqrt y = y) by (apply sqrt_sqrt; lra);
  set (w := sqrt y) in *; clearbody w.
Ltac circle p := let SC := fresh "SC" in pose proof (sin2_cos2 p) as SC; unfold Rsqr in SC.
"""


UNDER_A_FORCE = f"""(** What follows needs derivatives, or is about the pair under a force. *)
From Coquelicot Require Import Coquelicot.
From {LIBRARY} Require Import Forced Entrain Nonstop Undamped Damped Transfer Arrival.
From {LIBRARY} Require Switching.
"""


FREE, FORCED = (ties_pair, ties_excursion), (ties_forced, ties_switching)


def text() -> str:
    """The whole file."""
    free = (tie.text for part in FREE for tie in part.ties())
    forced = (tie.text for part in FORCED for tie in part.ties())
    return "\n".join([HEADER, *free, UNDER_A_FORCE, *forced])


def ties() -> Iterator[Tie]:
    """Yield all of them."""
    for part in (*FREE, *FORCED):
        yield from part.ties()
