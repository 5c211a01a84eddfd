(** Decimals of the critical mass ratio, by Interval (primitive integers of the kernel among the axioms). *)
From Interval Require Import Tactic.
From InertialPair Require Import Dini TurningFunction.
(** a bracket of phi* , from below *)
Definition lo := 1898637871626800 / 1000000000000000.
(** and from above *)
Definition hi := 1898637871626801 / 1000000000000000.
(** [critical-mass-ratio-digits] The critical mass ratio $-\cos 2\varphi^*$ up to $2\cdot 10^{-14}$, and $\varphi^*$
    up to $10^{-15}$. *)
Theorem decimals p : 0 < p <= PI -> (forall q, 0 < q <= PI -> K q = 0 -> q = p) ->
  lo < p < hi /\ Rabs (- cos (2 * p) - 79263163272865 / 100000000000000) <= 2 / 100000000000000.
Proof.
  intros Hp U. assert (KL : 0 < K lo) by (unfold K, lo; interval with (i_prec 100)).
  assert (KH : K hi < 0) by (unfold K, hi; interval with (i_prec 100)). assert (3 < PI) by interval with (i_prec 60).
  destruct (cont_IVT K lo hi cont_K) as (q & Hq & Z); [unfold lo, hi; lra|nra|].
  assert (Hq' : lo < q < hi). { destruct (Req_dec q lo); [subst q; lra|]. destruct (Req_dec q hi); [subst q; lra|].
    lra. }
  rewrite <- (U q); [|unfold lo, hi in *; lra|auto]. split; auto. interval with (i_prec 100).
Qed.
