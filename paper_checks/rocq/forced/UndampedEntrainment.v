(** The pair beside a stuck motion that needs at most the share rho < 1 of friction: its slide is paid for by the energy
    distance. Then, without a damper: under F sin (om t), F < F*, every motion tends to one stuck motion. *)
From Coq Require Import Rtopology.
From InertialPair Require Import Dini Pair Stick Pursuit Forced EnergyLimit Entrainment.

Section Slide.
Variables m1 m2 a1 a2 b rho : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Variables U x v1 v2 s y v r : R -> R.
Hypotheses (H : forced m1 m2 a1 a2 b U x v1 v2 s) (H' : forced m1 m2 a1 a2 b U y v v r)
  (Easy : forall p q, 0 <= p <= q -> Rabs (r q - r p) <= rho * (q - p)).
Let w t := v1 t - v2 t.
Let D t := energy m1 m2 a2 (x t - y t) (v1 t - v t) (v2 t - v t).

(** the relative velocity is continuous *)
Lemma cont_slip : cont w.
Proof. apply cont_minus; [apply (f_cv _ _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 m1 m2 a1 a2 b Hm2 _ _ _ _ _ _ H)]. Qed.

(** D' <= - b (1 - rho) |w|: the motion's friction takes b |w|, the other's gives back at most rho of it *)
Lemma D_falls t : 0 <= t -> dini_le D t (- (b * (1 - rho) * Rabs (w t))).
Proof.
  intros Ht e He. assert (V : rderiv (fun q => m1 * (v1 q - v q) + b * (s q - r q)) t
    (- (a2 * (x t - y t) + a1 * (v1 t - v t)))).
  { apply rderiv_ext with (fun q => m1 * v1 q + b * s q - U q - (m1 * v q + b * r q - U q)). { intros; ring. }
    apply rderiv_eq with (- (a2 * x t + a1 * v1 t) - - (a2 * y t + a1 * v t)); [ring|].
    exact (rderiv_minus _ _ _ _ _ (f_v1 _ _ _ _ _ _ _ _ _ _ H t Ht) (f_v1 _ _ _ _ _ _ _ _ _ _ H' t Ht)). }
  destruct (energy_increment m1 m2 a2 b Hm1 Hm2 (fun q => x q - y q) (fun q => v1 q - v q) (fun q => v2 q - v q)
    (fun q => s q - r q) t _ (rderiv_minus _ _ _ _ _ (f_x _ _ _ _ _ _ _ _ _ _ H t Ht)
    (f_x _ _ _ _ _ _ _ _ _ _ H' t Ht)) V) with (eps := e / 2) as (d1 & Hd1 & K1); try lra.
  - intros h Hh. pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H t (t + h) Ht ltac:(lra)).
    pose proof (moves_v2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H' t (t + h) Ht ltac:(lra)). lra.
  - eapply big_ext; [|exact (big_minus _ _ (moves_big _ _ _ _ _ _ _ _ _ _ _ H t Ht)
      (moves_big _ _ _ _ _ _ _ _ _ _ _ H' t Ht))]. intros h; simpl; ring.
  - destruct (friction_power s (w t) t (q_slip _ _ _ _ _ _ _ _ _ _ _ H t Ht) (e / (2 * b))) as (d2 & Hd2 & K2);
      [positive|].
    smaller d1 d2. intros h Hh. specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). cbv beta in K1.
    apply Rabs_inv in K1. apply Rabs_inv in K2. pose proof (Easy t (t + h) ltac:(lra)) as L.
    replace (t + h - t) with h in L by ring. pose proof (Rle_abs ((r (t + h) - r t) * w t)) as G. rewrite Rabs_mult in G.
    assert (Rabs (r (t + h) - r t) * Rabs (w t) <= rho * h * Rabs (w t))
      by (apply Rmult_le_compat_r; auto using Rabs_pos).
    assert (B1 : b * ((s (t + h) - s t) * w t) >= b * (Rabs (w t) * h) - e / 2 * h).
    { destruct K2 as (K2 & _). apply (Rmult_le_compat_l b) in K2; [|lra].
      replace (b * - (e / (2 * b) * h)) with (- (e / 2 * h)) in K2 by (field; lra). lra. }
    assert (B2 : b * ((r (t + h) - r t) * w t) <= b * (rho * h * Rabs (w t))) by (apply Rmult_le_compat_l; lra).
    pose proof (pow2_ge_0 (v1 t - v t)) as Sq. apply (Rmult_le_compat_l a1) in Sq; [|lra].
    apply (Rmult_le_compat_r h) in Sq; [|lra].
    match type of K1 with _ <= _ + b * ?f <= _ =>
      replace f with ((s (t + h) - s t) * w t - (r (t + h) - r t) * w t) in K1 by (unfold w; ring) end.
    unfold D. lra.
Qed.

(** the distance is continuous *)
Lemma cont_D : cont D.
Proof. exact (moves_cD _ _ _ _ _ Hm2 _ _ _ _ _ _ _ _ _ _ H H'). Qed.

(** *** the slide bound: b (1 - rho) times the path of the slip is at most the energy distance that is lost *)
Theorem slide p q : 0 <= p <= q -> b * (1 - rho) * (integral (fun t => Rabs (w t)) q - integral (fun t => Rabs (w t)) p)
  <= D p - D q.
Proof.
  intros Hp. pose proof (cont_abs _ cont_slip) as Cw. set (c := b * (1 - rho)).
  assert (Q : D q + c * integral (fun t => Rabs (w t)) q <= D p + c * integral (fun t => Rabs (w t)) p); [|lra].
  apply (dini_mono (fun t => D t + c * integral (fun t => Rabs (w t)) t)); auto.
  - apply cont_plus; [exact cont_D|apply cont_scal, integral_cont, Cw].
  - intros t Ht e He. destruct (D_falls t ltac:(lra) (e / 2)) as (d1 & Hd1 & K1); [lra|].
    destruct (rderiv_scal c _ _ _ (integral_rderiv _ t Cw ltac:(lra)) (e / 2)) as (d2 & Hd2 & K2); [lra|].
    smaller d1 d2. intros h Hh. specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K2.
    fold c in K1. cbv beta in K2. lra.
Qed.
End Slide.

(** multiples of a number come as close to an integer as one likes, as late as one likes *)
Lemma recurs z e N : 0 <= z -> 0 < e <= 1 -> exists n k : nat, (N <= n)%nat /\ Rabs (INR n * z - INR k) < e.
Proof.
  intros Hz He. set (f := fun n => frac_part (INR n * z)).
  destruct (Bolzano_Weierstrass f (fun c => 0 <= c <= 1) (compact_P3 0 1)) as (l & Hl).
  { intros n. pose proof (base_fp (INR n * z)). unfold f. lra. }
  assert (Nb : neighbourhood (fun c => Rabs (c - l) < e / 2) l).
  { exists (mkposreal (e / 2) ltac:(lra)). intros c Hc. exact Hc. }
  destruct (Hl _ 0%nat Nb) as (i & _ & Hi). destruct (Hl _ (i + N)%nat Nb) as (j & Hj & Hjl).
  exists (j - i)%nat. set (k := (Int_part (INR j * z) - Int_part (INR i * z))%Z).
  assert (Ij : INR (j - i) * z = IZR k + (f j - f i)).
  { rewrite minus_INR by lia. unfold k, f, frac_part. rewrite minus_IZR. ring. }
  apply Rabs_def2 in Hi. apply Rabs_def2 in Hjl.
  assert (Hk : (0 <= k)%Z).
  { assert (0 <= INR (j - i) * z) by (apply Rmult_le_pos; auto using pos_INR).
    assert (L : -1 < IZR k) by lra. apply lt_IZR in L. lia. }
  exists (Z.to_nat k). split; [lia|]. rewrite INR_IZR_INZ with (n := Z.to_nat k), Z2Nat.id by auto.
  rewrite Ij. apply Rabs_def1; lra.
Qed.

(** *** Without a damper: every motion under F sin (om t), F < F*, tends to one stuck motion *)
Section Undamped.
Variables m1 m2 a2 b F om : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b) (HF : 0 <= F) (Hom : 0 < om)
  (HZ : 0 < Z m1 m2 0 a2 om) (Low : F < Fstar m1 m2 0 a2 b om).
Variables x v1 v2 s : R -> R.
Hypothesis H : forced m1 m2 0 a2 b (drive F om) x v1 v2 s.
Let M := m1 + m2.
Let Om := omega m1 m2 a2.
Let y := rX m1 m2 0 a2 F om.
Let v := rV m1 m2 0 a2 F om.
Let rho := F / Fstar m1 m2 0 a2 b om.
Let w t := v1 t - v2 t.
Let dx t := x t - y t.
Let d1 t := v1 t - v t.
Let d2 t := v2 t - v t.
Let D t := energy m1 m2 a2 (dx t) (d1 t) (d2 t).
Let P t := m1 * d1 t + m2 * d2 t.

Let M_pos : 0 < M. Proof. unfold M; lra. Qed.
Let Om_pos : 0 < Om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2.
Let Om_sq : Om * Om = a2 / M := omega_sq m1 m2 a2 Hm1 Hm2 Ha2.
Let Stuck : forced m1 m2 0 a2 b (drive F om) y v v (fun t => m2 / b * v t).
Proof. apply entrained; auto. lra. Qed.

(** the stuck response needs the share F / F* of friction *)
Lemma share p q : 0 <= p <= q -> Rabs (m2 / b * v q - m2 / b * v p) <= rho * (q - p).
Proof.
  intros Hp. pose proof (sqrt_lt_R0 _ HZ) as Sz. assert (O2 : 0 < om ^ 2) by nra.
  apply (lip_of_rderiv (fun t => m2 / b * v t) (fun t => m2 / b * (- om ^ 2 * y t))); auto.
  { apply cont_scal. eapply cont_of_derive; intros; apply derive_rV. }
  intros t Ht. split; [apply rderiv_scal, rderiv_of_derive, derive_rV|].
  replace rho with (m2 / b * (om ^ 2 * (F / sqrt (Z m1 m2 0 a2 om)))) by (unfold rho, Fstar; field; repeat split; lra).
  apply abs_scal; [positive|]. rewrite <- Ropp_mult_distr_l, Rabs_Ropp.
  apply abs_scal; [lra|]. apply rX_bound; auto.
Qed.

(** that share is less than all of it *)
Lemma share_below : 0 <= rho < 1.
Proof.
  assert (0 < Fstar m1 m2 0 a2 b om) by lra. unfold rho. split; [positive|].
  apply Rmult_lt_reg_r with (Fstar m1 m2 0 a2 b om); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Let del := b * (1 - rho).
Let del_pos : 0 < del. Proof. pose proof share_below. unfold del. apply Rmult_lt_0_compat; lra. Qed.
Let kap := m2 / (M * del).
Let kap_pos : 0 < kap. Proof. unfold kap. apply Rdiv_lt_0_compat; auto. positive. Qed.

(** the distance falls at the rate delta |w| at least *)
Lemma D_pays t : 0 <= t -> dini_le D t (- (del * Rabs (w t))).
Proof. exact (D_falls m1 m2 0 a2 b rho Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ H Stuck share t). Qed.
(** the distance is continuous *)
Lemma cont_distance : cont D.
Proof. exact (cont_D m1 m2 0 a2 b Hm2 _ _ _ _ _ _ _ _ H Stuck). Qed.
(** so is the relative velocity *)
Lemma cont_relative : cont w.
Proof. exact (cont_slip m1 m2 0 a2 b Hm2 _ _ _ _ _ H). Qed.
(** and the distance never grows *)
Lemma D_mono p q : 0 <= p <= q -> D q <= D p.
Proof.
  intros Hp. apply dini_mono; auto using cont_distance. intros t Ht e He.
  destruct (D_pays t ltac:(lra) e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
  pose proof (Rabs_pos (w t)). assert (0 <= del * Rabs (w t)) by (apply Rmult_le_pos; lra). nra.
Qed.

(** the common momentum, less that of the response, feels the spring alone *)
Lemma momentum_rate t : 0 <= t -> rderiv P t (- a2 * dx t).
Proof.
  intros Ht. apply rderiv_ext with (fun q => (m1 * v1 q + b * s q - drive F om q)
    - (m1 * v q + b * (m2 / b * v q) - drive F om q) + (m2 * v2 0 - b * s 0)).
  { intros q Hq. pose proof (f_v2 _ _ _ _ _ _ _ _ _ _ H q ltac:(lra)).
    replace (b * (m2 / b * v q)) with (m2 * v q) by (field; lra). unfold P, d1, d2. lra. }
  apply rderiv_eq with (- (a2 * x t + 0 * v1 t) - - (a2 * y t + 0 * v t) + 0); [unfold dx; ring|].
  apply rderiv_plus; [|apply rderiv_const].
  exact (rderiv_minus _ _ _ _ _ (f_v1 _ _ _ _ _ _ _ _ _ _ H t Ht) (f_v1 _ _ _ _ _ _ _ _ _ _ Stuck t Ht)).
Qed.

(** the place beside the response, in the frame that turns with the pair *)
Let turned phi t := dx t * cos (Om * t + phi) - P t / (M * Om) * sin (Om * t + phi).
(** is continuous *)
Lemma cont_turned phi : cont (turned phi).
Proof.
  assert (cont P).
  { apply cont_plus; apply cont_scal, cont_minus; try apply (f_cv _ _ _ _ _ _ _ _ _ _ Stuck);
      [apply (f_cv _ _ _ _ _ _ _ _ _ _ H)|exact (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ H)]. }
  apply cont_minus; apply cont_mult.
  - apply cont_minus; [apply (f_cx _ _ _ _ _ _ _ _ _ _ H)|apply (f_cx _ _ _ _ _ _ _ _ _ _ Stuck)].
  - apply cont_of_derive with (fun t => - Om * sin (Om * t + phi)). intros t; auto_derive; auto. ring.
  - apply cont_ext with (fun u => / (M * Om) * P u); [intros; unfold Rdiv; ring|apply cont_scal; auto].
  - apply cont_of_derive with (fun t => Om * cos (Om * t + phi)). intros t; auto_derive; auto. ring.
Qed.
(** and changes by slip alone *)
Lemma turned_rate phi t : 0 <= t -> rderiv (turned phi) t (m2 / M * w t * cos (Om * t + phi)).
Proof.
  intros Ht. apply rderiv_ext with (fun u => dx u * cos (Om * u + phi) - / (M * Om) * (P u * sin (Om * u + phi))).
  { intros; unfold turned; field. split; lra. }
  eapply rderiv_eq; [|apply rderiv_minus; [apply rderiv_mult; [exact (rderiv_minus _ _ _ _ _
    (f_x _ _ _ _ _ _ _ _ _ _ H t Ht) (f_x _ _ _ _ _ _ _ _ _ _ Stuck t Ht))|]|apply rderiv_scal,
    rderiv_mult; [apply momentum_rate, Ht|]]; apply rderiv_of_derive; auto_derive; auto; reflexivity].
  unfold w, P, d1, d2, dx. replace a2 with (M * (Om * Om)) by (rewrite Om_sq; field; lra). unfold M in *. field.
  split; lra.
Qed.
(** which the distance pays for *)
Lemma paid phi p q : 0 <= p <= q -> Rabs (turned phi q - turned phi p) <= kap * (D p - D q).
Proof.
  intros Hp. assert (Q : forall k, k = 1 \/ k = -1 -> k * turned phi q + kap * D q <= k * turned phi p + kap * D p).
  { intros k Hk. apply (dini_mono (fun u => k * turned phi u + kap * D u)); auto.
    { apply cont_plus; apply cont_scal; auto using cont_turned, cont_distance. }
    intros t Ht e He. destruct (D_pays t ltac:(lra) (e / (2 * kap))) as (e1 & He1 & K1); [positive|].
    destruct (rderiv_scal k _ _ _ (turned_rate phi t ltac:(lra)) (e / 2)) as (e2 & He2 & K2); [lra|].
    smaller e1 e2. intros h Hh. specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K2.
    cbv beta in K2. apply (Rmult_le_compat_l kap) in K1; [|lra].
    replace (kap * ((- (del * Rabs (w t)) + e / (2 * kap)) * h)) with (- (m2 / M * Rabs (w t)) * h + e / 2 * h) in K1
      by (unfold kap; field; repeat split; lra).
    assert (k * (w t * cos (Om * t + phi)) <= Rabs (w t)).
    { pose proof (COS_bound (Om * t + phi)). unfold Rabs; destruct Rcase_abs; destruct Hk; subst k; nra. }
    assert (0 < m2 / M) by positive.
    assert (m2 / M * (k * (w t * cos (Om * t + phi))) * h <= m2 / M * Rabs (w t) * h).
    { apply Rmult_le_compat_r; [lra|]. scale. }
    lra. }
  pose proof (Q 1 (or_introl eq_refl)). pose proof (Q (-1) (or_intror eq_refl)). apply Rabs_le; lra.
Qed.

(** the relative velocity is Lipschitz, as all forces stay bounded *)
Lemma relative_lip : exists K, 0 < K /\ forall p q, 0 <= p <= q -> Rabs (w q - w p) <= K * (q - p).
Proof.
  set (X0 := sqrt (2 * D 0 / a2)). set (Y0 := F / sqrt (Z m1 m2 0 a2 om)). pose proof (sqrt_lt_R0 _ HZ) as Sz.
  assert (DP : forall t, 0 <= D t) by (intros t; apply energy_pos; auto).
  assert (Hx : forall t, 0 <= t -> Rabs (x t) <= Y0 + X0).
  { intros t Ht. replace (x t) with (y t + dx t) by (unfold dx; ring). eapply Rle_trans; [apply Rabs_triang|].
    apply Rplus_le_compat; [apply rX_bound; auto|]. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr.
    undivide a2. pose proof (D_mono 0 t ltac:(lra)) as Q. unfold D at 1, energy in Q.
    pose proof (pow2_ge_0 (d1 t)). pose proof (pow2_ge_0 (d2 t)). nra. }
  assert (Y1 : 0 <= Y0) by (unfold Y0; positive). assert (X1 : 0 <= X0) by apply sqrt_pos.
  set (G := a2 * (Y0 + X0)). assert (HG : 0 <= G) by (unfold G; apply Rmult_le_pos; lra).
  assert (Bm : 0 < b / m2) by positive. assert (G1 : 0 <= / m1 * (G + b + F)) by positive.
  exists (/ m1 * (G + b + F) + b / m2). split; [lra|]. intros p q Hp.
  assert (L : Rabs ((m1 * v1 q + b * s q - drive F om q) - (m1 * v1 p + b * s p - drive F om p)) <= G * (q - p)).
  { apply (lip_of_rderiv (fun t => m1 * v1 t + b * s t - drive F om t) (fun t => - (a2 * x t + 0 * v1 t))); auto.
    - apply cont_minus; [apply cont_plus; apply cont_scal|]; [apply (f_cv _ _ _ _ _ _ _ _ _ _ H)| |
        apply (f_cU _ _ _ _ _ _ _ _ _ _ H)]. exact (moves_cs m1 m2 0 a2 b _ _ _ _ _ _ H).
    - intros t Ht. split; [apply (f_v1 _ _ _ _ _ _ _ _ _ _ H t Ht)|].
      replace (- (a2 * x t + 0 * v1 t)) with (- (a2 * x t)) by ring. rewrite Rabs_Ropp.
      apply abs_scal; [lra|auto]. }
  pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H p q Hp) as Ls. pose proof (drive_lip F om HF Hom p q Hp) as Lu.
  pose proof (only_gentle m1 m2 0 a2 b Hm2 Hb _ _ _ _ _ p q H Hp) as L2.
  assert (Lb : Rabs (b * (s q - s p)) <= b * (q - p)) by (apply abs_scal; lra).
  assert (L1 : Rabs (v1 q - v1 p) <= / m1 * ((G + b + F) * (q - p))).
  { replace (v1 q - v1 p) with (/ m1 * ((m1 * v1 q + b * s q - drive F om q - (m1 * v1 p + b * s p - drive F om p))
      - b * (s q - s p) + (drive F om q - drive F om p))) by (field; lra).
    apply abs_scal; [positive|]. apply Rabs_inv in L. apply Rabs_inv in Lb. apply Rabs_inv in Lu. apply Rabs_le; lra. }
  apply Rabs_inv in L1. apply Rabs_inv in L2. unfold w. apply Rabs_le; lra.
Qed.

(** so it vanishes *)
Lemma relative_vanishes e : 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (w t) <= e.
Proof.
  intros He. destruct relative_lip as (K & HK & L).
  destruct (dec_limit D D_mono ltac:(intros; apply energy_pos; auto)) as (l & _ & Below & Lim).
  set (h := e / (2 * K)). assert (Hh : 0 < h) by (unfold h; positive). assert (Kh : K * h = e / 2) by (unfold h; field; lra).
  assert (Cost : 0 < del * (e / 2) * h / 2) by positive. destruct (Lim _ Cost) as (T & HT & Q).
  exists T. split; auto. intros t Ht. apply Rnot_lt_le. intros N.
  assert (Big : forall u, t <= u < t + h -> e / 2 <= Rabs (w u)).
  { intros u Hu. pose proof (L t u ltac:(lra)) as Lu. assert (K * (u - t) <= K * h) by (apply Rmult_le_compat_l; lra).
    pose proof (Rabs_triang_inv (w t) (w t - w u)) as Tr. replace (w t - (w t - w u)) with (w u) in Tr by ring.
    rewrite (Rabs_minus_sym (w t) (w u)) in Tr. lra. }
  assert (S : D (t + h) - D t <= - (del * (e / 2)) * (t + h - t)).
  { apply dini_slope; auto using cont_distance; [lra|]. intros u Hu e' He'.
    destruct (D_pays u ltac:(lra) e' He') as (d & Hd & K'). exists d; split; auto. intros k Hk. specialize (K' k Hk).
    specialize (Big u Hu). assert (del * (e / 2) <= del * Rabs (w u)) by scale. nra. }
  pose proof (Below (t + h) ltac:(lra)). specialize (Q t Ht). replace (t + h - t) with h in S by ring. lra.
Qed.

(** the response and a free oscillation of the pair beside it: its place *)
Let yX x0 v0 t := y t + X m1 m2 a2 x0 v0 t.
(** and its speed *)
Let yV x0 v0 t := v t + V m1 m2 a2 x0 v0 t.

(** the motion tends to one of these *)
Lemma tends : exists x0 v0, forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
  energy m1 m2 a2 (x t - yX x0 v0 t) (v1 t - yV x0 v0 t) (v2 t - yV x0 v0 t) <= e.
Proof.
  destruct (dec_limit D D_mono ltac:(intros; apply energy_pos; auto)) as (l & _ & Below & Lim).
  destruct (paid_limit D (turned 0) kap l (Rlt_le _ _ kap_pos) Below (paid 0)) as (a & Na).
  destruct (paid_limit D (turned (- (PI / 2))) kap l (Rlt_le _ _ kap_pos) Below (paid (- (PI / 2)))) as (c & Nc).
  exists a, (Om * c). intros e He. assert (Km : 0 < m1 * m2 / (2 * M)) by positive.
  set (g := Rmin 1 (e / (2 * (a2 * kap ^ 2)))). assert (Ak : 0 < a2 * kap ^ 2) by positive.
  assert (Hg : 0 < g) by positive. destruct (Lim g Hg) as (T1 & HT1 & L1).
  set (k := Rmin 1 (e / (2 * (m1 * m2 / (2 * M))))). assert (Hk : 0 < k) by positive.
  destruct (relative_vanishes k Hk) as (T2 & HT2 & L2).
  exists (Rmax T1 T2). pose proof (Rmax_l T1 T2). pose proof (Rmax_r T1 T2). split; [lra|]. intros t Ht.
  assert (ID : energy m1 m2 a2 (x t - yX a (Om * c) t) (v1 t - yV a (Om * c) t) (v2 t - yV a (Om * c) t)
    = a2 / 2 * ((turned 0 t - a) ^ 2 + (turned (- (PI / 2)) t - c) ^ 2) + m1 * m2 / (2 * M) * w t ^ 2).
  { unfold turned. rewrite Rplus_0_r. replace (Om * t + - (PI / 2)) with (- (PI / 2 - Om * t)) by ring.
    rewrite cos_neg, sin_neg, cos_shift, sin_shift. unfold yX, yV, X, V. fold Om.
    pose proof (sin2_cos2 (Om * t)) as SC. unfold Rsqr in SC.
    replace (x t - (y t + (a * cos (Om * t) + Om * c / Om * sin (Om * t))))
      with (dx t - (a * cos (Om * t) + c * sin (Om * t))) by (unfold dx; field; lra).
    set (co := cos (Om * t)) in *. set (si := sin (Om * t)) in *. set (p := P t / (M * Om)).
    set (f1 := dx t - (a * co + c * si)). set (f2 := p - (c * co - a * si)).
    assert (Ea : dx t * co - p * si - a = f1 * co - f2 * si).
    { replace (dx t * co - p * si - a) with (dx t * co - p * si - a * (si * si + co * co)) by (rewrite SC; ring).
      unfold f1, f2. ring. }
    assert (Ec : dx t * si - p * - co - c = f1 * si + f2 * co).
    { replace (dx t * si - p * - co - c) with (dx t * si - p * - co - c * (si * si + co * co)) by (rewrite SC; ring).
      unfold f1, f2. ring. }
    rewrite Ea, Ec. replace ((f1 * co - f2 * si) ^ 2 + (f1 * si + f2 * co) ^ 2) with
      ((f1 ^ 2 + f2 ^ 2) * (si * si + co * co)) by ring. rewrite SC. unfold energy, f2, p.
    rewrite (ltac:(rewrite Om_sq; field; lra) : a2 = M * (Om * Om)). unfold w, P, d1, d2, M. field. unfold M in *. lra. }
  rewrite ID. specialize (Na t ltac:(lra)). specialize (Nc t ltac:(lra)). specialize (L1 t ltac:(lra)).
  specialize (L2 t ltac:(lra)). specialize (Below t ltac:(lra)).
  assert (G1 : g <= 1) by apply Rmin_l. assert (G2 : g <= e / (2 * (a2 * kap ^ 2))) by apply Rmin_r.
  assert (K1 : k <= 1) by apply Rmin_l. assert (K2 : k <= e / (2 * (m1 * m2 / (2 * M)))) by apply Rmin_r.
  assert (Sq : forall z, Rabs z <= kap * (D t - l) -> z ^ 2 <= kap ^ 2 * g).
  { intros z Hz. rewrite <- (pow2_abs z). pose proof (Rabs_pos z).
    assert (Rabs z <= kap * g) by (eapply Rle_trans; [exact Hz|]; apply Rmult_le_compat_l; lra).
    assert (Rabs z ^ 2 <= (kap * g) ^ 2) by (apply pow_incr; lra).
    assert ((kap * g) ^ 2 <= kap ^ 2 * g); [|lra]. rewrite Rpow_mult_distr. apply Rmult_le_compat_l; [positive|nra]. }
  pose proof (Sq _ Na). pose proof (Sq _ Nc).
  assert (S1 : a2 / 2 * ((turned 0 t - a) ^ 2 + (turned (- (PI / 2)) t - c) ^ 2) <= e / 2).
  { apply Rle_trans with (a2 / 2 * (kap ^ 2 * g + kap ^ 2 * g)); [apply Rmult_le_compat_l; lra|].
    replace (a2 / 2 * (kap ^ 2 * g + kap ^ 2 * g)) with (a2 * kap ^ 2 * g) by field.
    apply Rle_trans with (a2 * kap ^ 2 * (e / (2 * (a2 * kap ^ 2)))); [scale|right; field; lra]. }
  assert (S2 : m1 * m2 / (2 * M) * w t ^ 2 <= e / 2).
  { apply Rle_trans with (m1 * m2 / (2 * M) * (e / (2 * (m1 * m2 / (2 * M))))); [|right; field; lra].
    apply Rmult_le_compat_l; [lra|]. rewrite <- (pow2_abs (w t)). pose proof (Rabs_pos (w t)). nra. }
  lra.
Qed.

(** a free oscillation is Lipschitz *)
Lemma free_lip x0 v0 : exists K, 0 < K /\ forall p q, 0 <= p <= q ->
  Rabs (V m1 m2 a2 x0 v0 q - V m1 m2 a2 x0 v0 p) <= K * (q - p).
Proof.
  pose proof (Rabs_pos x0). pose proof (Rabs_pos (v0 / Om)). assert (0 < Om * Om) by positive.
  exists (Om * Om * (Rabs x0 + Rabs (v0 / Om) + 1)). split; [apply Rmult_lt_0_compat; lra|].
  intros p q Hp. apply (lip_of_rderiv _ (fun t => - (Om * Om) * X m1 m2 a2 x0 v0 t)); auto.
  { eapply cont_of_derive; intros; apply derive_V; auto. }
  intros t Ht. split; [apply rderiv_of_derive, derive_V; auto|].
  rewrite <- Ropp_mult_distr_l, Rabs_Ropp. apply abs_scal; [lra|]. unfold X. fold Om.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
  assert (Rabs (cos (Om * t)) <= 1) by (apply Rabs_le, COS_bound).
  assert (Rabs (sin (Om * t)) <= 1) by (apply Rabs_le, SIN_bound). nra.
Qed.

(** and has its period *)
Lemma free_period x0 v0 k t : V m1 m2 a2 x0 v0 (t + INR k * (2 * PI / Om)) = V m1 m2 a2 x0 v0 t.
Proof.
  unfold V. fold Om. replace (Om * (t + INR k * (2 * PI / Om))) with (Om * t + 2 * INR k * PI) by (field; lra).
  rewrite cos_period, sin_period. auto.
Qed.

(** after some number of the force's periods, as late as one likes, the stuck motion nearly repeats itself *)
Lemma nearly_repeats x0 v0 e N : 0 < e -> exists n, (N <= n)%nat /\ forall t, 0 <= t ->
  Rabs (yV x0 v0 (t + INR n * (2 * PI / om)) - yV x0 v0 t) <= e.
Proof.
  intros He. destruct (free_lip x0 v0) as (K & HK & L). pose proof PI_RGT_0 as P0. set (tau := 2 * PI / Om).
  assert (Tp : 0 < tau) by (unfold tau; positive). set (g := Rmin 1 (e / (K * tau))).
  assert (Hg : 0 < g) by positive. assert (G1 : g <= 1) by apply Rmin_l. assert (G2 : g <= e / (K * tau)) by apply Rmin_r.
  destruct (recurs (Om / om) g N ltac:(positive) ltac:(lra)) as (n & k & Hn & Near). exists n. split; auto.
  intros t Ht. set (d := INR n * (Om / om) - INR k) in *. apply Rabs_def2 in Near.
  assert (Kg : K * (g * tau) <= e).
  { apply Rle_trans with (K * (e / (K * tau) * tau)); [|right; field; split; lra].
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; lra. }
  unfold yV, v. rewrite rV_period by auto.
  replace (V m1 m2 a2 x0 v0 (t + INR n * (2 * PI / om))) with (V m1 m2 a2 x0 v0 (t + tau + d * tau)).
  2: { rewrite <- (free_period x0 v0 k (t + tau + d * tau)), <- (free_period x0 v0 1 (t + INR n * (2 * PI / om))).
    f_equal. unfold d, tau. simpl INR. field. split; lra. }
  rewrite <- (free_period x0 v0 1 t) at 1. simpl INR. rewrite Rmult_1_l. fold tau.
  match goal with |- Rabs ?z <= _ =>
    replace z with (V m1 m2 a2 x0 v0 (t + tau + d * tau) - V m1 m2 a2 x0 v0 (t + tau)) by ring end.
  destruct (Rle_dec 0 d).
  - pose proof (L (t + tau) (t + tau + d * tau)) as Q. assert (0 <= d * tau) by positive.
    specialize (Q ltac:(lra)). eapply Rle_trans; [exact Q|]. eapply Rle_trans; [|exact Kg].
    apply Rmult_le_compat_l; [lra|]. replace (t + tau + d * tau - (t + tau)) with (d * tau) by ring.
    apply Rmult_le_compat_r; lra.
  - pose proof (L (t + tau + d * tau) (t + tau)) as Q. assert (0 <= (1 + d) * tau) by (apply Rmult_le_pos; lra).
    assert (0 <= - d * tau) by (apply Rmult_le_pos; lra).
    specialize (Q ltac:(lra)). rewrite Rabs_minus_sym. eapply Rle_trans; [exact Q|]. eapply Rle_trans; [|exact Kg].
    apply Rmult_le_compat_l; [lra|]. replace (t + tau - (t + tau + d * tau)) with (- d * tau) by ring.
    apply Rmult_le_compat_r; lra.
Qed.

(** so what the motion tends to asks for no more than b, and is a motion *)
Lemma limit_moves x0 v0 : (forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - yX x0 v0 t) (v1 t - yV x0 v0 t) (v2 t - yV x0 v0 t) <= e) ->
  forced m1 m2 0 a2 b (drive F om) (yX x0 v0) (yV x0 v0) (yV x0 v0) (fun t => m2 / b * yV x0 v0 t).
Proof.
  intros To. assert (DX : forall t, is_derive (yX x0 v0) t (yV x0 v0 t)).
  { intros t. apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); [apply derive_rX; auto|apply derive_X; auto]. }
  assert (DV : forall t, is_derive (yV x0 v0) t (- om ^ 2 * y t + - (Om * Om) * X m1 m2 a2 x0 v0 t)).
  { intros t. apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); [apply derive_rV; auto|apply derive_V; auto]. }
  apply stuck_forced; auto.
  - apply (f_cU _ _ _ _ _ _ _ _ _ _ H).
  - eapply cont_of_derive; exact DX.
  - intros; apply rderiv_of_derive, DX.
  - intros t Ht. apply rderiv_eq with (M * (- om ^ 2 * y t + - (Om * Om) * X m1 m2 a2 x0 v0 t) - F * sin (om * t)).
    { pose proof (balance m1 m2 0 a2 F om HZ t) as Q. fold M in Q. fold y in Q.
      rewrite Om_sq. unfold yX. rewrite <- Q. field. lra. }
    apply rderiv_minus; [apply rderiv_scal|]; apply rderiv_of_derive; [apply DV|apply derive_drive; auto].
  - intros p q Hp. apply le_epsilon. intros e He.
    destruct (To (m2 * (e / 4) ^ 2 / 2)) as (T & HT & Near); [positive|].
    assert (Close : forall t, T <= t -> Rabs (v2 t - yV x0 v0 t) <= e / 4).
    { intros t Ht. specialize (Near t Ht). unfold energy in Near. apply Rabs_le, sq_le_abs; [lra|].
      pose proof (pow2_ge_0 (x t - yX x0 v0 t)) as S1. pose proof (pow2_ge_0 (v1 t - yV x0 v0 t)) as S2.
      apply (Rmult_le_compat_l a2) in S1; [|lra]. apply (Rmult_le_compat_l m1) in S2; [|lra].
      apply Rmult_le_reg_l with m2; lra. }
    pose proof PI_RGT_0. assert (Pp : 0 < 2 * PI / om) by positive.
    destruct (nat_above T (2 * PI / om) Pp) as (N & HN).
    destruct (nearly_repeats x0 v0 (e / 4) N ltac:(lra)) as (n & Hn & Rep). set (S := INR n * (2 * PI / om)) in *.
    assert (HS : T <= S).
    { apply le_INR in Hn. assert (INR N * (2 * PI / om) <= S) by (apply Rmult_le_compat_r; lra). lra. }
    pose proof (Rep p ltac:(lra)) as E1. pose proof (Rep q ltac:(lra)) as E2.
    pose proof (Close (p + S) ltac:(lra)) as C1. pose proof (Close (q + S) ltac:(lra)) as C2.
    pose proof (only_gentle m1 m2 0 a2 b Hm2 Hb _ _ _ _ _ (p + S) (q + S) H ltac:(lra)) as G.
    replace (q + S - (p + S)) with (q - p) in G by ring.
    apply Rabs_inv in E1. apply Rabs_inv in E2. apply Rabs_inv in C1. apply Rabs_inv in C2. apply Rabs_inv in G.
    apply Rabs_le; lra.
Qed.

(** *** a1 = 0, F < F*: the path of the slip is at most the energy distance from the stuck response over b times the unused share of F*,
    and the motion tends to one that sticks for ever *)

(** [undamped-entrained] With $a_1=0$ every motion under a sinusoidal force of amplitude below $U_*$ tends to one that
    sticks permanently, and $\int|\dot z|\,dt$ is at most the energy distance from the stuck response at $t=0$ over
    $b\,(1-U/U_{*})$. *)
Theorem undamped_entrained :
  (forall t, 0 <= t -> b * (1 - F / Fstar m1 m2 0 a2 b om) * integral (fun q => Rabs (v1 q - v2 q)) t <=
    energy m1 m2 a2 (x 0 - rX m1 m2 0 a2 F om 0) (v1 0 - rV m1 m2 0 a2 F om 0) (v2 0 - rV m1 m2 0 a2 F om 0)) /\
  exists p q r, forced m1 m2 0 a2 b (drive F om) p q q r /\ forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t ->
    energy m1 m2 a2 (x t - p t) (v1 t - q t) (v2 t - q t) <= e.
Proof.
  split.
  - intros t Ht. pose proof (slide m1 m2 0 a2 b rho Hm1 Hm2 (Rle_refl 0) Hb _ _ _ _ _ _ _ _ H Stuck share 0 t
      ltac:(lra)) as Q. rewrite integral_0, Rminus_0_r in Q.
    eapply Rle_trans; [exact Q|]. pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t - y t) (v1 t - v t) (v2 t - v t)).
    unfold y, v in *. lra.
  - destruct tends as (x0 & v0 & To). exists (yX x0 v0), (yV x0 v0), (fun t => m2 / b * yV x0 v0 t).
    split; [exact (limit_moves x0 v0 To)|exact To].
Qed.
End Undamped.
