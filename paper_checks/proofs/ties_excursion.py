"""Ties of one excursion, of the return map, and of the merging set."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from paper_checks.proofs.gallina import term
from paper_checks.proofs.tie import NAMES, PAIR, Tie, equal
from theory import energy, excursion, merging, near_critical, return_map
from theory.symbols import epsilon, m1, m2, q, theta, v1_0, x1_0


def ties() -> Iterator[Tie]:
    """All of them."""
    yield from _excursion()
    yield from _merging()


def _excursion() -> Iterator[Tie]:
    """One excursion, in the half angle p: where it ends, its depth, the return map, the time of a cycle."""
    half = {theta: 2 * excursion.angle}
    inside = "0 < p < PI -> "
    sine = "pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)); "
    yield Tie(
        "tie_h",
        r"$h$: the push whose slip has the angle $\theta$.",
        equal("u", "1 - cos u <> 0 -> ", "h u", excursion.h()),
        "intros; unfold h; field; lra.",
    )
    yield Tie(
        "tie_half_angle_h",
        "The same in the half angle.",
        equal("p", inside, "hh p", excursion.h().subs(half)),
        f"intros; {sine}circle p; rewrite hh_h by auto; unfold h; rewrite cos_2a_sin; field; nra.",
    )
    yield Tie(
        "tie_depth",
        "The depth of an excursion.",
        equal("p", inside, "depth p", return_map.depth().subs(half)),
        f"intros; {sine}unfold depth; field; lra.",
    )
    contact = return_map.contact_condition().subs(return_map.push, 0).subs(half)
    yield Tie(
        "tie_push",
        r"The push whose slip from the gap $d$ has the half angle $\varphi$.",
        equal("d p", inside, "push d p", contact),
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
        "The energy level at the end of a slip from the gap $d$.",
        equal("m1 m2 p d", f"0 < m1 -> 0 < m2 -> {inside}", "level m1 m2 p d", landed.subs(q, share)),
        """intros m1 m2 p d H1 H2 Hp. pose proof (half_depth p Hp) as Id. pose proof (tie_depth p Hp) as Ed.
  pose proof (tie_half_angle_h p Hp) as Eh. unfold level. unfold ct in *. cbv zeta. rewrite <- Eh.
  set (k := cos p / sin p) in *. set (h := hh p) in *. set (c := depth p) in *. clearbody k h c.
  replace (-2 * p * k) with (c - 2) by lra. apply Rminus_diag_uniq.
  rewrite <- (Rmult_0_r (c + 2 * d)). replace 0 with (c * (1 + k ^ 2) - 2 * (1 - h * k)) at 1 by lra. unfold Rdiv. ring.""",
    )
    yield Tie(
        "tie_slip_time",
        "The duration of an excursion.",
        equal("m1 a2 p", "0 < m1 -> 0 < a2 -> ", "2 * p / o1 m1 a2", excursion.duration_in_si().subs(half)),
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
        equal("m1 m2 a2 b", PAIR, "rate m1 m2 a2", sp.powsimp(sp.expand(law))),
        """intros; unfold rate; rewrite sqrt_div_alt by lra. root (m1 + m2). root a2.
  replace (m1 + m2) with (w * w) by auto. replace a2 with (w0 * w0) by auto. field. lra.""",
    )


def _merging() -> Iterator[Tie]:
    """The turning function, and the share and the mass ratio at its zero."""
    yield Tie(
        "tie_turning_function",
        "The function whose zero is where $h/c$ turns.",
        equal("p", "", "K p", sp.expand(merging.turning_function())),
        "intros; unfold K; ring.",
    )
    yield Tie(
        "tie_ratio",
        "$h/c$ in the half angle.",
        equal("p", "0 < p < PI -> ", "ratio p", merging.ratio()),
        """intros; pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). pose proof (g_pos p ltac:(lra)).
  assert (1 - p * (cos p / sin p) = (sin p - p * cos p) / sin p) by (field; lra).
  rewrite ratio_AB by auto. field. repeat split; try lra; nra.""",
    )
    yield Tie(
        "tie_critical_mass_ratio",
        "The critical mass ratio by the zero of the turning function.",
        equal("p", "", "- cos (2 * p)", merging.critical_mass_ratio()),
        "intros; rewrite cos_2a_sin; ring.",
    )
