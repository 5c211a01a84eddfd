(** The half angles with hh <= sqrt r depth: none, or one closed interval around the turning point. *)
From InertialPair Require Import Dini Excursion ReturnMap TurningFunction ExitOrbit.

(** h/c is above 1 for short and for long slips *)
Lemma ratio_short : exists p, 0 < p < PI / 2 /\ 1 < ratio p.
Proof.
  pose proof PI2_3_2 as P3. destruct (half_spec (1 / 2) ltac:(lra)) as (Hp & E). set (p := half (1 / 2)) in *.
    exists p. split.
  - split; [lra|]. destruct (Rlt_dec p (PI / 2)) as [|N]; auto. exfalso.
    assert (hh (PI / 2) <= hh p). { destruct (Req_dec (PI / 2) p) as [->|]; [lra|]. apply Rlt_le, hh_incr; lra. }
      rewrite hh_half_pi in *. lra.
  - pose proof (depth_upper p Hp) as D. pose proof (depth_pos p Hp). rewrite E in D. unfold ratio. rewrite E.
    undivide (depth p). lra.
Qed.
(** for long slips *)
Lemma ratio_long p : PI - / 20 <= p < PI -> 1 < ratio p.
Proof.
  intros Hp. pose proof PI2_3_2 as P3. pose proof PI_4 as P4. assert (P : 0 < p < PI) by lra. rewrite ratio_AB by auto.
  pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p P) as G.
  assert (S2 : sin p <= / 20). { rewrite <- sin_PI_x. pose proof (sin_below (PI - p) ltac:(lra)). lra. }
  pose proof (COS_bound p) as C. assert (D : 0 < 2 * sin p * (sin p - p * cos p)) by positive.
  undivide (2 * sin p * (sin p - p * cos p)). assert (sin p - p * cos p <= / 20 + 4) by nra.
  assert (2 * sin p * (sin p - p * cos p) <= 2 * / 20 * (/ 20 + 4)). { apply Rmult_le_compat; lra. }
  assert (sin p * cos p <= / 20) by nra. lra.
Qed.

(** below g the ratio is at most g on exactly one interval, which holds the turning point *)
Theorem ratio_set ps g : 0 < ps < PI -> (forall u, 0 < u < ps -> 0 < K u) -> (forall u, ps < u <= PI -> K u < 0) ->
  g <= 1 -> ratio ps <= g -> 0 < g ->
  exists pl pu, 0 < pl /\ pl <= ps /\ ps <= pu /\ pu < PI /\ ratio pl = g /\ ratio pu = g /\
    (forall p, 0 < p < PI -> (ratio p <= g <-> pl <= p <= pu)).
Proof.
  intros Hps Le Ri Hg1 Hg Hg0.
  assert (Falls : forall p q, 0 < p -> p < q -> q <= ps -> ratio q < ratio p). { intros p q H0 H1 H2.
    apply (ratio_step p q); [lra|lra|lra|]. intros; apply Le; lra. }
  assert (Rises : forall p q, ps <= p -> p < q -> q < PI -> ratio p < ratio q). { intros p q H0 H1 H2.
    apply (ratio_step p q); [lra|lra|lra|]. intros; apply Ri; lra. }
  set (G := fun p => (p - sin p * cos p) - g * (2 * sin p * (sin p - p * cos p))). assert (CG : cont G).
  { apply cont_of_derive with (fun p => 2 * sin p * sin p + (1 - (sin p * sin p + cos p * cos p)) - g * (2 * cos p
    * (sin p - p * cos p) + 2 * sin p * (p * sin p))).
    intros t. unfold G. auto_derive; auto. ring. }
  assert (SG : forall p, 0 < p < PI -> G p = (2 * sin p * (sin p - p * cos p)) * (ratio p - g) /\
    0 < 2 * sin p * (sin p - p * cos p)).
  { intros p Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos p Hp) as Gp.
    split; [|positive]. rewrite ratio_AB by auto. unfold G. field. lra. }
  assert (Zero : forall p, 0 < p < PI -> G p = 0 -> ratio p = g).
  { intros p Hp Z. destruct (SG p Hp) as (E & Ps). rewrite E in Z. apply Rmult_integral in Z. lra. }
  assert (Gs : G ps <= 0). { destruct (SG ps Hps) as (E & Ps). rewrite E. nra. }
  destruct ratio_short as (pa & Ha & Ra). pose proof PI_RGT_0. assert (Pa : pa < ps).
  { destruct (Rlt_dec pa ps); auto. exfalso. pose proof (ratio_falls ps pa ltac:(lra) ltac:(lra) ltac:(lra)). lra. }
  set (pb := Rmax (PI - / 20) ((ps + PI) / 2)). assert (Pb : PI - / 20 <= pb < PI /\ ps < pb).
  { unfold pb. pose proof (Rmax_l (PI - / 20) ((ps + PI) / 2)). pose proof (Rmax_r (PI - / 20) ((ps + PI) / 2)).
    split; [|lra]. split; [auto|]. apply Rmax_lub_lt; lra. }
  pose proof (ratio_long pb ltac:(lra)) as Rb. pose proof PI2_3_2.
  assert (Ga : 0 < G pa). { destruct (SG pa ltac:(lra)) as (E & Ps). rewrite E. apply Rmult_lt_0_compat; lra. }
  assert (Gb : 0 < G pb). { destruct (SG pb ltac:(lra)) as (E & Ps). rewrite E. apply Rmult_lt_0_compat; lra. }
  destruct (cont_IVT G pa ps CG) as (pl & Hl & Zl); [lra|nra|].
    destruct (cont_IVT G ps pb CG) as (pu & Hu & Zu); [lra|nra|].
  apply Zero in Zl; [|lra]. apply Zero in Zu; [|lra]. exists pl, pu. repeat (split; [lra|]). intros p Hp. split.
  - intros R. split.
    + destruct (Rle_dec pl p); auto. exfalso. pose proof (Falls p pl ltac:(lra) ltac:(lra) ltac:(lra)). lra.
    + destruct (Rle_dec p pu); auto. exfalso. pose proof (Rises pu p ltac:(lra) ltac:(lra) ltac:(lra)). lra.
  - intros R. destruct (Rle_dec p ps) as [n|n].
    + destruct (Req_dec pl p) as [->|]; [lra|]. pose proof (Falls pl p ltac:(lra) ltac:(lra) n). lra.
    + destruct (Req_dec p pu) as [->|]; [lra|]. pose proof (Rises p pu ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** the share of body 2 beside the least ratio, as the critical mass ratio beside that of the masses *)
Lemma ratio_share p m1 m2 : 0 < p < PI -> K p = 0 -> 0 < m1 -> 0 < m2 ->
  0 < m2 / (m1 + m2) * ratio p ^ 2 /\
  m2 / (m1 + m2) - ratio p ^ 2 = (- cos (2 * p) - m1 / m2) * (m2 / (m1 + m2) * ratio p ^ 2).
Proof.
  intros Hp Z H1 H2. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. rewrite (ratio_root p Hp Z), cos_2a_sin.
  split; [|field; lra]. apply Rmult_lt_0_compat; [positive|apply Rinv_0_lt_compat; nra].
Qed.

(** the set of half angles that merge at the first landing, r = m2/(m1+m2): empty, or [pl, pu] around phi* *)
Theorem merging_angles : exists ps, 0 < ps < PI /\ K ps = 0 /\ forall m1 m2, 0 < m1 -> 0 < m2 -> let r :=
  m2 / (m1 + m2) in
  (- cos (2 * ps) < m1 / m2 -> forall p, 0 < p < PI -> ~ hh p ^ 2 <= r * depth p ^ 2) /\
  (m1 / m2 <= - cos (2 * ps) -> exists pl pu, 0 < pl /\ pl <= ps /\ ps <= pu /\ pu < PI /\
     hh pl = sqrt r * depth pl /\ hh pu = sqrt r * depth pu /\ (m1 / m2 < - cos (2 * ps) -> pl < ps < pu) /\
     forall p, 0 < p < PI -> (hh p ^ 2 <= r * depth p ^ 2 <-> pl <= p <= pu)).
Proof.
  destruct threshold as (ps & Hps & Z & Un & Up & Lo & Iff). exists ps. split; [auto|]. split; [auto|].
  intros m1 m2 H1 H2 r. assert (R0 : 0 < r) by positive. assert (R1 : r < 1). { unfold r. undivide (m1 + m2). lra. }
  split.
  { intros Hr p Hp. apply Iff in Hr; auto. pose proof (Up r R0 Hr p Hp). lra. }
  intros Hr. destruct root as (p0 & Hp0 & Z0 & Le & Ri). rewrite (Un p0 ltac:(lra) Z0) in Le, Ri.
  assert (S0 : 0 < sqrt r) by positive. assert (SS : sqrt r * sqrt r = r) by (apply sqrt_sqrt; lra).
  assert (S1 : sqrt r < 1). { rewrite <- sqrt_1. apply sqrt_lt_1; lra. }
  assert (Eq : forall p, 0 < p < PI -> (hh p ^ 2 <= r * depth p ^ 2 <-> ratio p <= sqrt r) /\ hh p = ratio p * depth p).
  { intros p Hp. pose proof (hh_pos p Hp) as A. pose proof (depth_pos p Hp) as B.
    assert (E : hh p = ratio p * depth p) by (unfold ratio; field; lra).
    assert (Rp : 0 < ratio p) by (apply Rdiv_lt_0_compat; auto). split; auto. rewrite E at 1.
    replace ((ratio p * depth p) ^ 2) with (ratio p * ratio p * depth p ^ 2) by ring.
      pose proof (pow_lt _ 2 B) as B2. split; intros Q.
    - apply Rmult_le_reg_r in Q; auto. rewrite <- SS in Q. destruct (Rle_dec (ratio p) (sqrt r)); auto. nra.
    - apply Rmult_le_compat_r; [lra|]. rewrite <- SS. apply Rmult_le_compat; lra. }
  destruct (ratio_share ps m1 m2 Hps Z H1 H2) as (Pr & Sh). fold r in Pr, Sh.
  assert (Rs : ratio ps <= sqrt r) by (apply Rnot_lt_le; intros N; nra).
  destruct (ratio_set ps (sqrt r) Hps Le Ri (Rlt_le _ _ S1) Rs S0) as (pl & pu & A1 & A2 & A3 & A4 & A5 & A6 & A7).
  exists pl, pu. repeat (split; [auto; fail|]).
  split; [rewrite <- A5; apply Eq; lra|]. split; [rewrite <- A6; apply Eq; lra|]. split.
  - intros Hlt. assert (Rs2 : ratio ps < sqrt r) by (apply Rnot_le_lt; intros N; nra).
    split; [destruct (Req_dec pl ps) as [E|]|destruct (Req_dec pu ps) as [E|]]; try lra; rewrite E in *; lra.
  - intros p Hp. rewrite <- (A7 p Hp). apply Eq; auto.
Qed.

(** *** Light drivers: the interval tends to the one between the roots of hh = depth *)

(** [light-driver] As $m_1/m_2\to 0$ the values of $h^2$ at both roots of $h=\sqrt r\,c$ tend to those at the two
    roots of $h=c$. *)
Theorem light_driver : exists ps pa pb, 0 < pa < ps /\ ps < pb < PI /\ K ps = 0 /\ hh pa = depth pa /\ hh pb = depth pb /\
  forall e, 0 < e -> exists d, 0 < d /\ forall m1 m2, 0 < m1 -> 0 < m2 -> m1 / m2 < d -> forall p, 0 < p < PI ->
  hh p = sqrt (m2 / (m1 + m2)) * depth p ->
  (p <= ps -> hh pa ^ 2 < hh p ^ 2 < hh pa ^ 2 + e) /\ (ps <= p -> hh pb ^ 2 - e < hh p ^ 2 < hh pb ^ 2).
Proof.
  destruct root as (ps & Hps & Z & Le & Ri). pose proof PI2_3_2 as P3.
  assert (Falls : forall p q, 0 < p -> p < q -> q <= ps -> ratio q < ratio p).
  { intros p q H0 H1 H2. apply (ratio_step p q); [lra|lra|lra|]. intros; apply Le; lra. }
  assert (Rises : forall p q, ps <= p -> p < q -> q < PI -> ratio p < ratio q).
  { intros p q H0 H1 H2. apply (ratio_step p q); [lra|lra|lra|]. intros; apply Ri; lra. }
  assert (R0 : forall p, 0 < p < PI -> 0 < ratio p) by (intros p Hp; apply Rdiv_lt_0_compat; [apply hh_pos|apply depth_pos]; auto).
  assert (Rs : ratio ps < 1).
  { assert (K2 : 0 < K (PI / 2)). { unfold K. rewrite sin_PI2, cos_PI2. pose proof (sqrt_sqrt 2 ltac:(lra)).
      pose proof (sqrt_pos 2). assert (sqrt 2 < 3 / 2) by nra. lra. }
    assert (PI / 2 < ps). { apply Rnot_le_lt. intros N. destruct (Req_dec ps (PI / 2)) as [E|E]; [rewrite E in Z; lra|].
      specialize (Ri (PI / 2) ltac:(lra)). lra. }
    apply Rlt_le_trans with (ratio (PI / 2)); [apply Falls; lra|]. rewrite ratio_AB by lra. rewrite sin_PI2, cos_PI2.
    replace ((PI / 2 - 1 * 0) / (2 * 1 * (1 - PI / 2 * 0))) with (PI / 4) by field. pose proof PI_4. lra. }
  destruct (ratio_set ps 1 Hps Le Ri (Rle_refl 1) (Rlt_le _ _ Rs) Rlt_0_1) as (pa & pb & A1 & A2 & A3 & A4 & A5 & A6 & _).
  assert (Pa : pa < ps) by (destruct (Req_dec pa ps) as [E|]; [rewrite E in A5|]; lra).
  assert (Pb : ps < pb) by (destruct (Req_dec pb ps) as [E|]; [rewrite E in A6|]; lra).
  exists ps, pa, pb. assert (One : forall p, 0 < p < PI -> ratio p = 1 -> hh p = depth p).
  { intros p Hp E. pose proof (depth_pos p Hp). unfold ratio in E. apply (Rmult_eq_compat_r (depth p)) in E. field_simplify in E; lra. }
  split; [lra|]. split; [lra|]. split; [auto|]. split; [apply One; lra|]. split; [apply One; lra|]. intros e He.
  (* the ratio at a place so little further in that h^2 is within e *)
  assert (Near : exists g, 0 < g < 1 /\ forall p, 0 < p < PI -> g < ratio p ->
    (p <= ps -> hh p ^ 2 < hh pa ^ 2 + e) /\ (ps <= p -> hh pb ^ 2 - e < hh p ^ 2)).
  { pose proof (hh_pos pa ltac:(lra)) as Ha. pose proof (hh_pos pb ltac:(lra)) as Hb.
    destruct (half_spec (sqrt (hh pa ^ 2 + e)) ltac:(positive)) as (HA & EA). set (a := half (sqrt (hh pa ^ 2 + e))) in *.
    set (z := Rmax (hh pb ^ 2 - e) (hh pb ^ 2 / 2)). assert (Zb : 0 < z < hh pb ^ 2 /\ hh pb ^ 2 - e <= z).
    { assert (0 < hh pb ^ 2) by positive. unfold z. pose proof (Rmax_l (hh pb ^ 2 - e) (hh pb ^ 2 / 2)).
      pose proof (Rmax_r (hh pb ^ 2 - e) (hh pb ^ 2 / 2)). split; [split; [lra|apply Rmax_lub_lt; lra]|lra]. }
    destruct (half_spec (sqrt z) ltac:(positive)) as (HB & EB). set (c := half (sqrt z)) in *.
    assert (Sq : forall u v, 0 < u -> 0 < v -> u ^ 2 < v ^ 2 -> u < v) by (intros; nra).
    assert (EA2 : hh a ^ 2 = hh pa ^ 2 + e) by (rewrite EA, pow2_sqrt; [auto|positive]).
    assert (EB2 : hh c ^ 2 = z) by (rewrite EB, pow2_sqrt; lra).
    assert (La : pa < a). { apply Rnot_le_lt. intros N. destruct (Req_dec a pa) as [E|]; [rewrite E in EA2; lra|].
      pose proof (hh_incr a pa ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (hh_pos a HA). nra. }
    assert (Lb : c < pb). { apply Rnot_le_lt. intros N. destruct (Req_dec pb c) as [E|]; [rewrite E in Zb; lra|].
      pose proof (hh_incr pb c ltac:(lra) ltac:(lra) ltac:(lra)). nra. }
    set (a' := Rmin a ps). set (c' := Rmax c ps).
    assert (Ra : 0 < ratio a' < 1).
    { unfold a', Rmin. destruct (Rle_dec a ps); (split; [apply R0; lra|]); [rewrite <- A5; apply Falls|]; lra. }
    assert (Rb : 0 < ratio c' < 1).
    { unfold c', Rmax. destruct (Rle_dec c ps); (split; [apply R0; lra|]); [|rewrite <- A6; apply Rises]; lra. }
    assert (G : exists g, ratio a' <= g /\ ratio c' <= g /\ g < 1).
    { exists (Rmax (ratio a') (ratio c')). split; [apply Rmax_l|]. split; [apply Rmax_r|apply Rmax_lub_lt; lra]. }
    destruct G as (g & Ml & Mr & G1). exists g. split; [lra|]. intros p Hp Hr. split; intros Side.
    - assert (p < a).
      { apply Rnot_le_lt. intros N. replace a' with a in Ml by (symmetry; apply Rmin_left; lra).
        destruct N as [Lt|E]; [pose proof (Falls a p ltac:(lra) Lt Side)|rewrite E in Ml]; lra. }
      pose proof (hh_incr p a ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (hh_pos p Hp). nra.
    - assert (c < p).
      { apply Rnot_le_lt. intros N. replace c' with c in Mr by (symmetry; apply Rmax_left; lra).
        destruct N as [Lt|E]; [pose proof (Rises p c Side Lt ltac:(lra))|rewrite <- E in Mr]; lra. }
      pose proof (hh_incr c p ltac:(lra) ltac:(lra) ltac:(lra)). pose proof (hh_pos c HB). nra. }
  destruct Near as (g & G & Near). exists (/ g ^ 2 - 1). assert (G2 : 0 < g ^ 2 < 1) by (split; [positive|nra]).
  assert (I : 1 < / g ^ 2) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). split; [lra|].
  intros m1 m2 H1 H2 Hd p Hp E. set (r := m2 / (m1 + m2)) in *. assert (Hr : g ^ 2 < r < 1).
  { split; [|unfold r; undivide (m1 + m2); lra]. unfold r. undivide (m1 + m2).
    apply Rlt_div_l in Hd; [|lra]. apply (Rmult_lt_compat_l (g ^ 2)) in Hd; [|lra].
    replace (g ^ 2 * ((/ g ^ 2 - 1) * m2)) with (m2 - g ^ 2 * m2) in Hd by (field; lra). lra. }
  assert (Rp : ratio p = sqrt r) by (pose proof (depth_pos p Hp); unfold ratio; rewrite E; field; lra).
  assert (S1 : g < sqrt r < 1). { rewrite <- Rp. pose proof (R0 p Hp). assert (ratio p ^ 2 = r) by (rewrite Rp, pow2_sqrt; lra). nra. }
  destruct (Near p Hp ltac:(lra)) as (Na & Nb). pose proof (hh_pos pa ltac:(lra)). pose proof (hh_pos p Hp).
  split; intros Side; split; auto.
  - assert (pa < p). { apply Rnot_le_lt. intros [Lt|Eq]; [pose proof (Falls p pa ltac:(lra) Lt ltac:(lra))|rewrite Eq in Rp]; lra. }
    pose proof (hh_incr pa p ltac:(lra) ltac:(lra) ltac:(lra)). nra.
  - assert (p < pb). { apply Rnot_le_lt. intros [Lt|Eq]; [pose proof (Rises pb p ltac:(lra) Lt ltac:(lra))|rewrite <- Eq in Rp]; lra. }
    pose proof (hh_incr p pb ltac:(lra) ltac:(lra) ltac:(lra)). nra.
Qed.
