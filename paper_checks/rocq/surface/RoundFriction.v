(** The pair on a surface, round friction. A stuck pair runs on an ellipse: it sticks for ever exactly if the semi-major
  axis is at most L, so the energy of the edge lies between E_cr (a line) and 2 E_cr (a circle). The end of a slip is a
      regular event of G = b|s| + Lambda.s. *)
From InertialPair Require Import Dini MonotoneInclusion EnergyLimit.

Section Ellipse.
Context {Y : ModuleSpace R_AbsRing}.
Context (ip : Y -> Y -> R) (In : inner ip).
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
Proof. apply sqrt_sqrt. positive. Qed.
Let R0_pos : 0 <= R0 := sqrt_pos _.

(** the load along it, by the double angle *)
Lemma ellipse_square th : ip (ellipse th) (ellipse th) = (A + B) / 2 + (A - B) / 2 * cos (2 * th) + C * sin (2 * th).
Proof.
  unfold ellipse. rewrite (ip_plus _ In), !(ip_scal _ In), (ip_sym _ In q (plus _ _)), (ip_sym _ In p (plus _ _)),
    !(ip_plus _ In), !(ip_scal _ In), (ip_sym _ In p q). fold A B C. rewrite sin_2a, cos_2a.
  pose proof (sin2_cos2 th) as SC. unfold Rsqr in SC.
  replace ((A + B) / 2) with ((A + B) / 2 * (sin th * sin th + cos th * cos th)) by (rewrite SC; ring). field.
Qed.

(** [plane-stuck-iff] On a stuck ellipse the load stays within isotropic friction permanently exactly if the
    semi-major axis is at most $L$. *)
Theorem stuck_iff L : 0 <= L -> ((forall th, norm ip (ellipse th) <= L) <-> semi_major_square <= L ^ 2).
Proof.
  intros HL. assert (Sq : forall th, norm ip (ellipse th) <= L <-> ip (ellipse th) (ellipse th) <= L ^ 2).
  { intros th. rewrite <- (norm_sq ip In). pose proof (norm_pos ip (ellipse th)). split; intros; nra. }
  unfold semi_major_square. fold A B C R0. split; intros K.
  - destruct (Req_dec R0 0) as [Z|N].
    + specialize (K 0). apply Sq in K. rewrite ellipse_square, Rmult_0_r, cos_0, sin_0 in K. nra.
    + destruct (polar (A - B) (2 * C) R0 2 0) as (th & _ & Ec & Es); [lra|lra|replace (R0 ^ 2) with (R0 * R0) by ring;
        rewrite R0_sq; ring|]. specialize (K th). apply Sq in K. rewrite ellipse_square in K. nra.
  - intros th. apply Sq. rewrite ellipse_square. pose proof (sin2_cos2 (2 * th)) as SC. unfold Rsqr in SC.
    set (c := cos (2 * th)) in *. set (s := sin (2 * th)) in *. pose proof (pow2_ge_0 ((A - B) * s - 2 * C * c)). nra.
Qed.

(** [plane-stuck-energies] On a stuck ellipse the load stays within isotropic friction always up to $E_{cr}$, never
    beyond $2E_{cr}$; on a line exactly up to the first, on a circle exactly up to the second. *)
Theorem stuck_energies L : 0 <= L ->
  (A + B <= L ^ 2 -> forall th, norm ip (ellipse th) <= L) /\
  ((forall th, norm ip (ellipse th) <= L) -> A + B <= 2 * L ^ 2) /\
  (C ^ 2 = A * B -> ((forall th, norm ip (ellipse th) <= L) <-> A + B <= L ^ 2)) /\
  (A = B /\ C = 0 -> ((forall th, norm ip (ellipse th) <= L) <-> A + B <= 2 * L ^ 2)).
Proof.
  intros HL. pose proof (ip_pos _ In q) as PA. pose proof (ip_pos _ In p) as PB. fold A in PA. fold B in PB.
  pose proof (cauchy_abs ip In q p) as CS. assert (C2 : C ^ 2 <= A * B).
  { rewrite <- (pow2_abs C). unfold A, B. rewrite <- (norm_sq ip In q), <- (norm_sq ip In p). pose proof (Rabs_pos C).
    replace (norm ip q * norm ip q * (norm ip p * norm ip p)) with ((norm ip q * norm ip p) ^ 2) by ring. apply
      pow_incr; auto. }
  rewrite (stuck_iff L HL). unfold semi_major_square. fold A B C R0. nra.
Qed.
End Ellipse.

(** Every stuck motion is such an ellipse: body 1 carries both masses on its spring, component by component. The force on
    body 2 is m2 times its acceleration, and within b exactly while the place is within L; with p in units of the frequency
    the energy is a2 (|q|^2 + |p|^2) / 2, and E_cr that of the place L. *)
Lemma oscillator om (x v : R -> R) : 0 < om -> (forall t, is_derive x t (v t)) ->
  (forall t, is_derive v t (- (om * om) * x t)) ->
  forall t, x t = x 0 * cos (om * t) + v 0 / om * sin (om * t) /\ x t ^ 2 + (v t / om) ^ 2 = x 0 ^ 2 + (v 0 / om) ^ 2.
Proof.
  intros Ho X V t. set (c := fun t => x t * cos (om * t) - v t / om * sin (om * t)).
  set (s := fun t => x t * sin (om * t) + v t / om * cos (om * t)).
  assert (Dx : forall t, Derive (fun u => x u) t = v t) by (intros; apply is_derive_unique, X).
  assert (Dv : forall t, Derive (fun u => v u) t = - (om * om) * x t) by (intros; apply is_derive_unique, V).
  assert (Const : forall f, (forall t, is_derive f t 0) -> f t = f 0).
  { intros f D.
    destruct (MVT_gen f 0 t (fun _ => 0)) as (m & _ & E); [auto|intros; apply derivable_continuous_pt; eexists;
      apply is_derive_Reals, D|lra]. }
  assert (C : c t = c 0) by (apply Const; intros u; unfold c; auto_derive; [repeat split; eexists; eauto|rewrite Dx, Dv;
    field; lra]).
  assert (S : s t = s 0) by (apply Const; intros u; unfold s; auto_derive; [repeat split; eexists; eauto|rewrite Dx, Dv;
    field; lra]). unfold c, s in C, S. rewrite Rmult_0_r, cos_0, sin_0 in C, S. pose proof (sin2_cos2 (om * t)) as SC.
  unfold Rsqr in SC. set (co := cos (om * t)) in *. set (si := sin (om * t)) in *.
  replace (x 0) with (x t * co - v t / om * si) by lra. replace (v 0 / om) with (x t * si + v t / om * co) by lra.
  split.
  - transitivity (x t * (si * si + co * co)); [rewrite SC|]; ring.
  - transitivity ((x t ^ 2 + (v t / om) ^ 2) * (si * si + co * co)); [rewrite SC|]; ring.
Qed.

(** [plane-stuck-load] A stuck pair in the plane moves on an ellipse; the force on body 2 is within $b$ exactly while
    the place is within $L$; its energy by the ellipse, and $E_{cr}=a_2L^2/2$. *)
Theorem stuck_load m1 m2 a2 b (x y v w ax ay : R -> R) : 0 < m1 -> 0 < m2 -> 0 < a2 -> 0 < b ->
  (forall t, is_derive x t (v t) /\ is_derive v t (ax t) /\ is_derive y t (w t) /\ is_derive w t (ay t)) ->
  (forall t, (m1 + m2) * ax t = - a2 * x t /\ (m1 + m2) * ay t = - a2 * y t) ->
  let om := sqrt (a2 / (m1 + m2)) in let L := b * (m1 + m2) / (a2 * m2) in forall t,
  x t = x 0 * cos (om * t) + v 0 / om * sin (om * t) /\ y t = y 0 * cos (om * t) + w 0 / om * sin (om * t) /\
  (sqrt ((m2 * ax t) ^ 2 + (m2 * ay t) ^ 2) <= b <-> sqrt (x t ^ 2 + y t ^ 2) <= L) /\
  a2 * (x t ^ 2 + y t ^ 2) / 2 + (m1 + m2) * (v t ^ 2 + w t ^ 2) / 2 =
    a2 / 2 * (x 0 ^ 2 + y 0 ^ 2 + ((v 0 / om) ^ 2 + (w 0 / om) ^ 2)) /\
  a2 / 2 * L ^ 2 = b ^ 2 * (m1 + m2) ^ 2 / (2 * a2 * m2 ^ 2).
Proof.
  intros Hm1 Hm2 Ha2 Hb D N om L t. assert (Ho : 0 < om) by positive.
  assert (O2 : om * om = a2 / (m1 + m2)) by (apply sqrt_sqrt, Rlt_le; positive).
  assert (HL : 0 < L) by (unfold L; positive).
  assert (A : forall z c : R, (m1 + m2) * c = - a2 * z -> c = - (om * om) * z).
  { intros z c Q. rewrite O2. apply Rmult_eq_reg_l with (m1 + m2); [rewrite Q; field|]; lra. }
  assert (Ax : forall t, ax t = - (om * om) * x t) by (intros; apply A, N).
  assert (Ay : forall t, ay t = - (om * om) * y t) by (intros; apply A, N).
  assert (Dv : forall t, is_derive v t (- (om * om) * x t)) by (intros u; rewrite <- Ax; apply D).
  assert (Dw : forall t, is_derive w t (- (om * om) * y t)) by (intros u; rewrite <- Ay; apply D).
  destruct (oscillator om x v Ho ltac:(apply D) Dv t) as (X & Ex), (oscillator om y w Ho ltac:(apply D) Dw t) as (Y &
    Ey). split; [exact X|]. split; [exact Y|]. split; [|split].
  - assert (E : sqrt ((m2 * ax t) ^ 2 + (m2 * ay t) ^ 2) = b / L * sqrt (x t ^ 2 + y t ^ 2)).
    { assert (F : m2 * (om * om) = b / L) by (rewrite O2; unfold L; field; lra).
      rewrite Ax, Ay, <- (sqrt_square (b / L)), <- sqrt_mult by (try positive; pose proof (pow2_ge_0 (x t)); pose proof
        (pow2_ge_0 (y t)); nra). f_equal. rewrite <- F. ring. }
    rewrite E. assert (Q : forall z, b / L * z <= b <-> z <= L).
    { split; intros Z; [apply Rmult_le_reg_l with (b / L); [positive|]|apply Rle_trans with (b / L * L); [scale;
        positive|right; field; lra]]. replace (b / L * L) with b by (field; lra). auto. } apply Q.
  - assert (P : forall z, (m1 + m2) * z ^ 2 = a2 * (z / om) ^ 2).
    { intros z. replace a2 with ((m1 + m2) * (om * om)) at 1 by (rewrite O2; field; lra). field. lra. }
    pose proof (P (v t)). pose proof (P (w t)). nra.
  - unfold L. field. lra.
Qed.

(** [plane-landing] In slip, $G=b|s|+\Lambda\cdot s$ has the rate $-\kappa(b^2-|\Lambda|^2)+\dot\Lambda\cdot s$. *)
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
