(** The pair on a surface, round friction. A stuck pair runs on an ellipse: it sticks for ever exactly if the semi-major
  axis is at most L, so the energy of the edge lies between E_cr (a line) and 2 E_cr (a circle). The end of a slip is a
      regular event of G = b|s| + Lambda.s. *)
From InertialPair Require Import Dini MonotoneInclusion EnergyLimit.

Section Ellipse.
Context {Y : ModuleSpace R_AbsRing}.
Variable ip : Y -> Y -> R.
Hypothesis In : inner ip.
Variables q p : Y.

(** the stuck motion with the place q and the velocity p (in units of the frequency) at the phase 0 *)
Definition ellipse th := plus (scal (cos th) q) (scal (sin th) p).
(** the square of its semi-major axis: of the operator norm of the matrix with the columns q, p *)
Definition semi_major_square := (ip q q + ip p p + sqrt ((ip q q - ip p p) ^ 2 + 4 * ip q p ^ 2)) / 2.

Let A := ip q q.
Let B := ip p p.
Let C := ip q p.
Let R0 := sqrt ((A - B) ^ 2 + 4 * C ^ 2).
Let R0_sq : R0 * R0 = (A - B) ^ 2 + 4 * C ^ 2.
Proof. apply sqrt_sqrt. pose proof (pow2_ge_0 (A - B)). pose proof (pow2_ge_0 C). lra. Qed.
Let R0_pos : 0 <= R0 := sqrt_pos _.

(** the load along it, by the double angle *)
Lemma ellipse_square th : ip (ellipse th) (ellipse th) = (A + B) / 2 + (A - B) / 2 * cos (2 * th) + C * sin (2 * th).
Proof.
  unfold ellipse. rewrite (ip_plus _ In), !(ip_scal _ In), (ip_sym _ In q (plus _ _)), (ip_sym _ In p (plus _ _)),
    !(ip_plus _ In), !(ip_scal _ In), (ip_sym _ In p q). fold A B C. rewrite sin_2a, cos_2a.
  pose proof (sin2_cos2 th) as SC. unfold Rsqr in SC.
  replace ((A + B) / 2) with ((A + B) / 2 * (sin th * sin th + cos th * cos th)) by (rewrite SC; ring). field.
Qed.

(** T3: within the friction for ever exactly if the semi-major axis is at most L *)
Theorem stuck_iff L : 0 <= L -> ((forall th, norm ip (ellipse th) <= L) <-> semi_major_square <= L ^ 2).
Proof.
  intros HL. assert (Sq : forall th, norm ip (ellipse th) <= L <-> ip (ellipse th) (ellipse th) <= L ^ 2).
  { intros th. rewrite <- (norm_sq ip In). pose proof (norm_pos ip (ellipse th)). split; intros; nra. }
  unfold semi_major_square. fold A B C R0. split; intros K.
  - destruct (Req_dec R0 0) as [Z|N].
    + specialize (K 0). apply Sq in K. rewrite ellipse_square, Rmult_0_r, cos_0, sin_0 in K. rewrite Z.
      assert (A - B = 0); [|lra]. apply Rsqr_0_uniq. unfold Rsqr. pose proof (pow2_ge_0 (A - B)). pose proof (pow2_ge_0
        C).
      rewrite Z in R0_sq. lra.
    + destruct (polar (A - B) (2 * C) R0 2 0) as (th & _ & Ec & Es); [lra|lra|replace (R0 ^ 2) with (R0 * R0) by ring;
        rewrite R0_sq; ring|].
      specialize (K th). apply Sq in K. rewrite ellipse_square in K.
      assert (E : (A - B) * cos (2 * th) + 2 * C * sin (2 * th) = R0).
      { apply Rmult_eq_reg_l with R0; auto. pose proof (sin2_cos2 (2 * th)) as SC. unfold Rsqr in SC.
        replace (R0 * ((A - B) * cos (2 * th) + 2 * C * sin (2 * th))) with ((A - B) * (R0 * cos (2 * th)) + 2 * C * (R0
          * sin (2 * th))) by ring. rewrite Ec, Es. lra. }
      lra.
  - intros th. apply Sq. rewrite ellipse_square. pose proof (sin2_cos2 (2 * th)) as SC. unfold Rsqr in SC.
    set (c := cos (2 * th)) in *. set (s := sin (2 * th)) in *. assert (Q : (A - B) * c + 2 * C * s <= R0); [|lra].
    apply Rnot_lt_le. intros N. pose proof (pow2_ge_0 ((A - B) * s - 2 * C * c)).
    assert (((A - B) * c + 2 * C * s) ^ 2 + ((A - B) * s - 2 * C * c) ^ 2 = R0 * R0).
    { rewrite R0_sq. replace (((A - B) * c + 2 * C * s) ^ 2 + ((A - B) * s - 2 * C * c) ^ 2) with (((A - B) ^ 2 + 4 * C
      ^ 2) * (s * s
        + c * c)) by ring. rewrite SC. ring. }
    nra.
Qed.

(** in units of E_cr the energy is (|q|^2 + |p|^2) / L^2: up to 1 it sticks for ever, beyond 2 never, and a line or a
  circle exactly up to there *)
Theorem stuck_energies L : 0 <= L ->
  (A + B <= L ^ 2 -> forall th, norm ip (ellipse th) <= L) /\
  ((forall th, norm ip (ellipse th) <= L) -> A + B <= 2 * L ^ 2) /\
  (C ^ 2 = A * B -> ((forall th, norm ip (ellipse th) <= L) <-> A + B <= L ^ 2)) /\
  (A = B /\ C = 0 -> ((forall th, norm ip (ellipse th) <= L) <-> A + B <= 2 * L ^ 2)).
Proof.
  intros HL. pose proof (ip_pos _ In q) as PA. pose proof (ip_pos _ In p) as PB. fold A in PA. fold B in PB.
  pose proof (cauchy_abs ip In q p) as CS. fold C in CS. assert (C2 : C ^ 2 <= A * B).
  { rewrite <- (pow2_abs C). unfold A, B. rewrite <- (norm_sq ip In q), <- (norm_sq ip In p). pose proof (Rabs_pos C).
    replace (norm ip q * norm ip q * (norm ip p * norm ip p)) with ((norm ip q * norm ip p) ^ 2) by ring. apply
      pow_incr; auto. }
  rewrite (stuck_iff L HL). unfold semi_major_square. fold A B C R0. split; [|split; [|split]].
  - intros E. assert (R0 <= A + B); [|lra]. apply Rnot_lt_le. intros N. nra.
  - intros E. lra.
  - intros E. assert (R0 = A + B); [|split; lra]. apply Rsqr_inj; [auto|lra|]. unfold Rsqr. rewrite R0_sq, E. ring.
  - intros (E & Z). assert (R0 = 0); [|split; lra]. apply Rsqr_inj; [auto|lra|]. unfold Rsqr. rewrite R0_sq, E, Z. ring.
Qed.
End Ellipse.

(** T4: in slip s' = k (Lambda - b s/|s|) the function G = b|s| + Lambda.s falls towards its zero, the end of the slip,
  at a rate that does not vanish there while |Lambda| < b *)
Theorem landing_rate k b (x y p q : R -> R) l l' t : 0 < x t ^ 2 + y t ^ 2 ->
  is_derive x t (k * (p t - b * x t / sqrt (x t ^ 2 + y t ^ 2))) ->
  is_derive y t (k * (q t - b * y t / sqrt (x t ^ 2 + y t ^ 2))) -> is_derive p t l -> is_derive q t l' ->
  is_derive (fun t => b * sqrt (x t ^ 2 + y t ^ 2) + (p t * x t + q t * y t)) t
    (- k * (b ^ 2 - (p t ^ 2 + q t ^ 2)) + (l * x t + l' * y t)).
Proof.
  intros Hp X Y P Q. pose proof (sqrt_lt_R0 _ Hp) as Sp. pose proof (sqrt_sqrt _ (Rlt_le _ _ Hp)) as Sq.
  set (r := sqrt (x t ^ 2 + y t ^ 2)) in *. evar_last.
  { apply (is_derive_plus (fun t => b * sqrt (x t ^ 2 + y t ^ 2)) (fun t => p t * x t + q t * y t)).
    - apply is_derive_scal, (is_derive_comp sqrt (fun t => x t ^ 2 + y t ^ 2)); [apply is_derive_Reals,
      derivable_pt_lim_sqrt, Hp|].
      apply (is_derive_plus (fun t => x t ^ 2) (fun t => y t ^ 2)); apply (is_derive_pow _ 2); eassumption.
    - apply (is_derive_plus (fun t => p t * x t) (fun t => q t * y t)); apply @is_derive_mult; try eassumption; intros;
      apply Rmult_comm. }
  unfold plus, mult, scal; simpl; unfold mult; simpl. change (sqrt (x t * (x t * 1) + y t * (y t * 1))) with r. apply
    Rminus_diag_uniq.
  apply Rmult_eq_reg_l with (r * r); [|nra]. rewrite Rmult_0_r.
  match goal with |- ?a = 0 => replace a with (k * b ^ 2 * (r * r - (x t ^ 2 + y t ^ 2))) by (field; lra) end.
  rewrite Sq. ring.
Qed.
