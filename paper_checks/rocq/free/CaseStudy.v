(** The paper's case study, m1 = m2 = 1, a1 = 0, a2 = 200, without a control: what its equations (11), (12), which have
    no stiction bracket, have in common with (3), (4) and with Coulomb's law, and what else they admit. *)
From InertialPair Require Import Dini Pair Stick Pursuit SwitchingSurface StartFromRest AlmostEverywhere Filippov
  Switching.

(** (11), (12) at one time: a and a' are the accelerations *)
Definition case_study b (x v1 v2 : R -> R) t := exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\
  is_derive v2 t a' /\ a = - (/ (2 - Rabs (sgn (v1 t - v2 t))) * (200 * x t + b * sgn (v1 t - v2 t))) /\
  a' = (1 - Rabs (sgn (v1 t - v2 t))) * a + b * sgn (v1 t - v2 t).

Section CaseStudy.
Context (b : R) (Hb : 0 < b).
Context (no_force := fun _ : R => 0) (law := filippov 1 1 0 200 b no_force).

(** [case-study-reduction] Case study: (3), (4) at one time are (11) and, in slip or where $|x_1|<b/100$, (12); with
    $v_1=v_2$ body 2 has no acceleration where $|x_1|>b/100$, and half of body 1's where $|x_1|=b/100$. *)
Theorem reduction (x v1 v2 : R -> R) t : switched 1 1 0 200 b no_force x v1 v2 t <->
  exists a a' : R, is_derive x t (v1 t) /\ is_derive v1 t a /\ is_derive v2 t a' /\
    a = - (/ (2 - Rabs (sgn (v1 t - v2 t))) * (200 * x t + b * sgn (v1 t - v2 t))) /\
    (v1 t <> v2 t \/ Rabs (x t) < b / 100 ->
      a' = (1 - Rabs (sgn (v1 t - v2 t))) * a + b * sgn (v1 t - v2 t)) /\
    (v1 t = v2 t -> b / 100 < Rabs (x t) -> a' = 0) /\ (v1 t = v2 t -> Rabs (x t) = b / 100 -> a' = a / 2).
Proof.
  assert (N1 : Rabs (-1) = 1) by (rewrite Rabs_left; lra).
  assert (St : forall a y : R, a = - (/ 2 * (200 * y)) -> Rabs a = 100 * Rabs y).
  { intros a y ->. replace (- (/ 2 * (200 * y))) with (-100 * y) by field. rewrite Rabs_mult, (Rabs_left (-100)); lra. }
  split; intros (a & a' & Dx & D1 & D2 & E); exists a, a'; (split; [auto|split; [auto|split; [auto|]]]);
    destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S, ?Rabs_R0, ?Rabs_R1, ?N1 in *;
      unfold no_force in *.
  1, 2: destruct E as (E3 & E4); split; [lra|]; split; [intros _; lra|]; split; intros; lra.
  - destruct E as (E3 & E4). assert (Ea : a = - (/ (2 - 0) * (200 * x t + b * 0))) by lra. split; [exact Ea|].
    pose proof (St a (x t) ltac:(lra)) as Abs.
    destruct (sgn_cases (Rabs a - b / 1)) as [(Q & Z)|[(Q & Z)|(Q & Z)]]; rewrite Z in E4;
      (split; [intros [N|N]; [exfalso; apply N|]|split; intros _ N]); lra.
  - split; lra.
  - split; lra.
  - destruct E as (E1 & E2 & E3 & E4). pose proof (St a (x t) ltac:(lra)) as Abs. split; [lra|].
    destruct (sgn_cases (Rabs a - b / 1)) as [(Q & ->)|[(Q & ->)|(Q & ->)]];
      [rewrite E3 by lra|rewrite E2 by (right; lra)|rewrite E4 by lra]; lra.
Qed.

(** [law-satisfies-case-study] Case study: every Filippov solution satisfies (11), (12) at almost every time. *)
Theorem law_case_study x v1 v2 : law x v1 v2 -> almost (case_study b x v1 v2).
Proof.
  intros F. pose proof (proj2 (switching_iff 1 1 0 200 b ltac:(lra) ltac:(lra) ltac:(lra) Hb x v1 v2) F) as Sw.
  pose proof (proj1 (forced_switching_iff 1 1 0 200 b ltac:(lra) ltac:(lra) Hb _ x v1 v2) Sw) as (_ & Le).
  destruct Sw as (_ & _ & _ & Sw). generalize (almost_and _ _ Sw Le). apply almost_impl. intros t _ (S & L).
  apply reduction in S. destruct S as (a & a' & Dx & D1 & D2 & E1 & E2 & _). exists a, a'.
  repeat (split; [assumption|]). apply E2. unfold ModeAtContact.load in L.
  replace (1 * (0 - 200 * x t - 0 * v1 t) / (1 + 1)) with (-100 * x t) in L by field.
  rewrite Rabs_mult, (Rabs_left (-100)) in L by lra. lra.
Qed.

(** *** A stick that is kept wherever the velocities are equal *)
Definition kept (v1 v2 : R -> R) := forall r t, 0 <= r <= t -> v1 r = v2 r -> v1 t = v2 t.

Lemma ac_square f : ac f -> ac (fun t => f t * f t).
Proof.
  intros F T HT e He. destruct (cont_bounded f T (cont_ac f F) HT) as (A & HA). pose proof (HA 0 ltac:(lra)).
  pose proof (Rabs_pos (f 0)). set (k := 2 * A + 1). assert (Hk : 0 < e / k) by (unfold k; positive).
  destruct (F T HT _ Hk) as (d & Hd & K). exists d. split; auto. intros l C L. specialize (K l C L).
  assert (M : forall l lo, 0 <= lo -> chain l lo T -> moves (fun t => f t * f t) l <= k * moves f l).
  { clear l C L K. induction l as [|(p, q) l IH]; simpl; intros lo Hlo C; [lra|]. destruct C as (Hp & C).
    pose proof (chain_le _ _ _ C). specialize (IH q ltac:(lra) C).
    assert (Rabs (f q * f q - f p * f p) <= k * Rabs (f q - f p)); [|lra].
    replace (f q * f q - f p * f p) with ((f q + f p) * (f q - f p)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos|]. eapply Rle_trans; [apply Rabs_triang|].
    pose proof (HA q ltac:(lra)).
    pose proof (HA p ltac:(lra)). unfold k. lra. }
  specialize (M l 0 ltac:(lra) C). apply Rle_div_r in K; unfold k in *; lra.
Qed.

(** Coulomb's law until a time: one motion *)
Lemma same_until x v1 v2 y w1 w2 T : 0 <= T -> ac x -> ac v1 -> ac v2 -> ac y -> ac w1 -> ac w2 ->
  x 0 = y 0 -> v1 0 = w1 0 -> v2 0 = w2 0 ->
  almost (fun t => t < T -> included 1 1 0 200 b no_force x v1 v2 t /\ included 1 1 0 200 b no_force y w1 w2 t) ->
  forall t, 0 <= t <= T -> x t = y t /\ v1 t = w1 t /\ v2 t = w2 t.
Proof.
  intros HT Ax A1 A2 By B1 B2 X0 V0 W0 In t Ht.
  set (D := fun t => 200 * ((x t - y t) * (x t - y t)) + ((v1 t - w1 t) * (v1 t - w1 t) + (v2 t - w2 t) * (v2 t - w2 t))).
  assert (Sub : forall f g, ac f -> ac g -> ac (fun t => f t - g t)).
  { intros f g F G. apply ac_ext with (fun t => f t + -1 * g t); [intros; ring|]. apply ac_plus, ac_scal; auto. }
  assert (AD : ac D) by (unfold D; repeat apply ac_plus; try apply ac_scal; apply ac_square; auto).
  destruct (almost_and _ _ (almost_not T) In T HT) as (N & HN & Q).
  assert (Le : - D 0 <= - D t).
  { apply (ac_grows (fun t => -1 * D t) (fun t => Derive (fun t => -1 * D t) t) N 0 t) in HN; [lra|apply ac_scal; auto|lra|].
    intros r Hr Nr. destruct (Q r ltac:(lra) Nr) as (Ne & I). destruct I as ((g & Hg & Gp & Gn & Dx & D1 & D2) &
      h & Hh & Hp & Hn & Ex & E1 & E2); [lra|].
    assert (DD : is_derive (fun t => -1 * D t) r (2 * b * ((g - h) * ((v1 r - v2 r) - (w1 r - w2 r))))).
    { unfold D. auto_derive; [repeat split; eexists; eauto|]. assert (Un : forall (f : R -> R) (l : R), is_derive f r l
        -> Derive (fun q => f q) r = l) by (intros f l Df; apply is_derive_unique, Df).
      rewrite (Un _ _ Dx), (Un _ _ D1), (Un _ _ D2), (Un _ _ Ex), (Un _ _ E1), (Un _ _ E2). field. }
    split; [apply Derive_correct; eexists; exact DD|]. eapply Rle_trans; [|right; symmetry; exact (is_derive_unique _ _ _ DD)].
    apply Rmult_le_pos; [lra|].
    destruct (Rtotal_order (v1 r) (v2 r)) as [O|[O|O]]; [rewrite (Gn O) in *| |rewrite (Gp O) in *];
      (destruct (Rtotal_order (w1 r) (w2 r)) as [O'|[O'|O']]; [rewrite (Hn O') in *| |rewrite (Hp O') in *]); nra. }
  assert (D0 : D 0 = 0) by (unfold D; rewrite X0, V0, W0; ring). unfold D in Le at 2.
  pose proof (Rle_0_sqr (x t - y t)) as P1. pose proof (Rle_0_sqr (v1 t - w1 t)) as P2.
  pose proof (Rle_0_sqr (v2 t - w2 t)) as P3. unfold Rsqr in *.
  repeat split; apply Rminus_diag_uniq, Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(** [case-study-agrees-until] Case study: a solution of (11), (12) that keeps every stick agrees with the Filippov
    solution up to $T$ exactly if at no time before $T$ it has $v_1=v_2$ and $|x_1|>b/100$. *)
Theorem agree_until x v1 v2 y w1 w2 T : 0 <= T -> ac x -> ac v1 -> ac v2 -> almost (case_study b x v1 v2) -> kept v1 v2 ->
  law y w1 w2 -> x 0 = y 0 -> v1 0 = w1 0 -> v2 0 = w2 0 ->
  ((forall t, 0 <= t <= T -> x t = y t /\ v1 t = w1 t /\ v2 t = w2 t) <->
    forall r, 0 <= r < T -> v1 r = v2 r -> Rabs (x r) <= b / 100).
Proof.
  intros HT Ax A1 A2 Cs Kp F X0 V0 W0. split.
  - intros Eq r Hr E. apply Rnot_lt_le. intros Out.
    destruct (proj1 (filippov_iff 1 1 0 200 b ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) Hb y w1 w2) F) as (s & H).
    destruct (Eq r ltac:(lra)) as (Ex & Ev & Ew).
    destruct (slips_beyond 1 1 200 b ltac:(lra) ltac:(lra) ltac:(lra) Hb y w1 w2 s H r ltac:(lra) ltac:(lra)) as (d & Hd & Sl).
    { replace (L 1 1 200 b) with (b / 100) by (unfold L; field). intros In. rewrite Ex in Out.
      pose proof (Rabs_le (y r) (b / 100) In). lra. }
    set (t := Rmin (r + d / 2) T). pose proof (Rmin_l (r + d / 2) T). pose proof (Rmin_r (r + d / 2) T).
    assert (r < t) by (apply Rmin_glb_lt; lra). fold t in H0, H1. specialize (Sl t ltac:(lra)).
    destruct (Eq t ltac:(lra)) as (_ & Ev' & Ew'). rewrite <- Ev', <- Ew', (Kp r t ltac:(lra) E), Rminus_diag_eq in Sl by auto.
    lra.
  - intros In. pose proof F as (By & B1 & B2 & Il). apply same_until; auto.
    generalize (almost_and _ _ Cs Il). apply almost_impl. intros t Ht ((a & a' & Dx & D1 & D2 & E1 & E2) & It) Lt.
    split; [|exact It].
    destruct (sgn_cases (v1 t - v2 t)) as [(W & S)|[(W & S)|(W & S)]]; rewrite S in *.
    + rewrite Rabs_R1 in *. exists 1. split; [lra|split; [lra|split; [lra|split; [auto|]]]]. unfold no_force.
      split; [match goal with |- is_derive _ _ ?z => replace z with a by lra end|
        replace (b * 1 / 1) with a' by lra]; auto.
    + replace (Rabs (-1)) with 1 in * by (rewrite Rabs_left; lra). exists (-1). split; [lra|split; [lra|split; [lra|split; [auto|]]]].
      unfold no_force. split; [match goal with |- is_derive _ _ ?z => replace z with a by lra end|
        replace (b * -1 / 1) with a' by lra]; auto.
    + rewrite Rabs_R0 in *. specialize (In t ltac:(lra) ltac:(lra)). apply Rabs_inv in In. exists (a / b).
      split; [split; undivide b; lra|]. split; [lra|]. split; [lra|]. split; [auto|]. unfold no_force.
      assert (Ba : b * (a / b) = a) by (field; lra).
      split; [match goal with |- is_derive _ _ ?z => replace z with a by (rewrite Ba; lra) end|
        replace (b * (a / b) / 1) with a' by (rewrite Ba; lra)]; auto.
Qed.
End CaseStudy.

(** *** The start of Fig. 4 (a), at rest at 6 mm, b = 1/2: two solutions of (11), (12), of which one is Coulomb's. *)
Definition six (x v1 v2 : R -> R) := x 0 = 6 / 1000 /\ v1 0 = 0 /\ v2 0 = 0.
(** [two-solutions-from-6-mm] Case study, $b=0.5$, from rest at 6 mm: the stuck $x_1=0.006\cos 10t$ satisfies (11),
    (12), and so does a Filippov solution that slips at once, the only one of (3), (4) and of the inclusion. *)
Theorem two_from_six : let x t := 6 / 1000 * cos (10 * t) in let v t := - (6 / 100 * sin (10 * t)) in
  (six x v v /\ ac x /\ ac v /\ forall t, case_study (1 / 2) x v v t) /\
  exists x v1 v2 T, six x v1 v2 /\ filippov 1 1 0 200 (1 / 2) (fun _ => 0) x v1 v2 /\
    almost (case_study (1 / 2) x v1 v2) /\ 0 < T /\ (forall t, 0 < t < T -> v1 t < v2 t) /\
    forall y w1 w2, six y w1 w2 -> switching 1 1 0 200 (1 / 2) (fun _ => 0) y w1 w2 \/
      filippov 1 1 0 200 (1 / 2) (fun _ => 0) y w1 w2 -> forall t, 0 <= t -> y t = x t /\ w1 t = v1 t /\ w2 t = v2 t.
Proof.
  intros x v. assert (Dx : forall t, is_derive x t (v t)) by (intros t; unfold x, v; auto_derive; auto; field).
  assert (Dv : forall t, is_derive v t (-100 * x t)) by (intros t; unfold x, v; auto_derive; auto; field).
  assert (Cx : cont x) by exact (cont_of_derive x v Dx).
  assert (Cv : cont v) by exact (cont_of_derive v _ Dv). split.
  - split; [unfold six, x, v; rewrite Rmult_0_r, cos_0, sin_0; lra|].
    split; [apply (ac_of_rderiv x v); auto; intros; apply rderiv_of_derive, Dx|].
    split; [apply (ac_of_rderiv v (fun t => -100 * x t)); auto using cont_scal; intros; apply rderiv_of_derive, Dv|].
    intros t. exists (-100 * x t), (-100 * x t). split; [apply Dx|split; [apply Dv|split; [apply Dv|]]].
    replace (v t - v t) with 0 by ring. destruct (sgn_cases 0) as [(L & _)|[(L & _)|(_ & ->)]]; try lra.
    rewrite Rabs_R0. split; field.
  - destruct (filippov_well_posed 1 1 0 200 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) (6 / 1000) 0 0)
      as (y & w1 & w2 & (F & Y0 & W1 & W2) & Only).
    pose proof F as G. apply filippov_iff in G; try lra. destruct G as (s & G).
    destruct (six_millimetres y w1 w2 s G Y0 W1 W2) as (T & HT & Sl). exists y, w1, w2, T.
    split; [repeat split; auto|split; [auto|]]. split; [apply law_case_study; [lra|auto]|]. split; [auto|split; [auto|]].
    intros y' w1' w2' (P1 & P2 & P3) [Sw|F'].
    + apply Only; auto. apply (switching_iff 1 1 0 200 (1 / 2)) in Sw; auto; lra.
    + apply Only; auto.
Qed.

(** *** The ring of Fig. 1: stuck pairs that differ in the place of body 2 keep their distance. Motion from rest at
    4 mm, b = 1/2, body 2 at 0 and at 1 mm: no region narrower than 1 mm is reached by both relative motions. *)

(** [ring-missed] Case study, $b=0.5$, from rest at 4 mm, body 2 at 0 or at 1 mm: both pairs stick permanently, 4 and
    3 mm apart, and no region narrower than 1 mm is reached by both relative motions. *)
Theorem ring_missed x v1 v2 s y x' v1' v2' s' y' : solution 1 1 0 200 (1 / 2) x v1 v2 s ->
  solution 1 1 0 200 (1 / 2) x' v1' v2' s' -> cont y -> (forall t, 0 <= t -> rderiv y t (v2 t)) -> cont y' ->
  (forall t, 0 <= t -> rderiv y' t (v2' t)) -> x 0 = 4 / 1000 -> v1 0 = 0 -> v2 0 = 0 -> y 0 = 0 ->
  x' 0 = 4 / 1000 -> v1' 0 = 0 -> v2' 0 = 0 -> y' 0 = 1 / 1000 ->
  (forall t, 0 <= t -> v1 t = v2 t /\ x t - y t = 4 / 1000 /\ v1' t = v2' t /\ x' t - y' t = 3 / 1000) /\
  forall region : R -> R -> Prop, (forall z w z' w', region z w -> region z' w' -> Rabs (z - z') < 1 / 1000) ->
  forall t t', 0 <= t -> 0 <= t' -> ~ (region (x t - y t) (v1 t - v2 t) /\ region (x' t' - y' t') (v1' t' - v2' t')).
Proof.
  intros H H' Cy Dy Cy' Dy' X0 V0 W0 Y0 X0' V0' W0' Y0'.
  assert (Rest : forall x v1 v2 s y, solution 1 1 0 200 (1 / 2) x v1 v2 s -> cont y ->
    (forall t, 0 <= t -> rderiv y t (v2 t)) -> x 0 = 4 / 1000 -> v1 0 = 0 -> v2 0 = 0 ->
    forall t, 0 <= t -> v1 t = v2 t /\ x t - y t = 4 / 1000 - y 0).
  { clear. intros x v1 v2 s y H Cy Dy X0 V0 W0 t Ht. pose proof (five_millimetres x v1 v2 s H V0 W0 ltac:(lra)) as St.
    split; [apply St; auto|]. cut (x t - y t - (x 0 - y 0) = 0 * (t - 0)); [lra|].
    apply (rderiv_line (fun t => x t - y t)); [apply cont_minus; [apply (s_cx _ _ _ _ _ _ _ _ _ H)|auto]|lra|].
    intros r Hr. apply rderiv_eq with (v1 r - v2 r); [rewrite (St r) by lra; ring|].
    apply rderiv_minus; [apply (s_x _ _ _ _ _ _ _ _ _ H)|apply Dy]; lra. }
  pose proof (Rest x v1 v2 s y H Cy Dy X0 V0 W0) as A. pose proof (Rest x' v1' v2' s' y' H' Cy' Dy' X0' V0' W0') as B.
  split.
  - intros t Ht. destruct (A t Ht), (B t Ht). repeat split; auto; lra.
  - intros region Narrow t t' Ht Ht' (P & Q). specialize (Narrow _ _ _ _ P Q). destruct (A t Ht), (B t' Ht').
    apply Rabs_def2 in Narrow. lra.
Qed.
