(** Existence: from every start there is a motion. No time steps: v2 = v2(0) + (b/m2) s and m1 v1 + b s = P, so the
    inclusion says that s chases c = (P/m1 - v2(0)) / (b/m1 + b/m2) with speed at most 1; the chaser moves no more
    than c when c is changed, and P is then the fixed point of a Picard iteration. The impulse U of the force cancels
    in the difference of two iterates, and enters the first step only: so the constant C grows with t, and each bound
    is taken until t. *)
From InertialPair Require Import Dini Pair Stick Pursuit Forced.

(** a continuous function is bounded up to each time *)
Lemma cont_bounded f t : cont f -> 0 <= t -> exists B, forall u, 0 <= u <= t -> Rabs (f u) <= B.
Proof.
  intros C Ht. set (g := fun u => Rabs (f (Rmax 0 u))). assert (CG : forall u, 0 <= u <= t -> continuity_pt g u).
  { intros u _. apply continuity_pt_filterlim. apply (max_continuous (fun u => Rabs (f u))). apply cont_abs; auto. }
  destruct (continuity_ab_maj g 0 t Ht CG) as (m & Hm & _). exists (g m). intros u Hu. specialize (Hm u Hu).
  unfold g in Hm at 1. rewrite Rmax_right in Hm by lra. auto.
Qed.

(** a sequence whose steps are halved each time comes to its limit at that rate *)
Lemma halving (a : nat -> R) c : (forall n, Rabs (a (S n) - a n) <= c * (/ 2) ^ n) ->
  forall n, Rabs (real (Lim_seq a) - a n) <= 2 * c * (/ 2) ^ n.
Proof.
  intros St n. set (r := fun n => 2 * c * (/ 2) ^ n). assert (R0 : is_lim_seq r 0).
  { replace (Finite 0) with (Rbar_mult (2 * c) 0) by (simpl; f_equal; ring).
    apply is_lim_seq_scal_l, is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  assert (Half : forall j, r (S j) = r j / 2 /\ - (r j / 2) <= a (S j) - a j <= r j / 2).
  { intros j. split; [unfold r; simpl; field|]. apply Rabs_inv. eapply Rle_trans; [apply St|right; unfold r; field]. }
  assert (Up : forall j, a j - r j <= a (S j) - r (S j)) by (intros j; destruct (Half j) as (-> & Q); lra).
  assert (Down : forall j, a (S j) + r (S j) <= a j + r j) by (intros j; destruct (Half j) as (-> & Q); lra).
  destruct (ex_lim_seq_adj (fun j => a j - r j) (fun j => a j + r j) Up Down) as ((l & Hl) & (k & Hk) & _).
  { apply is_lim_seq_ext with (fun j => r j + r j); [intros; ring|]. rewrite <- (Rplus_0_r 0). apply is_lim_seq_plus'; auto. }
  assert (La : is_lim_seq a l).
  { apply is_lim_seq_ext with (fun j => (a j - r j) + r j); [intros; ring|]. rewrite <- (Rplus_0_r l).
    apply is_lim_seq_plus'; auto. }
  assert (Lk : is_lim_seq (fun j => a j + r j) l) by (rewrite <- (Rplus_0_r l); apply is_lim_seq_plus'; auto).
  rewrite (is_lim_seq_unique _ _ La). pose proof (is_lim_seq_incr_compare _ _ Hl Up n).
  pose proof (is_lim_seq_decr_compare _ _ Lk Down n). fold (r n). apply Rabs_le. simpl. lra.
Qed.

(** ** Picard *)
Section Picard.
Variables m1 m2 a1 a2 b x0 v10 v20 : R.
Variable U : R -> R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (CU : cont U).

Let k := b / m1 + b / m2.
Let kp : 0 < k. Proof. unfold k. positive. Qed.

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
  unfold K. apply Rmult_lt_0_compat; [positive|].
  assert (0 < b / (m1 * k)); [|lra]. apply Rdiv_lt_0_compat; auto. positive.
Qed.

(** one step of Picard halves the distance *)
Lemma next_near v v' D T : cont v -> cont v' -> 0 <= D ->
  (forall u, 0 <= u <= T -> Rabs (v u - v' u) <= D * exp (lam * u)) ->
  forall t, 0 <= t <= T -> Rabs (next v t - next v' t) <= D / 2 * exp (lam * t).
Proof.
  intros C C' HD B t (Ht & HtT). assert (Hl : 1 <= lam) by (unfold lam; lra).
    assert (m1p : 0 < / m1) by positive.
  assert (mk : 0 < / (m1 * k)) by positive. set (e := D / lam). assert (He : 0 <= e) by positive.
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
  { intros u Hu. unfold G. apply Rmult_le_compat_l; [positive|].
    destruct (Req_dec u t) as [->|]; [lra|]. apply Rlt_le, exp_increasing. scale. }
  assert (A : forall u, 0 <= u <= t -> - (/ (m1 * k) * G t) <= aim v u - aim v' u <= / (m1 * k) * G t).
  { intros u Hu. apply Rabs_inv. replace (aim v u - aim v' u) with (/ (m1 * k) * (force v u - force v' u)) by
    (unfold aim; field; lra). apply abs_scal; [lra|]. eapply Rle_trans; [apply F; lra|apply Gm; auto]. }
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

(** up to a time each difference is at most half the bound of the one before *)
Lemma it_step T : 0 <= T -> exists C, 0 < C /\ forall n t, 0 <= t <= T ->
  Rabs (it (S n) t - it n t) <= C * (/ 2) ^ n * exp (lam * t).
Proof.
  intros HT. destruct (cont_bounded (it 1) T (it_cont 1) HT) as (B & HB). pose proof (HB 0 ltac:(lra)).
  pose proof (Rabs_pos (it 1 0)). exists (1 + B). split; [lra|]. induction n as [|n IH]; intros t Ht.
  - rewrite pow_O, Rmult_1_r. change (it 0 t) with 0. rewrite Rminus_0_r. specialize (HB t Ht).
    pose proof (exp_ineq1_le (lam * t)). assert (0 <= lam * t) by (apply Rmult_le_pos; unfold lam; lra). nra.
  - replace ((1 + B) * (/ 2) ^ S n) with ((1 + B) * (/ 2) ^ n / 2) by (simpl; field).
    apply (next_near (it (S n)) (it n) _ T); auto using it_cont. apply Rmult_le_pos; [lra|apply pow_le; lra].
Qed.

(** the limit of the iterates: they converge, at that rate *)
Definition limit t := real (Lim_seq (fun n => it n t)).
Lemma limit_near T : 0 <= T -> exists C, 0 < C /\ forall n t, 0 <= t <= T ->
  Rabs (limit t - it n t) <= C * (/ 2) ^ n * exp (lam * t).
Proof.
  intros HT. destruct (it_step T HT) as (C & HC & St). exists (2 * C). split; [lra|]. intros n t Ht.
  replace (2 * C * (/ 2) ^ n * exp (lam * t)) with (2 * (C * exp (lam * t)) * (/ 2) ^ n) by ring.
  apply (halving (fun n => it n t)). intros j. eapply Rle_trans; [apply St; auto|right; ring].
Qed.

(** the limit is continuous *)
Lemma limit_cont : cont limit.
Proof.
  intros t Ht e He. assert (Hl : 1 <= lam) by (unfold lam; lra). pose proof (exp_pos (lam * (t + 1))) as Ep.
  destruct (limit_near (t + 1) ltac:(lra)) as (C & CT & Near).
  destruct (small (C * exp (lam * (t + 1))) (e / 3)) as (n & Hn); [nra|lra|].
  destruct (it_cont n t Ht (e / 3)) as (d & Hd & Kd); [lra|]. smaller d 1. intros u Hu Hd1.
  assert (B : forall r, 0 <= r < t + 1 -> Rabs (limit r - it n r) < e / 3).
  { intros r Hr. eapply Rle_lt_trans; [apply Near; lra|]. eapply Rle_lt_trans; [|exact Hn].
    rewrite (Rmult_assoc C (exp _)), (Rmult_comm (exp _)), <- Rmult_assoc. apply Rmult_le_compat_l.
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
  apply Rabs_pos_lt in N. pose proof (exp_pos (lam * t)). destruct (limit_near t Ht) as (C & CT & Near).
  destruct (small (C * exp (lam * t)) (Rabs (next limit t - limit t)) ltac:(nra) N) as (n & Hn).
  assert (A : Rabs (next limit t - it (S n) t) <= C * (/ 2) ^ n / 2 * exp (lam * t)).
  { apply (next_near limit (it n) _ t); auto using it_cont, limit_cont; [|lra].
    pose proof (pow_le (/ 2) n ltac:(lra)). nra. }
  pose proof (Near (S n) t ltac:(lra)) as B. simpl pow in B.
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
  repeat split; auto. pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H 0 t ltac:(lra) Ht) as Q.
  pose proof (moves_v2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H' 0 t ltac:(lra) Ht) as Q'.
  rewrite W in Q. rewrite W1, W' in Q'. apply Rmult_eq_reg_l with (b / m2); [lra|].
    apply Rgt_not_eq, Rdiv_lt_0_compat; auto.
Qed.
