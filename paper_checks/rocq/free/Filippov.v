(** What is called a motion under a force in Forced.v is what Filippov calls one: absolutely continuous functions that
    obey the differential inclusion at almost all times. The force may be any function u that is integrable (with the
    integral U) and continuous at almost all times: all that is continuous by pieces, and more. *)
From InertialPair Require Import Dini Pair Pursuit Forced ForcedExistence Approach ModeAtContact AlmostEverywhere.

(** slopes near t that come to l: a derivative *)
Lemma derive_of_slopes (f : R -> R) t (l : R) : (forall e, 0 < e -> exists d, 0 < d /\ forall q, t - d < q < t + d ->
  Rabs (f q - f t - l * (q - t)) <= e * Rabs (q - t)) -> is_derive f t l.
Proof.
  intros K. apply is_derive_Reals. intros e He. destruct (K (e / 2) ltac:(lra)) as (d & Hd & Q).
  exists (mkposreal d Hd). simpl. intros h Nh Hh. apply Rabs_def2 in Hh. specialize (Q (t + h) ltac:(lra)).
  replace (t + h - t) with h in Q by ring. pose proof (Rabs_pos_lt h Nh).
  replace ((f (t + h) - f t) / h - l) with ((f (t + h) - f t - l * h) / h) by (field; auto).
  unfold Rdiv at 1. rewrite Rabs_mult, Rbasic_fun.Rabs_inv. apply Rmult_lt_reg_r with (Rabs h); auto.
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. nra.
Qed.

(** a continuous right derivative is a derivative *)
Lemma derive_of_rderiv f g t : cont f -> cont g -> (forall u, 0 <= u -> rderiv f u (g u)) -> 0 < t ->
  is_derive f t (g t).
Proof.
  intros F G D Ht. apply derive_of_slopes. intros e He. destruct (G t ltac:(lra) e He) as (d & Hd & K).
  assert (S : forall p q, t - Rmin d t < p <= q -> q < t + Rmin d t ->
    (g t - e) * (q - p) <= f q - f p <= (g t + e) * (q - p)).
  { intros p q Hp Hq. pose proof (Rmin_l d t). pose proof (Rmin_r d t). apply (between f g); auto; [lra|].
    split; [apply D; lra|]. specialize (K u ltac:(lra) ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in K. lra. }
  exists (Rmin d t). split; [positive|]. intros q Hq. apply Rabs_le. destruct (Rle_dec t q).
  - rewrite (Rabs_pos_eq (q - t)) by lra. destruct (S t q); lra.
  - rewrite (Rabs_left (q - t)) by lra. destruct (S q t); lra.
Qed.

(** a bounded right derivative on every [0, T]: absolutely continuous *)
Lemma ac_of_rderiv f g : cont f -> cont g -> (forall u, 0 <= u -> rderiv f u (g u)) -> ac f.
Proof.
  intros F G D. apply ac_lip. intros T HT. destruct (cont_bounded g T G HT) as (B & HB). exists B. split.
  { pose proof (HB 0 ltac:(lra)). pose proof (Rabs_pos (g 0)). lra. }
  intros r t Hr Hl. apply (lip_between f g); auto. split; [apply D; lra|apply Rabs_inv, HB; lra].
Qed.

(** equal around t *)
Lemma derive_near (f g : R -> R) t d (l : R) : 0 < d -> (forall u, t - d < u < t + d -> f u = g u) ->
  is_derive f t l -> is_derive g t l.
Proof.
  intros Hd E D. apply (is_derive_ext_loc f); auto. exists (mkposreal d Hd). intros u Hu. apply E.
  unfold ball in Hu; simpl in Hu; unfold AbsRing_ball, abs, minus, plus, opp in Hu; simpl in Hu.
  apply Rabs_def2 in Hu. lra.
Qed.

(** a force with its integral *)
Definition integral_of (u U : R -> R) := ac U /\ almost (fun t => is_derive U t (u t)).

Section Filippov.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).

(** the inclusion at one time: x' = v1, m1 v1' = u - a2 x - a1 v1 - b g, m2 v2' = b g for some g in the set-valued sign *)
Definition included (u x v1 v2 : R -> R) t := exists g, -1 <= g <= 1 /\ (v2 t < v1 t -> g = 1) /\
  (v1 t < v2 t -> g = -1) /\
  is_derive x t (v1 t) /\ is_derive v1 t ((u t - a2 * x t - a1 * v1 t - b * g) / m1) /\ is_derive v2 t (b * g / m2).

(** a Filippov solution on [0, oo) *)
Definition filippov (u x v1 v2 : R -> R) := ac x /\ ac v1 /\ ac v2 /\ almost (included u x v1 v2).

(** [filippov-forced] Under any integrable force a Filippov solution is a motion: what is proved of all motions is
    true of it. *)
Theorem filippov_forced u U x v1 v2 : integral_of u U -> filippov u x v1 v2 ->
  forced m1 m2 a1 a2 b U x v1 v2 (fun t => m2 / b * v2 t).
Proof.
  intros (AU & DU) (Ax & A1 & A2 & In). pose proof (cont_ac _ Ax) as Cx. pose proof (cont_ac _ A1) as C1.
  pose proof (cont_ac _ A2) as C2. assert (As : ac (fun t => m2 / b * v2 t)) by (apply ac_scal; auto).
  assert (Ds : forall t, included u x v1 v2 t -> exists g, is_derive (fun t => m2 / b * v2 t) t g /\ -1 <= g <= 1 /\ (v2
    t < v1 t -> g = 1) /\ (v1 t < v2 t -> g = -1)).
  { intros t (g & Hg & Gp & Gn & _ & _ & D). exists g. split; auto.
    replace g with (m2 / b * (b * g / m2)) by (field; lra). apply (is_derive_scal v2 t (m2 / b) _ D). }
  assert (Local : forall t k, 0 <= t -> k = 1 \/ k = -1 -> 0 < k * (v1 t - v2 t) ->
    rderiv (fun t => m2 / b * v2 t) t k).
  { intros t k Ht Hk1 Pos. assert (Cw : cont (fun t => k * (v1 t - v2 t))) by (apply cont_scal, cont_minus; auto).
    destruct (Cw t Ht _ Pos) as (d & Hd & K). exists d; split; auto. intros h Hh.
    destruct (In (t + h) ltac:(lra)) as (N & HN & Inn).
    destruct (ac_slope (fun t => m2 / b * v2 t) N t (t + h) k k) as (L & U'); auto; [lra| |].
    - intros r Hr Nr. destruct (Ds r (Inn r ltac:(lra) Nr)) as (g & Dg & _ & Gp & Gn). exists g. split; auto.
      specialize (K r ltac:(lra)). assert (Q : Rabs (r - t) < d) by (rewrite Rabs_pos_eq; lra). specialize (K Q).
      apply Rabs_def2 in K. destruct Hk1; subst k; [rewrite Gp by lra|rewrite Gn by lra]; lra.
    - apply Rabs_le. split; nra. }
  constructor; auto using cont_ac.
  - intros r t Hr. destruct (In t ltac:(lra)) as (N & HN & Inn).
    destruct (ac_slope (fun t => m2 / b * v2 t) N r t (-1) 1) as (L & U'); auto.
    + intros q Hq Nq. destruct (Ds q (Inn q ltac:(lra) Nq)) as (g & Dg & Hg & _). exists g; auto.
    + apply Rabs_le. lra.
  - intros t Ht Hv. apply (Local t 1); auto; lra.
  - intros t Ht Hv. apply (Local t (-1)); auto; lra.
  - intros t Ht. apply (ac_rderiv x v1); auto. apply (almost_impl (included u x v1 v2)); auto.
    intros r _ (g & _ & _ & _ & D & _). exact D.
  - intros t Ht. apply (ac_rderiv (fun r => m1 * v1 r + b * (m2 / b * v2 r) - U r) (fun r => - (a2 * x r + a1 * v1 r)));
      auto.
    + apply ac_ext with (fun r => m1 * v1 r + b * (m2 / b * v2 r) + -1 * U r); [intros; ring|].
      apply ac_plus; [apply ac_plus; apply ac_scal; auto|apply ac_scal; auto].
    + continuous.
    + apply (almost_impl (fun r => included u x v1 v2 r /\ is_derive U r (u r))); [|apply almost_and; auto].
      intros r _ ((g & _ & _ & _ & _ & D1 & D2) & D).
      replace (- (a2 * x r + a1 * v1 r)) with (minus (plus (m1 * ((u r - a2 * x r - a1 * v1 r - b * g) / m1))
        (b * (m2 / b * (b * g / m2)))) (u r)) by (unfold minus, plus, opp; simpl; field; lra).
      apply (is_derive_minus (fun r => m1 * v1 r + b * (m2 / b * v2 r)) U); auto.
      apply (is_derive_plus (fun r => m1 * v1 r) (fun r => b * (m2 / b * v2 r))).
      * apply (is_derive_scal v1 r m1 _ D1).
      * apply (is_derive_scal (fun r => m2 / b * v2 r) r b). apply (is_derive_scal v2 r (m2 / b) _ D2).
  - intros t Ht. field; lra.
Qed.

(** *** And the other way round *)
Section Motion.
Context (u U x v1 v2 s : R -> R) (HU : integral_of u U) (H : forced m1 m2 a1 a2 b U x v1 v2 s).
Context (w := fun t => v1 t - v2 t) (kap := (m1 + m2) / (m1 * m2)) (load := load m1 m2 a1 a2 u x v1).
(** what the relative velocity would be without friction, of which the load gives the rate *)
Let g t := w t + kap * b * s t.

Lemma v2_by_s t : 0 <= t -> v2 t = v2 0 - b / m2 * s 0 + b / m2 * s t.
Proof. intros Ht. pose proof (f_v2 _ _ _ _ _ _ _ _ _ _ H t Ht). apply Rmult_eq_reg_l with m2; [field_simplify; lra|lra]. Qed.
Lemma motion_ac : ac x /\ ac v1 /\ ac v2 /\ ac g /\ almost (fun t => is_derive g t (kap * load t)).
Proof.
  pose proof (f_cx _ _ _ _ _ _ _ _ _ _ H) as Cx. pose proof (f_cv _ _ _ _ _ _ _ _ _ _ H) as Cv.
  set (P := fun t => m1 * v1 t + b * s t - U t). set (p := fun t => - (a2 * x t + a1 * v1 t)).
  assert (Cp : cont p) by continuous. assert (CP : cont P) by continuous.
  assert (AP : ac P) by exact (ac_of_rderiv P p CP Cp (f_v1 _ _ _ _ _ _ _ _ _ _ H)). assert (As : ac s). { apply ac_lip.
    exists 1. split; [lra|]. intros r t Hr _. rewrite Rmult_1_l. apply (f_lip _ _ _ _ _ _ _ _ _ _ H); auto. }
  assert (A2 : ac v2). { apply ac_ext with (fun t => v2 0 - b / m2 * s 0 + b / m2 * s t);
    [intros; symmetry; apply v2_by_s; auto|]. apply ac_plus; [apply ac_const|apply ac_scal; auto]. }
  assert (Eg : forall t, 0 <= t -> / m1 * (P t + U t) - (v2 0 - b / m2 * s 0) = g t).
  { intros t Ht. unfold g, w, P, kap. rewrite (v2_by_s t Ht). field. lra. }
  destruct HU as (AU & DU).
  split; [exact (ac_of_rderiv x v1 Cx Cv (f_x _ _ _ _ _ _ _ _ _ _ H))|]. split; [|split; [auto|split]].
  - apply ac_ext with (fun t => / m1 * (P t + U t) + - b / m1 * s t); [intros; unfold P; field; lra|].
    apply ac_plus; apply ac_scal; auto using ac_plus.
  - apply ac_ext with (fun t => / m1 * (P t + U t) + - (v2 0 - b / m2 * s 0)); [intros; apply Eg; auto|].
    apply ac_plus; [apply ac_scal, ac_plus; auto|apply ac_const].
  - apply (almost_impl (fun t => 0 < t /\ is_derive U t (u t))); [|apply almost_and; auto using almost_later].
    intros t _ (Ht & D). apply (derive_near (fun t => / m1 * (P t + U t) - (v2 0 - b / m2 * s 0)) g t t); auto.
    { intros r Hr. apply Eg. lra. }
    pose proof (derive_of_rderiv P p t CP Cp (f_v1 _ _ _ _ _ _ _ _ _ _ H) Ht) as DP.
    replace (kap * load t) with (minus (/ m1 * plus (p t) (u t)) 0)
      by (unfold kap, load, ModeAtContact.load, p, minus, plus, opp; simpl; field; lra).
    apply (is_derive_minus (fun t => / m1 * (P t + U t)) (fun _ => v2 0 - b / m2 * s 0)); [|apply @is_derive_const].
    apply (is_derive_scal (fun t => P t + U t)), (is_derive_plus P U); auto.
Qed.

(** where the force is continuous: that rate is nearly constant near by *)
Lemma near t e : 0 < t -> continuous u t -> 0 < e -> exists d, 0 < d <= t /\
  forall p q, t - d < p <= q -> q < t + d -> (kap * load t - e) * (q - p) <= g q - g p <= (kap * load t + e) * (q - p).
Proof.
  intros Ht Cu He. assert (Kp : 0 < kap) by positive. assert (Hek : 0 < e / kap) by positive.
  destruct (load_near m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 U u x v1 v2 s t H ltac:(lra) (fun _ => True) (e / kap) Hek)
    as (d & Hd & K).
  { intros r Hr. destruct (proj1 (filterlim_locally u (u t)) Cu (mkposreal r Hr)) as ((d & Hd) & K). exists d.
    split; auto. intros q _ Hq. apply Rlt_le. exact (K q Hq). }
  destruct motion_ac as (_ & _ & _ & Ag & Dg). exists (Rmin d t). pose proof (Rmin_l d t). pose proof (Rmin_r d t).
  split; [split; [positive|auto]|]. intros p q Hp Hq. destruct (Dg (t + t) ltac:(lra)) as (N & HN & F).
  apply (ac_slope g N p q); auto; [lra|]. intros r Hr Nr. exists (kap * load r). split; [apply F; auto; lra|].
  specialize (K r ltac:(lra) I ltac:(apply Rabs_def1; lra)). apply Rabs_inv in K. fold load in K.
  replace e with (kap * (e / kap)) by (field; lra). nra.
Qed.

Lemma derive_g t : 0 < t -> continuous u t -> is_derive g t (kap * load t).
Proof.
  intros Ht Cu. apply derive_of_slopes. intros e He. destruct (near t e Ht Cu He) as (d & Hd & K). exists d.
  split; [lra|]. intros q Hq. apply Rabs_le. destruct (Rle_dec t q).
  - rewrite (Rabs_pos_eq (q - t)) by lra. specialize (K t q ltac:(lra) ltac:(lra)). nra.
  - rewrite (Rabs_left (q - t)) by lra. specialize (K q t ltac:(lra) ltac:(lra)). nra.
Qed.

(** in a slip, its first time included or not, friction has its whole impulse *)
Lemma whole_impulse k p q : k = 1 \/ k = -1 -> 0 <= p <= q -> (forall r, p < r < q -> 0 < k * w r) ->
  s q - s p = k * (q - p).
Proof.
  intros Hk Hp W. assert (B : forall e, 0 < e -> Rabs (s q - s p - k * (q - p)) <= e).
  { intros e He. destruct (Req_dec p q) as [->|Ne].
    { replace (s q - s q - k * (q - q)) with 0 by ring. rewrite Rabs_R0. lra. }
    set (d := Rmin (q - p) e / 2). pose proof (Rmin_l (q - p) e). pose proof (Rmin_r (q - p) e).
    assert (0 < Rmin (q - p) e) by positive. pose proof (moves_impulse m1 m2 a1 a2 b _ _ _ _ _ _ (forced_moving m1 m2 a1
      a2 b _ _ _ _ _ H) (p + d) q k ltac:(unfold d; lra) Hk) as I.
    specialize (I ltac:(intros r Hr; apply W; unfold d in *; lra)).
    pose proof (f_lip _ _ _ _ _ _ _ _ _ _ H p (p + d) ltac:(unfold d; lra)) as Li. apply Rabs_inv in Li. unfold d in *.
    apply Rabs_le. destruct Hk; subst k; lra. }
  apply Rminus_diag_uniq. destruct (Req_dec (s q - s p - k * (q - p)) 0) as [|N]; auto. apply Rabs_pos_lt in N.
  specialize (B (Rabs (s q - s p - k * (q - p)) / 2) ltac:(lra)). lra.
Qed.

(** in a stick, with other times of it just before: the load is within b, and the relative velocity has the rate 0 *)
Lemma stuck_rate t : 0 < t -> continuous u t -> w t = 0 -> (forall d, 0 < d -> exists r, t - d < r < t /\ w r = 0) ->
  Rabs (load t) <= b /\ is_derive w t 0.
Proof.
  intros Ht Cu W Cr. assert (Kp : 0 < kap) by positive.
  assert (Cw : cont w) by exact (cont_w m1 m2 a1 a2 b Hm2 U x v1 v2 s H).
  assert (Li : forall p q, 0 <= p <= q -> - (q - p) <= s q - s p <= q - p)
    by (intros; apply Rabs_inv, (f_lip _ _ _ _ _ _ _ _ _ _ H); auto).
  assert (Gs : forall p q, g q - g p = w q - w p + kap * b * (s q - s p)) by (intros; unfold g; ring).
  assert (Bd : Rabs (load t) <= b).
  { apply Rnot_lt_le. intros G. set (e := kap * (Rabs (load t) - b) / 2).
    assert (He : 0 < e) by (unfold e; assert (0 < kap * (Rabs (load t) - b)) by (apply Rmult_lt_0_compat; lra); lra).
    destruct (near t e Ht Cu He) as (d & Hd & K). destruct (Cr d ltac:(lra)) as (r & Hr & Wr).
    specialize (K r t ltac:(lra) ltac:(lra)). rewrite Gs in K. specialize (Li r t ltac:(lra)).
    assert (kap * b * - (t - r) <= kap * b * (s t - s r)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
    assert (kap * b * (s t - s r) <= kap * b * (t - r)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra).
    unfold e, Rabs in *. destruct (Rcase_abs (load t)); nra. }
  split; [auto|]. apply derive_of_slopes. intros e He. destruct (near t (e / 2) Ht Cu ltac:(lra)) as (d & Hd & K).
  destruct (Cr d ltac:(lra)) as (z & Hz & Wz). exists (t - z). split; [lra|]. intros q Hq. rewrite W.
  replace (w q - 0 - 0 * (q - t)) with (w q) by ring.
  destruct (Req_dec (w q) 0) as [->|Nq]; [rewrite Rabs_R0; pose proof (Rabs_pos (q - t)); nra|].
  assert (exists k, (k = 1 \/ k = -1) /\ 0 < k * w q) as (k & Hk & Wq)
    by (destruct (Rlt_dec 0 (w q)); [exists 1|exists (-1)]; split; auto; lra).
  replace (Rabs (w q)) with (k * w q) by (destruct Hk; subst k; [rewrite Rabs_pos_eq|rewrite Rabs_left]; lra).
  assert (A : k * load t <= b) by (apply Rabs_inv in Bd; destruct Hk; subst k; lra).
  set (y := kap * (k * load t - b)). assert (Y : y <= 0).
  { rewrite <- (Rmult_0_r kap). apply Rmult_le_compat_l; lra. }
  (* since the last stick before q *)
  assert (After : forall p, w p = 0 -> z <= p <= q -> exists p', p <= p' < q /\ k * w q <= (y + e / 2) * (q - p')).
  { intros p Wp Hp.
    destruct (last_nonneg (fun r => - k * w r) p q (cont_scal _ _ Cw)) as (p' & Hp' & Wp' & Neg); try nra. exists p'.
    specialize (K p' q ltac:(lra) ltac:(lra)). rewrite Gs in K.
    rewrite (whole_impulse k p' q Hk ltac:(lra)) in K by (intros r Hr; specialize (Neg r ltac:(lra)); lra). unfold y.
    destruct Hk; subst k; nra. }
  destruct (Rle_dec t q) as [Le|Gt].
  - rewrite (Rabs_pos_eq (q - t)) by lra. destruct (After t W ltac:(lra)) as (p & Hp & Q). nra.
  - rewrite (Rabs_left (q - t)) by lra. destruct (After z Wz ltac:(lra)) as (p & Hp & Q).
    destruct (first_zero w q t Cw) as (c & Hc & Wc & Sg); [lra|rewrite W; lra|auto|].
    specialize (K q c ltac:(lra) ltac:(lra)). rewrite Gs, Wc in K.
    rewrite (whole_impulse k q c Hk ltac:(lra)) in K
      by (intros r Hr; specialize (Sg r ltac:(lra)); destruct Hk; subst k; nra).
    assert (k * w q <= (- y + e / 2) * (c - q)) by (unfold y; destruct Hk; subst k; nra).
    assert (- y <= e / 2) by nra. nra.
Qed.

(** at almost all times the inclusion is met *)
Lemma motion_included t : 0 < t -> continuous u t ->
  (w t = 0 -> forall d, 0 < d -> exists r, t - d < r < t /\ w r = 0) -> included u x v1 v2 t.
Proof.
  intros Ht Cu Cr. assert (Kp : 0 < kap) by positive.
  assert (Sd : exists j, is_derive s t j /\ -1 <= j <= 1 /\ (0 < w t -> j = 1) /\ (w t < 0 -> j = -1)).
  { destruct (Req_dec (w t) 0) as [W|N].
    - destruct (stuck_rate t Ht Cu W (Cr W)) as (Bd & Dw). exists (load t / b). apply Rabs_inv in Bd.
      split; [|split; [split; [undivide b|undivide b]; lra|split; lra]].
      apply (derive_near (fun r => / (kap * b) * (g r - w r)) s t 1); [lra|intros; unfold g; field; lra|].
      replace (load t / b) with (/ (kap * b) * minus (kap * load t) 0) by (unfold minus, plus, opp; simpl; field; lra).
      apply (is_derive_scal (fun r => g r - w r)), (is_derive_minus g w); [apply derive_g|]; auto.
    - assert (exists k, (k = 1 \/ k = -1) /\ 0 < k * w t) as (k & Hk & Wt)
        by (destruct (Rlt_dec 0 (w t)); [exists 1|exists (-1)]; split; auto; lra). exists k.
      split; [|destruct Hk; subst k; lra]. pose proof (cont_w m1 m2 a1 a2 b Hm2 U x v1 v2 s H) as Cw.
      destruct (cont_scal k _ Cw t ltac:(lra) _ Wt) as (d & Hd & K). set (d' := Rmin d t / 2). pose proof (Rmin_l d t).
      pose proof (Rmin_r d t). assert (0 < Rmin d t) by positive.
      apply (derive_near (fun r => s (t - d') + k * (r - (t - d'))) s t d'); [unfold d'; lra| |auto_derive; auto; ring].
      intros r Hr. rewrite <- (whole_impulse k (t - d') r Hk); [ring|unfold d' in *; lra|].
      intros q Hq. specialize (K q ltac:(unfold d' in *; lra) ltac:(apply Rabs_def1; unfold d' in *; lra)).
      apply Rabs_def2 in K. fold (w q) in K. fold (w t) in K. lra. }
  destruct Sd as (j & Dj & Hj & Jp & Jn). exists j. split; [auto|]. split; [intros; apply Jp; unfold w; lra|].
  split; [intros; apply Jn; unfold w; lra|]. split.
  { apply derive_of_rderiv; auto; [apply (f_cx _ _ _ _ _ _ _ _ _ _ H)|apply (f_cv _ _ _ _ _ _ _ _ _ _ H)|
      exact (f_x _ _ _ _ _ _ _ _ _ _ H)]. }
  assert (D2 : is_derive v2 t (b * j / m2)).
  { apply (derive_near (fun r => v2 0 - b / m2 * s 0 + b / m2 * s r) v2 t t); auto;
      [intros; symmetry; apply v2_by_s; lra|].
    replace (b * j / m2) with (plus 0 (b / m2 * j)) by (unfold plus; simpl; field; lra).
    apply (is_derive_plus (fun _ => v2 0 - b / m2 * s 0)); [apply @is_derive_const|apply (is_derive_scal s t _ _ Dj)]. }
  split; [|exact D2]. apply (derive_near (fun r => g r - kap * b * s r + v2 r) v1 t 1); [lra|intros; unfold g, w; ring|].
  replace ((u t - a2 * x t - a1 * v1 t - b * j) / m1) with (plus (minus (kap * load t) (kap * b * j)) (b * j / m2))
    by (unfold kap, load, ModeAtContact.load, minus, plus, opp; simpl; field; lra).
  apply (is_derive_plus (fun r => g r - kap * b * s r)); [|auto].
  apply (is_derive_minus g); [apply derive_g; auto|apply (is_derive_scal s t _ _ Dj)].
Qed.

(** Every motion under a force that is continuous at almost all times is a Filippov solution. *)
Theorem forced_filippov : almost (continuous u) -> filippov u x v1 v2.
Proof.
  destruct motion_ac as (Ax & A1 & A2 & _). repeat (split; [auto|]). apply (almost_impl (fun t => (0 < t /\ continuous u
    t) /\ (w t = 0 -> forall d, 0 < d -> exists r, t - d < r < t /\ w r = 0)));
    [intros t _ ((Ht & Ct) & Cr); apply motion_included; auto|].
  apply almost_and; [apply almost_and; auto using almost_later|exact (almost_crowded (fun t => w t = 0))].
Qed.
End Motion.

(** [forced-filippov-iff] Under an integrable force that is continuous at almost every time the motions are the
    Filippov solutions, and only they. *)
Corollary forced_filippov_iff u U x v1 v2 : integral_of u U -> almost (continuous u) ->
  (filippov u x v1 v2 <-> exists s, forced m1 m2 a1 a2 b U x v1 v2 s).
Proof.
  intros HU Cu. split; [intros F; eexists; apply (filippov_forced u U); auto|]. intros (s & H).
  exact (forced_filippov u U x v1 v2 s HU H Cu).
Qed.

(** From every start there is one and only one Filippov solution. *)
Corollary forced_filippov_well_posed u U x0 v10 v20 : integral_of u U -> almost (continuous u) ->
  exists x v1 v2, (filippov u x v1 v2 /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2', filippov u x' v1' v2' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof.
  intros HU Cu. destruct (forced_well_posed m1 m2 a1 a2 b U x0 v10 v20 Hm1 Hm2 Ha1 Ha2 Hb (cont_ac U (proj1 HU)))
    as (x & v1 & v2 & s & (H & St) & Only).
  exists x, v1, v2. split; [split; [exact (forced_filippov u U x v1 v2 s HU H Cu)|auto]|]. intros x' v1' v2' F X V W t Ht.
  destruct (Only _ _ _ _ (filippov_forced u U _ _ _ HU F) X V W t Ht) as (? & ? & ? & _). auto.
Qed.

(** Without a force. *)
Lemma no_force : integral_of (fun _ => 0) (fun _ => 0) /\ almost (continuous (fun _ : R => 0)).
Proof.
  split; [split; [apply ac_const|]|]; apply (almost_impl (fun t => 0 < t)); auto using almost_later; intros t _ _;
    [apply @is_derive_const|apply continuous_const].
Qed.
(** [filippov-iff] A solution is what Filippov calls one: absolutely continuous, and in the differential inclusion at
    almost all times. *)
Corollary filippov_iff x v1 v2 : filippov (fun _ => 0) x v1 v2 <-> exists s, solution m1 m2 a1 a2 b x v1 v2 s.
Proof.
  destruct no_force as (HU & Cu). rewrite (forced_filippov_iff _ _ x v1 v2 HU Cu). split; intros (s & F); exists s;
    apply free_case; exact F.
Qed.
(** [filippov-well-posed] From every initial state there is exactly one Filippov solution, with or without damping. *)
Corollary filippov_well_posed x0 v10 v20 :
  exists x v1 v2, (filippov (fun _ => 0) x v1 v2 /\ x 0 = x0 /\ v1 0 = v10 /\ v2 0 = v20) /\
  forall x' v1' v2', filippov (fun _ => 0) x' v1' v2' -> x' 0 = x0 -> v1' 0 = v10 -> v2' 0 = v20 ->
  forall t, 0 <= t -> x' t = x t /\ v1' t = v1 t /\ v2' t = v2 t.
Proof. destruct no_force as (HU & Cu). exact (forced_filippov_well_posed _ _ x0 v10 v20 HU Cu). Qed.
End Filippov.
