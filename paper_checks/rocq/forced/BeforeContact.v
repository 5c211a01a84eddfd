(** What came before a contact at the time T: one mode, for a while. Where the load is off the edges friction brings
    the relative velocity to 0 or cannot bring it there; where it comes to an edge, what the force asks beyond b keeps
    its sign before T, and with it the load. *)
From Coq Require Import Classical.
From InertialPair Require Import Dini Forced ModeAtContact Analytic Modes.

(** what the force asks beyond b is analytic with the force *)
Lemma analytic_beyond m1 m2 a1 a2 b f x v1 t0 k : 0 < m2 -> analytic_at f t0 ->
  analytic_at (beyond m1 m2 a1 a2 b f x v1 t0 k) t0.
Proof.
  intros Hm2 A. set (c0 := - (a2 * (k * x t0)) - a1 * (k * v1 t0) - (m1 + m2) * (b / m2)).
  set (c1 := - (a2 * (k * v1 t0)) - a1 * (b / m2)). set (c2 := - (a2 * (b / m2) / 2)).
  apply (analytic_near (fun r => k * f r + (c0 + (c1 * (r - t0) ^ 1 + c2 * (r - t0) ^ 2))) _ t0 1 Rlt_0_1).
  { intros r _. unfold beyond, c0, c1, c2. field. lra. }
  apply analytic_plus; [apply analytic_scal, A|]. apply analytic_plus; [apply analytic_const|].
  apply analytic_plus; apply analytic_scal, analytic_power.
Qed.

Section Before.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (U u x v1 v2 s : R -> R) (H : forced m1 m2 a1 a2 b U x v1 v2 s) (DU : forall t, 0 <= t -> rderiv U t (u t)).
Let M := m1 + m2.
Let w t := v1 t - v2 t.
Let load := load m1 m2 a1 a2 u x v1.

Let Cw : cont w := cont_w m1 m2 a1 a2 b Hm2 U x v1 v2 s H.

(** *** Before a time T: where the load stays on one side of the edges *)
Context (T : R) (HT : 0 < T) (Meet : v1 T = v2 T).

(** with the load at most b in the direction k no slip of that sign begins *)
Lemma stays_behind k r t : k = 1 \/ k = -1 -> 0 <= r <= t -> (forall q, r <= q < t -> k * load q <= b) ->
  k * w r <= 0 -> k * w t <= 0.
Proof.
  intros Hk Hr Ld W0. apply (stays_behind m1 m2 a1 a2 b Hm1 Hm2 U u x v1 v2 s 0 t H (Rle_refl 0)) with (r := r); auto;
    [intros; apply DU; lra|lra].
Qed.

(** the load within both edges: once stuck, the pair sticks up to T *)
Lemma before_within c : 0 <= c < T -> (forall q, c < q < T -> - b <= load q <= b) ->
  exists d, 0 < d /\ one_mode v1 v2 (T - d) T.
Proof.
  intros Hc Ld. destruct (classic (exists r, c < r < T /\ w r = 0)) as [(r & Hr & Z)|No].
  - exists (T - r). split; [lra|]. left. intros t Ht. replace (T - (T - r)) with r in Ht by ring.
    pose proof (stays_behind 1 r t (or_introl eq_refl) ltac:(lra) ltac:(intros q Hq; specialize (Ld q ltac:(lra));
      lra) ltac:(lra)).
    pose proof (stays_behind (-1) r t (or_intror eq_refl) ltac:(lra) ltac:(intros q Hq; specialize (Ld q ltac:(lra));
      lra) ltac:(lra)).
    unfold w in *. lra.
  - exists (T - c). split; [lra|]. replace (T - (T - c)) with c by ring. apply no_zero_one_sign; [exact Cw|lra|].
    intros t Ht N. apply No. exists t. split; [auto|unfold w; lra].
Qed.

(** the load above the lower edge: slip of the sign - k up to T, or none of it *)
Lemma before_above k c : k = 1 \/ k = -1 -> 0 <= c < T -> (forall q, c < q < T -> - k * load q <= b) ->
  (forall r, c < r < T -> (forall q, r <= q <= T -> 0 <= k * w q) -> exists d, 0 < d /\ one_mode v1 v2 (T - d) T) ->
  exists d, 0 < d /\ one_mode v1 v2 (T - d) T.
Proof.
  intros Hk Hc Ld Then. assert (Hk' : - k = 1 \/ - k = -1) by (destruct Hk; [right|left]; lra).
  destruct (classic (exists r, c < r < T /\ 0 <= k * w r)) as [(r & Hr & Z)|No].
  - apply (Then r Hr). intros q Hq.
    pose proof (stays_behind (- k) r q Hk' ltac:(lra) ltac:(intros z Hz; apply Ld; lra) ltac:(lra)). lra.
  - exists (T - c). split; [lra|]. replace (T - (T - c)) with c by ring.
    apply (one_sided (- k)); auto. intros t Ht. assert (k * w t < 0); [|unfold w in *; lra]. apply Rnot_le_lt. eauto.
Qed.

(** *** Before a time T at which the load comes to the edge k b. Beside the motion with the constant acceleration k b/m2
    through the state at T: the place y of body 1, what the relative velocity and body 2 are ahead, their momentum *)
Section Edge.
Context (k c : R) (Hk : k = 1 \/ k = -1) (Hc : 0 <= c < T) (Ahead : forall q, c <= q <= T -> 0 <= k * w q).
Let p := beyond m1 m2 a1 a2 b u x v1 T k.
Let y := place m2 b x v1 T k.
Let y' := lead m2 b v1 T k.
Let E := gain m1 m2 b v1 v2 T k.
Let F t := p t - a1 * y' t - a2 * y t.
Let rate_E t : 0 <= t -> rderiv E t (F t).
Proof. intros Ht. apply (gain_rate m1 m2 a1 a2 b Hm2 U u x v1 v2 s T H k t Ht (DU t Ht)). Qed.
Let place_rate t : 0 <= t -> rderiv y t (y' t).
Proof. apply (place_rate m1 m2 a1 a2 b Hm2 U x v1 v2 s T H k t). Qed.
Let cont_y : cont y.
Proof. exact (cont_place m1 m2 a1 a2 b U x v1 v2 s T H k). Qed.

(** so is body 1, by what the momentum allows *)
Lemma lead_bounds t : c <= t <= T -> 0 <= y' t /\ m1 * y' t <= E t.
Proof.
  intros Ht. assert (Sp : y' t = k * w t + ahead2 m2 b v2 T k t) by exact (lead_split m2 b v1 v2 T Meet k t).
  pose proof (Ahead t Ht). pose proof (proj1 (ahead2_sign m1 m2 a1 a2 b Hm2 Hb U x v1 v2 s T H ltac:(lra) k t Hk
    ltac:(lra)) ltac:(lra)) as A. assert (0 <= m2 * ahead2 m2 b v2 T k t) by positive.
  split; [lra|]. unfold E, gain. fold (w t) M. rewrite Sp. unfold M. nra.
Qed.

(** and its place is behind *)
Lemma place_behind t : c <= t <= T -> y t <= 0.
Proof.
  intros Ht. assert (YT : y T = 0) by (unfold y, place; field; lra). assert (-1 * y T <= -1 * y t); [|lra].
  apply (dini_mono (fun r => -1 * y r)); [apply cont_scal, cont_y|lra|].
  intros r Hr. destruct (lead_bounds r ltac:(lra)). eapply rderiv_dini; [|apply rderiv_scal, place_rate; lra]. lra.
Qed.
(** but not far *)
Lemma place_not_far t B : c <= t <= T -> (forall q, t <= q < T -> y' q <= B) -> - (B * (T - t)) <= y t.
Proof.
  intros Ht Up. assert (YT : y T = 0) by (unfold y, place; field; lra).
  pose proof (dini_slope y B t T cont_y ltac:(lra)) as Q.
  rewrite YT in Q. assert (0 - y t <= B * (T - t)); [|lra]. apply Q.
  intros r Hr. eapply rderiv_dini; [|apply place_rate; lra]. apply Up; lra.
Qed.

(** weighted by g = exp (a1 (t - T)/m1), the momentum has at least the rate of what the force asks beyond b *)
Let g t := exp (a1 / m1 * (t - T)).
Lemma weighted_rate r : c <= r < T -> rderiv (fun t => g t * E t) r (a1 / m1 * g r * E r + g r * F r) /\
  g r * p r <= a1 / m1 * g r * E r + g r * F r.
Proof.
  intros Hr. split.
  - apply (rderiv_mult g E); [|apply rate_E; lra]. apply rderiv_of_derive. unfold g. auto_derive; auto.
    unfold Rminus. ring.
  - destruct (lead_bounds r ltac:(lra)) as (Y0 & Y1). pose proof (place_behind r ltac:(lra)).
    pose proof (exp_pos (a1 / m1 * (r - T))). assert (a1 * y' r <= a1 / m1 * E r).
    { replace (a1 * y' r) with (a1 / m1 * (m1 * y' r)) by (field; lra). apply Rmult_le_compat_l; auto.
      apply Rmult_le_pos; [auto|positive]. }
    assert (a2 * y r <= 0) by nra.
    replace (a1 / m1 * g r * E r + g r * F r) with (g r * (a1 / m1 * E r + F r)) by ring.
    apply Rmult_le_compat_l; [unfold g; lra|]. unfold F. lra.
Qed.

(** the weight is at most 1 before T, and not small *)
Lemma weight r : r <= T -> g r <= 1 /\ (T - 1 <= r -> exp (- (a1 / m1)) <= g r).
Proof.
  intros Hr. assert (A : 0 <= a1 / m1) by positive. split; [rewrite <- exp_0|intros Hr']; apply exp_mono; nra.
Qed.

(** where the force asks at least b - z, the weighted momentum is at most z times the time left: it ends at 0 *)
Lemma momentum_up_to z q : c <= q <= T -> 0 <= z -> (forall r, q <= r < T -> - z <= p r) -> g q * E q <= z * (T - q).
Proof.
  intros Hq Hz Low. assert (Q : -1 * (g T * E T) - -1 * (g q * E q) <= z * (T - q)); [|rewrite (gain_0 m1 m2 b v1 v2 T
    Meet k : E T = 0) in Q; lra].
  apply (dini_slope (fun r => -1 * (g r * E r))); [|lra|].
  - apply cont_scal, cont_mult; [|exact (cont_gain m1 m2 a1 a2 b Hm2 U x v1 v2 s T H k)].
    apply cont_of_derive with (fun r => a1 / m1 * g r). intros r. unfold g. auto_derive; auto. unfold Rminus. ring.
  - intros r Hr. destruct (weighted_rate r ltac:(lra)) as (D & Ge). destruct (weight r ltac:(lra)) as (G1 & _).
    specialize (Low r ltac:(lra)). pose proof (exp_pos (a1 / m1 * (r - T))). fold (g r) in *.
    eapply rderiv_dini; [|apply rderiv_scal, D]. nra.
Qed.

(** so just before T the force cannot ask more than b all the time *)
Lemma not_more d : c <= d < T -> (forall t, d < t < T -> 0 < p t) -> False.
Proof.
  intros Hd Pos. set (r := (d + T) / 2). assert (Hr : d < r < T) by (unfold r; lra).
  assert (E0 : forall t, r <= t < T -> E t = 0 /\ y' t = 0).
  { intros t Ht. destruct (lead_bounds t ltac:(lra)) as (Y0 & Y1). pose proof (exp_pos (a1 / m1 * (t - T))).
    fold (g t) in *.
    pose proof (momentum_up_to 0 t ltac:(lra) (Rle_refl 0) ltac:(intros q Hq; specialize (Pos q ltac:(lra)); lra)).
    assert (0 <= E t) by nra. assert (E t <= 0) by nra. split; nra. }
  assert (F0 : F r = 0).
  { apply (rderiv_unique E r); [apply rate_E; lra|]. apply (rderiv_near (fun _ => 0) E r 0 (T - r));
    [lra| |apply rderiv_const]. intros t Ht. symmetry. apply E0. lra. }
  pose proof (place_behind r ltac:(lra)). specialize (Pos r Hr). unfold F in F0. destruct (E0 r ltac:(lra)) as (_ & Y0).
  rewrite Y0 in F0. nra.
Qed.

(** and where it asks ever more, up to b at T, the load stays within b just before T: spring and damper give back
  less *)
Lemma load_within d : c <= d < T -> (forall r t, d < r <= t -> t < T -> p r <= p t) -> (forall t, d < t < T -> p t <=
  0) ->
  exists d', d <= d' < T /\ forall t, d' < t < T -> k * load t <= b.
Proof.
  intros Hd Up Neg. set (h := exp (- (a1 / m1))). assert (Hh : 0 < h) by apply exp_pos.
  assert (Near : 0 < h * m1 / a2) by positive.
  destruct (just_before d T (Rmin 1 (h * m1 / a2))) as (d' & Hd' & Late); [lra|positive|].
  min_bounds (Rmin 1 (h * m1 / a2)). exists d'. split; [lra|]. intros t Ht.
  set (z := - p t). assert (Hz : 0 <= z) by (specialize (Neg t ltac:(lra)); unfold z; lra).
  set (B := z * (T - t) / (h * m1)). assert (Lead : forall q, t <= q < T -> y' q <= B).
  { intros q Hq. destruct (lead_bounds q ltac:(lra)) as (Y0 & Y1). destruct (weight q ltac:(lra)) as (_ & G).
    specialize (G ltac:(lra)). fold h in G.
    pose proof (momentum_up_to z q ltac:(lra) Hz ltac:(intros r Hr; specialize (Up t r ltac:(lra) ltac:(lra));
      unfold z; lra)) as Mo.
    assert (0 <= E q) by nra. apply Rmult_le_reg_l with (h * m1); [positive|].
    replace (h * m1 * B) with (z * (T - t)) by (unfold B; field; lra). assert (h * (m1 * y' q) <= h * E q) by scale.
    assert (h * E q <= g q * E q) by scale. assert (z * (T - q) <= z * (T - t)) by scale. lra. }
  pose proof (place_not_far t B ltac:(lra) Lead) as Far. destruct (lead_bounds t ltac:(lra)) as (Y0 & _).
  assert (Small : a2 * (B * (T - t)) <= z).
  { replace (a2 * (B * (T - t))) with (z * ((T - t) * ((T - t) / (h * m1 / a2)))) by (unfold B; field; lra).
    rewrite <- (Rmult_1_r z) at 2. apply Rmult_le_compat_l; auto. rewrite <- (Rmult_1_r 1).
    apply Rmult_le_compat; [lra|positive|lra|]. apply Rmult_le_reg_r with (h * m1 / a2); auto.
    unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Fn : F t <= 0).
  { assert (0 <= a1 * y' t) by positive. assert (a2 * - (B * (T - t)) <= a2 * y t) by scale.
    unfold F. unfold z in Small. lra. }
  pose proof (excess_of_load m1 m2 a1 a2 b Hm1 Hm2 u x v1 T k t : F t = M / m2 * (k * load t - b)) as X.
  assert (0 < M / m2) by (apply Rdiv_lt_0_compat; unfold M; lra). nra.
Qed.
End Edge.

(** the load beyond the edge: it would drive the momentum away from 0 *)
Lemma before_beyond k c g : k = 1 \/ k = -1 -> 0 <= c < T -> 0 < g -> (forall q, c < q < T -> b + g <= k * load q) ->
  exists d, 0 < d /\ one_mode v1 v2 (T - d) T.
Proof.
  intros Hk Hc Hg Ld. apply (before_above k c Hk Hc); [intros q Hq; specialize (Ld q Hq); lra|].
  intros r Hr Pos. exfalso. assert (P : 0 < M / m2) by (apply Rdiv_lt_0_compat; unfold M; lra).
  pose proof (gain_rises m1 m2 a1 a2 b Hm2 U u x v1 v2 s T H k (M / m2 * g) r T ltac:(lra)) as Q.
  rewrite gain_0 in Q by auto. destruct (lead_bounds k r Hk ltac:(lra) Pos r ltac:(lra)) as (Y0 & Y1).
  apply (Rmult_le_compat_l m1) in Y0; [rewrite Rmult_0_r in Y0|lra]. assert (0 < M / m2 * g * (T - r)) by positive.
  assert (M / m2 * g * (T - r) <= 0 - gain m1 m2 b v1 v2 T k r); [|lra]. apply Q. intros q Hq. split; [apply DU; lra|].
  rewrite (excess_of_load m1 m2 a1 a2 b Hm1 Hm2 u x v1 T k q). apply Rmult_le_compat_l; [apply Rlt_le, P|].
  specialize (Ld q ltac:(lra)). unfold load in Ld. lra.
Qed.

(** one mode lasts up to T *)
Lemma mode_before f d0 : 0 < d0 -> analytic_at f T -> (forall r, 0 <= r -> T - d0 < r < T -> u r = f r) ->
  exists d, 0 < d /\ one_mode v1 v2 (T - d) T.
Proof.
  intros Hd0 A Eq. set (ld := ModeAtContact.load m1 m2 a1 a2 f x v1).
  (* the load just before T is near its limit *)
  assert (Near : forall e, 0 < e -> exists c, 0 <= c < T /\ T - d0 <= c /\ forall q, c < q < T -> Rabs (load q - ld T)
    <= e).
  { intros e He. destruct (load_near m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 U f x v1 v2 s T H ltac:(lra) (fun _ => True) e He)
      as (d & Hd & K).
    { intros e' He'. destruct (analytic_continuous f T A e' He') as (d & Hd & K). exists d. split; auto. intros q _ Dq.
      apply Rlt_le, K, Dq. }
    destruct (just_before 0 T (Rmin d d0)) as (c & Hc & Late); [auto|positive|]. min_bounds (Rmin d d0).
    exists c. split; [auto|]. split; [lra|]. intros q Hq. unfold load, ModeAtContact.load.
    rewrite Eq by lra. apply K; [lra|auto|]. rewrite Rabs_left; lra. }
  assert (Edge : forall k, k = 1 \/ k = -1 -> k * ld T = b -> exists d, 0 < d /\ one_mode v1 v2 (T - d) T).
  { intros k Hk Tie. destruct (Near b Hb) as (c & Hc & Hcd & Ld).
    assert (Low : forall q, c < q < T -> - k * load q <= b).
    { intros q Hq. specialize (Ld q Hq). apply Rabs_inv in Ld. destruct Hk; subst k; lra. }
    apply (before_above k c Hk Hc Low). intros r Hr Pos.
    assert (Same : forall t, c < t < T -> beyond m1 m2 a1 a2 b u x v1 T k t = beyond m1 m2 a1 a2 b f x v1 T k t)
      by (intros t Ht; unfold beyond; rewrite Eq by lra; auto).
    assert (Z : beyond m1 m2 a1 a2 b f x v1 T k T = 0).
    { replace (beyond m1 m2 a1 a2 b f x v1 T k T) with (M / m2 * (k * ld T - b)) by (unfold beyond, ld, ModeAtContact.load, M;
      field; lra). rewrite Tie. ring. }
    destruct (analytic_one_way _ T (-1) (or_intror eq_refl) (analytic_beyond m1 m2 a1 a2 b f x v1 T k Hm2 A)) as (d1
      & Hd1 & Way).
    destruct (just_before r T d1) as (d & Hd & Late); [lra|auto|]. destruct Way as [Up|Down].
    - exfalso. apply (not_more k r Hk ltac:(lra) Pos d ltac:(lra)). intros t Ht. rewrite Same by lra.
      specialize (Up (T - t) ltac:(lra)). rewrite Z in Up. replace (T + -1 * (T - t)) with t in Up by ring. exact Up.
    - destruct (load_within k r Hk ltac:(lra) Pos d ltac:(lra)) as (d' & Hd' & In).
      + intros q t Hq Ht. rewrite !Same by lra. specialize (Down (T - t) (T - q) ltac:(lra) ltac:(lra)).
        replace (T + -1 * (T - t)) with t in Down by ring. replace (T + -1 * (T - q)) with q in Down by ring.
        exact Down.
      + intros t Ht. rewrite Same by lra. specialize (Down 0 (T - t) ltac:(lra) ltac:(lra)).
        replace (T + -1 * (T - t)) with t in Down by ring. rewrite Rmult_0_r, Rplus_0_r in Down. lra.
      + apply (before_within d'); [lra|]. intros q Hq. specialize (In q Hq). specialize (Low q ltac:(lra)).
        destruct Hk; subst k; lra. }
  assert (Beyond : forall k, k = 1 \/ k = -1 -> b <= k * ld T -> exists d, 0 < d /\ one_mode v1 v2 (T - d) T).
  { intros k Hk Le. destruct (Req_dec (k * ld T) b) as [Tie|N]; [apply (Edge k); auto|].
    destruct (Near ((k * ld T - b) / 2)) as (c & Hc & _ & Ld); [lra|].
    apply (before_beyond k c ((k * ld T - b) / 2) Hk Hc); [lra|]. intros q Hq. specialize (Ld q Hq).
    apply Rabs_inv in Ld. destruct Hk; subst k; lra. }
  destruct (Rle_dec b (ld T)) as [Hi|]; [apply (Beyond 1); [auto|lra]|].
  destruct (Rle_dec (ld T) (- b)) as [Lo|]; [apply (Beyond (-1)); [auto|lra]|].
  destruct (Near (Rmin (b - ld T) (b + ld T))) as (c & Hc & _ & Ld); [positive|].
  pose proof (Rmin_l (b - ld T) (b + ld T)). pose proof (Rmin_r (b - ld T) (b + ld T)).
  apply (before_within c Hc). intros q Hq. specialize (Ld q Hq). apply Rabs_inv in Ld. lra.
Qed.
End Before.
