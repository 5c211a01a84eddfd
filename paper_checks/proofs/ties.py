"""Tie.v, written anew from `theory/`: every definition of the proofs equals the expression that the theory derives.

The right side of each equation is printed from sympy, so a changed sign in `theory/` or in a proof file breaks its proof.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from paper_checks.proofs.gallina import term
from paper_checks.proofs.sources import LIBRARY
from theory import energy, excursion, filippov, merging, near_critical, return_map, scaling
from theory.closed_forms import Regime, rate, rates, solution
from theory.model import free_system
from theory.symbols import E0, a1, a2, b, epsilon, m1, m2, q, t, theta, v1, v1_0, v2, v2_0, x1, x1_0

PAIR = "0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b -> "
NAMES = {one: one.name for one in (m1, m2, a1, a2, b, t)} | {
    x1: "x",
    v1: "v1",
    v2: "v2",
    E0: "e",
    theta: "u",
    excursion.angle: "p",
    energy.sigma: "sg",
    return_map.gap: "d",
    return_map.push: "u",
}
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


@dataclass(frozen=True)
class Tie:
    """One statement that a definition is what the theory says, and its proof."""

    name: str
    words: str
    statement: str
    proof: str

    @property
    def text(self) -> str:
        """As it stands in the file."""
        return f"(** {self.words} *)\nTheorem {self.name} : {self.statement}.\nProof. {self.proof} Qed.\n"


def text() -> str:
    """The whole file."""
    return "\n".join([HEADER, *(tie.text for tie in ties())])


def ties() -> Iterator[Tie]:
    """All ties."""
    yield from _law()
    yield from _surface()
    yield from _motions()
    yield from _excursion()
    yield from _merging()


def _equal(variables: str, given: str, mine: str, theirs: sp.Expr, names: Mapping[sp.Symbol, str] | None = None) -> str:
    return f"forall {variables} : R, {given}{mine} = {term(theirs, names or NAMES)}"


def _law() -> Iterator[Tie]:
    """The equations of motion, with the friction's impulse s in the place of the integral of its sign."""
    field = free_system(energy.sigma)
    along = NAMES | {x1: "(x t)", v1: "(v1 t)", v2: "(v2 t)"}
    forces = [sp.expand(mass * entry) for mass, entry in zip((1, m1, m2), field, strict=True)]
    smooth = [term(force.subs(energy.sigma, 0), along) for force in forces]
    friction = [term(sp.diff(force, energy.sigma), NAMES) for force in forces]
    guard = term(filippov.guard(), along)
    yield Tie(
        "tie_solution",
        "A solution obeys the equations of motion of the theory, with an impulse that follows the sign of its guard.",
        f"""forall m1 m2 a1 a2 b (x v1 v2 s : R -> R), solution m1 m2 a1 a2 b x v1 v2 s <->
  ((forall r t, 0 <= r <= t -> Rabs (s t - s r) <= t - r) /\\
   (forall t, 0 <= t -> 0 < {guard} -> rderiv s t 1) /\\ (forall t, 0 <= t -> {guard} < 0 -> rderiv s t (-1)) /\\
   cont x /\\ cont v1 /\\
   (forall t, 0 <= t -> rderiv (fun t => x t - {friction[0]} * s t) t {smooth[0]}) /\\
   (forall t, 0 <= t -> rderiv (fun t => m1 * v1 t - {friction[1]} * s t) t {smooth[1]}) /\\
   (forall t, 0 <= t -> m2 * v2 t - {friction[2]} * s t = m2 * v2 0 - {friction[2]} * s 0 + {smooth[2]} * t))""",
        """intros; split.
  - intros [L P N CX CV X V W]. split; [auto|]. split; [intros; apply P; lra|]. split; [intros; apply N; lra|].
    split; [auto|]. split; [auto|]. split; [|split].
    + intros t Ht. apply rderiv_ext with x; [intros; ring|auto].
    + intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring].
    + intros t Ht. pose proof (W t Ht). lra.
  - intros (L & P & N & CX & CV & X & V & W). constructor; auto.
    + intros; apply P; lra.
    + intros; apply N; lra.
    + intros t Ht. eapply rderiv_ext; [|exact (X t Ht)]. intros; cbv beta; ring.
    + intros t Ht. eapply rderiv_ext; [|eapply rderiv_eq; [|exact (V t Ht)]]; [intros; cbv beta; ring|ring].
    + intros t Ht. pose proof (W t Ht). lra.""",
    )
    yield Tie(
        "tie_energy",
        "The energy.",
        _equal("m1 m2 a2 x v1 v2", "", "energy m1 m2 a2 x v1 v2", energy.energy()),
        "intros; unfold energy; field; lra.",
    )
    yield Tie(
        "tie_dwell_time",
        "The longest stay off S.",
        _equal("m2 b e", "0 < m2 -> 0 < b -> 0 <= e -> ", "2 * sqrt (2 * e * m2) / b", energy.dwell_time_bound()),
        "intros; rewrite !sqrt_mult by nra; field; lra.",
    )


def _surface() -> Iterator[Tie]:
    """The sliding region, the critical energy, and the level below which a damped pair stays stuck."""
    yield Tie(
        "tie_half_width",
        "The half width L of the sliding region.",
        _equal("m1 m2 a2 b", PAIR, "L m1 m2 a2 b", filippov.half_width()),
        "intros; unfold L; field; lra.",
    )
    yield Tie(
        "tie_critical_energy",
        "The critical energy.",
        _equal("m1 m2 a2 b", PAIR, "Ecr m1 m2 a2 b", energy.critical_energy()),
        "intros; unfold Ecr; field; lra.",
    )
    for sign, name in ((1, "above"), (-1, "below")):
        yield Tie(
            f"tie_rate_{name}",
            f"The rate of the relative velocity {name} S: the field's normal component.",
            _equal("m1 m2 a2 b x", PAIR, f"normal_rate m1 m2 a2 b ({sign}) x", filippov.transversality(sign)),
            "intros; unfold normal_rate; field; lra.",
        )
    yield Tie(
        "tie_captive",
        "With damping: the level whose ellipse lies in the sliding region.",
        f"forall m1 m2 a1 a2 b e : R, {PAIR}0 <= a1 -> (captive m1 m2 a1 a2 b e <-> e <= {term(energy.captive_energy(), NAMES)})",
        """intros. unfold captive.
  assert (W : 0 < a2 + a1 ^ 2 / (m1 + m2)).
  { assert (0 <= a1 ^ 2 / (m1 + m2)); [|lra]. apply Rmult_le_pos; [nra|apply Rlt_le, Rinv_0_lt_compat; lra]. }
  match goal with |- _ <-> e <= ?t => assert (E : t = (b * (m1 + m2) / m2) ^ 2 / (2 * (a2 + a1 ^ 2 / (m1 + m2)))) end.
  { field. repeat split; try lra. pose proof (pow2_ge_0 a1). nra. }
  rewrite E. split; intros I.
  - apply Rmult_le_reg_r with (2 * (a2 + a1 ^ 2 / (m1 + m2))); [lra|]. unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - apply Rmult_le_compat_r with (r := 2 * (a2 + a1 ^ 2 / (m1 + m2))) in I; [|lra].
    unfold Rdiv at 2 in I. rewrite Rmult_assoc, Rinv_l in I by lra. lra.""",
    )


def _motions() -> Iterator[Tie]:
    """The closed forms of stick and of slip, and their frequencies."""
    yield Tie(
        "tie_stick_frequency",
        "The frequency of stick.",
        _equal("m1 m2 a2", "0 < m1 -> 0 < m2 -> 0 < a2 -> ", "omega m1 m2 a2", scaling.stick_frequency()),
        "intros; unfold omega; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra.",
    )
    yield Tie(
        "tie_slip_frequency",
        "The frequency of slip.",
        _equal("m1 a2", "0 < m1 -> 0 < a2 -> ", "o1 m1 a2", rates("slip-", Regime.UNDAMPED)[rate]),
        "intros; unfold o1; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra.",
    )
    names = NAMES | {rate: "(omega m1 m2 a2)", x1_0: "x0", v1_0: "v0"}
    stick = solution("stick", Regime.UNDAMPED)
    for name, mine, theirs in (("place", "X", stick.x1), ("speed", "V", stick.v1)):
        yield Tie(
            f"tie_stick_{name}",
            f"Stick: the {name} of both bodies.",
            _equal("m1 m2 a2 x0 v0 t", "0 < m1 -> 0 < m2 -> 0 < a2 -> ", f"{mine} m1 m2 a2 x0 v0 t", theirs, names),
            "intros; pose proof (omega_pos m1 m2 a2 ltac:(lra) ltac:(lra) ltac:(lra)); unfold X, V; rewrite ?(Rmult_comm t); field; lra.",
        )
    unit = scaling.half_width() * scaling.stick_frequency() * sp.sqrt(m1 / (m1 + m2))
    yield Tie(
        "tie_ray",
        "The speed on an exit ray: u, in units of sqrt q, of length and of frequency.",
        _equal("m1 m2 a2 b u", PAIR, "ray m1 m2 a2 b u", unit * return_map.push),
        """intros; unfold ray, o1; rewrite sqrt_div_alt by lra. root m1. root a2.
  replace m1 with (w * w) by auto. field. lra.""",
    )
    slip = solution("slip-", Regime.UNDAMPED)
    for name, letter, at, theirs in (
        ("place", "x", "u t", slip.x1),
        ("speed", "1", "u t", slip.v1),
        ("driven", "2", "u t", slip.v2),
    ):
        gap_at = at if letter == "2" else f"d {at}"
        yield _slip(f"tie_slip_{name}", f"S{letter} m1 m2 a2 b {at}", theirs, "0")
        yield _slip(f"tie_gap_{name}", f"G{letter} m1 m2 a2 b {gap_at}", theirs, "d")


def _slip(name: str, mine: str, theirs: sp.Expr, gap: str) -> Tie:
    """The slip from x > 0 on S, `gap` beyond the end of the sliding region in units of q L, with the push u."""
    speed = "(ray m1 m2 a2 b u)"
    place = f"(L m1 m2 a2 b * (1 + m1 / (m1 + m2) * {gap}))"
    names = NAMES | {rate: "(o1 m1 a2)", x1_0: place, v1_0: speed, v2_0: speed}
    return Tie(
        name,
        f"Slip from {'the ray' if gap == '0' else 'S at the gap d'}: {name.rsplit('_', maxsplit=1)[1]} (driven: of body 2).",
        _equal("m1 m2 a2 b d u t", PAIR, mine, theirs, names),
        f"""intros; unfold {mine.split(maxsplit=1)[0]}, ray, L; pose proof (o1_pos m1 a2 ltac:(lra) ltac:(lra)).
  assert (Q : a2 = m1 * (o1 m1 a2 * o1 m1 a2)) by (apply o1_sq; lra). set (o := o1 m1 a2) in *. clearbody o. subst a2.
  rewrite ?(Rmult_comm t o). field. repeat split; lra.""",
    )


def _excursion() -> Iterator[Tie]:
    """One excursion, in the half angle p: where it ends, its depth, the return map, the time of a cycle."""
    half = {theta: 2 * excursion.angle}
    inside = "0 < p < PI -> "
    sine = "pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); "
    yield Tie(
        "tie_h",
        "h: the push whose slip has the angle u.",
        _equal("u", "1 - cos u <> 0 -> ", "h u", excursion.h()),
        "intros; unfold h; field; lra.",
    )
    yield Tie(
        "tie_half_angle_h",
        "The same in the half angle.",
        _equal("p", inside, "hh p", excursion.h().subs(half)),
        f"intros; {sine}circle p; rewrite hh_h by auto; unfold h; rewrite cos_2a_sin; field; nra.",
    )
    yield Tie(
        "tie_depth",
        "The depth of an excursion.",
        _equal("p", inside, "depth p", return_map.depth().subs(half)),
        f"intros; {sine}unfold depth; field; lra.",
    )
    contact = return_map.contact_condition().subs(return_map.push, 0).subs(half)
    yield Tie(
        "tie_push",
        "The push whose slip from the gap d has the half angle p.",
        _equal("d p", inside, "push d p", contact),
        f"intros; {sine}unfold push, ct; rewrite tie_half_angle_h by auto; field; rewrite ?cos_2a_sin; split; nra.",
    )
    share = m1 / (m1 + m2)
    after = return_map.return_map_of_angle()[1].subs(half).subs(q, share)
    yield Tie(
        "tie_return_map",
        "The return map, in the half angle.",
        f"forall m1 m2 p : R, 0 < m1 -> 0 < m2 -> {inside}next m1 m2 p = half (sqrt {term(after, NAMES)})",
        f"intros; {sine}unfold next; rewrite tie_half_angle_h, tie_depth by auto; do 2 f_equal; field; rewrite ?cos_2a_sin; repeat split; nra.",
    )
    start = {return_map.gap: return_map.gap, return_map.push: contact}
    change = (return_map.landing().excess_change / q).subs(half)
    landed = merging.over_q(start[return_map.gap], contact).subs(merging.share, 1 - q) + change
    yield Tie(
        "tie_level",
        "The energy level at the end of a slip from the gap d.",
        _equal("m1 m2 p d", f"0 < m1 -> 0 < m2 -> {inside}", "level m1 m2 p d", landed.subs(q, share)),
        """intros m1 m2 p d H1 H2 Hp. pose proof (half_depth p Hp) as Id. pose proof (tie_depth p Hp) as Ed.
  pose proof (tie_half_angle_h p Hp) as Eh. unfold level. unfold ct in *. cbv zeta. rewrite <- Eh.
  set (k := cos p / sin p) in *. set (h := hh p) in *. set (c := depth p) in *. clearbody k h c.
  replace (-2 * p * k) with (c - 2) by lra. apply Rminus_diag_uniq.
  rewrite <- (Rmult_0_r (c + 2 * d)). replace 0 with (c * (1 + k ^ 2) - 2 * (1 - h * k)) at 1 by lra. unfold Rdiv. ring.""",
    )
    yield Tie(
        "tie_slip_time",
        "The duration of an excursion.",
        _equal("m1 a2 p", "0 < m1 -> 0 < a2 -> ", "2 * p / o1 m1 a2", excursion.duration_in_si().subs(half)),
        "intros; unfold o1; rewrite sqrt_div_alt by lra. root m1. root a2. field. lra.",
    )
    # the stick from (X, V) on S to the ray at the speed eps: X = rho cos(B), V = - rho sin(B) and -1 = rho cos(A)
    rotation = near_critical.stick_rotation()
    names = NAMES | {x1_0: "z", v1_0: "v", epsilon: "e"}
    yield Tie(
        "tie_stick_rotation",
        "The stick between two excursions, as the difference of two arc cosines.",
        f"""forall z v e rho : R, 0 < rho -> v <= 0 -> 0 <= e -> z ^ 2 + v ^ 2 = rho ^ 2 -> 1 + e ^ 2 = rho ^ 2 ->
  cos (acos (- / rho) - acos (z / rho)) = {term(rotation[0], names)} /\\
  sin (acos (- / rho) - acos (z / rho)) = {term(rotation[1], names)}""",
        """intros z v e rho R V E Z O.
  assert (I : / rho * rho = 1) by (apply Rinv_l; lra). assert (P : 0 < / rho) by (apply Rinv_0_lt_compat; auto).
  assert (B1 : -1 <= - / rho <= 1) by (split; nra). assert (B2 : -1 <= z / rho <= 1) by (unfold Rdiv; split; nra).
  rewrite cos_minus, sin_minus, !cos_acos, !sin_acos by auto.
  assert (S1 : sqrt (1 - (- / rho)²) = e / rho).
  { rewrite <- (sqrt_Rsqr (e / rho)) by (apply Rmult_le_pos; lra). f_equal. unfold Rsqr, Rdiv.
    replace (e * / rho * (e * / rho)) with ((rho ^ 2 - 1) * / rho * / rho) by (rewrite <- O; ring). field. lra. }
  assert (S2 : sqrt (1 - (z / rho)²) = - v / rho).
  { rewrite <- (sqrt_Rsqr (- v / rho)) by (apply Rmult_le_pos; lra). f_equal. unfold Rsqr, Rdiv.
    replace (- v * / rho * (- v * / rho)) with ((rho ^ 2 - z ^ 2) * / rho * / rho) by (rewrite <- Z; ring). field. lra. }
  rewrite S1, S2. assert (N : 0 < z ^ 2 + v ^ 2) by (rewrite Z; nra).
  split; (replace (v ^ 2 + z ^ 2) with (rho ^ 2) by (rewrite <- Z; ring)); field; lra.""",
    )
    law = near_critical.rate_constant() / energy.critical_energy()
    yield Tie(
        "tie_rate",
        "The constant of the sharp law, in units of the critical energy.",
        _equal("m1 m2 a2 b", PAIR, "rate m1 m2 a2", sp.powsimp(sp.expand(law))),
        """intros; unfold rate; rewrite sqrt_div_alt by lra. root (m1 + m2). root a2.
  replace (m1 + m2) with (w * w) by auto. replace a2 with (w0 * w0) by auto. field. lra.""",
    )


def _merging() -> Iterator[Tie]:
    """The turning function, and the share and the mass ratio at its zero."""
    yield Tie(
        "tie_turning_function",
        "The function whose zero is where h/c turns.",
        _equal("p", "", "K p", sp.expand(merging.turning_function())),
        "intros; unfold K; ring.",
    )
    yield Tie(
        "tie_ratio",
        "h/c in the half angle.",
        _equal("p", "0 < p < PI -> ", "ratio p", merging.ratio()),
        """intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). pose proof (g_pos p ltac:(lra)).
  assert (1 - p * (cos p / sin p) = (sin p - p * cos p) / sin p) by (field; lra).
  rewrite ratio_AB by auto. field. repeat split; try lra; nra.""",
    )
    yield Tie(
        "tie_critical_mass_ratio",
        "The critical mass ratio by the zero of the turning function.",
        _equal("p", "", "- cos (2 * p)", merging.critical_mass_ratio()),
        "intros; rewrite cos_2a_sin; ring.",
    )
