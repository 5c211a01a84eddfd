(** After any time one mode lasts for a while, by the rule of `ModeAtContact.v`. *)
From InertialPair Require Import Dini Forced ModeAtContact Analytic Modes BeforeContact.

Section Zeno.
Context (m1 m2 a1 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha1 : 0 <= a1) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (U u x v1 v2 s : R -> R) (H : forced m1 m2 a1 a2 b U x v1 v2 s) (DU : forall t, 0 <= t -> rderiv U t (u t)).
Let M := m1 + m2.
Let w t := v1 t - v2 t.
Let load := load m1 m2 a1 a2 u x v1.

Let Cw : cont w := cont_w m1 m2 a1 a2 b Hm2 U x v1 v2 s H.

(** one mode lasts *)
Lemma mode_after t0 g d0 : 0 <= t0 -> 0 < d0 -> analytic_at g t0 -> (forall r, t0 <= r < t0 + d0 -> u r = g r) ->
  exists d, 0 < d /\ one_mode v1 v2 t0 (t0 + d).
Proof.
  intros Ht Hd0 A E. destruct (Req_dec (v1 t0) (v2 t0)) as [Meet|Apart].
  2: { destruct (apart_nearby v1 v2 t0 Cw Ht Apart) as (d & Hd & K). exists d. split; auto.
    apply no_zero_one_sign; [exact Cw|lra|]. intros t Hr. apply K; [lra|]. rewrite Rabs_pos_eq; lra. }
  assert (Cu : forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 <= h < d -> Rabs (u (t0 + h) - u t0) <= e).
  { intros e He. destruct (analytic_continuous g t0 A e He) as (d & Hd & K). smaller d d0. intros h Hh.
    rewrite !E by lra. apply Rlt_le, K. replace (t0 + h - t0) with h by ring. rewrite Rabs_pos_eq; lra. }
  assert (Edge : forall k, k = 1 \/ k = -1 -> k * load t0 = b -> exists d, 0 < d /\ one_mode v1 v2 t0 (t0 + d)).
  { intros k Hk Tie. assert (Same : forall t, t0 <= t < t0 + d0 ->
      beyond m1 m2 a1 a2 b u x v1 t0 k t = beyond m1 m2 a1 a2 b g x v1 t0 k t) by (intros t Hr; unfold beyond;
        rewrite E; auto).
    assert (Z : beyond m1 m2 a1 a2 b g x v1 t0 k t0 = 0).
    { rewrite <- Same by lra. replace (beyond m1 m2 a1 a2 b u x v1 t0 k t0) with (M / m2 * (k * load t0 - b))
        by (unfold beyond, load, ModeAtContact.load, M; field; lra). rewrite Tie. ring. }
    destruct (analytic_one_way _ t0 1 (or_introl eq_refl) (analytic_beyond m1 m2 a1 a2 b g x v1 t0 k Hm2 A)) as (d1 &
      Hd1 & Way).
    set (d := Rmin d0 d1). least d. assert (Hd : 0 < d) by positive. destruct Way as [Up|Down].
    - destruct (slips_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht Hd ltac:(intros; apply DU;
      lra) Meet k Hk Tie) as (d' & Hd' & Slip); [|exists d'; eauto using one_sided].
      intros t Hr. rewrite Same by lra. specialize (Up (t - t0) ltac:(lra)). rewrite Z in Up.
      replace (t0 + 1 * (t - t0)) with t in Up by ring. exact Up.
    - destruct (sticks_at_edge m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d H Ht Hd ltac:(intros; apply DU;
      lra) Cu Meet k Hk Tie) as (d' & Hd' & Stick); [|exists d'; split; [auto|left; intros; apply Stick; lra]].
      intros r t Hr Ht'. rewrite !Same by lra. specialize (Down (r - t0) (t - t0) ltac:(lra) ltac:(lra)).
      replace (t0 + 1 * (t - t0)) with t in Down by ring. replace (t0 + 1 * (r - t0)) with r in Down by ring.
      exact Down. }
  assert (Beyond : forall k, k = 1 \/ k = -1 -> b <= k * load t0 -> exists d, 0 < d /\ one_mode v1 v2 t0 (t0 + d)).
  { intros k Hk Le. destruct (Req_dec (k * load t0) b) as [Tie|N].
    - exact (Edge k Hk Tie).
    - destruct (slips_at m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 Hb U u x v1 v2 s t0 d0 H Ht Hd0 ltac:(intros; apply DU; lra)
        Cu Meet k Hk) as (d & Hd & Slip); [unfold load in *; lra|exists d; eauto using one_sided]. }
  destruct (Rle_dec b (load t0)) as [Up|]; [apply (Beyond 1); [auto|lra]|].
  destruct (Rle_dec (load t0) (- b)) as [Lo|]; [apply (Beyond (-1)); [auto|lra]|].
  destruct (sticks_at m1 m2 a1 a2 b Hm1 Hm2 Ha1 Ha2 U u x v1 v2 s t0 d0 H Ht Hd0 ltac:(intros; apply DU; lra) Cu Meet)
    as (d & Hd & Stick); [fold load; apply Rabs_def1; lra|]. exists d. split; auto. left. intros t Hr. apply Stick. lra.
Qed.
End Zeno.
