(** The half angles with hh <= sqrt r depth: none, or one closed interval around the turning point. *)
From Coq Require Import Ranalysis5.
From InertialPair Require Import Dini Excursion ReturnMap TurningFunction ExitOrbit.

(** h/c is above 1 for short slips *)
Lemma ratio_short p : 0 < p < PI -> hh p <= 1 / 2 -> 1 < ratio p.
Proof.
  intros Hp Hh. pose proof (hh_pos p Hp). pose proof (depth_pos p Hp). pose proof (depth_upper p Hp).
  undivide (depth p). nra.
Qed.
(** and for long ones *)
Lemma ratio_long p : PI - / 20 <= p < PI -> 1 < ratio p.
Proof.
  intros Hp. pose proof PI2_3_2 as P3. pose proof PI_4 as P4. assert (P : 0 < p < PI) by lra. rewrite ratio_AB by auto.
  pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p P) as G. pose proof (COS_bound p) as C.
  assert (S2 : sin p <= / 20) by (rewrite <- sin_PI_x; pose proof (sin_below (PI - p) ltac:(lra)); lra).
  undivide (2 * sin p * (sin p - p * cos p)). assert (sin p - p * cos p <= / 20 + 4) by nra.
  assert (2 * sin p * (sin p - p * cos p) <= 2 * / 20 * (/ 20 + 4)) by (apply Rmult_le_compat; lra). nra.
Qed.
Lemma ratio_cont p : 0 < p < PI -> continuity_pt ratio p.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)). pose proof (depth_pos p Hp). unfold depth in *.
  apply continuity_pt_filterlim, (ex_derive_continuous ratio). unfold ratio, hh, depth. auto_derive.
  repeat split; auto; apply Rgt_not_eq; [nra|lra|positive].
Qed.

(** the ratio is at most g on exactly one interval, which holds the turning point, and below g inside it *)
Theorem ratio_set ps g : 0 < ps < PI -> K ps = 0 -> ratio ps <= g <= 1 ->
  exists pl pu, 0 < pl /\ pl <= ps /\ ps <= pu /\ pu < PI /\ ratio pl = g /\ ratio pu = g /\
    forall p, 0 < p < PI -> (ratio p <= g <-> pl <= p <= pu) /\ (ratio p < g <-> pl < p < pu).
Proof.
  intros Hps Z Hg. destruct (signs ps ltac:(lra) Z) as (Le & Ri). assert (Falls : forall p q, 0 < p -> p < q -> q <= ps
    -> ratio q < ratio p) by (intros p q Hp Hq H; apply (ratio_step p q); try lra; intros; apply Le; lra).
  assert (Rises : forall p q, ps <= p -> p < q -> q < PI -> ratio p < ratio q)
    by (intros p q Hp Hq H; apply (ratio_step p q); try lra; intros; apply Ri; lra).
  destruct (half_spec (1 / 2) ltac:(lra)) as (Hh & Eh). set (pa := Rmin (half (1 / 2)) (ps / 2)).
  assert (Pa : 0 < pa < ps /\ pa <= half (1 / 2)) by (unfold pa, Rmin; destruct Rle_dec; lra).
  assert (Ra : 1 < ratio pa) by (apply ratio_short; [lra|rewrite <- Eh; apply hh_le; lra]).
  set (pb := Rmax (PI - / 20) ((ps + PI) / 2)).
  assert (Pb : PI - / 20 <= pb < PI /\ ps < pb) by (unfold pb, Rmax; destruct Rle_dec; lra).
  pose proof (ratio_long pb ltac:(lra)) as Rb. assert (Val : forall k u v, 0 < u < v -> v < PI -> k * (ratio u - g) < 0
    -> 0 < k * (ratio v - g) -> exists z, u <= z <= v /\ ratio z = g).
  { intros k u v Hu Hv Lo Up. destruct (IVT_interv (fun p => k * (ratio p - g)) u v) as (z & Hz & E); auto; [|lra|].
    - intros p Hp. apply continuity_pt_scal, continuity_pt_minus; [apply ratio_cont; lra|]. apply continuity_pt_const.
      intros ? ?. auto.
    - exists z. split; [auto|]. destruct (Rmult_integral _ _ E) as [->|]; lra. }
  assert (Ends : exists pl pu, pa <= pl <= ps /\ ps <= pu <= pb /\ ratio pl = g /\ ratio pu = g).
  { destruct (proj1 Hg) as [Lt|E]; [|exists ps, ps; lra]. destruct (Val (-1) pa ps) as (pl & Hl & El); try lra.
    destruct (Val 1 ps pb) as (pu & Hu & Eu); try lra. exists pl, pu. lra. }
  destruct Ends as (pl & pu & Hl & Hu & El & Eu). exists pl, pu. repeat (split; [lra|]). intros p Hp.
  assert (T : (p < pl \/ pu < p) /\ g < ratio p \/ (p = pl \/ p = pu) /\ ratio p = g \/ pl < p < pu /\ ratio p < g).
  { destruct (Rtotal_order p pl) as [A|[A|A]]; [left|right; left; subst; auto|].
    - split; [auto|]. rewrite <- El. apply Falls; lra.
    - destruct (Rtotal_order p pu) as [B|[B|B]]; [right; right|right; left; subst; auto|left].
      + split; [auto|]. destruct (Rle_dec p ps); [rewrite <- El; apply Falls|rewrite <- Eu; apply Rises]; lra.
      + split; [auto|]. rewrite <- Eu. apply Rises; lra. }
  split; split; intros; lra.
Qed.

(** the set of half angles that merge at the first landing, r = m2/(m1+m2): empty, or [pl, pu] around phi* *)
Theorem merging_angles : exists ps, 0 < ps < PI /\ K ps = 0 /\ forall m1 m2, 0 < m1 -> 0 < m2 ->
  let r := m2 / (m1 + m2) in
  (- cos (2 * ps) < m1 / m2 -> forall p, 0 < p < PI -> ~ hh p ^ 2 <= r * depth p ^ 2) /\
  (m1 / m2 <= - cos (2 * ps) -> exists pl pu, 0 < pl /\ pl <= ps /\ ps <= pu /\ pu < PI /\
     hh pl = sqrt r * depth pl /\ hh pu = sqrt r * depth pu /\ (m1 / m2 < - cos (2 * ps) -> pl < ps < pu) /\
     forall p, 0 < p < PI -> (hh p ^ 2 <= r * depth p ^ 2 <-> pl <= p <= pu) /\
       (hh p ^ 2 < r * depth p ^ 2 <-> pl < p < pu)).
Proof.
  destruct threshold as (ps & Hps & Z & _ & Up & _ & Iff). exists ps. split; [auto|]. split; [auto|].
  intros m1 m2 H1 H2 r. assert (R0 : 0 < r < 1) by (split; [positive|unfold r; undivide (m1 + m2); lra]). split.
  { intros Hr p Hp. apply Iff in Hr; auto. pose proof (Up r ltac:(lra) Hr p Hp). lra. }
  intros Hr. set (g := sqrt r). assert (S0 : 0 < g) by (unfold g; positive).
  assert (SS : g ^ 2 = r) by (apply pow2_sqrt; lra).
  assert (Eq : forall p, 0 < p < PI -> hh p = ratio p * depth p /\ 0 < ratio p /\ 0 < depth p ^ 2).
  { intros p Hp. pose proof (hh_pos p Hp). pose proof (depth_pos p Hp). unfold ratio.
    split; [field; lra|split; positive]. }
  destruct (ratio_share ps m1 m2 Hps Z H1 H2) as (Pr & Sh). fold r in Pr, Sh. destruct (Eq ps Hps) as (_ & Rp & _).
  destruct (ratio_set ps g Hps Z) as (pl & pu & A1 & A2 & A3 & A4 & A5 & A6 & A7).
  { assert (0 <= r - ratio ps ^ 2) by (rewrite Sh; apply Rmult_le_pos; lra). split; nra. }
  exists pl, pu. repeat (split; [auto; fail|]). split; [rewrite <- A5; apply Eq; lra|].
  split; [rewrite <- A6; apply Eq; lra|]. split.
  - intros Hlt. apply (A7 ps Hps). assert (0 < r - ratio ps ^ 2) by (rewrite Sh; apply Rmult_lt_0_compat; lra). nra.
  - intros p Hp. destruct (Eq p Hp) as (E & Q & D). destruct (A7 p Hp) as (<- & <-). rewrite E, Rpow_mult_distr, <- SS.
    split; split; intros I; [apply Rmult_le_reg_r in I|apply Rmult_le_compat_r| apply Rmult_lt_reg_r
      in I|apply Rmult_lt_compat_r]; nra.
Qed.

(** *** Light drivers: the interval tends to the one between the roots of hh = depth *)

(** [light-driver] As $m_1/m_2\to 0$ the values of $h^2$ at both roots of $h=\sqrt r\,c$ tend to those at the two
    roots of $h=c$. *)
Theorem light_driver : exists ps pa pb, 0 < pa < ps /\ ps < pb < PI /\ K ps = 0 /\ hh pa = depth pa /\ hh pb = depth pb /\
  forall e, 0 < e -> exists d, 0 < d /\ forall m1 m2, 0 < m1 -> 0 < m2 -> m1 / m2 < d -> forall p, 0 < p < PI ->
  hh p = sqrt (m2 / (m1 + m2)) * depth p ->
  (p <= ps -> hh pa ^ 2 < hh p ^ 2 < hh pa ^ 2 + e) /\ (ps <= p -> hh pb ^ 2 - e < hh p ^ 2 < hh pb ^ 2).
Proof.
  destruct root as (ps & Hps & Z & _). pose proof pi_below. pose proof PI2_3_2.
  assert (R0 : 0 < ratio ps) by (apply Rdiv_lt_0_compat; [apply hh_pos|apply depth_pos]; auto).
  assert (Rs : ratio ps < 1).
  { apply Rle_lt_trans with (ratio (PI / 2)); [apply ratio_least; auto; lra|].
    rewrite ratio_AB, sin_PI2, cos_PI2 by lra. replace (_ / _) with (PI / 4) by field. lra. }
  destruct (ratio_set ps 1 Hps Z ltac:(lra)) as (pa & pb & A1 & A2 & A3 & A4 & A5 & A6 & In).
  destruct (proj1 (proj2 (In ps Hps)) Rs) as (Pa & Pb). exists ps, pa, pb.
  assert (One : forall p, 0 < p < PI -> ratio p = 1 -> hh p = depth p).
  { intros p Hp E. pose proof (depth_pos p Hp). replace (hh p) with (ratio p * depth p); [rewrite E; ring|].
    unfold ratio. field. lra. }
  split; [lra|]. split; [lra|]. split; [auto|]. split; [apply One; lra|]. split; [apply One; lra|]. intros e He.
  (* where h^2 is within e, the ratio is below 1 still: at a before ps, and at c behind it *)
  pose proof (hh_pos pa ltac:(lra)) as Ha. pose proof (hh_pos pb ltac:(lra)) as Hb.
  set (z := Rmax (hh pb ^ 2 - e) (hh pb ^ 2 / 2)). assert (0 < hh pb ^ 2) by positive.
  assert (Zb : 0 < z < hh pb ^ 2 /\ hh pb ^ 2 - e <= z) by (unfold z, Rmax; destruct Rle_dec; lra).
  destruct (half_spec (sqrt (hh pa ^ 2 + e)) ltac:(positive)) as (HA & EA). set (a := half (sqrt (_ + _))) in *.
  destruct (half_spec (sqrt z) ltac:(positive)) as (HB & EB). set (c := half (sqrt z)) in *.
  assert (EA2 : hh a ^ 2 = hh pa ^ 2 + e) by (rewrite EA, pow2_sqrt; [auto|positive]).
  assert (EB2 : hh c ^ 2 = z) by (rewrite EB, pow2_sqrt; lra). assert (La : pa < a) by (apply hh_sq; lra).
  assert (Lb : c < pb) by (apply hh_sq; lra). set (a' := Rmin a ps).
  assert (Aa : pa < a' <= ps /\ a' <= a) by (unfold a', Rmin; destruct Rle_dec; lra). set (c' := Rmax c ps).
  assert (Cc : ps <= c' < pb /\ c <= c') by (unfold c', Rmax; destruct Rle_dec; lra).
  assert (Ra : ratio a' < 1) by (apply In; lra). assert (Rc : ratio c' < 1) by (apply In; lra).
  set (g := Rmax (ratio ps) (Rmax (ratio a') (ratio c'))).
  assert (G : ratio ps <= g < 1 /\ ratio a' <= g /\ ratio c' <= g) by (unfold g, Rmax; repeat destruct Rle_dec; lra).
  destruct (ratio_set ps g Hps Z ltac:(lra)) as (pl & pu & _ & _ & _ & _ & _ & _ & Within).
  assert (Wa : pl <= a' <= pu) by (apply Within; lra). assert (Wc : pl <= c' <= pu) by (apply Within; lra).
  exists (/ g ^ 2 - 1). assert (G2 : 0 < g ^ 2 < 1) by nra.
  assert (I : 1 < / g ^ 2) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). split; [lra|].
  intros m1 m2 M1 M2 Hd p Hp E. set (r := m2 / (m1 + m2)) in *. assert (Hr : g ^ 2 < r < 1).
  { split; [|unfold r; undivide (m1 + m2); lra]. unfold r. undivide (m1 + m2).
    apply Rlt_div_l in Hd; [|lra]. apply (Rmult_lt_compat_l (g ^ 2)) in Hd; [|lra].
    replace (g ^ 2 * ((/ g ^ 2 - 1) * m2)) with (m2 - g ^ 2 * m2) in Hd by (field; lra). lra. }
  assert (Rp : ratio p = sqrt r) by (pose proof (depth_pos p Hp); unfold ratio; rewrite E; field; lra).
  assert (S1 : g < ratio p < 1).
  { assert (0 <= sqrt r) by positive. assert (sqrt r ^ 2 = r) by (apply pow2_sqrt; lra). rewrite Rp. nra. }
  destruct (proj1 (proj2 (In p Hp)) (proj2 S1)) as (P1 & P2).
  assert (Out : ~ pl <= p <= pu) by (intros N; apply (Within p Hp) in N; lra). split; intros Side; split.
  - apply hh_sq; lra.
  - rewrite <- EA2. apply hh_sq; lra.
  - apply Rle_lt_trans with z; [lra|]. rewrite <- EB2. apply hh_sq; lra.
  - apply hh_sq; lra.
Qed.
