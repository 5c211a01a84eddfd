(** Who merges from S0 when it first meets S after it left S0, and who at the first re-entry of S0,
    after any number of crossings: exactly the energies of one and the same closed interval above E_cr,
    whose ends are the two roots of hh = sqrt r depth. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction Cycle SlipFromGap ExitOrbit SharpRate
  MergingAngles AfterOneSlip AlternatingSlips KappaBound ReturnToS0 MergingByMassRatio MergingIff.

(** [merging-set] For $m_1/m_2\leqslant-\cos 2\varphi^*$ the equation $h=\sqrt r\,c$ has two roots, which are one at
    equality; the energies on $S_0$ above $E_{cr}$ from the one root to the other, and no others, merge at the first
    contact, and they, and no others, at the first re-entry, after any number of crossings; those below never merge.
    *)
Theorem merging_set : exists ps, 0 < ps < PI /\ K ps = 0 /\ forall m1 m2, 0 < m1 -> 0 < m2 ->
  let root p := 0 < p < PI /\ hh p = sqrt (m2 / (m1 + m2)) * depth p in
  (- cos (2 * ps) < m1 / m2 -> forall p, ~ root p) /\
  (m1 / m2 <= - cos (2 * ps) -> exists pl pu, pl <= ps <= pu /\ (forall p, root p <-> p = pl \/ p = pu) /\
    (m1 / m2 < - cos (2 * ps) -> pl < ps < pu) /\ (m1 / m2 = - cos (2 * ps) -> pl = pu) /\
    forall a2 b, 0 < a2 -> 0 < b ->
    let level p := Ecr m1 m2 a2 b * (1 + m1 / (m1 + m2) * hh p ^ 2) in
    Ecr m1 m2 a2 b < level pl /\ (pl < pu -> level pl < level pu) /\
    forall x v1 v2 s t0, solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> v1 t0 = v2 t0 ->
      - L m1 m2 a2 b <= x t0 <= L m1 m2 a2 b ->
    let E0 := energy m1 m2 a2 (x t0) (v1 t0) (v2 t0) in Ecr m1 m2 a2 b < E0 ->
    (E0 < level pl -> forall t, t0 <= t -> Ecr m1 m2 a2 b < energy m1 m2 a2 (x t) (v1 t) (v2 t)) /\
    exists te t1 t, t0 <= te < t1 /\ t1 <= t /\
      (forall t', t0 <= t' <= te -> v1 t' = v2 t' /\ - L m1 m2 a2 b <= x t' <= L m1 m2 a2 b) /\
      (forall t', te < t' < t1 -> v1 t' <> v2 t') /\ v1 t1 = v2 t1 /\ first_reentry (L m1 m2 a2 b) x v1 v2 te t /\
      ((forall u, 0 <= u -> v1 (t1 + u) = v2 (t1 + u)) <-> level pl <= E0 <= level pu) /\
      ((forall u, 0 <= u -> v1 (t + u) = v2 (t + u)) <-> level pl <= E0 <= level pu) /\
      (~ (- L m1 m2 a2 b <= x t1 <= L m1 m2 a2 b) -> ~ forall u, 0 <= u -> v1 (t + u) = v2 (t + u))).
Proof.
  destruct merging_angles as (ps & Hps & Z & Main). exists ps. split; [auto|]. split; [auto|]. intros m1 m2 H1 H2 root.
  destruct (Main m1 m2 H1 H2) as (None & Some). set (r := m2 / (m1 + m2)) in *.
  assert (R0 : 0 < r) by positive. split.
  { intros Hr p (Hp & E). apply (None Hr p Hp). rewrite E, Rpow_mult_distr, pow2_sqrt by lra. lra. }
  intros Hr. destruct (Some Hr) as (pl & pu & A1 & A2 & A3 & A4 & A5 & A6 & A7 & A8). exists pl, pu.
  assert (Only : forall p, root p -> p = pl \/ p = pu).
  { intros p (Hp & E). assert (hh p ^ 2 = r * depth p ^ 2) by (rewrite E, Rpow_mult_distr, pow2_sqrt; lra).
    destruct (A8 p Hp) as (In & Inside). pose proof (proj1 In ltac:(lra)). destruct (Req_dec p pl); [auto|right].
    apply Rle_antisym; [lra|]. apply Rnot_lt_le. intros N. pose proof (proj2 Inside ltac:(lra)). lra. }
  split; [lra|]. split.
  { split; [apply Only|]. intros [->| ->]; split; auto; lra. }
  split; [exact A7|]. split.
  { (* with two roots the ratio would be less between them than at its least *)
    intros Eq. apply Rle_antisym; [lra|]. apply Rnot_lt_le. intros N. set (p := (pl + pu) / 2).
    assert (Hp : 0 < p < PI) by (unfold p; lra). pose proof (proj2 (proj2 (A8 p Hp)) ltac:(unfold p; lra)) as Lt.
    destruct (ratio_share ps m1 m2 Hps Z H1 H2) as (Rs & Q). rewrite Eq in Q. fold r in Rs, Q.
    pose proof (ratio_least ps p Hps Z Hp). pose proof (depth_pos p Hp). pose proof (hh_pos ps Hps).
    assert (0 < ratio ps) by (apply Rdiv_lt_0_compat; auto using depth_pos).
    replace (hh p) with (ratio p * depth p) in Lt by (unfold ratio; field; lra). rewrite Rpow_mult_distr in Lt.
    apply Rmult_lt_reg_r in Lt; [nra|positive]. }
  intros a2 b Ha Hb level. pose proof (q_pos m1 m2 H1 H2) as Q0. pose proof (Ecr_pos m1 m2 a2 b H1 H2 Ha Hb) as E0.
  set (q := m1 / (m1 + m2)) in *. set (Ec := Ecr m1 m2 a2 b) in *.
  assert (Inc : rising PI level).
  { intros p p' Hp Lt Hp'. apply Rmult_lt_compat_l, Rplus_lt_compat_l, Rmult_lt_compat_l, hh_sq; auto; lra. }
  assert (Le : forall p p', 0 < p < PI -> 0 < p' < PI -> (level p <= level p' <-> p <= p'))
    by (intros p p' Hp Hp'; apply (rising_iff PI level p p' Inc Hp Hp')).
  split.
  { unfold level. pose proof (pow_lt _ 2 (hh_pos pl ltac:(lra))) as P.
    pose proof (Rmult_lt_0_compat _ _ E0 (Rmult_lt_0_compat _ _ Q0 P)). lra. }
  split; [intros; apply Inc; lra|]. intros x v1 v2 s t0 H Ht Ev Hx En0 HE.
  assert (T0 : forall p, 0 < p -> 0 < 2 * p / o1 m1 a2) by (intros; apply Rdiv_lt_0_compat; [lra|apply o1_pos; auto]).
  assert (Q : 0 < q < 1).
  { split; [auto|]. undivide (m1 + m2). lra. }
  destruct (pc_ex q Q) as (pc & Hpc & Dc). pose proof (kappa_large m1 m2 ps pc H1 H2 Hps Z Hr Hpc Dc) as HK.
  assert (Iff' : forall k te p t, k = 1 \/ k = -1 -> 0 <= te -> 0 < p < PI -> on_ray m1 m2 a2 b k (hh p) x v1 v2 te ->
    first_reentry (L m1 m2 a2 b) x v1 v2 te t ->
    ((forall u, 0 <= u -> v1 (t + u) = v2 (t + u)) <-> hh p ^ 2 <= r * depth p ^ 2)).
  { intros k te p t Hk Te Hp HR F. exact (first_reentry_iff m1 m2 a2 b H1 H2 Ha Hb pc Hpc Dc (Rlt_le _ _ HK) x v1 v2 s H k te
      t p Hk Te Hp HR F). }
  split.
  { intros Low. apply (stays_above m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H En0); [|repeat split; auto; lra|fold En0; lra].
    intros k te p t Hk Te Hp HR En F. pose proof (first_reentry_in _ _ _ _ _ _ F) as (T1 & Ev1 & _).
    apply Rnot_le_lt. intros N. pose proof (proj2 (sticks_iff m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t ltac:(lra) Ev1) N) as St.
    pose proof (proj1 (proj1 (A8 p Hp)) (proj1 (Iff' k te p t Hk Te Hp HR F) St)) as In.
    pose proof (proj2 (Le pl p ltac:(lra) Hp) (proj1 In)).
    rewrite (ray_energy m1 m2 a2 b H1 H2 Ha k (hh p) x v1 v2 te Hk HR) in En. fold q Ec in En. unfold level in *. lra. }
  destruct (round m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H t0 (conj Ht (conj Ev (conj Hx HE))))
    as (k & te & p & t & Hk & Te & Hp & En & St & HR & F & Tt).
  destruct (merges_at_first_landing m1 m2 a2 b H1 H2 Ha Hb x v1 v2 s H k te p Hk ltac:(lra) Hp HR)
    as (Sg & Ev1 & Ex & _ & Iff & Dp).
  specialize (Iff' k te p t Hk ltac:(lra) Hp HR F). specialize (T0 p ltac:(lra)).
  assert (Between : hh p ^ 2 <= r * depth p ^ 2 <-> level pl <= En0 <= level pu).
  { rewrite (proj1 (A8 p Hp)). unfold En0. rewrite En.
    change (Ecr m1 m2 a2 b * (1 + m1 / (m1 + m2) * hh p ^ 2)) with (level p). rewrite !Le by lra. tauto. }
  exists te, (te + 2 * p / o1 m1 a2), t. split; [lra|]. split; [lra|]. split; [exact St|]. split;
    [|split; [auto|split]].
  - intros t' Ht' E. specialize (Sg t' Ht'). rewrite E in Sg. lra.
  - exact F.
  - rewrite <- Between. split; [exact Iff|]. split; [exact Iff'|]. intros Out Q'. apply Iff' in Q'.
    apply Out, (lands m1 m2 a2 b H1 H2 Ha Hb k _ 0 p Hk (Rle_refl 0) Hp); rewrite Rplus_0_r; [exact Ex|auto].
Qed.
