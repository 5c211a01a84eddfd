(** From cycle to cycle: the exits of a solution are an orbit of the return map; the cycle time. *)
From InertialPair Require Import Dini Pair Stick Excursion ReturnMap TurningFunction FollowArc Cycle SlipFromGap.

(** each h > 0 is that of an angle *)
Lemma half_ex u : 0 < u -> {p | 0 < p < PI /\ hh p = u}.
Proof.
  intros Hu. set (p0 := Rmin 1 (u / 4)). pose proof PI2_1.
  assert (P0 : 0 < p0 /\ p0 <= 1 /\ p0 <= u / 4) by (repeat split; [positive|apply Rmin_l|apply Rmin_r]).
  destruct (push_ex 0 u p0) as (p & P); [lra| |exists p; rewrite <- push_0; auto]. rewrite push_0.
  pose proof (sin_half p0 ltac:(lra)) as S. pose proof (A_above p0 ltac:(lra)) as A.
  assert (0 < p0 ^ 2) by positive. assert (p0 ^ 2 / 4 <= sin p0 ^ 2) by nra.
  apply Rmult_lt_reg_r with (sin p0 ^ 2); [lra|].
  replace (hh p0 * sin p0 ^ 2) with (p0 - sin p0 * cos p0); [nra|unfold hh; field; lra].
Qed.
(** and each push from a gap, or outwards from a ray *)
Lemma push_at d u : 0 < d \/ d = 0 /\ 0 < u -> exists p, 0 < p < PI /\ push d p = u.
Proof.
  intros [D|(-> & U)]; [destruct (push_root d u D) as (p & P & _); eauto|]. destruct (half_ex u U) as (p & Hp & E).
  exists p. rewrite push_0. auto.
Qed.
(** the half angle by the push *)
Definition half u := match Rlt_dec 0 u with left Hu => proj1_sig (half_ex u Hu) | right _ => 1 end.
Lemma half_spec u : 0 < u -> 0 < half u < PI /\ hh (half u) = u.
Proof. intros Hu. unfold half. destruct (Rlt_dec 0 u); [|lra]. exact (proj2_sig (half_ex u r)). Qed.
(** h = pi/2 at p = pi/2 *)
Lemma hh_half_pi : hh (PI / 2) = PI / 2.
Proof. unfold hh. rewrite sin_PI2, cos_PI2. field. Qed.
(** h is monotone, both ways *)
Lemma hh_le p q : 0 < p < PI -> 0 < q < PI -> (hh p <= hh q <-> p <= q).
Proof. intros Hp Hq. apply (rising_iff PI hh p q hh_incr Hp Hq). Qed.

(** up to half angle pi/2 it lands inside the strip, moving to the other ray *)
Lemma depth_two p : 0 < p <= PI / 2 -> depth p <= 2.
Proof.
  intros Hp. pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (cos_ge_0 p ltac:(lra) ltac:(lra)) as C.
  undivide (sin p). nra.
Qed.
(** it comes back inwards: h < theta *)
Lemma back p : 0 < p <= PI / 2 -> hh p < 2 * p.
Proof.
  intros Hp. destruct (Req_dec p (PI / 2)) as [->|N]. { rewrite hh_half_pi. lra. }
  pose proof (sin_gt_0 p ltac:(lra) ltac:(lra)) as S. pose proof (g_pos (2 * p) ltac:(lra)) as G.
  rewrite cos_2a_sin, sin_2a in G. undivide (sin p ^ 2). nra.
Qed.

(** h/c decreases up to pi/2, because K > 0 there *)
Lemma ratio_falls p q : 0 < p -> p <= q -> q <= PI / 2 -> ratio q <= ratio p.
Proof.
  intros H0 [Lt|<-] Hq; [|lra]. pose proof PI2_3_2 as P3. destruct root as (ps & Hps & Z & Le & Ri).
  assert (Kh : 0 < K (PI / 2)).
  { unfold K. rewrite sin_PI2, cos_PI2. pose proof (sqrt_sqrt 2 ltac:(lra)). nra. }
  assert (PI / 2 < ps) by (apply Rnot_le_lt; intros [L|E]; [pose proof (Ri (PI / 2))|rewrite E in Z]; lra).
  apply Rlt_le, (ratio_step p q); [lra|lra|lra|]. intros t Ht. apply Le. lra.
Qed.
(** so an excursion shorter than one that ends above E_cr ends above it too *)
Lemma stays_above r p q : 0 < p -> p <= q -> q <= PI / 2 -> r * depth q ^ 2 < hh q ^ 2 -> r * depth p ^ 2 < hh p ^ 2.
Proof.
  intros Hp Hpq Hq I. pose proof (depth_pos p ltac:(lra)) as Dp. pose proof (depth_pos q ltac:(lra)) as Dq.
  pose proof (hh_pos q ltac:(lra)) as Hh. pose proof (ratio_falls p q Hp Hpq Hq) as R1.
  assert (Eq : hh q = ratio q * depth q) by (unfold ratio; field; lra).
  assert (Ep : hh p = ratio p * depth p) by (unfold ratio; field; lra). assert (R0 : 0 < ratio q) by nra.
  assert (R2 : ratio q ^ 2 <= ratio p ^ 2) by nra. rewrite Eq, Rpow_mult_distr in I.
  apply Rmult_lt_reg_r in I; [|positive]. rewrite Ep, Rpow_mult_distr. scale.
Qed.

(** acos is at most sqrt (8 (1 - z)) *)
Lemma acos_small z : -1 <= z <= 1 -> acos z ^ 2 <= 8 * (1 - z).
Proof.
  intros Hz. pose proof (acos_bound z) as B. pose proof (cos_acos z Hz) as C. set (a := acos z) in *.
  destruct (Req_dec a 0) as [->|N]. { lra. } replace a with (2 * (a / 2)) in C by field. rewrite cos_2a_sin in C.
    pose proof (sin_half (a / 2) ltac:(lra)) as S. nra.
Qed.

(** the sides alternate *)
Lemma sides k n : k = 1 \/ k = -1 -> k * (-1) ^ n = 1 \/ k * (-1) ^ n = -1.
Proof. intros Hk. induction n; simpl; [|destruct IHn; [right|left]]; lra. Qed.

Section Orbit.
Context (m1 m2 a2 b : R) (Hm1 : 0 < m1) (Hm2 : 0 < m2) (Ha2 : 0 < a2) (Hb : 0 < b).
Context (M := m1 + m2) (q := m1 / M) (r := m2 / M) (om := omega m1 m2 a2) (o1 := o1 m1 a2)
  (L := L m1 m2 a2 b) (Ecr := Ecr m1 m2 a2 b) (on_ray := on_ray m1 m2 a2 b) (amp := amp m1 m2)
  (q_pos : 0 < q := q_pos m1 m2 Hm1 Hm2) (r_pos : 0 < r := r_pos m1 m2 Hm1 Hm2)
  (qr : q + r = 1 := qr_one m1 m2 Hm1 Hm2) (om_pos : 0 < om := omega_pos m1 m2 a2 Hm1 Hm2 Ha2)
  (o1_pos : 0 < o1 := o1_pos m1 a2 Hm1 Ha2).

(** excursions up to theta = pi that land above E_cr, and the return map in the half angle *)
Definition ok p := 0 < p <= PI / 2 /\ r * depth p ^ 2 < hh p ^ 2.
(** the half angle of the next excursion *)
Definition next p := half (sqrt (hh p ^ 2 - r * depth p ^ 2)).
(** the time of a cycle: a slip, and a stick between two arc cosines *)
Definition cyc p := 2 * p / o1 + (acos (- / amp (hh (next p) ^ 2)) - acos ((1 - q * depth p) / amp (hh (next p) ^
  2))) / om.

(** 9/4 r h^2 < 1 is enough *)
Lemma ok_small p : 0 < p <= PI / 2 -> 9 / 4 * r * hh p ^ 2 < 1 -> ok p.
Proof.
  split; auto. assert (P : 0 < p < PI) by lra. pose proof (depth_pos p P) as D0. pose proof (depth_upper p P) as D1.
  assert (D2 : depth p ^ 2 <= (3 / 2 * hh p ^ 2) ^ 2) by nra. nra.
Qed.
(** the next excursion is one of them too, and its level is that of the return map *)
Lemma next_ok p : ok p -> ok (next p) /\ hh (next p) ^ 2 = hh p ^ 2 - r * depth p ^ 2.
Proof.
  intros (Hp & Hs). assert (P : 0 < p < PI) by lra. pose proof (hh_pos p P) as H0.
  assert (Y : 0 < hh p ^ 2 - r * depth p ^ 2) by lra. destruct (half_spec _ (sqrt_lt_R0 _ Y)) as (Hn & E).
  fold (next p) in Hn, E.
  assert (E2 : hh (next p) ^ 2 = hh p ^ 2 - r * depth p ^ 2) by (rewrite E, <- Rsqr_pow2, Rsqr_sqrt; lra). split; auto.
  assert (hh (next p) <= hh p) by nra. pose proof (proj1 (hh_le (next p) p Hn P) ltac:(lra)).
  split; [lra|]. apply (stays_above r (next p) p); lra.
Qed.
Lemma ok_pi p : ok p -> 0 < p < PI. Proof. intros (Hp & _). lra. Qed.

(** The cycle from ray to ray, on either side: slip with k (v1 - v2) < 0, then stick inside the strip. *)
Lemma cycle1 x v1 v2 s t0 p : solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> ok p -> on_ray 1 (hh p) x v1 v2 t0 ->
  2 * p / o1 <= cyc p < 2 * p / o1 + PI / om /\ on_ray (-1) (hh (next p)) x v1 v2 (t0 + cyc p) /\
  (forall u, 0 < u < 2 * p / o1 -> v1 (t0 + u) < v2 (t0 + u)) /\
  (forall u, 2 * p / o1 <= u <= cyc p -> v1 (t0 + u) = v2 (t0 + u) /\ - L <= x (t0 + u) <= L).
Proof.
  intros H Ht Hok HR. pose proof (ok_pi p Hok) as Hp. destruct (next_ok p Hok) as (Hn & E).
    pose proof (hh_pos _ (ok_pi _ Hn)) as H1.
  destruct (slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t0 p H Ht Hp HR) as (Sl & Lx & L1 & L2).
  fold o1 in Sl, Lx, L1, L2. set (t1 := t0 + 2 * p / o1) in *. assert (T1 : 0 < 2 * p / o1) by positive.
  destruct Hok as (Hok & _). pose proof (depth_two p Hok). pose proof (depth_pos p Hp). pose proof (back p Hok).
  assert (S := stick m1 m2 a2 b Hm1 Hm2 Ha2 Hb x v1 v2 s t1 (1 - q * depth p) (hh (next p)) H ltac:(unfold t1;
    lra) H1 Lx).
  destruct S as (St & Sr & Si).
  - split; nra.
  - pose proof (ray_pos m1 m2 a2 b Hm1 Hm2 Ha2 Hb (2 * p - hh p) ltac:(lra)). unfold ray in *. lra.
  - positive.
  - rewrite E. apply (ray_slip m1 m2 a2 b Hm1 Hm2 Ha2 Hb 1 x v1 v2 s t0 p (or_introl eq_refl) H Ht Hp HR).
  - fold om amp in St, Sr, Si. set (T :=
    (acos (- / amp (hh (next p) ^ 2)) - acos ((1 - q * depth p) / amp (hh (next p) ^ 2))) / om) in *.
    assert (C : cyc p = 2 * p / o1 + T) by auto. rewrite C.
    replace (t0 + (2 * p / o1 + T)) with (t1 + T) by (unfold t1; ring). split; [lra|]. split; [exact Sr|].
    split; [exact Sl|]. intros u Hu. replace (t0 + u) with (t1 + (u - 2 * p / o1)) by (unfold t1; ring). apply Si. lra.
Qed.

(** [cycle] From a ray with slip angle up to $\pi$ and $r\,c^2<h^2$ to the other ray: one slip and one stick, with the
    return map $y'=h^2-r\,c^2$. *)
Theorem cycle k x v1 v2 s t0 p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> ok p ->
  on_ray k (hh p) x v1 v2 t0 ->
  2 * p / o1 <= cyc p < 2 * p / o1 + PI / om /\ on_ray (- k) (hh (next p)) x v1 v2 (t0 + cyc p) /\
  (forall u, 0 < u < 2 * p / o1 -> k * v1 (t0 + u) < k * v2 (t0 + u)) /\
  (forall u, 2 * p / o1 <= u <= cyc p -> v1 (t0 + u) = v2 (t0 + u) /\ - L <= x (t0 + u) <= L).
Proof.
  intros Hk H Ht Hok HR. destruct (cycle1 _ _ _ _ t0 p (sided m1 m2 a2 b k _ _ _ _ Hk H) Ht Hok) as (A & B & C & D).
  { unfold on_ray, Cycle.on_ray in *. lra. }
  split; [auto|]. split; [unfold on_ray, Cycle.on_ray in *; lra|]. split; [auto|]. intros u Hu. specialize (D u Hu).
  destruct Hk; subst k; lra.
Qed.

(** the cycle time is pi / omega up to 6 sqrt q hh p / omega *)
Lemma om_o1 : om / o1 = sqrt q.
Proof.
  unfold om, o1, omega, Cycle.o1. rewrite <- sqrt_div_alt by positive. f_equal. unfold q, M.
    field. lra.
Qed.
(** [cycle-time] With slip angle up to $\pi$ and $r\,c^2<h^2$ the time of a cycle differs from $\pi/\Omega$ by at most
    $6\sqrt w/\Omega$. *)
Theorem cycle_time p : ok p -> Rabs (om * cyc p - PI) <= 6 * sqrt q * hh p.
Proof.
  intros Hok. pose proof (ok_pi p Hok) as Hp. destruct (next_ok p Hok) as (Hn & E).
  pose proof (hh_pos _ (ok_pi _ Hn)) as H1. pose proof (hh_pos p Hp) as H0. pose proof (depth_pos p Hp) as D0.
  pose proof (depth_upper p Hp) as D1. pose proof (hh_below p Hp) as Hb'. destruct Hok as (Hok & _).
  pose proof (depth_two p Hok) as D2. set (y1 := hh (next p) ^ 2) in *. assert (Y1 : 0 < y1) by positive.
  assert (Y2 : y1 <= hh p ^ 2) by nra. assert (R1 : 1 <= amp y1) by (apply amp_ge; auto; lra).
  assert (R2 : amp y1 * amp y1 = 1 + q * y1) by (apply amp_sq; auto; lra). unfold cyc. fold y1.
  set (rho := amp y1) in *. assert (R3 : rho - 1 <= q * y1 / 2) by nra. assert (Ir : 0 < / rho <= 1).
  { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  assert (I1 : rho * / rho = 1) by (apply Rinv_r; lra). rewrite acos_opp. set (A := acos (/ rho)).
  set (B := acos ((1 - q * depth p) / rho)). pose proof (acos_bound (/ rho)) as A0. fold A in A0.
  pose proof (acos_bound ((1 - q * depth p) / rho)) as B0. fold B in B0. pose proof (sqrt_pos q) as Q0.
  pose proof (sqrt_sqrt q ltac:(lra)) as Q1. assert (A1 : A <= 2 * sqrt q * hh p).
  { pose proof (acos_small (/ rho) ltac:(lra)) as S. fold A in S. assert (q * y1 <= q * hh p ^ 2) by nra.
    assert (A ^ 2 <= (2 * sqrt q * hh p) ^ 2) by nra. assert (0 <= sqrt q * hh p) by positive. nra. }
  assert (B1 : B <= 4 * sqrt q * hh p).
  { assert (Qd : 0 < q * depth p <= 2) by nra.
    pose proof (acos_small ((1 - q * depth p) / rho) ltac:(unfold Rdiv; split; nra)) as S. fold B in S. nra. }
  replace (om * (2 * p / o1 + (PI - A - B) / om) - PI) with (2 * p * (om / o1) - A - B) by (field; lra). rewrite om_o1.
  assert (0 <= 2 * p * sqrt q <= 3 * sqrt q * hh p) by nra. apply Rabs_le. lra.
Qed.

(** *** The exits of the solution *)
Fixpoint orb p n := match n with O => p | S n => next (orb p n) end.
(** the times of the exits *)
Fixpoint tim t0 p n := match n with O => t0 | S n => tim t0 p n + cyc (orb p n) end.
(** the orbit stays among them *)
Lemma orb_ok p n : ok p -> ok (orb p n).
Proof. intros Hp. induction n; simpl; auto. apply next_ok; auto. Qed.
(** a cycle is longer than its slip *)
Lemma cyc_long p : ok p -> 0 < 2 * p / o1 < cyc p.
Proof.
  intros Hp. pose proof (ok_pi _ Hp). split; [positive|]. destruct Hp as (Hp & _). pose proof (depth_two p Hp).
  pose proof (depth_pos p ltac:(lra)).
  assert (R1 : 1 <= amp (hh (next p) ^ 2)) by (apply amp_ge; auto; apply pow2_ge_0). unfold cyc.
  set (rho := amp (hh (next p) ^ 2)) in *. assert (Ir : 0 < / rho <= 1). { split; [apply Rinv_0_lt_compat; lra|].
    rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
  pose proof (acos_bound (- / rho)). pose proof (acos_bound ((1 - q * depth p) / rho)).
  assert (Qd : 0 < q * depth p < 2) by nra. assert (- / rho < (1 - q * depth p) / rho <= 1) by nra.
  assert (acos ((1 - q * depth p) / rho) < acos (- / rho)).
  { apply cos_decreasing_0; try lra. rewrite !cos_acos by lra. lra. }
  apply Rminus_lt_0. replace (_ - _) with ((acos (- / rho) - acos ((1 - q * depth p) / rho)) / om) by ring.
  apply Rdiv_lt_0_compat; lra.
Qed.
(** the exit times do not decrease *)
Lemma tim_mono t0 p n : ok p -> tim t0 p n <= tim t0 p (S n).
Proof. intros Hp. simpl. pose proof (cyc_long _ (orb_ok p n Hp)). lra. Qed.
Lemma tim_start t0 p n : ok p -> t0 <= tim t0 p n.
Proof. intros Hp. induction n; [simpl; lra|]. pose proof (tim_mono t0 p n Hp). lra. Qed.

(** [exits] From a ray with slip angle up to $\pi$ and $r\,c^2<h^2$ the exits of a solution follow the orbit of the
    return map. *)
Theorem exits k x v1 v2 s t0 p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> ok p ->
  on_ray k (hh p) x v1 v2 t0 ->
  forall n, on_ray (k * (-1) ^ n) (hh (orb p n)) x v1 v2 (tim t0 p n).
Proof.
  intros Hk H Ht Hp HR n. induction n as [|n IH]; [rewrite Rmult_1_r; auto|].
  replace (k * (-1) ^ S n) with (- (k * (-1) ^ n)) by (simpl; ring).
  apply (cycle (k * (-1) ^ n) x v1 v2 s (tim t0 p n) (orb p n)); auto using sides, orb_ok.
  pose proof (tim_start t0 p n Hp). lra.
Qed.
(** [ray-energy] On an exit ray with the exit speed $h$ the energy is $E_{cr}(1+q\,h^2)$. *)
Lemma ray_energy k u x v1 v2 t : k = 1 \/ k = -1 -> on_ray k u x v1 v2 t ->
  energy m1 m2 a2 (x t) (v1 t) (v2 t) = Ecr * (1 + q * u ^ 2).
Proof.
  intros Hk (Ex & E1 & E2). unfold Ecr, q, M. rewrite <- (ray_level m1 m2 a2 b Hm1 Hm2 Ha2 u).
  rewrite <- Ex, <- E1 at 1. rewrite <- E2. symmetry. apply energy_side; auto.
Qed.
(** [exit-energy] Along the orbit of exits the energy at each is $E_{cr}(1+q\,y)$. *)
Theorem exit_energy k x v1 v2 s t0 p : k = 1 \/ k = -1 -> solution m1 m2 0 a2 b x v1 v2 s -> 0 <= t0 -> ok p ->
  on_ray k (hh p) x v1 v2 t0 ->
  forall n, energy m1 m2 a2 (x (tim t0 p n)) (v1 (tim t0 p n)) (v2 (tim t0 p n)) = Ecr * (1 + q * hh (orb p n) ^ 2).
Proof.
  intros Hk H Ht Hp HR n. apply (ray_energy (k * (-1) ^ n)); [apply sides|apply (exits k x v1 v2 s t0 p)]; auto.
Qed.
End Orbit.
