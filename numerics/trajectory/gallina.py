"""The proof file of a trajectory in the words of the kernel."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from numerics.linear.modes import Mode
from numerics.scene import Scene
from numerics.scene.decimals import decimal_text
from numerics.trajectory.closed_forms import Spell, Steady

DEPTH = 64
"""How often the kernel halves an interval to show that no event was passed."""


def number(value: Fraction) -> str:
    """Return an exact number."""
    text = decimal_text(value)
    if "/" in text:
        return f"({value.numerator} # {value.denominator})"
    return text if text[0] != "-" else f"({text})"


def truth(value: bool) -> str:
    """Return a truth value."""
    return "true" if value else "false"


def mode(value: Mode) -> str:
    """Return a mode."""
    return "Stick" if value is Mode.STICK else f"(Slip {truth(value is Mode.SLIP_PLUS)})"


def proof_file(
    scene: Scene, spells: list[Spell], events: Iterable[str], ending: str, hints: Iterable[str], bits: tuple[int, int]
) -> str:
    """Return the file; bits: those of the first state, and those in which it is shown that no event was passed."""
    pair, at = scene.pair, scene.initial
    numbers = (pair.m1, pair.m2, pair.a1, pair.a2, at.x1, at.v1, at.x2, at.v2)
    table = ";\n  ".join(events)
    return TEXT.format(
        scene=" ".join(map(number, numbers)),
        first=_spell(spells[0]),
        later=_list(map(_spell, spells[1:]), ";\n  "),
        events=f"[\n  {table}]" if table else "[]",
        ending=ending,
        answers=_list((f"({_steady(one.alone)}, {_steady(one.together)})" for one in spells), ";\n  "),
        hints=";\n  ".join(hints),
        state=bits[0],
        sign=bits[1],
        depth=DEPTH,
    )


def _list(items: Iterable[str], between: str = "; ") -> str:
    return f"[{between.join(items)}]"


def _steady(force: Steady) -> str:
    tones = (f"Tone {' '.join(map(number, one))}" for one in force.tones)
    return f"Steady {number(force.since)} {_list(map(number, force.polynomial))} {_list(tones)}"


def _spell(spell: Spell) -> str:
    return f"(Spell {number(spell.since)} {number(spell.friction)} ({_steady(spell.force)}))"


TEXT = """(** Written by `python -m numerics solve --proof`: the events of a scene, proved for every motion of it. *)
From Coq Require Import Reals QArith List.
From Interval.Float Require Import Specific_ops Specific_stdz.
From Interval.Interval Require Import Float_full.
From InertialPair Require Import Waves Trajectory.
Import ListNotations.
Module F := SpecificFloat StdZRadix2.
Module I := FloatIntervalFull F.
Module C := Check I.
Local Open Scope Q_scope.

(** m1, m2, a1 and a2; x1, v1, x2 and v2 at the time 0; from when on what friction and what force act *)
Definition the_scene := Scene {scene}
  {first} {later}.

(** its events: the mode until then; bounds of the time, of both places, and of the common velocity *)
Definition the_events : list event := {events}.

(** its end: the mode and the time; bounds of x1, v1, x2 and v2, and of v1 - v2; whether it sticks for ever *)
Definition the_ending := {ending}.

(** how body 1 and both bodies answer to the force *)
Definition answers := {answers}.

(** what helps the program: in how many bits to compute, bounds of the time since the event before, which way a stick
    ends; until when a mode lasts, for how long at least, and which motion is close then; until when a stick that is for
    ever is followed *)
Definition hints := [
  {hints}].

(** the program accepts it *)
Lemma accepted :
  C.check F.PtoP (F.PtoP {sign}) {depth} the_scene {state} answers the_events the_ending hints = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

(** so every motion of the scene runs through these events *)
Theorem trajectory x v1 x2 v2 : motion the_scene x v1 x2 v2 -> unfolds x v1 x2 v2 0 the_events the_ending.
Proof. exact (C.sound _ _ _ _ _ _ _ _ _ accepted x v1 x2 v2). Qed.
"""
