(** A sinusoidal force u = F sin (om t): the stuck periodic response, and when it exists. *)
From InertialPair Require Import Dini Pair Pursuit Forced EnergyLimit BoundedMotions.

Section Entrain.
Variables m1 m2 a1 a2 b F om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b) (HF : 0 <= F) (Hom : 0 < om).
Let M := m1 + m2.
(** the square of the pair's dynamic stiffness at om *)
Definition Z := (a2 - (m1 + m2) * om ^ 2) ^ 2 + (a1 * om) ^ 2.
Hypothesis HZ : 0 < Z.
(** beta |a2 - M om^2 + i a1 om| / om^2 *)
Definition Fstar := b / m2 * sqrt Z / om ^ 2.
(** the response's part in phase *)
Definition cA := F * (a2 - (m1 + m2) * om ^ 2) / Z.
(** and out of phase *)
Definition cB := - F * a1 * om / Z.
(** the stuck response: its place *)
Definition rX t := cA * sin (om * t) + cB * cos (om * t).
(** and its speed *)
Definition rV t := om * (cA * cos (om * t) - cB * sin (om * t)).
(** the impulse of F sin (om t) *)
Definition drive t := F / om * (1 - cos (om * t)).

Lemma derive_rX t : is_derive rX t (rV t).
Proof. unfold rX, rV. auto_derive; auto. ring. Qed.
Lemma derive_rV t : is_derive rV t (- om ^ 2 * rX t).
Proof. unfold rX, rV. auto_derive; auto. ring. Qed.
Lemma derive_drive t : is_derive drive t (F * sin (om * t)).
Proof. unfold drive. auto_derive; auto. field; lra. Qed.

(** the stuck pair is one oscillator of mass M *)
Lemma balance t : M * (- om ^ 2 * rX t) + a1 * rV t + a2 * rX t = F * sin (om * t).
Proof. unfold rX, rV, cA, cB, M. pose proof HZ as Q. unfold Z in *. field. lra. Qed.

(** the response's amplitude is F over the stiffness *)
Lemma amplitude : cA ^ 2 + cB ^ 2 = (F / sqrt Z) ^ 2.
Proof.
  pose proof (sqrt_lt_R0 Z HZ). replace ((F / sqrt Z) ^ 2) with (F ^ 2 / Z).
  - unfold cA, cB, Z in *. field. lra.
  - rewrite <- (sqrt_sqrt Z) at 1 by lra. field. lra.
Qed.

(** so the place is bounded by it *)
Lemma rX_bound t : Rabs (rX t) <= F / sqrt Z.
Proof.
  pose proof (sqrt_lt_R0 Z HZ). assert (Rp : 0 <= F / sqrt Z) by positive.
  apply Rabs_le, sq_le_abs; auto. rewrite <- amplitude. unfold rX. pose proof (sin2_cos2 (om * t)) as SC.
    unfold Rsqr in SC.
  set (c := cos (om * t)) in *. set (n := sin (om * t)) in *. pose proof (pow2_ge_0 (cA * c - cB * n)).
  replace (cA ^ 2 + cB ^ 2) with ((cA ^ 2 + cB ^ 2) * (n * n + c * c)) by (rewrite SC; ring). nra.
Qed.

(** F <= F* says that body 2 can be accelerated so *)
Lemma Fstar_load : F <= Fstar <-> om ^ 2 * (F / sqrt Z) <= b / m2.
Proof.
  pose proof (sqrt_lt_R0 Z HZ). assert (0 < om ^ 2) by nra.
    assert (Q : 0 < om ^ 2 / sqrt Z) by positive.
  replace (om ^ 2 * (F / sqrt Z)) with (om ^ 2 / sqrt Z * F) by (field; lra).
  replace (b / m2) with (om ^ 2 / sqrt Z * Fstar) by (unfold Fstar; field; lra).
  split; intros K; [scale|apply Rmult_le_reg_l with (1 := Q); auto].
Qed.

Lemma drive_lip r t : 0 <= r <= t -> Rabs (drive t - drive r) <= F * (t - r).
Proof.
  intros Hr. apply (lip_of_rderiv drive (fun t => F * sin (om * t))); auto.
  - eapply cont_of_derive; intros; apply derive_drive.
  - intros u _. split; [apply rderiv_of_derive, derive_drive|]. rewrite <- (Rmult_1_r F) at 2.
    apply abs_scal; auto. apply Rabs_le, SIN_bound.
Qed.

(** the stuck response is a solution, if friction is strong enough for it *)
Lemma response f : 0 < f -> om ^ 2 * (F / sqrt Z) <= f / m2 ->
  forced m1 m2 a1 a2 f drive rX rV rV (fun t => m2 / f * rV t).
Proof.
  intros Hf Q. assert (CV : cont rV) by (eapply cont_of_derive; intros; apply derive_rV). apply stuck_forced; auto.
  - eapply cont_of_derive; intros; apply derive_drive.
  - eapply cont_of_derive; intros; apply derive_rX.
  - intros; apply rderiv_of_derive, derive_rX.
  - intros t Ht. apply rderiv_eq with (M * (- om ^ 2 * rX t) - F * sin (om * t)); [rewrite <- balance; ring|].
    apply rderiv_minus; [apply rderiv_scal|]; apply rderiv_of_derive; [apply derive_rV|apply derive_drive].
  - intros r t Hr. apply (lip_of_rderiv rV (fun t => - om ^ 2 * rX t)); auto.
    intros u _. split; [apply rderiv_of_derive, derive_rV|]. rewrite Rabs_mult, Rabs_Ropp, (Rabs_pos_eq (om ^ 2)) by nra.
    eapply Rle_trans; [|exact Q]. apply Rmult_le_compat_l; [nra|apply rX_bound].
Qed.
(** F <= F* is enough *)
Theorem entrained : F <= Fstar -> forced m1 m2 a1 a2 b drive rX rV rV (fun t => m2 / b * rV t).
Proof. intros HS. apply response; [auto|apply Fstar_load, HS]. Qed.

(** the velocity of the stuck response is b/m2-Lipschitz only if F <= F* *)
Lemma gentle_needs : (forall r t, 0 <= r <= t -> Rabs (rV t - rV r) <= b / m2 * (t - r)) -> F <= Fstar.
Proof.
  intros L. destruct (Req_dec F 0) as [Z0|NZ].
  { rewrite Z0. unfold Fstar. pose proof (sqrt_lt_R0 Z HZ). apply Rmult_le_pos; [positive|].
    apply Rlt_le, Rinv_0_lt_compat; nra. }
  apply Fstar_load. set (R := F / sqrt Z).
    assert (HR : 0 < R) by positive.
  destruct (polar cB cA R om 0 HR Hom) as (t & (Ht & _) & C & S). { rewrite Rplus_comm. apply amplitude. }
  assert (X : rX t = R).
  { unfold rX. rewrite <- C, <- S. pose proof (sin2_cos2 (om * t)) as Q. unfold Rsqr in Q.
    apply (f_equal (Rmult R)) in Q. lra. }
  pose proof (lip_rderiv rV _ t _ L Ht (rderiv_of_derive _ _ _ (derive_rV t))) as B. rewrite X in B.
  rewrite Rabs_left in B by (assert (0 < om ^ 2 * R) by positive; lra). lra.
Qed.

(** the speed has the force's period *)
Lemma rV_period n t : rV (t + INR n * (2 * PI / om)) = rV t.
Proof. unfold rV. replace (om * (t + INR n * (2 * PI / om))) with (om * t + 2 * INR n * PI) by (field; lra).
  rewrite cos_period, sin_period. auto. Qed.

(** a1 > 0: under F > F* nothing sticks for ever. With more friction a stuck motion and the stuck response are motions
    of one pair and approach each other; so the response inherits the Lipschitz constant b/m2 of the motion. *)
Theorem stuck_for_ever x v1 v2 s : 0 < a1 -> forced m1 m2 a1 a2 b drive x v1 v2 s -> (forall t, 0 <= t ->
  v1 t = v2 t) -> F <= Fstar.
Proof.
  intros Ha H St. set (K := om ^ 2 * (F / sqrt Z)). assert (HK : 0 <= K) by positive.
  set (f := b + m2 * K). assert (Hf : 0 < f) by (unfold f; nra).
  assert (Ef : f / m2 = b / m2 + K) by (unfold f; field; lra). assert (0 < b / m2) by positive.
  assert (Lv : forall r t, 0 <= r <= t -> Rabs (v1 t - v1 r) <= b / m2 * (t - r)).
  { intros r t Hr. rewrite (St t), (St r) by lra. apply (only_gentle m1 m2 a1 a2 b Hm2 Hb _ _ _ _ _ r t H Hr). }
  assert (H' : forced m1 m2 a1 a2 f drive x v1 v1 (fun t => m2 / f * v1 t)).
  { apply stuck_forced; auto; try apply H.
    - intros t Ht. apply (stuck_needs m1 m2 a1 a2 b _ _ _ _ _ t 1 H Rlt_0_1); auto. intros r Hr. apply St. lra.
    - intros r t Hr. eapply Rle_trans; [apply Lv; auto|]. scale. }
  apply gentle_needs. intros r t Hr. apply le_epsilon. intros d Hd.
  destruct (energy_close m1 m2 a2 Hm1 Hm2 Ha2 (d / 2) ltac:(lra)) as (e & He & Small).
  destruct (approach m1 m2 a1 a2 f Hm1 Hm2 Ha Ha2 Hf _ _ _ _ _ _ _ _ _ F H' (response f Hf ltac:(fold K; lra))
    HF drive_lip e He) as (T & HT & Q).
  assert (Near : forall u, T <= u -> Rabs (v1 u - rV u) <= d / 2) by
    (intros u Hu; apply (Small _ _ _ (Q u Hu))).
  assert (P0 := PI_RGT_0). assert (Pp : 0 < 2 * PI / om) by positive.
  destruct (nat_above T (2 * PI / om) Pp) as (n & Hn).
  rewrite <- (rV_period n t), <- (rV_period n r). set (p := INR n * (2 * PI / om)) in *.
  pose proof (Near (t + p) ltac:(lra)) as N1. pose proof (Near (r + p) ltac:(lra)) as N2.
    pose proof (Lv (r + p) (t + p) ltac:(lra)) as L.
  replace (t + p - (r + p)) with (t - r) in L by ring. by_sizes.
Qed.

(** [stuck-iff] With $a_1>0$ some solution sticks permanently under a sinusoidal force exactly if its amplitude is at
    most $U_*$. *)
Corollary stuck_iff : 0 < a1 -> (exists x v1 v2 s, forced m1 m2 a1 a2 b drive x v1 v2 s /\ forall t, 0 <= t ->
  v1 t = v2 t) <-> F <= Fstar.
Proof.
  intros Ha. split.
  - intros (x & v1 & v2 & s & H & St). exact (stuck_for_ever x v1 v2 s Ha H St).
  - intros HS. exists rX, rV, rV, (fun t => m2 / b * rV t). split; [apply entrained; auto|auto].
Qed.
End Entrain.
