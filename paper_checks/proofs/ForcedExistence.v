(** Existence: from every start there is a motion. No time steps: v2 = v2(0) + (b/m2) s and m1 v1 + b s = P, so the
    inclusion says that s chases c = (P/m1 - v2(0)) / (b/m1 + b/m2) with speed at most 1; the chaser moves no more
    than c when c is changed, and P is then the fixed point of a Picard iteration. The impulse U of the force cancels
    in the difference of two iterates, and enters the first step only: so the constant C grows with t, and each bound
    is taken until t. *)
From InertialPair Require Import Dini Pair Stick Chase Forced.

(** a continuous function is bounded up to each time *)
Lemma cont_bounded f t : cont f -> 0 <= t -> exists B, forall u, 0 <= u <= t -> Rabs (f u) <= B.
Proof.
  intros C Ht. set (g := fun u => Rabs (f (Rmax 0 u))).
  assert (CG : forall u, 0 <= u <= t -> continuity_pt g u).
  { intros u _. apply continuity_pt_filterlim. apply (max_continuous (fun u => Rabs (f u))). apply cont_abs; auto. }
  destruct (continuity_ab_maj g 0 t Ht CG) as (m & Hm & _). exists (g m). intros u Hu. specialize (Hm u Hu).
  unfold g in Hm at 1. rewrite Rmax_right in Hm by lra. auto.
Qed.

(** ** Picard *)
Section Picard.
Variables m1 m2 a1 a2 b x0 v10 v20 : R.
Variable U : R -> R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (CU : cont U).

Let k := b / m1 + b / m2.
Let kp : 0 < k. Proof. unfold k. apply Rplus_lt_0_compat; apply Rdiv_lt_0_compat; auto. Qed.

(** x by v1 *)
Definition place v t := x0 + integral v t.
(** m1 v1 + b s by v1: the momentum without friction, with the force's impulse *)
Definition force v t := m1 * v10 + (U t - U 0) - a2 * integral (place v) t - a1 * integral v t.
(** what the impulse of friction chases *)
Definition aim v t := (force v t / m1 - v20) / k.
(** the impulse of friction by v1 *)
Definition impulse v := chase (aim v).
(** one step of the iteration *)
Definition next v t := (force v t - b * impulse v t) / m1.

(** x is continuous *)
Lemma place_cont v : cont v -> cont (place v).
Proof. intros. apply cont_plus; [apply cont_const|apply integral_cont; auto]. Qed.
(** the momentum is continuous *)
Lemma force_cont v : cont v -> cont (force v).
Proof.
  intros. repeat apply cont_minus; [apply cont_plus; [|apply cont_minus]; auto using cont_const| |];
    apply cont_scal, integral_cont; auto. apply place_cont; auto.
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
Lemma next_near v v' D T : cont v -> cont v' -> 0 <= D ->
  (forall u, 0 <= u <= T -> Rabs (v u - v' u) <= D * exp (lam * u)) ->
  forall t, 0 <= t <= T -> Rabs (next v t - next v' t) <= D / 2 * exp (lam * t).
Proof.
  intros C C' HD B t (Ht & HtT). assert (Hl : 1 <= lam) by (unfold lam; lra).
    assert (m1p : 0 < / m1) by (apply Rinv_0_lt_compat; auto).
  assert (mk : 0 < / (m1 * k)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; auto).
  set (e := D / lam). assert (He : 0 <= e) by (apply Rmult_le_pos; [auto|apply Rlt_le, Rinv_0_lt_compat; lra]).
  assert (el : e / lam <= e). { apply Rmult_le_reg_r with lam; [lra|].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r; nra. }
  assert (I1 : forall u, 0 <= u <= T -> Rabs (integral v u - integral v' u) <= e * exp (lam * u)).
  { intros u Hu. apply integral_near; auto; [lra|lra|]. intros; apply B; lra. }
  assert (I2 : forall u, 0 <= u <= T -> Rabs (integral (place v) u - integral (place v') u) <= e * exp (lam * u)).
  { intros u Hu. eapply Rle_trans; [apply (integral_near (place v) (place v') e lam u); auto using place_cont;
    [lra|lra|]|].
    - intros r Hr. unfold place. replace (x0 + integral v r - (x0 + integral v' r)) with (integral v r - integral
      v' r) by ring. apply I1; lra.
    - apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|auto]. }
  set (G u := (a2 + a1) * e * exp (lam * u)).
  assert (F : forall u, 0 <= u <= T -> Rabs (force v u - force v' u) <= G u).
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
  pose proof (abs_scal b _ _ ltac:(lra) S). pose proof (F t ltac:(lra)). lra.
Qed.

(** the iterates, from 0 *)
Fixpoint it n : R -> R := match n with O => fun _ => 0 | S n => next (it n) end.
(** they are continuous *)
Lemma it_cont n : cont (it n).
Proof. induction n; simpl; [apply cont_const|apply next_cont; auto]. Qed.

(** 1 more than the largest first iterate until t, as a least upper bound *)
Let C t := 1 + real (Lub_Rbar (fun y => exists u, 0 <= u <= t /\ y = Rabs (it 1 u))).
Let C_lub t : 0 <= t -> (forall u, 0 <= u <= t -> 1 + Rabs (it 1 u) <= C t) /\
  (forall B, (forall u, 0 <= u <= t -> 1 + Rabs (it 1 u) <= B) -> C t <= B).
Proof.
  intros Ht. destruct (cont_bounded (it 1) t (it_cont 1) Ht) as (B & HB).
  destruct (lub_real (fun y => exists u, 0 <= u <= t /\ y = Rabs (it 1 u)) (Rabs (it 1 0)) B) as (P & L).
  - exists 0; split; auto; lra.
  - intros y (u & Hu & ->). auto.
  - split; [intros u Hu; apply Rplus_le_compat_l, P; exists u; auto|]. intros B' HB'. unfold C.
    apply Rle_trans with (1 + (B' - 1)); [|lra]. apply Rplus_le_compat_l, L. intros y (u & Hu & ->).
    specialize (HB' u Hu). lra.
Qed.
Let Cp t : 0 <= t -> 0 < C t.
Proof. intros Ht. pose proof (proj1 (C_lub t Ht) t ltac:(lra)). pose proof (Rabs_pos (it 1 t)). lra. Qed.
Let C_mono r t : 0 <= r <= t -> C r <= C t.
Proof. intros Hr. apply C_lub; [lra|]. intros u Hu. apply C_lub; lra. Qed.

(** the first two differ by at most C(t) exp (lam t) *)
Lemma it_first t : 0 <= t -> Rabs (it 1 t - it 0 t) <= C t * exp (lam * t).
Proof.
  intros Ht. pose proof (proj1 (C_lub t Ht) t ltac:(lra)). change (it 0 t) with 0. rewrite Rminus_0_r.
  pose proof (Rabs_pos (it 1 t)). pose proof (exp_ineq1_le (lam * t)).
  assert (0 <= lam * t) by (apply Rmult_le_pos; unfold lam; lra). nra.
Qed.

(** each difference is half the one before, up to T *)
Lemma it_step n T t : 0 <= t <= T -> Rabs (it (S n) t - it n t) <= C T * (/ 2) ^ n * exp (lam * t).
Proof.
  revert t. induction n; intros t Ht.
  - rewrite pow_O, Rmult_1_r. eapply Rle_trans; [apply it_first; lra|].
    apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|apply C_mono; auto].
  - assert (P : 0 <= C T * (/ 2) ^ n) by (apply Rmult_le_pos; [apply Rlt_le, Cp; lra|apply pow_le; lra]).
    pose proof (next_near (it (S n)) (it n) _ T (it_cont _) (it_cont _) P IHn t Ht) as Q.
    replace (C T * (/ 2) ^ S n) with (C T * (/ 2) ^ n / 2) by (simpl; field). exact Q.
Qed.

(** the limit of the iterates, as a least upper bound *)
Definition limit t := real (Lub_Rbar (fun y => exists n, y = it n t - 2 * C t * (/ 2) ^ n * exp (lam * t))).

(** so they converge, at that rate *)
Lemma limit_near n t : 0 <= t -> Rabs (limit t - it n t) <= 2 * C t * (/ 2) ^ n * exp (lam * t).
Proof.
  intros Ht. set (r := fun n => 2 * C t * (/ 2) ^ n * exp (lam * t)).
  assert (Rp : forall n, 0 <= r n). { intros j. unfold r. pose proof (Cp t Ht). pose proof (exp_pos (lam * t)).
    pose proof (pow_le (/ 2) j ltac:(lra)). apply Rmult_le_pos; [apply Rmult_le_pos|]; lra. }
  assert (Dn : forall p q, it p t - r p <= it (q + p) t - r (q + p)%nat /\
    it (q + p) t + r (q + p)%nat <= it p t + r p).
  { intros p q. induction q as [|q IH]; [simpl; lra|]. pose proof (it_step (q + p) t t ltac:(lra)) as Q.
    apply Rabs_inv in Q.
    replace (C t * (/ 2) ^ (q + p) * exp (lam * t)) with (r (q + p)%nat / 2) in Q by (unfold r; field).
    assert (r (S q + p)%nat = r (q + p)%nat / 2) by (unfold r; simpl; field).
    change (it (S q + p) t) with (it (S (q + p)) t). lra. }
  assert (Nest : forall p q, it p t - r p <= it q t + r q).
  { intros p q. destruct (Dn p q) as (A & _). destruct (Dn q p) as (_ & B).
    replace (p + q)%nat with (q + p)%nat in B by lia.
    pose proof (Rp (q + p)%nat). lra. }
  destruct (lub_real (fun y => exists n, y = it n t - r n) (it 0 t - r 0%nat) (it 0 t + r 0%nat)) as (Ub & L).
  { exists 0%nat; auto. } { intros y (j & ->). apply Nest. }
  fold (r n). change (real (Lub_Rbar (fun y => exists n, y = it n t - r n))) with (limit t) in Ub, L.
  assert (it n t - r n <= limit t) by (apply Ub; exists n; auto).
  assert (limit t <= it n t + r n) by (apply L; intros y (j & ->); apply Nest).
  apply Rabs_le; lra.
Qed.

(** the same with one constant up to T *)
Lemma limit_near' n T t : 0 <= t <= T -> Rabs (limit t - it n t) <= 2 * C T * (/ 2) ^ n * exp (lam * t).
Proof.
  intros Ht. eapply Rle_trans; [apply limit_near; lra|]. apply Rmult_le_compat_r; [apply Rlt_le, exp_pos|].
  apply Rmult_le_compat_r; [apply pow_le; lra|]. pose proof (C_mono t T Ht). lra.
Qed.

(** the limit is continuous *)
Lemma limit_cont : cont limit.
Proof.
  intros t Ht e He. assert (Hl : 1 <= lam) by (unfold lam; lra). pose proof (exp_pos (lam * (t + 1))) as Ep.
  pose proof (Cp (t + 1) ltac:(lra)) as CT.
  destruct (small (2 * C (t + 1) * exp (lam * (t + 1))) (e / 3)) as (n & Hn); [nra|lra|].
  destruct (it_cont n t Ht (e / 3)) as (d & Hd & Kd); [lra|].
  exists (Rmin d 1); split; [apply Rmin_glb_lt; lra|]. intros u Hu Hd1. pose proof (Rmin_l d 1).
    pose proof (Rmin_r d 1).
  assert (B : forall r, 0 <= r < t + 1 -> Rabs (limit r - it n r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [apply (limit_near' n (t + 1)); lra|]. eapply Rle_lt_trans; [|exact Hn].
    rewrite (Rmult_assoc (2 * C (t + 1)) (exp _)), (Rmult_comm (exp _)), <- Rmult_assoc. apply Rmult_le_compat_l.
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
  apply Rabs_pos_lt in N. pose proof (exp_pos (lam * t)). pose proof (Cp t Ht) as CT.
  destruct (small (2 * C t * exp (lam * t)) (Rabs (next limit t - limit t)) ltac:(nra) N) as (n & Hn).
  assert (A : Rabs (next limit t - it (S n) t) <= 2 * C t * (/ 2) ^ n / 2 * exp (lam * t)).
  { apply (next_near limit (it n) _ t); auto using it_cont, limit_cont.
    - pose proof (pow_le (/ 2) n ltac:(lra)). nra.
    - intros; apply limit_near'; auto.
    - lra. }
  pose proof (limit_near (S n) t Ht) as B. simpl pow in B.
  replace (next limit t - limit t) with ((next limit t - it (S n) t) - (limit t - it (S n) t)) in Hn by ring.
  pose proof (Rabs_triang (next limit t - it (S n) t) (- (limit t - it (S n) t))) as T. rewrite Rabs_Ropp in T.
    unfold Rminus at 1 in Hn. lra.
Qed.

(** and a fixed point is a solution *)
Theorem forced_existence : exists x v1 v2 s, forced m1 m2 a1 a2 b U x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20.
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
  - auto.
  - apply place_cont; auto.
  - auto.
  - intros t Ht. apply rderiv_eq with (0 + v t); [ring|].
    apply rderiv_plus; [apply rderiv_const|apply integral_rderiv; auto].
  - intros t Ht. apply rderiv_ext with (fun u => (m1 * v10 - U 0) - a2 * integral (place v) u - a1 * integral v u).
    { intros u Hu. rewrite FV by lra. unfold force. ring. }
    apply rderiv_eq with (0 - a2 * place v t - a1 * v t); [ring|].
    repeat apply rderiv_minus; [apply rderiv_const| |]; apply rderiv_scal, integral_rderiv; auto using place_cont.
  - intros t Ht. rewrite S0. field; lra.
  - unfold place. rewrite integral_0, S0. repeat split; try ring.
    pose proof (FV 0 (Rle_refl 0)) as F. rewrite S0 in F. unfold force in F. rewrite !integral_0 in F.
    apply Rmult_eq_reg_l with m1; lra.
Qed.
End Picard.


(** Well-posed under every continuous impulse: one and only one solution from every start. *)
Theorem forced_well_posed m1 m2 a1 a2 b U x0 v10 v20 : 0 < m1 -> 0 < m2 -> 0 <= a1 -> 0 < a2 -> 0 < b -> cont U ->
  exists x v1 v2 s, (forced m1 m2 a1 a2 b U x v1 v2 s /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2' s', forced m1 m2 a1 a2 b U x' v1' v2' s' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t /\ s' t - s' 0 = s t - s 0.
Proof.
  intros Hm1 Hm2 Ha1 Ha2 Hb CU. destruct (forced_existence m1 m2 a1 a2 b x0 v10 v20 U Hm1 Hm2 Ha1 Ha2 Hb CU) as (x
    & v1 & v2 & s & H & X & V & W).
  exists x, v1, v2, s. split; [auto|]. intros x' v1' v2' s' H' X' V' W' t Ht.
  destruct (forced_unique m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb _ _ _ _ _ _ _ _ _ 0 H' H ltac:(lra) ltac:(lra)
    ltac:(lra) ltac:(lra) t Ht) as (X1 & V1 & W1).
  repeat split; auto.
  pose proof (forced_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ 0 t H ltac:(lra) Ht) as Q.
  pose proof (forced_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ 0 t H' ltac:(lra) Ht) as Q'.
  rewrite W in Q. rewrite W1, W' in Q'. apply Rmult_eq_reg_l with (b / m2); [lra|].
    apply Rgt_not_eq, Rdiv_lt_0_compat; auto.
Qed.
