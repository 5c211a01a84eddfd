(** Is creeping robust? With static friction bs above kinetic bk, by any jump, it is not: every free motion that keeps a
    stick while the load is below bs has a bounded number of slips, and sticks for ever from some time on. Between bk
      and
    bs such motions are not unique in general (a stick might be left at any time); these are those that keep it. *)
From InertialPair Require Import Dini Pair Stick Approach EnergyLimit.

Section Robust.
Variables m1 m2 a1 a2 bs bk : R.
Hypotheses (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hk : 0 < bk) (Hs : bk < bs).
Context (M := m1 + m2) (kap := M / (m1 * m2)) (energy := energy m1 m2 a2).

(** the friction that sticking needs *)
Definition stick_load x v := - (m2 * (a2 * x + a1 * v)) / (m1 + m2).

(** bk s is the impulse of friction: bk against the slip, up to bs in contact *)
Record two_frictions (x v1 v2 s : R -> R) : Prop := {
  j_lip : forall r t, 0 <= r <= t -> bk * Rabs (s t - s r) <= bs * (t - r);
  j_pos : forall t, 0 <= t -> v2 t < v1 t -> rderiv s t 1;
  j_neg : forall t, 0 <= t -> v1 t < v2 t -> rderiv s t (-1);
  j_cx : cont x;
  j_cv : cont v1;
  j_x : forall t, 0 <= t -> rderiv x t (v1 t);
  j_v1 : forall t, 0 <= t -> rderiv (fun u => m1 * v1 u + bk * s u) t (- (a2 * x t + a1 * v1 t));
  j_v2 : forall t, 0 <= t -> m2 * v2 t - bk * s t = m2 * v2 0 - bk * s 0 }.

(** it moves as any motion with the friction bk, but its impulse may be faster *)
Lemma two_frictions_moves x v1 v2 s :
  two_frictions x v1 v2 s <-> moves m1 m2 a1 a2 bk (bs / bk) (fun _ => 0) x v1 v2 s.
Proof.
  assert (Q : forall p y, bk * p <= bs * y <-> p <= bs / bk * y).
  { intros p y. replace (bs * y) with (bk * (bs / bk * y)) by (field; lra).
    split; [apply Rmult_le_reg_l; auto|scale]. }
  split; [intros [L P N CX CV X V W]|intros [L P CX CV X V W]]; constructor; auto using opposes_both;
    try (intros; apply Q; auto; fail).
  - intros t Ht. apply rderiv_ext with (fun r => m1 * v1 r + bk * s r); [intros; ring|auto].
  - intros t Ht Hv. apply (P t Ht 1); auto; lra.
  - intros t Ht Hv. apply (P t Ht (-1)); auto; lra.
  - intros t Ht. apply rderiv_ext with (fun r => m1 * v1 r + bk * s r - 0); [intros; ring|auto].
Qed.

(** and a stick is kept while its load is below bs *)
Record jumping (x v1 v2 s : R -> R) : Prop := {
  j_two :> two_frictions x v1 v2 s;
  j_keeps : forall t, 0 <= t -> v1 t = v2 t -> Rabs (stick_load (x t) (v1 t)) < bs ->
    exists d, 0 < d /\ forall u, t <= u <= t + d -> v1 u = v2 u }.

(** how fast the load can change on the energy e *)
Definition load_rate e := m2 / (m1 + m2) *
  (a2 * sqrt (2 * e / m1) + a1 * ((a2 * sqrt (2 * e / a2) + a1 * sqrt (2 * e / m1) + bs) / m1)).
(** how long a slip lasts at least (the second term: where the load does not change) *)
Definition least_slip e := (bs - bk) / (2 * load_rate e + (bs - bk) * sqrt (a2 / m1)).
(** and what it costs at least *)
Definition least_loss e := bk * ((m1 + m2) / (m1 * m2)) * (bs - bk) * least_slip e ^ 2 / 16.

(** *** Any motion with both frictions, whether it keeps its sticks or not *)
Section Moves.
Context (x v1 v2 s : R -> R) (H : two_frictions x v1 v2 s).
Context (w := fun t => v1 t - v2 t) (E := fun t => energy (x t) (v1 t) (v2 t))
  (ld := fun t => stick_load (x t) (v1 t)).
Context (e : R) (He : E 0 <= e).
Context (C := load_rate e) (h0 := least_slip e) (e0 := least_loss e).

Let Mp : 0 < M. Proof. positive. Qed.
Let Kp : 0 < kap. Proof. positive. Qed.

(** what is known of all motions *)
Lemma jumping_moves : moves m1 m2 a1 a2 bk (bs / bk) (fun _ => 0) x v1 v2 s.
Proof. apply two_frictions_moves, H. Qed.
Let Cs : cont s. Proof. exact (moves_cs _ _ _ _ _ _ _ _ _ _ _ jumping_moves). Qed.
Lemma jumping_cw : cont w.
Proof. apply cont_minus; [apply (j_cv _ _ _ _ H)|exact (moves_cv2 _ _ _ _ _ Hm2 _ _ _ _ _ _ jumping_moves)]. Qed.
Let CE : cont E. Proof. exact (moves_cE _ _ _ _ _ Hm2 _ _ _ _ _ _ jumping_moves). Qed.

(** in slip the relative velocity is driven by what the load has beyond bk *)
Lemma slip_rate t k : 0 <= t -> k = 1 \/ k = -1 -> 0 < k * w t -> rderiv (fun r => k * w r) t (kap * (k * ld t - bk)).
Proof.
  intros Ht Hk' Hw. pose proof (q_slip _ _ _ _ _ _ _ _ _ _ _ jumping_moves t Ht k Hk' Hw) as S.
  eapply rderiv_eq; [|apply rderiv_scal, (moves_rate _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ _ jumping_moves t 0 k Ht
    (rderiv_const 0 t) S)].
  unfold kap, ld, stick_load, M. destruct Hk'; subst k; field; lra.
Qed.

(** the energy falls by friction and the damper *)
Lemma jumping_energy_rate t : 0 <= t -> rderiv E t (- bk * Rabs (w t) - a1 * v1 t ^ 2).
Proof. exact (free_energy_rate _ _ _ _ _ Hm1 Hm2 _ _ _ _ _ jumping_moves t). Qed.
Lemma jumping_decreases r t : 0 <= r <= t -> E t <= E r.
Proof. exact (free_decreases _ _ _ _ _ Hm1 Hm2 Ha1 Hk _ _ _ _ _ jumping_moves r t). Qed.

(** the load changes slowly *)
Lemma load_lip r t : 0 <= r <= t -> Rabs (ld t - ld r) <= C * (t - r).
Proof.
  intros Hr. set (P := sqrt (2 * e / a2)). set (V := sqrt (2 * e / m1)).
  set (A := (a2 * P + a1 * V + bs) / m1).
  assert (Bd : forall u, 0 <= u -> Rabs (x u) <= P /\ Rabs (v1 u) <= V).
  { intros u Hu. destruct (Forced.energy_parts m1 m2 a2 Hm1 Hm2 Ha2 (x u) (v1 u) (v2 u) e) as (Q1 & Q2 & _);
      [exact (Rle_trans _ _ _ (jumping_decreases 0 u ltac:(lra)) He)|]. split; apply Forced.root_bound; auto.
      }
  assert (Lx : Rabs (x t - x r) <= V * (t - r)).
  { apply (lip_of_rderiv x v1); auto using (j_cx _ _ _ _ H). split; [apply (j_x _ _ _ _ H)|apply Bd]; auto. }
  assert (Lv : Rabs (v1 t - v1 r) <= A * (t - r)).
  { assert (L1 : Rabs ((m1 * v1 t + bk * s t) - (m1 * v1 r + bk * s r)) <= (a2 * P + a1 * V) * (t - r)).
    { apply (lip_of_rderiv (fun u => m1 * v1 u + bk * s u) (fun u => - (a2 * x u + a1 * v1 u))); auto.
      - apply cont_plus; apply cont_scal; [apply (j_cv _ _ _ _ H)|apply Cs].
      - intros u Hu. split; [apply (j_v1 _ _ _ _ H); auto|]. destruct (Bd u Hu) as (B1 & B2). apply Rabs_inv in B1.
        apply Rabs_inv in B2. apply Rabs_le. split; nra. }
    pose proof (j_lip _ _ _ _ H r t Hr) as L2. rewrite <- (Rabs_pos_eq bk), <- Rabs_mult in L2 by lra.
    apply Rmult_le_reg_l with m1; auto. replace (m1 * (A * (t - r))) with ((a2 * P + a1 * V) * (t - r) + bs * (t - r))
      by (unfold A; field; lra). rewrite <- (Rabs_pos_eq m1) at 1 by lra. rewrite <- Rabs_mult.
    replace (m1 * (v1 t - v1 r)) with ((m1 * v1 t + bk * s t - (m1 * v1 r + bk * s r)) - bk * (s t - s r)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  replace (C * (t - r)) with (m2 / M * (a2 * (V * (t - r)) + a1 * (A * (t - r)))) by (unfold C, load_rate, M, A, V, P;
    field; split; lra). unfold ld, stick_load. replace (- (m2 * (a2 * x t + a1 * v1 t)) / (m1 + m2) - - (m2 * (a2 * x r
    + a1 * v1 r)) / (m1 + m2)) with (m2 / M * (- (a2 * (x t - x r) + a1 * (v1 t - v1 r)))) by (unfold M; field; lra).
  assert (0 < m2 / M) by positive. rewrite Rabs_mult, Rabs_pos_eq by lra. apply Rmult_le_compat_l; [lra|].
  apply Rabs_inv in Lx. apply Rabs_inv in Lv. apply Rabs_le. split; nra.
Qed.

Let C0 : 0 <= C.
Proof. pose proof (load_lip 0 1 ltac:(lra)) as L. pose proof (Rabs_pos (ld 1 - ld 0)). lra. Qed.
Let Dp : 0 < (bs - bk) * sqrt (a2 / m1).
Proof. positive. Qed.
Let H0 : 0 < h0. Proof. unfold h0, least_slip. fold C. positive. Qed.
Let Ch : C * h0 <= (bs - bk) / 2.
Proof.
  unfold h0, least_slip. fold C. set (D := (bs - bk) * sqrt (a2 / m1)) in *. apply Rmult_le_reg_r with (2 * C + D);
    [lra|].
  replace (C * ((bs - bk) / (2 * C + D)) * (2 * C + D)) with (C * (bs - bk)) by (field; lra). nra.
Qed.

(** *** From a contact with the load bs in a direction: once it slips, it slips on that way, faster and faster *)
Section Launch.
Context (c k : R) (Hc : 0 <= c) (Meet : v1 c = v2 c) (Hk' : k = 1 \/ k = -1) (Edge : bs <= k * ld c).

(** for a while the load stays well above bk *)
Lemma load_above t : c <= t <= c + h0 -> (bs + bk) / 2 <= k * ld t.
Proof.
  intros Ht. pose proof (load_lip c t ltac:(lra)) as L. apply Rabs_inv in L. assert (C * (t - c) <= C * h0) by nra.
  destruct Hk'; subst k; lra.
Qed.

(** it does not slip the other way *)
Lemma not_back t : c <= t <= c + h0 -> 0 <= k * w t.
Proof.
  intros Ht. cut (- k * w t <= 0); [lra|].
  apply (moves_behind m1 m2 a1 a2 bk Hm1 Hm2 _ _ _ _ _ _ jumping_moves c t (- k)); [lra|lra|rewrite Meet; lra|].
  exists 0. split; [eapply rderiv_dini; [|apply rderiv_scal, (rderiv_const 0 q)]; lra|].
  pose proof (load_above q ltac:(lra)) as La.
  replace (m2 * _) with (- (k * ld q) * (m1 + m2)) by (unfold ld, stick_load; field; lra).
  apply Rmult_le_compat_r; lra.
Qed.

(** and once it slips it does not stop, but gains speed *)
Lemma gains p t : c <= p <= t -> t <= c + h0 -> 0 < k * w p -> kap * ((bs - bk) / 2) * (t - p) <= k * w t.
Proof.
  intros Hp Ht Wp. assert (Ck : cont (fun u => k * w u)) by (apply cont_scal, jumping_cw).
  assert (Rate : forall u, p <= u <= t -> kap * ((bs - bk) / 2) <= kap * (k * ld u - bk)).
  { intros u Hu. pose proof (load_above u ltac:(lra)). scale. }
  assert (Up : forall u, p <= u <= t -> k * w p <= k * w u).
  { intros u Hu. destruct (Rle_dec (k * w p) (k * w u)) as [|N]; auto.
    destruct (last_nonneg (fun y => k * w y - k * w p) p u) as (l & Hl & Wl & Ab); try lra.
    { apply cont_minus; auto using cont_const. }
    set (g := kap * (k * ld l - bk)). assert (G : 0 < g) by (specialize (Rate l ltac:(lra)); unfold g; nra).
    destruct (slip_rate l k ltac:(lra) Hk' ltac:(lra) (g / 2)) as (d & Hd & K); [lra|]. fold g in K.
    set (h := Rmin (d / 2) (u - l)). assert (h <= d / 2) by apply Rmin_l. assert (h <= u - l) by apply Rmin_r.
    assert (0 < h) by positive. specialize (K h ltac:(lra)). apply Rabs_inv in K. specialize (Ab (l + h) ltac:(lra)).
    nra. }
  assert (Q : - (k * w t) - - (k * w p) <= - (kap * ((bs - bk) / 2)) * (t - p)); [|lra].
  apply (dini_slope (fun u => - (k * w u))); [|lra|].
  { apply cont_ext with (fun u => -1 * (k * w u)); [intros; ring|auto using cont_scal]. }
  intros u Hu. apply rderiv_dini with (-1 * (kap * (k * ld u - bk))); [specialize (Rate u ltac:(lra)); lra|].
  apply rderiv_ext with (fun r => -1 * (k * w r)); [intros; ring|]. apply rderiv_scal, slip_rate; auto; [lra|].
  specialize (Up u ltac:(lra)). lra.
Qed.

(** which costs *)
Lemma loses p : c <= p <= c + h0 / 2 -> 0 < k * w p -> E (c + h0) <= E c - e0.
Proof.
  intros Hp Wp. set (g := kap * ((bs - bk) / 2)). assert (G : 0 < g) by positive.
  assert (Q : E (c + h0) + bk * g / 2 * (c + h0 - p) ^ 2 <= E p + bk * g / 2 * (p - p) ^ 2).
  { apply (rderiv_mono (fun t => E t + bk * g / 2 * (t - p) ^ 2) p (c + h0)
      (fun u => (- bk * Rabs (w u) - a1 * v1 u ^ 2) + bk * g * (u - p))); [| lra|].
    - apply cont_plus; [apply CE|]. apply cont_of_derive with (fun u => bk * g * (u - p)).
      intros u. auto_derive; auto. field.
    - intros u Hu. split.
      + apply rderiv_plus; [apply jumping_energy_rate; lra|]. apply rderiv_of_derive. auto_derive; auto. field.
      + pose proof (gains p u ltac:(lra) ltac:(lra) Wp) as Gu. fold g in Gu. assert (k * w u <= Rabs (w u)). {
        pose proof (Rle_abs (w u)). pose proof (Rle_abs (- w u)) as R2. rewrite Rabs_Ropp in R2.
        destruct Hk'; subst k; lra. } nra. }
  pose proof (jumping_decreases c p ltac:(lra)) as D.
  assert (bk * g / 2 * (h0 / 2) ^ 2 <= bk * g / 2 * (c + h0 - p) ^ 2) by (apply Rmult_le_compat_l; nra).
  replace e0 with (bk * g / 2 * (h0 / 2) ^ 2). 2: { unfold e0, least_loss, g, kap, M, h0. field; lra. }
  lra.
Qed.
End Launch.

(** something *)
Lemma loss_pos : 0 < e0.
Proof.
  apply Rdiv_lt_0_compat; [positive|lra].
Qed.
(** in a time that is not nothing *)
Lemma slip_pos : 0 < h0.
Proof. exact H0. Qed.
End Moves.

(** *** A motion that keeps its sticks *)
Section One.
Context (x v1 v2 s : R -> R) (H : jumping x v1 v2 s).
Let H2 := j_two _ _ _ _ H.
Context (w := fun t => v1 t - v2 t) (E := fun t => energy (x t) (v1 t) (v2 t))
  (ld := fun t => stick_load (x t) (v1 t)) (h0 := least_slip (E 0)) (e0 := least_loss (E 0)).
Let Kp : 0 < kap. Proof. positive. Qed.
Let H0 : 0 < h0 := slip_pos _ _ _ _ H2 (E 0) (Rle_refl _).
Let e0_pos : 0 < e0 := loss_pos _ _ _ _ H2 (E 0) (Rle_refl _).
Let falls r t : 0 <= r <= t -> E t <= E r := jumping_decreases _ _ _ _ H2 r t.
Let back c k : 0 <= c -> v1 c = v2 c -> k = 1 \/ k = -1 -> bs <= k * ld c -> forall t, c <= t <= c + h0 -> 0 <= k * w t :=
  not_back _ _ _ _ H2 (E 0) (Rle_refl _) c k.
Let faster c k : 0 <= c -> k = 1 \/ k = -1 -> bs <= k * ld c -> forall p t, c <= p <= t -> t <= c + h0 -> 0 < k * w p ->
  kap * ((bs - bk) / 2) * (t - p) <= k * w t := gains _ _ _ _ H2 (E 0) (Rle_refl _) c k.
Let dearer c k : 0 <= c -> k = 1 \/ k = -1 -> bs <= k * ld c -> forall p, c <= p <= c + h0 / 2 -> 0 < k * w p ->
  E (c + h0) <= E c - e0 := loses _ _ _ _ H2 (E 0) (Rle_refl _) c k.
Let Cw : cont w := jumping_cw _ _ _ _ H2.

(** where a stick can be left *)
Lemma leaves c : 0 <= c -> v1 c = v2 c -> (forall d, 0 < d -> exists u, c < u < c + d /\ v1 u <> v2 u) ->
  exists k, (k = 1 \/ k = -1) /\ bs <= k * ld c.
Proof.
  intros Hc Meet Out. destruct (Rlt_dec (Rabs (ld c)) bs) as [Lt|N].
  - exfalso. destruct (j_keeps _ _ _ _ H c Hc Meet Lt) as (d & Hd & K). destruct (Out d Hd) as (u & Hu & Nu).
    apply Nu, K. lra.
  - destruct (Rle_dec 0 (ld c)); [exists 1|exists (-1)]; [rewrite Rabs_pos_eq in N by lra|rewrite Rabs_left in N by
    lra]; split; auto; lra.
Qed.

(** a slip from one contact to the next *)
Definition one_slip p q := 0 <= p < q /\ v1 p = v2 p /\ v1 q = v2 q /\ forall u, p < u < q -> v1 u <> v2 u.

(** [static-slip-costs] With static friction above kinetic, where sticks are kept, every slip of a free motion from a
    contact to the next lasts longer than a fixed time and dissipates at least a fixed energy, both given by $E(0)$.
    *)
Theorem slip_costs p q : one_slip p q -> p + h0 < q /\ E q <= E p - e0.
Proof.
  intros (Hp & Mp' & Mq & Sl). destruct (leaves p ltac:(lra) Mp') as (k & Hk' & Edge).
  { intros d Hd. exists (p + Rmin (d / 2) ((q - p) / 2)). assert (0 < Rmin (d / 2) ((q - p) / 2)) by positive.
    pose proof (Rmin_l (d / 2) ((q - p) / 2)). pose proof (Rmin_r (d / 2) ((q - p) / 2)). split; [lra|apply Sl; lra]. }
  set (u := p + Rmin (h0 / 2) ((q - p) / 2)). assert (0 < Rmin (h0 / 2) ((q - p) / 2)) by positive.
  pose proof (Rmin_l (h0 / 2) ((q - p) / 2)). pose proof (Rmin_r (h0 / 2) ((q - p) / 2)). assert (Wu : 0 < k * w u).
  { pose proof (back p k ltac:(lra) Mp' Hk' Edge u ltac:(unfold u; lra)). specialize (Sl u ltac:(unfold u; lra)).
    assert (w u <> 0) by (unfold w; lra). destruct Hk'; subst k; lra. }
  assert (Long : p + h0 < q).
  { apply Rnot_le_lt. intros N. pose proof (faster p k ltac:(lra) Hk' Edge u q ltac:(unfold u; lra) N Wu) as G.
    unfold w in G at 1. assert (0 < kap * ((bs - bk) / 2)) by nra. assert (0 < q - u) by (unfold u; lra). nra. }
  pose proof (dearer p k ltac:(lra) Hk' Edge u ltac:(unfold u; lra) Wu). pose proof (falls (p + h0) q ltac:(lra)). lra.
Qed.

(** [static-few-slips] With static friction above kinetic, where sticks are kept, a free motion has at most $E(0)/e_0$
    such slips, $e_0>0$ explicit. *)
Theorem few_slips (p q : nat -> R) n : (forall i, (i < n)%nat -> one_slip (p i) (q i)) ->
  (forall i, (S i < n)%nat -> q i <= p (S i)) -> INR n * e0 <= E 0.
Proof.
  intros Sl Or. assert (Q : INR n * e0 <= E 0 - match n with O => E 0 | S i => E (q i) end).
  { induction n as [|n IH]; [simpl; lra|]. destruct (Sl n ltac:(lia)) as (Hp & _).
    specialize (IH ltac:(intros; apply Sl; lia) ltac:(intros; apply Or; lia)). rewrite S_INR.
    destruct (slip_costs _ _ (Sl n ltac:(lia))) as (_ & Co). destruct n as [|n].
    - pose proof (falls 0 (p O) ltac:(lra)). lra.
    - specialize (Or n ltac:(lia)). destruct (Sl n ltac:(lia)) as (Hp' & _).
      pose proof (falls (q n) (p (S n)) ltac:(lra)). lra. }
  assert (Ep : forall t, 0 <= E t) by (intros; apply energy_pos; auto). destruct n; [|specialize (Ep (q n)); lra].
  rewrite Rmult_0_l. apply Ep.
Qed.

(** it meets again after any time *)
Lemma jumping_contact T : 0 <= T -> exists t, T <= t /\ v1 t = v2 t.
Proof.
  intros HT. destruct (moves_contact _ _ _ _ _ Hm1 Hm2 Ha1 Ha2 Hk _ _ _ _ _ T (jumping_moves _ _ _ _ H2) HT) as (t & Ht & Z).
  exists t. split; [lra|auto].
Qed.

(** from a contact on: stuck for ever, or dearer *)
Lemma stuck_or_dearer c : 0 <= c -> v1 c = v2 c ->
  (forall t, c <= t -> v1 t = v2 t) \/ exists t, c <= t /\ E t <= E c - e0.
Proof.
  destruct (Classical_Prop.classic (exists t, c <= t /\ E t <= E c - e0)) as [|No]; [auto|left].
  intros t Ht. assert (Z : w t = 0); [|unfold w in Z; lra].
  assert (C2 : cont (fun u => w u * w u)) by auto using cont_mult.
  apply (onward (fun u => w u = 0) c t); [lra|unfold w; lra| | |lra].
  - intros l Hl All. apply Rsqr_0_uniq, Rle_antisym; [|apply Rle_0_sqr]. apply (cont_le _ 0 c l C2); [lra|].
    intros u Hu. rewrite All; lra.
  - intros l Hl Wl. apply Classical_Prop.NNPP. intros Nl.
    assert (Out : forall d, 0 < d -> exists u, l < u < l + d /\ v1 u <> v2 u).
    { intros d Hd. apply Classical_Prop.NNPP. intros Nu. apply Nl. exists d. split; auto. intros u Hu.
      apply Classical_Prop.NNPP. intros Wu. apply Nu. exists u. unfold w in Wu. lra. }
    destruct (leaves l ltac:(lra) ltac:(unfold w in Wl; lra) Out) as (k & Hk' & Edge).
    destruct (Out (h0 / 2)) as (u & Hu & Nu); [lra|]. apply No. exists (l + h0). pose proof (falls c l ltac:(lra)).
    assert (Wu : 0 < k * w u).
    { pose proof (back l k ltac:(lra) ltac:(unfold w in Wl; lra) Hk' Edge u ltac:(lra)).
      assert (w u <> 0) by (unfold w; lra). destruct Hk'; subst k; lra. }
    pose proof (dearer l k ltac:(lra) Hk' Edge u ltac:(lra) Wu). lra.
Qed.

(** *** Every motion sticks for ever from some time on *)

(** [static-sticks-at-last] With static friction above kinetic, by any amount, every free motion that keeps its sticks
    sticks permanently from some time on. *)
Theorem sticks_at_last : exists T, 0 <= T /\ forall t, T <= t -> v1 t = v2 t.
Proof.
  assert (Q : forall n T, 0 <= T -> E T <= INR n * e0 -> exists T, 0 <= T /\ forall t, T <= t -> v1 t = v2 t).
  { induction n as [|n IH]; intros T HT En; destruct (jumping_contact T HT) as (c & Hc & Meet);
    pose proof (falls T c ltac:(lra)) as D;
    (destruct (stuck_or_dearer c ltac:(lra) Meet) as [St|(t & Ht & Et)]; [exists c; split; [lra|auto]|]).
    - simpl in En. pose proof (energy_pos m1 m2 a2 Hm1 Hm2 Ha2 (x t) (v1 t) (v2 t)). unfold E, energy in *. lra.
    - apply (IH t); [lra|]. rewrite S_INR in En. lra. }
  destruct (nat_above (E 0) e0 e0_pos) as (n & Hn). apply (Q n 0); lra.
Qed.
End One.
End Robust.
