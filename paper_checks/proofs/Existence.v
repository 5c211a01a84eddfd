(** Existence: from every start there is a solution. No time steps: v2 = v2(0) + (b/m2) s and m1 v1 + b s = P, so the
    inclusion says that s chases c = (P/m1 - v2(0)) / (b/m1 + b/m2) with speed at most 1; the chaser is a supremum of
    subsolutions (Perron) and moves no more than c when c is changed;
      P is then the fixed point of a Picard iteration. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From InertialPair Require Import Dini Pair Stick.
Local Open Scope R_scope.

(** the least upper bound as a number (no choice) *)
Lemma lub_real (A : R -> Prop) m M : A m -> (forall y, A y -> y <= M) ->
  (forall y, A y -> y <= real (Lub_Rbar A)) /\ (forall B, (forall y, A y -> y <= B) -> real (Lub_Rbar A) <= B).
Proof.
  intros Am AM. pose proof (Lub_Rbar_correct A) as (U & L).
  assert (F : is_finite (Lub_Rbar A)).
  { assert (Rbar_le (Lub_Rbar A) M). { apply L. intros y Hy. apply AM; auto. }
    pose proof (U m Am). destruct (Lub_Rbar A); simpl in *; try contradiction; reflexivity. }
  rewrite <- F in U, L. split.
  - intros y Hy. exact (U y Hy).
  - intros B HB. exact (L B HB).
Qed.

(** a bound times a factor *)
Lemma abs_scal c y B : 0 <= c -> Rabs y <= B -> Rabs (c * y) <= c * B.
Proof. intros Hc HB. rewrite Rabs_mult, (Rabs_pos_eq c) by auto. apply Rmult_le_compat_l; auto. Qed.

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

(** of a constant *)
Lemma integral_const c t : integral (fun _ => c) t = c * t.
Proof. unfold integral. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. Qed.

(** the weight exp (l t) makes integration a contraction *)
Lemma integral_near f g D l t : cont f -> cont g -> 0 < l -> 0 <= t ->
  (forall u, 0 <= u <= t -> Rabs (f u - g u) <= D * exp (l * u)) ->
    Rabs (integral f t - integral g t) <= D / l * exp (l * t).
Proof.
  intros Cf Cg Hl Ht B.
  assert (HD : 0 <= D). { pose proof (B 0 ltac:(lra)) as Q. rewrite Rmult_0_r, exp_0 in Q.
    pose proof (Rabs_pos (f 0 - g 0)). lra. }
  assert (Dl : 0 <= D / l) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; auto]).
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

(** ** Picard *)
Section Picard.
Variables m1 m2 a1 a2 b x0 v10 v20 : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

Let k := b / m1 + b / m2.
Let kp : 0 < k. Proof. unfold k. apply Rplus_lt_0_compat; apply Rdiv_lt_0_compat; auto. Qed.

(** x by v1 *)
Definition place v t := x0 + integral v t.
(** m1 v1 + b s by v1: the momentum without friction *)
Definition force v t := m1 * v10 - a2 * integral (place v) t - a1 * integral v t.
(** what the impulse chases *)
Definition aim v t := (force v t / m1 - v20) / k.
(** the impulse of friction by v1 *)
Definition impulse v := chase (aim v).
(** one step of the iteration: v1 by v1 *)
Definition next v t := (force v t - b * impulse v t) / m1.

(** x is continuous *)
Lemma place_cont v : cont v -> cont (place v).
Proof. intros. apply cont_plus; [apply cont_const|apply integral_cont; auto]. Qed.
(** the momentum is continuous *)
Lemma force_cont v : cont v -> cont (force v).
Proof.
  intros. repeat apply cont_minus; [apply cont_const| |]; apply cont_scal, integral_cont; auto. apply place_cont; auto.
Qed.
(** the aim is continuous *)
Lemma aim_cont v : cont v -> cont (aim v).
Proof.
  intros. apply cont_ext with (fun u => / k * (/ m1 * force v u - v20)). { intros; unfold aim; field; lra. }
  apply cont_scal, cont_minus; [apply cont_scal, force_cont; auto|apply cont_const].
Qed.
(** the impulse is continuous *)
Lemma impulse_cont v : cont (impulse v).
Proof. apply (lip_cont _ 1); [lra|]. intros r t Hr. rewrite Rmult_1_l. apply Rabs_le, chase_lip; auto. Qed.
(** the next iterate is continuous *)
Lemma next_cont v : cont v -> cont (next v).
Proof.
  intros. apply cont_ext with (fun u => / m1 * (force v u - b * impulse v u)). { intros; unfold next; field; lra. }
  apply cont_scal, cont_minus; [apply force_cont; auto|apply cont_scal, impulse_cont].
Qed.

Let K := (a2 + a1) / m1 * (1 + b / (m1 * k)).
Let lam := 1 + 2 * K.
Let Kp : 0 < K.
Proof.
  unfold K. apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra|].
  assert (0 < b / (m1 * k)); [|lra]. apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat; auto.
Qed.

(** one step of Picard halves the distance *)
Lemma next_near v v' D : cont v -> cont v' -> 0 <= D ->
  (forall u, 0 <= u -> Rabs (v u - v' u) <= D * exp (lam * u)) ->
  forall t, 0 <= t -> Rabs (next v t - next v' t) <= D / 2 * exp (lam * t).
Proof.
  intros C C' HD B t Ht. assert (Hl : 1 <= lam) by (unfold lam; lra).
    assert (m1p : 0 < / m1) by (apply Rinv_0_lt_compat; auto).
  assert (mk : 0 < / (m1 * k)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; auto).
  set (e := D / lam). assert (He : 0 <= e) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; lra]).
  assert (el : e / lam <= e). { apply Rmult_le_reg_r with lam; [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r; nra. }
  assert (I1 : forall u, 0 <= u -> Rabs (integral v u - integral v' u) <= e * exp (lam * u)).
  { intros u Hu. apply integral_near; auto; [lra|]. intros; apply B; lra. }
  assert (I2 : forall u, 0 <= u -> Rabs (integral (place v) u - integral (place v') u) <= e * exp (lam * u)).
  { intros u Hu. eapply Rle_trans; [apply (integral_near (place v) (place v') e lam u); auto using place_cont; [lra|]|].
    - intros r Hr. unfold place. replace (x0 + integral v r - (x0 + integral v' r)) with (integral v r - integral
      v' r) by ring. apply I1; lra.
    - apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|auto]. }
  set (G u := (a2 + a1) * e * exp (lam * u)).
  assert (F : forall u, 0 <= u -> Rabs (force v u - force v' u) <= G u).
  { intros u Hu. replace (force v u - force v' u) with
      (- (a2 * (integral (place v) u - integral (place v') u) + a1 * (integral v u - integral v' u))) by (unfold
        force; ring).
    rewrite Rabs_Ropp. eapply Rle_trans; [apply Rabs_triang|]. unfold G.
    pose proof (abs_scal a2 _ _ ltac:(lra) (I2 u Hu)). pose proof (abs_scal a1 _ _ Ha1 (I1 u Hu)). lra. }
  assert (Gm : forall u, 0 <= u <= t -> G u <= G t).
  { intros u Hu. unfold G. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|].
    destruct (Req_dec u t) as [->|]; [lra|]. apply Rlt_le, exp_increasing. apply Rmult_lt_compat_l; lra. }
  assert (A : forall u, 0 <= u <= t -> - (/ (m1 * k) * G t) <= aim v u - aim v' u <= / (m1 * k) * G t).
  { intros u Hu. apply Rabs_inv. replace (aim v u - aim v' u) with (/ (m1 * k) * (force v u - force v' u)) by
    (unfold aim; field; lra).
    apply abs_scal; [lra|]. eapply Rle_trans; [apply F; lra|apply Gm; auto]. }
  assert (G0 : 0 <= / (m1 * k) * G t) by (specialize (A t ltac:(lra)); lra).
  assert (S : Rabs (impulse v t - impulse v' t) <= / (m1 * k) * G t).
  { pose proof (chase_near (aim v) (aim v') _ t Ht G0) as N. pose proof (chase_near (aim v') (aim v) _ t Ht G0) as N'.
    unfold impulse. apply Rabs_le. split; [cut (chase (aim v') t <= chase (aim v) t + / (m1 * k) * G t); [lra|apply N']
      |cut (chase (aim v) t <= chase (aim v') t + / (m1 * k) * G t); [lra|apply N]]; intros u Hu;
        specialize (A u Hu); lra. }
  assert (KD : K * e <= D / 2).
  { apply Rmult_le_reg_r with lam; [lra|]. replace (K * e * lam) with (K * D) by (unfold e; field; lra).
    unfold lam. nra. }
  apply Rle_trans with (K * e * exp (lam * t)); [|apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|auto]].
  replace (K * e * exp (lam * t)) with (/ m1 * (G t + b * (/ (m1 * k) * G t))) by (unfold K, G; field; lra).
  replace (next v t - next v' t) with (/ m1 * (force v t - force v' t + - (b * (impulse v t - impulse v' t)))) by
    (unfold next; field; lra).
  apply abs_scal; [lra|]. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp.
  pose proof (abs_scal b _ _ ltac:(lra) S). pose proof (F t Ht). lra.
Qed.

(** the iterates, from 0 *)
Fixpoint it n : R -> R := match n with O => fun _ => 0 | S n => next (it n) end.
(** they are continuous *)
Lemma it_cont n : cont (it n).
Proof. induction n; simpl; [apply cont_const|apply next_cont; auto]. Qed.

Let C := Rabs v10 + (a2 * Rabs x0 + b) / m1.
Let Cp : 0 < C.
Proof.
  unfold C. pose proof (Rabs_pos v10). pose proof (Rabs_pos x0). assert (0 < (a2 * Rabs x0 + b) / m1); [|lra].
  apply Rdiv_lt_0_compat; auto. nra.
Qed.

(** the first two differ by at most C exp (lam t) *)
Lemma it_first t : 0 <= t -> Rabs (it 1 t - it 0 t) <= C * exp (lam * t).
Proof.
  intros Ht. simpl. unfold next, force.
  assert (Z : forall u, integral (fun _ => 0) u = 0) by (intros; rewrite integral_const; ring).
  assert (PL : integral (place (fun _ => 0)) t = x0 * t).
  { rewrite <- integral_const. unfold integral. apply RInt_ext. intros u _. unfold place. rewrite Z. apply Rplus_0_r. }
  rewrite PL, Z. pose proof (chase_lip (aim (fun _ => 0)) 0 t ltac:(lra)) as L. rewrite chase_0 in L.
    fold (impulse (fun _ => 0)) in L.
  assert (E : 1 + t <= exp (lam * t)).
  { apply Rle_trans with (exp t); [apply exp_ineq1_le|]. destruct (Req_dec t 0) as [->|]; [rewrite Rmult_0_r; lra|].
    destruct (Req_dec K 0); [lra|]. apply Rlt_le, exp_increasing. unfold lam. nra. }
  replace ((m1 * v10 - a2 * (x0 * t) - a1 * 0 - b * impulse (fun _ => 0) t) / m1 - 0)
    with (v10 + (- (a2 * x0 * t + b * impulse (fun _ => 0) t) / m1)) by (field; lra).
  eapply Rle_trans; [apply Rabs_triang|]. unfold Rdiv.
    rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (/ m1)) by (apply Rlt_le, Rinv_0_lt_compat; auto).
  assert (Q : Rabs (a2 * x0 * t + b * impulse (fun _ => 0) t) <= (a2 * Rabs x0 + b) * t).
  { eapply Rle_trans; [apply Rabs_triang|].
    rewrite !Rabs_mult, (Rabs_pos_eq a2), (Rabs_pos_eq t), (Rabs_pos_eq b) by lra.
    assert (Rabs (impulse (fun _ => 0) t) <= t) by (apply Rabs_le; lra). nra. }
  set (q := Rabs (a2 * x0 * t + b * impulse (fun _ => 0) t)) in *. set (y := a2 * Rabs x0 + b) in *.
  assert (0 < / m1) by (apply Rinv_0_lt_compat; auto). unfold C. fold y. unfold Rdiv. pose proof (Rabs_pos v10).
  assert (0 < y) by (unfold y; pose proof (Rabs_pos x0); nra).
  assert (q * / m1 <= y * / m1 * t) by (replace (y * / m1 * t) with (y * t * / m1) by ring;
    apply Rmult_le_compat_r; lra).
  assert (0 < y * / m1) by nra. nra.
Qed.

(** each difference is half the one before, in the weighted norm *)
Lemma it_step n t : 0 <= t -> Rabs (it (S n) t - it n t) <= C * (/ 2) ^ n * exp (lam * t).
Proof.
  revert t. induction n; intros t Ht.
  - rewrite pow_O, Rmult_1_r. apply it_first; auto.
  - assert (P : 0 <= C * (/ 2) ^ n) by (apply Rmult_le_pos; [lra|apply pow_le; lra]).
    pose proof (next_near (it (S n)) (it n) _ (it_cont _) (it_cont _) P IHn t Ht) as Q.
    replace (C * (/ 2) ^ S n) with (C * (/ 2) ^ n / 2) by (simpl; field). exact Q.
Qed.

(** the limit of the iterates, as a least upper bound *)
Definition limit t := real (Lub_Rbar (fun y => exists n, y = it n t - 2 * C * (/ 2) ^ n * exp (lam * t))).

(** so they converge, at that rate *)
Lemma limit_near n t : 0 <= t -> Rabs (limit t - it n t) <= 2 * C * (/ 2) ^ n * exp (lam * t).
Proof.
  intros Ht. set (r := fun n => 2 * C * (/ 2) ^ n * exp (lam * t)).
  assert (Rp : forall n, 0 <= r n). { intros j. unfold r. pose proof (exp_pos (lam * t)).
    pose proof (pow_le (/ 2) j ltac:(lra)). apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. }
  assert (Dn : forall p q, it p t - r p <= it (q + p) t - r (q + p)%nat /\
    it (q + p) t + r (q + p)%nat <= it p t + r p).
  { intros p q. induction q as [|q IH]; [simpl; lra|]. pose proof (it_step (q + p) t Ht) as Q. apply Rabs_inv in Q.
    replace (C * (/ 2) ^ (q + p) * exp (lam * t)) with (r (q + p)%nat / 2) in Q by (unfold r; field).
    assert (r (S q + p)%nat = r (q + p)%nat / 2) by (unfold r; simpl; field).
    change (it (S q + p) t) with (it (S (q + p)) t). lra. }
  assert (Nest : forall p q, it p t - r p <= it q t + r q).
  { intros p q. destruct (Dn p q) as (A & _). destruct (Dn q p) as (_ & B).
    replace (p + q)%nat with (q + p)%nat in B by lia.
    pose proof (Rp (q + p)%nat). lra. }
  destruct (lub_real (fun y => exists n, y = it n t - r n) (it 0 t - r 0%nat) (it 0 t + r 0%nat)) as (U & L).
  { exists 0%nat; auto. } { intros y (j & ->). apply Nest. }
  fold (r n). change (real (Lub_Rbar (fun y => exists n, y = it n t - r n))) with (limit t) in U, L.
  assert (it n t - r n <= limit t) by (apply U; exists n; auto).
  assert (limit t <= it n t + r n) by (apply L; intros y (j & ->); apply Nest).
  apply Rabs_le; lra.
Qed.

(** powers of 1/2 become small *)
Lemma small q e : 0 < q -> 0 < e -> exists n, q * (/ 2) ^ n < e.
Proof.
  intros Hq He. destruct (pow_lt_1_zero (/ 2)) with (y := e / q) as (n & N).
  { rewrite Rabs_pos_eq; lra. } { apply Rdiv_lt_0_compat; auto. }
  exists n. specialize (N n (le_n n)). rewrite Rabs_pos_eq in N by (apply pow_le; lra).
  apply Rmult_lt_compat_l with (r := q) in N; auto. replace (q * (e / q)) with e in N by (field; lra). auto.
Qed.

(** the limit is continuous *)
Lemma limit_cont : cont limit.
Proof.
  intros t Ht e He. assert (Hl : 1 <= lam) by (unfold lam; lra). pose proof (exp_pos (lam * (t + 1))) as Ep.
  destruct (small (2 * C * exp (lam * (t + 1))) (e / 3)) as (n & Hn); [nra|lra|].
  destruct (it_cont n t Ht (e / 3)) as (d & Hd & Kd); [lra|].
  exists (Rmin d 1); split; [apply Rmin_glb_lt; lra|]. intros u Hu Hd1. pose proof (Rmin_l d 1).
    pose proof (Rmin_r d 1).
  assert (B : forall r, 0 <= r < t + 1 -> Rabs (limit r - it n r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [apply limit_near; lra|]. eapply Rle_lt_trans; [|exact Hn].
    rewrite (Rmult_assoc (2 * C) (exp _)), (Rmult_comm (exp _)), <- Rmult_assoc. apply Rmult_le_compat_l.
    - pose proof (pow_le (/ 2) n ltac:(lra)). nra.
    - apply Rlt_le, exp_increasing, Rmult_lt_compat_l; lra. }
  assert (Q : Rabs (u - t) < 1) by lra. apply Rabs_def2 in Q.
  pose proof (B u ltac:(lra)) as B1. pose proof (B t ltac:(lra)) as B2. specialize (Kd u Hu ltac:(lra)).
  apply Rabs_def2 in B1. apply Rabs_def2 in B2. apply Rabs_def2 in Kd. apply Rabs_def1; lra.
Qed.

(** the limit is a fixed point *)
Lemma limit_fixed t : 0 <= t -> next limit t = limit t.
Proof.
  intros Ht. apply Rminus_diag_uniq. destruct (Req_dec (next limit t - limit t) 0) as [|N]; auto. exfalso.
  apply Rabs_pos_lt in N. pose proof (exp_pos (lam * t)).
  destruct (small (2 * C * exp (lam * t)) (Rabs (next limit t - limit t)) ltac:(nra) N) as (n & Hn).
  assert (A : Rabs (next limit t - it (S n) t) <= 2 * C * (/ 2) ^ n / 2 * exp (lam * t)).
  { apply (next_near limit (it n)); auto using it_cont, limit_cont.
    - pose proof (pow_le (/ 2) n ltac:(lra)). nra.
    - intros; apply limit_near; auto. }
  pose proof (limit_near (S n) t Ht) as B. simpl pow in B.
  replace (next limit t - limit t) with ((next limit t - it (S n) t) - (limit t - it (S n) t)) in Hn by ring.
  pose proof (Rabs_triang (next limit t - it (S n) t) (- (limit t - it (S n) t))) as T. rewrite Rabs_Ropp in T.
    unfold Rminus at 1 in Hn. lra.
Qed.

(** and a fixed point is a solution *)
Theorem existence : exists x v1 v2 s, solution m1 m2 a1 a2 b x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20.
Proof.
  set (v := limit). pose proof limit_cont as CV. fold v in CV.
  assert (FV : forall t, 0 <= t -> m1 * v t + b * impulse v t = force v t).
  { intros t Ht. unfold v. rewrite <- (limit_fixed t Ht) at 1. unfold next. field; lra. }
  assert (S0 : impulse v 0 = 0) by apply chase_0.
  assert (W : forall t, 0 <= t -> v t - (v20 + b / m2 * impulse v t) = k * (aim v t - impulse v t)).
  { intros t Ht. unfold aim. rewrite <- (FV t Ht). unfold k. field. repeat split; try lra. apply Rgt_not_eq. nra. }
  exists (place v), v, (fun t => v20 + b / m2 * impulse v t), (impulse v). split; [constructor|].
  - intros r t Hr. apply Rabs_le, chase_lip; auto.
  - intros t Ht O. apply chase_up; auto using aim_cont. specialize (W t Ht). apply Rmult_lt_reg_l with k; auto.
    unfold impulse in *. lra.
  - intros t Ht O. apply chase_down; auto using aim_cont. specialize (W t Ht). apply Rmult_lt_reg_l with k; auto.
    unfold impulse in *. lra.
  - apply place_cont; auto.
  - auto.
  - intros t Ht. apply rderiv_eq with (0 + v t); [ring|].
    apply rderiv_plus; [apply rderiv_const|apply integral_rderiv; auto].
  - intros t Ht. apply rderiv_ext with (force v). { intros u Hu. symmetry. apply FV. lra. }
    apply rderiv_eq with (0 - a2 * place v t - a1 * v t); [ring|]. unfold force.
    repeat apply rderiv_minus; [apply rderiv_const| |]; apply rderiv_scal, integral_rderiv; auto using place_cont.
  - intros t Ht. rewrite S0. field; lra.
  - unfold place. rewrite integral_0, S0. repeat split; try ring.
    pose proof (FV 0 (Rle_refl 0)) as F. rewrite S0 in F. unfold force in F. rewrite !integral_0 in F.
    apply Rmult_eq_reg_l with m1; lra.
Qed.
End Picard.

(** Well-posed: one and only one solution from every start (and [contraction]: it depends continuously on the start). *)
Theorem well_posed m1 m2 a1 a2 b x0 v10 v20 : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b ->
  exists x v1 v2 s, (solution m1 m2 a1 a2 b x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2' s', solution m1 m2 a1 a2 b x' v1' v2' s' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t /\ s' t - s' 0 = s t - s 0.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb. destruct (existence m1 m2 a1 a2 b x0 v10 v20 Hm1 Hm2 Ha1 Ha2 Hb) as (x & v1 & v2 & s
    & H & X & V & W).
  exists x, v1, v2, s. split; [auto|]. intros x' v1' v2' s' H' X' V' W' t Ht.
  assert (U : forall u, 0 <= u -> x' u = x u /\ v1' u = v1 u /\ v2' u = v2 u).
  { apply (unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ 0 H' H); lra. }
  destruct (U t Ht) as (X1 & V1 & W1). repeat split; auto.
  pose proof (s_v2 _ _ _ _ _ _ _ _ _ H t Ht) as Q. pose proof (s_v2 _ _ _ _ _ _ _ _ _ H' t Ht) as Q'.
  rewrite W in Q. rewrite W1, W' in Q'. apply Rmult_eq_reg_l with b; lra.
Qed.
