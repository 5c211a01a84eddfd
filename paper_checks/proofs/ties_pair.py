"""Ties of the law, the sliding region, and the closed forms of stick and slip."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from paper_checks.proofs.gallina import term
from paper_checks.proofs.tie import NAMES, PAIR, Tie, equal
from theory import energy, filippov, return_map, scaling
from theory.closed_forms import DampingRegime, rate, rates, solution
from theory.model import free_system
from theory.symbols import m1, m2, v1, v1_0, v2, v2_0, x1, x1_0


def ties() -> Iterator[Tie]:
    """All of them."""
    yield from _law()
    yield from _surface()
    yield from _motions()


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
        equal("m1 m2 a2 x v1 v2", "", "energy m1 m2 a2 x v1 v2", energy.energy()),
        "intros; unfold energy; field; lra.",
    )
    yield Tie(
        "tie_dwell_time",
        "The longest stay off $S$.",
        equal("m2 b e", "0 < m2 -> 0 < b -> 0 <= e -> ", "2 * sqrt (2 * e * m2) / b", energy.dwell_time_bound()),
        "intros; rewrite !sqrt_mult by nra; field; lra.",
    )


def _surface() -> Iterator[Tie]:
    """The sliding region, the critical energy, and the level below which a damped pair stays stuck."""
    yield Tie(
        "tie_half_width",
        "The half width $L$ of the sliding region.",
        equal("m1 m2 a2 b", PAIR, "L m1 m2 a2 b", filippov.half_width()),
        "intros; unfold L; field; lra.",
    )
    yield Tie(
        "tie_critical_energy",
        "The critical energy.",
        equal("m1 m2 a2 b", PAIR, "Ecr m1 m2 a2 b", energy.critical_energy()),
        "intros; unfold Ecr; field; lra.",
    )
    for sign, name in ((1, "above"), (-1, "below")):
        yield Tie(
            f"tie_rate_{name}",
            f"The rate of the relative velocity {name} $S$: the field's normal component.",
            equal("m1 m2 a2 b x", PAIR, f"normal_rate m1 m2 a2 b ({sign}) x", filippov.transversality(sign)),
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
        equal("m1 m2 a2", "0 < m1 -> 0 < m2 -> 0 < a2 -> ", "omega m1 m2 a2", scaling.stick_frequency()),
        "intros; unfold omega; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra.",
    )
    yield Tie(
        "tie_slip_frequency",
        "The frequency of slip.",
        equal("m1 a2", "0 < m1 -> 0 < a2 -> ", "o1 m1 a2", rates("slip-", DampingRegime.UNDAMPED)[rate]),
        "intros; unfold o1; rewrite sqrt_div_alt by lra; field; apply Rgt_not_eq, sqrt_lt_R0; lra.",
    )
    names = NAMES | {rate: "(omega m1 m2 a2)", x1_0: "x0", v1_0: "v0"}
    stick = solution("stick", DampingRegime.UNDAMPED)
    for name, mine, theirs in (("place", "X", stick.x1), ("speed", "V", stick.v1)):
        yield Tie(
            f"tie_stick_{name}",
            f"Stick: the {name} of both bodies.",
            equal("m1 m2 a2 x0 v0 t", "0 < m1 -> 0 < m2 -> 0 < a2 -> ", f"{mine} m1 m2 a2 x0 v0 t", theirs, names),
            "intros; pose proof (omega_pos m1 m2 a2 ltac:(lra) ltac:(lra) ltac:(lra)); unfold X, V; rewrite ?(Rmult_comm t); field; lra.",
        )
    unit = scaling.half_width() * scaling.stick_frequency() * sp.sqrt(m1 / (m1 + m2))
    yield Tie(
        "tie_ray",
        r"The speed on an exit ray: $h$, in units of $L\Omega\sqrt q$.",
        equal("m1 m2 a2 b u", PAIR, "ray m1 m2 a2 b u", unit * return_map.push),
        """intros; unfold ray, o1; rewrite sqrt_div_alt by lra. root m1. root a2.
  replace m1 with (w * w) by auto. field. lra.""",
    )
    slip = solution("slip-", DampingRegime.UNDAMPED)
    for name, letter, theirs in (("place", "x", slip.x1), ("speed", "1", slip.v1), ("driven", "2", slip.v2)):
        for start, gap in (("slip", "0"), ("gap", "d")):
            at = "u t" if letter == "2" else f"{gap} u t"
            yield _slip(f"tie_{start}_{name}", f"G{letter} m1 m2 a2 b {at}", theirs, gap)


def _slip(name: str, mine: str, theirs: sp.Expr, gap: str) -> Tie:
    """The slip from x > 0 on S, `gap` beyond the end of the sliding region in units of q L, with the push u."""
    speed = "(ray m1 m2 a2 b u)"
    place = f"(L m1 m2 a2 b * (1 + m1 / (m1 + m2) * {gap}))"
    names = NAMES | {rate: "(o1 m1 a2)", x1_0: place, v1_0: speed, v2_0: speed}
    return Tie(
        name,
        f"Slip from {'the ray' if gap == '0' else '$S$ at the gap $d$'}: {name.rsplit('_', maxsplit=1)[1]} (driven: of body 2).",
        equal("m1 m2 a2 b d u t", PAIR, mine, theirs, names),
        f"""intros; unfold {mine.split(maxsplit=1)[0]}, ray, L; pose proof (o1_pos m1 a2 ltac:(lra) ltac:(lra)).
  assert (Q : a2 = m1 * (o1 m1 a2 * o1 m1 a2)) by (apply o1_sq; lra). set (o := o1 m1 a2) in *. clearbody o. subst a2.
  rewrite ?(Rmult_comm t o). field. repeat split; lra.""",
    )
