(** Tools for existence: a function that chases another with speed at most 1, as a supremum of subsolutions (Perron),
    moves no more than that one does when it is changed; and integrals of functions that are continuous on [0,
    +oo). *)
From InertialPair Require Import Dini.

(** the least upper bound as a number (no choice) *)
Lemma lub_real (A : R -> Prop) m M : A m -> (forall y, A y -> y <= M) ->
  (forall y, A y -> y <= real (Lub_Rbar A)) /\ (forall B, (forall y, A y -> y <= B) -> real (Lub_Rbar A) <= B).
Proof.
  intros Am AM. pose proof (Lub_Rbar_correct A) as (U & L). assert (F : is_finite (Lub_Rbar A)).
  { assert (Rbar_le (Lub_Rbar A) M). { apply L. intros y Hy. apply AM; auto. }
    pose proof (U m Am). destruct (Lub_Rbar A); simpl in *; try contradiction; reflexivity. }
  rewrite <- F in U, L. split.
  - intros y Hy. exact (U y Hy).
  - intros B HB. exact (L B HB).
Qed.

(** a bound times a factor *)
Lemma abs_scal c y B : 0 <= c -> Rabs y <= B -> Rabs (c * y) <= c * B.
Proof. intros Hc HB. rewrite Rabs_mult, (Rabs_pos_eq c) by auto. scale. Qed.

(** ** The chaser: s(0) = 0, s' in Sgn (c - s) *)
Section Chase.

(** subsolutions on [0, t]: 1-Lipschitz, and above c they fall with slope -1 *)
Definition sub (c : R -> R) (t : R) (z : R -> R) :=
  z 0 <= 0 /\ (forall p q, 0 <= p <= q -> q <= t -> - (q - p) <= z q - z p <= q - p) /\
  forall p q, 0 <= p <= q -> q <= t -> (forall u, p <= u <= q -> c u < z u) -> z q <= z p - (q - p).

(** the chaser: the supremum of all that start at 0, fall no faster than 1 and rise only below c *)
Definition chase c t := real (Lub_Rbar (fun y => exists z, sub c t z /\ y = z t)).

(** the function -t is one of them *)
Lemma sub_fall c t : sub c t (fun u => - u).
Proof. repeat split; intros; simpl; lra. Qed.

(** it is their least upper bound *)
Lemma chase_lub c t : 0 <= t -> (forall z, sub c t z -> z t <= chase c t) /\
  (forall y, (forall z, sub c t z -> z t <= y) -> chase c t <= y).
Proof.
  intros Ht. destruct (lub_real (fun y => exists z, sub c t z /\ y = z t) (- t) t) as (U & L).
  { exists (fun u => - u); split; auto. apply sub_fall. }
  { intros y (z & (Z & Lz & _) & ->). specialize (Lz 0 t ltac:(lra) ltac:(lra)). lra. }
  split.
  - intros z Hz. apply U. exists z; auto.
  - intros y Hy. apply L. intros y' (z & Hz & ->). auto.
Qed.

(** a subsolution may go on with slope -1, and with slope 1 as long as it stays below c *)
Definition ext (z : R -> R) r k u := if Rle_dec u r then z u else z r + k * (u - r).

(** one of them can be prolonged by a line: falling, or rising below c *)
Lemma ext_sub c z r t k : 0 <= r <= t -> sub c r z ->
  k = -1 \/ (k = 1 /\ forall u, r <= u <= t -> z r + (u - r) <= c u) -> sub c t (ext z r k).
Proof.
  intros Hr (Z & Lz & Fz) Hk. unfold ext. split; [destruct (Rle_dec 0 r); lra|]. split.
  - intros p q Hp Hq. destruct (Rle_dec p r), (Rle_dec q r); try lra.
    + apply Lz; lra.
    + pose proof (Lz p r ltac:(lra) ltac:(lra)). destruct Hk as [->|(-> & _)]; lra.
    + destruct Hk as [->|(-> & _)]; lra.
  - intros p q Hp Hq O. destruct (Rle_dec q r) as [Q|Q].
    { destruct (Rle_dec p r); [|lra]. apply Fz; try lra. intros u Hu. specialize (O u Hu).
      destruct (Rle_dec u r); lra. }
    destruct Hk as [->|(-> & B)].
    + destruct (Rle_dec p r); [|lra]. assert (z r <= z p - (r - p)); [|lra].
      apply Fz; try lra. intros u Hu. specialize (O u ltac:(lra)). destruct (Rle_dec u r); lra.
    + specialize (O q ltac:(lra)). destruct (Rle_dec q r); [lra|]. specialize (B q ltac:(lra)). lra.
Qed.

(** and cut off *)
Lemma sub_less c r t z : r <= t -> sub c t z -> sub c r z.
Proof. intros Hr (Z & Lz & Fz). repeat split; auto; intros; try (apply Lz; lra). apply Fz; auto; lra. Qed.

(** the chaser starts at 0 *)
Lemma chase_0 c : chase c 0 = 0.
Proof.
  destruct (chase_lub c 0 (Rle_refl 0)) as (U & L). apply Rle_antisym.
  - apply L. intros z (Z & _). auto.
  - specialize (U _ (sub_fall c 0)). simpl in U. lra.
Qed.

(** it is 1-Lipschitz *)
Lemma chase_lip c r t : 0 <= r <= t -> - (t - r) <= chase c t - chase c r <= t - r.
Proof.
  intros Hr. destruct (chase_lub c r ltac:(lra)) as (Ur & Lr). destruct (chase_lub c t ltac:(lra)) as (Ut & Lt). split.
  - assert (chase c r <= chase c t + (t - r)); [|lra]. apply Lr. intros z Hz.
    pose proof (Ut _ (ext_sub c z r t (-1) Hr Hz (or_introl eq_refl))) as Q. unfold ext in Q.
    destruct (Rle_dec t r); [replace t with r in * by lra|]; lra.
  - assert (chase c t <= chase c r + (t - r)); [|lra]. apply Lt. intros z Hz.
    pose proof (Ur z (sub_less c r t z ltac:(lra) Hz)). destruct Hz as (_ & Lz & _).
      specialize (Lz r t ltac:(lra) ltac:(lra)). lra.
Qed.

(** causal, and not expansive *)
Lemma chase_near c c' M t : 0 <= t -> 0 <= M -> (forall u, 0 <= u <= t -> c u <= c' u + M) ->
  chase c t <= chase c' t + M.
Proof.
  intros Ht HM C. destruct (chase_lub c t Ht) as (_ & L). destruct (chase_lub c' t Ht) as (U & _). apply L.
  intros z (Z & Lz & Fz). assert (z t - M <= chase c' t); [|lra]. apply (U (fun u => z u - M)). split; [lra|]. split.
  - intros p q Hp Hq. specialize (Lz p q Hp Hq). lra.
  - intros p q Hp Hq O. specialize (Fz p q Hp Hq). assert (z q <= z p - (q - p)); [|lra].
    apply Fz. intros u Hu. specialize (O u Hu). specialize (C u ltac:(lra)). lra.
Qed.

(** the right derivative of a function that is a line for a while *)
Lemma rderiv_exact f t l d : 0 < d -> (forall h, 0 < h < d -> f (t + h) - f t = l * h) -> rderiv f t l.
Proof. intros Hd F e He. exists d; split; auto. intros h Hh. rewrite F by auto.
  rewrite Rminus_diag_eq, Rabs_R0 by auto. nra. Qed.

(** above c it falls with speed 1 *)
Lemma chase_down c t : cont c -> 0 <= t -> c t < chase c t -> rderiv (chase c) t (-1).
Proof.
  intros C Ht Hc. set (g := chase c t - c t). destruct (C t Ht (g / 4)) as (d & Hd & K); [unfold g; lra|].
  assert (Hd2 : 0 < Rmin d (g / 8)) by (apply Rmin_glb_lt; unfold g; lra).
  apply rderiv_exact with (1 := Hd2). intros h Hh. pose proof (Rmin_l d (g / 8)). pose proof (Rmin_r d (g / 8)).
  pose proof (chase_lip c t (t + h) ltac:(lra)). assert (chase c (t + h) <= chase c t - h); [|lra].
  destruct (chase_lub c t Ht) as (U & _). destruct (chase_lub c (t + h) ltac:(lra)) as (_ & L). apply L. intros z Hz.
  pose proof (U z (sub_less c t (t + h) z ltac:(lra) Hz)). destruct Hz as (_ & Lz & Fz).
  destruct (Rle_dec (z (t + h)) (chase c t - h)) as [|N]; auto. exfalso.
  assert (z (t + h) <= z t - (t + h - t)); [|lra]. apply Fz; try lra. intros u Hu.
  specialize (Lz u (t + h) ltac:(lra) ltac:(lra)). assert (Q : Rabs (c u - c t) < g / 4). { apply K; [lra|].
    rewrite Rabs_pos_eq; lra. }
  apply Rabs_def2 in Q. unfold g in *. lra.
Qed.

(** below c it rises with speed 1 *)
Lemma chase_up c t : cont c -> 0 <= t -> chase c t < c t -> rderiv (chase c) t 1.
Proof.
  intros C Ht Hc. set (g := c t - chase c t). destruct (C t Ht (g / 4)) as (d & Hd & K); [unfold g; lra|].
  assert (Hd2 : 0 < Rmin d (g / 8)) by (apply Rmin_glb_lt; unfold g; lra).
  apply rderiv_exact with (1 := Hd2). intros h Hh. pose proof (Rmin_l d (g / 8)). pose proof (Rmin_r d (g / 8)).
  pose proof (chase_lip c t (t + h) ltac:(lra)). assert (chase c t <= chase c (t + h) - h); [|lra].
  destruct (chase_lub c t Ht) as (U & L). destruct (chase_lub c (t + h) ltac:(lra)) as (U' & _). apply L. intros z Hz.
  assert (Q : sub c (t + h) (ext z t 1)).
  { apply ext_sub; auto; [lra|]. right; split; auto. intros u Hu. pose proof (U z Hz).
    assert (Q : Rabs (c u - c t) < g / 4). { apply K; [lra|]. rewrite Rabs_pos_eq; lra. }
    apply Rabs_def2 in Q. unfold g in *. lra. }
  pose proof (U' _ Q) as W. unfold ext in W. destruct (Rle_dec (t + h) t); lra.
Qed.
End Chase.

(** ** Integrals of functions that are continuous on [0, +oo) *)
Definition integral (f : R -> R) (t : R) : R := RInt (fun u => f (Rmax 0 u)) 0 t.

(** continuity in the sense of the library *)
Lemma max_continuous f u : cont f -> continuous (fun u => f (Rmax 0 u)) u.
Proof.
  intros C. apply continuity_pt_filterlim. intros e He.
  destruct (C (Rmax 0 u) (Rmax_l _ _) e He) as (d & Hd & K). exists d; split; auto.
  intros r (_ & Hr). apply K; [apply Rmax_l|]. eapply Rle_lt_trans; [|exact Hr]. simpl. unfold R_dist.
  unfold Rmax; destruct (Rle_dec 0 r), (Rle_dec 0 u); unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(** the derivative of an integral *)
Lemma integral_derive f t : cont f -> is_derive (integral f) t (f (Rmax 0 t)).
Proof.
  intros C. apply (is_derive_RInt (fun u => f (Rmax 0 u)) (integral f) 0 t); [|apply max_continuous; auto].
  exists (mkposreal 1 Rlt_0_1). intros u _. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros r _. apply max_continuous; auto.
Qed.

(** and its right derivative *)
Lemma integral_rderiv f t : cont f -> 0 <= t -> rderiv (integral f) t (f t).
Proof. intros C Ht. pose proof (rderiv_of_derive _ _ _ (integral_derive f t C)) as Q.
  rewrite Rmax_right in Q by lra. auto. Qed.

(** an integral is continuous *)
Lemma integral_cont f : cont f -> cont (integral f).
Proof. intros C. apply cont_of_derive with (fun t => f (Rmax 0 t)). intros; apply integral_derive; auto. Qed.

(** it starts at 0 *)
Lemma integral_0 f : integral f 0 = 0.
Proof. unfold integral. rewrite RInt_point. reflexivity. Qed.

(** the weight exp (l t) makes integration a contraction *)
Lemma integral_near f g D l t : cont f -> cont g -> 0 < l -> 0 <= t ->
  (forall u, 0 <= u <= t -> Rabs (f u - g u) <= D * exp (l * u)) ->
    Rabs (integral f t - integral g t) <= D / l * exp (l * t).
Proof.
  intros Cf Cg Hl Ht B. assert (HD : 0 <= D). { pose proof (B 0 ltac:(lra)) as Q. rewrite Rmult_0_r, exp_0 in Q.
    pose proof (Rabs_pos (f 0 - g 0)). lra. }
  assert (Dl : 0 <= D / l) by positive.
  assert (RE : forall u, is_derive (fun u => D / l * exp (l * u)) u (D * exp (l * u))). { intros u.
    auto_derive; auto. field; lra. }
  assert (Q : forall k, k = 1 \/ k = -1 -> k * (integral f t - integral g t) - D / l * exp (l * t) <= 0).
  { intros k Hk. apply Rle_trans with (k * (integral f 0 - integral g 0) - D / l * exp (l * 0)).
    2: { rewrite !integral_0, Rmult_0_r, exp_0. lra. }
    apply (rderiv_mono (fun u => k * (integral f u - integral g u) - D / l * exp (l * u)) 0 t (fun u => k * (f u -
      g u) - D * exp (l * u))); [|lra|].
    - apply cont_minus; [apply cont_scal, cont_minus; apply integral_cont; auto|]. eapply cont_of_derive; exact RE.
    - intros u Hu. split.
      + apply rderiv_minus; [apply rderiv_scal, rderiv_minus; apply integral_rderiv; auto; lra|].
        apply rderiv_of_derive, RE.
      + pose proof (B u ltac:(lra)) as W. apply Rabs_inv in W. destruct Hk; subst k; lra. }
  pose proof (Q 1 (or_introl eq_refl)). pose proof (Q (-1) (or_intror eq_refl)). apply Rabs_le; lra.
Qed.

(** powers of 1/2 become small *)
Lemma small q e : 0 < q -> 0 < e -> exists n, q * (/ 2) ^ n < e.
Proof.
  intros Hq He. destruct (pow_lt_1_zero (/ 2)) with (y := e / q) as (n & N).
  { rewrite Rabs_pos_eq; lra. } { positive. }
  exists n. specialize (N n (le_n n)). rewrite Rabs_pos_eq in N by (apply pow_le; lra).
  apply Rmult_lt_compat_l with (r := q) in N; auto. replace (q * (e / q)) with e in N by (field; lra). auto.
Qed.
