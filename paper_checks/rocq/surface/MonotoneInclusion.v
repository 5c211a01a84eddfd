(** Dry friction in any number of directions: y' in A y + g - d phi (y), where -A is monotone and phi any function, in a
    space whose inner product gives the energy, |y|^2 / 2. Everything enters by its impulse, so that jumps are allowed;
      the
    inner product need not be definite. Two motions never part, and defects add up; friction that brakes has a finite
      path. *)
From InertialPair Require Import Dini PaidRates Forced.

(** *** The space *)

(** a symmetric, bilinear, nonnegative form *)
Record inner {Y : ModuleSpace R_AbsRing} (ip : Y -> Y -> R) : Prop := {
  ip_sym : forall y z, ip y z = ip z y;
  ip_plus : forall y z w, ip (plus y z) w = ip y w + ip z w;
  ip_scal : forall c y z, ip (scal c y) z = c * ip y z;
  ip_pos : forall y, 0 <= ip y y }.

Section Space.
Context {Y : ModuleSpace R_AbsRing}.
Context (ip : Y -> Y -> R) (In : inner ip).

(** the norm *)
Definition norm y := sqrt (ip y y).
(** f(h) = o(h) *)
Definition vlittle (f : R -> Y) := forall eps, 0 < eps -> exists d, 0 < d /\ forall h, 0 < h < d -> norm (f h) <= eps *
  h.
(** l is the right derivative *)
Definition vderiv (f : R -> Y) t l := vlittle (fun h => minus (minus (f (t + h)) (f t)) (scal h l)).
(** continuity *)
Definition vcont (f : R -> Y) := forall t, 0 <= t -> forall e, 0 < e -> exists d, 0 < d /\ forall u, 0 <= u -> Rabs (u -
  t) < d ->
  norm (minus (f u) (f t)) < e.

(** P is at the time t the impulse of a subgradient of phi at y *)
Definition drags (phi : Y -> R) (P : R -> Y) y t := forall z e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  ip (minus (P (t + h)) (P t)) (minus z y) <= h * (phi z - phi y + e).
(** P is at the time t the impulse of a friction with a power of at least c *)
Definition brakes c (P : R -> Y) y t := forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  (c - e) * h <= ip (minus (P (t + h)) (P t)) y.
(** -A is monotone: it takes energy from the difference of two states *)
Definition monotone (A : Y -> Y) := forall y z, ip (minus (A y) (A z)) (minus y z) <= 0.

(** y moves by A, a drive with the impulse G and a bounded friction with the impulse P *)
Record driven (A : Y -> Y) (G P y : R -> Y) : Prop := {
  d_lip : exists K, forall r t, 0 <= r <= t -> norm (minus (P t) (P r)) <= K * (t - r);
  d_cont : vcont y;
  d_rate : forall t, 0 <= t -> vderiv (fun r => minus (plus (y r) (P r)) (G r)) t (A (y t)) }.
(** and the friction is a subgradient of phi *)
Definition motion A phi G P y := driven A G P y /\ forall t, 0 <= t -> drags phi P (y t) t.

Lemma ip_opp y z : ip (opp y) z = - ip y z.
Proof.
  rewrite <- (scal_opp_one y). rewrite (ip_scal _ In). change (opp one * ip y z = - ip y z). unfold opp, one; simpl.
    ring.
Qed.
Lemma ip_minus y z w : ip (minus y z) w = ip y w - ip z w.
Proof. unfold minus. rewrite (ip_plus _ In), ip_opp. ring. Qed.
Ltac lin := rewrite ?ip_minus, ?(ip_plus _ In), ?(ip_scal _ In), ?ip_minus, ?(ip_plus _ In), ?(ip_scal _ In), ?ip_minus,
  ?(ip_plus _ In).

(** Cauchy and Schwarz *)
Lemma cauchy y z : ip y z <= norm y * norm z.
Proof.
  assert (Q : forall c, 0 <= ip y y + 2 * c * ip y z + c ^ 2 * ip z z).
  { intros c. pose proof (ip_pos _ In (plus y (scal c z))) as P. rewrite (ip_plus _ In), (ip_scal _ In) in P.
    rewrite (ip_sym _ In y (plus _ _)), (ip_sym _ In z (plus _ _)), !(ip_plus _ In), !(ip_scal _ In) in P.
    rewrite (ip_sym _ In z y) in P. lra. }
  pose proof (ip_pos _ In y). pose proof (ip_pos _ In z). unfold norm. rewrite <- sqrt_mult by auto.
  destruct (Rle_dec (ip y z) 0). { eapply Rle_trans; [eassumption|apply sqrt_pos]. }
  rewrite <- (sqrt_Rsqr (ip y z)) by lra. apply sqrt_le_1_alt. unfold Rsqr. destruct (Req_dec (ip z z) 0) as [Z|N].
  - specialize (Q (- (ip y y + 1) / (2 * ip y z))). rewrite Z in Q.
    replace (ip y y + 2 * (- (ip y y + 1) / (2 * ip y z)) * ip y z + (- (ip y y + 1) / (2 * ip y z)) ^ 2 * 0) with (-1)
      in Q by (field; lra). lra.
  - specialize (Q (- ip y z / ip z z)). apply Rmult_le_compat_r with (r := ip z z) in Q; auto.
    replace ((ip y y + 2 * (- ip y z / ip z z) * ip y z + (- ip y z / ip z z) ^ 2 * ip z z) * ip z z) with
      (ip y y * ip z z - ip y z * ip y z) in Q by (field; lra). lra.
Qed.
Lemma norm_pos y : 0 <= norm y. Proof. apply sqrt_pos. Qed.
Lemma norm_sq y : norm y * norm y = ip y y. Proof. apply sqrt_sqrt, (ip_pos _ In). Qed.
(** a norm from what a vector does to the others *)
Lemma norm_by u c : 0 <= c -> (forall w, ip u w <= c * norm w) -> norm u <= c.
Proof.
  intros Hc K. specialize (K u). rewrite <- norm_sq in K. pose proof (norm_pos u).
  destruct (Req_dec (norm u) 0) as [->|]; auto. apply Rmult_le_reg_r with (norm u); lra.
Qed.
Lemma cauchy_abs y z : Rabs (ip y z) <= norm y * norm z.
Proof.
  apply Rabs_le. split; [|apply cauchy]. pose proof (cauchy (opp y) z) as Q. rewrite ip_opp in Q.
  assert (norm (opp y) = norm y); [|rewrite H in Q; lra]. unfold norm. rewrite ip_opp, (ip_sym _ In), ip_opp. f_equal.
    ring.
Qed.

Lemma norm_swap y z : norm (minus y z) <= norm (minus z y).
Proof.
  apply norm_by; [apply norm_pos|]. intros w. pose proof (cauchy_abs (minus z y) w) as C. apply Rabs_inv in C.
  rewrite !ip_minus in *. lra.
Qed.

(** the increment of the energy *)
Lemma energy_increment y P t l : vderiv (fun r => plus (y r) (P r)) t l ->
  big (fun h => norm (minus (P (t + h)) (P t))) ->
  little (fun h => ip (y (t + h)) (y (t + h)) / 2 - ip (y t) (y t) / 2 - h * ip l (y t) + ip (minus (P (t + h)) (P t))
    (y t)).
Proof.
  intros D (K & dP & HK & HdP & LP). set (er := fun h => minus (minus (plus (y (t + h)) (P (t + h))) (plus (y t) (P t)))
    (scal h l)) in D.
  set (dy := fun h => minus (y (t + h)) (y t)).
  assert (Ey : forall h w, ip (dy h) w = ip (er h) w + h * ip l w - ip (minus (P (t + h)) (P t)) w).
  { intros h w. unfold dy, er. lin. ring. }
  assert (B : big (fun h => norm (dy h))).
  { destruct (D 1 Rlt_0_1) as (d & Hd & Q). pose proof (norm_pos l). exists (1 + norm l + K), (Rmin d dP).
    split; [lra|]. split; [positive|]. intros h Hh. pose proof (Rmin_l d dP). pose proof (Rmin_r d dP).
    rewrite Rabs_pos_eq by apply norm_pos. apply norm_by; [nra|]. intros w.
    rewrite Ey. pose proof (norm_pos w) as Pw. pose proof (cauchy (er h) w) as C1. pose proof (cauchy l w) as C2.
    pose proof (cauchy_abs (minus (P (t + h)) (P t)) w) as C3. apply Rabs_inv in C3.
    assert (norm (er h) * norm w <= h * norm w) by (apply Rmult_le_compat_r; [auto|specialize (Q h ltac:(lra)); unfold
      er in *; lra]).
    assert (h * ip l w <= h * (norm l * norm w)) by scale.
    assert (norm (minus (P (t + h)) (P t)) * norm w <= K * h * norm w).
    { apply Rmult_le_compat_r; auto. specialize (LP h ltac:(lra)). rewrite Rabs_pos_eq in LP by apply norm_pos. auto. }
    lra. }
  assert (E1 : little (fun h => ip (er h) (y t))).
  { intros e He. pose proof (norm_pos (y t)). destruct (D (e / (norm (y t) + 1))) as (d & Hd & Q); [apply
    Rdiv_lt_0_compat; lra|].
    exists d; split; auto. intros h Hh. eapply Rle_trans; [apply cauchy_abs|]. specialize (Q h Hh). fold (er h) in Q.
    assert (e / (norm (y t) + 1) * norm (y t) <= e).
    { apply Rmult_le_reg_r with (norm (y t) + 1); [lra|].
      replace (e / (norm (y t) + 1) * norm (y t) * (norm (y t) + 1)) with (e * norm (y t)) by (field; lra). nra. }
    apply Rmult_le_compat_r with (r := norm (y t)) in Q; auto. assert (0 < h) by lra. nra. }
  eapply little_ext; [|exact (little_plus _ _ E1 (little_scal (/ 2) _ (big_mult _ _ B B)))]. intros h. cbv beta.
  rewrite norm_sq. assert (Q : ip (y (t + h)) (y (t + h)) = ip (y t) (y t) + 2 * ip (dy h) (y t) + ip (dy h) (dy h)).
  { unfold dy. rewrite !ip_minus. rewrite (ip_sym _ In (y (t + h)) (minus _ _)), (ip_sym _ In (y t) (minus _ _)),
    !ip_minus. rewrite (ip_sym _ In (y (t + h)) (y t)). ring. }
  rewrite Q, (Ey h (y t)). field.
Qed.

Lemma cont_energy y : vcont y -> cont (fun t => ip (y t) (y t) / 2).
Proof.
  intros C. assert (N : cont (fun t => norm (y t))).
  { intros t Ht e He. destruct (C t Ht e He) as (d & Hd & K). exists d; split; auto. intros u Hu Hd'. specialize (K u Hu
    Hd'). assert (T : forall a b, norm a <= norm (minus a b) + norm b).
    { intros a b. pose proof (norm_pos (minus a b)). pose proof (norm_pos b). apply norm_by; [lra|]. intros w.
      pose proof (cauchy (minus a b) w) as C1. pose proof (cauchy b w). rewrite ip_minus in C1. lra. }
    pose proof (T (y u) (y t)). pose proof (T (y t) (y u)). pose proof (norm_swap (y t) (y u)). apply Rabs_def1; lra. }
  apply cont_ext with (fun t => / 2 * (norm (y t) * norm (y t))); [intros; rewrite norm_sq; field|].
  apply cont_scal, cont_mult; auto.
Qed.
Lemma vcont_minus y z : vcont y -> vcont z -> vcont (fun t => minus (y t) (z t)).
Proof.
  intros C D t Ht e He. destruct (C t Ht (e / 2)) as (d1 & H1 & K1); [lra|]. destruct (D t Ht (e / 2)) as (d2 & H2 &
    K2); [lra|].
  smaller d1 d2. intros u Hu Hd. specialize (K1 u Hu ltac:(lra)). specialize (K2 u Hu ltac:(lra)).
  eapply Rle_lt_trans with (norm (minus (y u) (y t)) + norm (minus (z u) (z t))); [|lra].
  pose proof (norm_pos (minus (y u) (y t))). pose proof (norm_pos (minus (z u) (z t))). apply norm_by; [lra|]. intros w.
  pose proof (cauchy (minus (y u) (y t)) w) as C1. pose proof (cauchy_abs (minus (z u) (z t)) w) as C2. apply Rabs_inv
    in C2.
  rewrite !ip_minus in *. lra.
Qed.

Lemma driven_big A G P y t : driven A G P y -> 0 <= t -> big (fun h => norm (minus (P (t + h)) (P t))).
Proof.
  intros [(K & L) _ _] Ht. pose proof (Rabs_pos K). exists (Rabs K + 1), 1. repeat split; try lra. intros h Hh.
  rewrite Rabs_pos_eq by apply norm_pos. specialize (L t (t + h) ltac:(lra)). replace (t + h - t) with h in L by ring.
  pose proof (Rle_abs K). nra.
Qed.

(** *** Two motions: defects add up, and nothing else parts them *)
Section Two.
Variables (A : Y -> Y) (phi : Y -> R) (G P y G' P' y' : R -> Y).
Hypotheses (Mo : monotone A) (H : motion A phi G P y) (H' : motion A phi G' P' y').
Let D t := ip (minus (y t) (y' t)) (minus (y t) (y' t)) / 2.

(** friction is monotone *)
Lemma drags_monotone t : 0 <= t -> forall e, 0 < e -> exists d, 0 < d /\ forall h, 0 < h < d ->
  - e * h <= ip (minus (minus (P (t + h)) (P' (t + h))) (minus (P t) (P' t))) (minus (y t) (y' t)).
Proof.
  intros Ht e He. destruct (proj2 H t Ht (y' t) (e / 2)) as (d1 & H1 & K1); [lra|].
  destruct (proj2 H' t Ht (y t) (e / 2)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros h Hh.
  specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)).
  rewrite ip_minus, (ip_sym _ In _ (minus _ _)), (ip_sym _ In (P t) _), !ip_minus in K1.
  rewrite ip_minus, (ip_sym _ In _ (minus _ _)), (ip_sym _ In (P' t) _), !ip_minus in K2.
  rewrite !ip_minus, !(ip_sym _ In _ (minus _ _)), !ip_minus. lra.
Qed.

(** the rate of the distance *)
Lemma distance_dini t d : 0 <= t -> vderiv (fun r => minus (G r) (G' r)) t d ->
  dini_le D t (ip (plus (minus (A (y t)) (A (y' t))) d) (minus (y t) (y' t))).
Proof.
  intros Ht HG e He. destruct (proj1 H) as [_ _ Ra], (proj1 H') as [_ _ Ra'].
  destruct (energy_increment (fun r => minus (y r) (y' r)) (fun r => minus (P r) (P' r)) t (plus (minus (A (y t)) (A (y'
    t))) d)) with (eps := e / 2) as (d1 & H1 & K1); try lra.
  - intros q Hq. destruct (Ra t Ht (q / 3)) as (c1 & Hc1 & Q1); [lra|]. destruct (Ra' t Ht (q / 3)) as (c2 & Hc2 & Q2);
    [lra|]. destruct (HG (q / 3)) as (c3 & Hc3 & Q3); [lra|]. exists (Rmin c1 (Rmin c2 c3)).
    split; [repeat apply Rmin_glb_lt; auto|]. intros h Hh. pose proof (Rmin_l c1 (Rmin c2 c3)). pose proof (Rmin_r c1
      (Rmin c2 c3)).
    pose proof (Rmin_l c2 c3). pose proof (Rmin_r c2 c3).
    specialize (Q1 h ltac:(lra)). specialize (Q2 h ltac:(lra)). specialize (Q3 h ltac:(lra)).
    match type of Q1 with norm ?a <= _ => set (e1 := a) in * end. match type of Q2 with norm ?a <= _ => set (e2 := a) in
      * end.
    match type of Q3 with norm ?a <= _ => set (e3 := a) in * end.
    apply norm_by; [nra|]. intros w. pose proof (norm_pos w). pose proof (cauchy e1 w). pose proof (cauchy_abs e2 w) as
      C2.
    apply Rabs_inv in C2. pose proof (cauchy e3 w).
    match goal with |- ip ?a w <= _ => replace (ip a w) with (ip e1 w - ip e2 w + ip e3 w) by (unfold e1, e2, e3; lin;
      ring) end.
    nra.
  - destruct (big_plus _ _ (driven_big _ _ _ _ t (proj1 H) Ht) (driven_big _ _ _ _ t (proj1 H') Ht)) as (k & c & Hk & Hc
    & L).
    exists k, c. repeat split; auto. intros h Hh. eapply Rle_trans; [|apply (L h Hh)]. rewrite !Rabs_pos_eq by (repeat
      apply Rplus_le_le_0_compat; apply norm_pos). pose proof (norm_pos (minus (P (t + h)) (P t))).
    pose proof (norm_pos (minus (P' (t + h)) (P' t))). apply norm_by; [lra|]. intros w.
    pose proof (cauchy (minus (P (t + h)) (P t)) w) as C1. pose proof (cauchy_abs (minus (P' (t + h)) (P' t)) w) as C2.
    apply Rabs_inv in C2. rewrite !ip_minus in *. lra.
  - destruct (drags_monotone t Ht (e / 2)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros h Hh.
    specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)).
    cbv beta in K1. apply Rabs_inv in K1. fold (D (t + h)) (D t) in K1. lra.
Qed.

(** [inclusion-defects] Two motions of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, separate by at most the
    integral of the norm of their defects. *)
Theorem defects_add d J r t : (forall u, 0 <= u -> vderiv (fun r => minus (G r) (G' r)) u (d u)) -> cont J ->
  (forall u, 0 <= u -> rderiv J u (norm (d u))) -> 0 <= r <= t ->
  norm (minus (y t) (y' t)) <= norm (minus (y r) (y' r)) + (J t - J r).
Proof.
  intros HG CJ HJ Hr. assert (Q : forall u, norm (minus (y u) (y' u)) = sqrt (2 * D u)) by (intros; unfold norm, D;
    f_equal; field).
  rewrite !Q. apply (root_grows D (fun u => norm (d u)) J); auto.
  - apply (cont_energy (fun u => minus (y u) (y' u))), vcont_minus; [apply (d_cont _ _ _ _ (proj1 H))|apply (d_cont _ _
    _ _ (proj1 H'))].
  - intros u. unfold D. pose proof (ip_pos _ In (minus (y u) (y' u))). lra.
  - intros u Hu. split; [apply norm_pos|split; [apply HJ; lra|]]. intros e He.
    destruct (distance_dini u (d u) ltac:(lra) (HG u ltac:(lra)) e He) as (c & Hc & K). exists c; split; auto.
    intros h Hh. specialize (K h Hh). pose proof (cauchy (d u) (minus (y u) (y' u))). pose proof (Mo (y u) (y' u)).
    rewrite Q, (ip_plus _ In) in *. nra.
Qed.
End Two.

(** [inclusion-contraction] The flow of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, is non-expansive in the energy
    norm. *)
Theorem contracts A phi G P y P' y' r t : monotone A -> motion A phi G P y -> motion A phi G P' y' -> 0 <= r <= t ->
  norm (minus (y t) (y' t)) <= norm (minus (y r) (y' r)).
Proof.
  intros Mo H H' Hr. assert (Z : forall v : Y, norm (minus v v) = 0).
  { intros v. unfold norm. rewrite ip_minus, Rminus_diag_eq, sqrt_0; auto. }
  assert (Zn : forall v : Y, norm (scal 0 v) = 0) by (intros v; unfold norm; rewrite (ip_scal _ In), Rmult_0_l, sqrt_0;
    auto).
  pose proof (defects_add A phi G P y G P' y' Mo H H' (fun _ => scal 0 (y 0)) (fun _ => 0) r t) as Q.
  rewrite Rminus_0_r, Rplus_0_r in Q. apply Q; auto using cont_const.
  - intros u Hu e He. exists 1; split; [lra|]. intros h Hh. replace (norm _) with 0; [nra|]. symmetry. apply
    Rle_antisym; [|apply norm_pos]. apply norm_by; [lra|]. intros w. lin. lra.
  - intros u Hu. rewrite Zn. apply rderiv_const.
Qed.

(** where A parts two states at most at the rate c, so do their motions: a friction that falls with the speed at most at
  the slope l is monotone with l more, and l less of a damper *)
Theorem parts_at_most c A phi G P y P' y' t : 0 <= c ->
  (forall y z, ip (minus (A y) (A z)) (minus y z) <= c * ip (minus y z) (minus y z)) ->
  motion A phi G P y -> motion A phi G P' y' -> 0 <= t ->
  norm (minus (y t) (y' t)) <= exp (c * t) * norm (minus (y 0) (y' 0)).
Proof.
  intros Hc Ac H H' Ht. set (D := fun t => ip (minus (y t) (y' t)) (minus (y t) (y' t)) / 2).
  assert (CD : cont D) by (apply cont_energy, vcont_minus; [apply (d_cont _ _ _ _ (proj1 H))|apply (d_cont _ _ _ _
    (proj1 H'))]).
  assert (Dp : forall u, 0 <= D u) by (intros u; unfold D; pose proof (ip_pos _ In (minus (y u) (y' u))); lra).
  assert (Dd : forall u, 0 <= u -> dini_le D u (2 * c * D u)).
  { intros u Hu e He. assert (Z : vderiv (fun r => minus (G r) (G r)) u (scal 0 (y 0))).
    { intros q Hq. exists 1; split; [lra|]. intros h Hh. apply norm_by; [nra|]. intros w. lin. pose proof (norm_pos w).
      assert (0 <= q * h * norm w) by positive. lra. }
    destruct (distance_dini A phi G P y G P' y' H H' u _ Hu Z e He) as (d & Hd & K). exists d; split; auto. intros h Hh.
    specialize (K h Hh). rewrite (ip_plus _ In), (ip_scal _ In) in K. specialize (Ac (y u) (y' u)). fold (D u) (D (u +
      h)) in K.
    assert (ip (minus (y u) (y' u)) (minus (y u) (y' u)) = 2 * D u) by (unfold D; field). nra. }
  assert (Q : D t <= exp (2 * c * t) * D 0).
  { apply le_epsilon. intros e He. pose proof (exp_pos (2 * c * t)) as Ep. set (q := e / exp (2 * c * t)).
    assert (Hq : 0 < q) by positive. pose proof (log_dini (fun u => D u + q) q (2 * c) t Hq) as L.
    cbv beta in L. replace (exp (2 * c * t) * D 0 + e) with (exp (2 * c * t) * (D 0 + q)) by (unfold q; field; lra).
    apply Rle_trans with (D t + q); [lra|]. apply L; auto; [intros u; specialize (Dp u); lra|apply cont_plus; auto using
      cont_const|].
    intros u Hu p Hp. destruct (Dd u Hu p Hp) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
    assert (0 <= c * q * h) by positive. lra. }
  unfold norm. replace (exp (c * t)) with (sqrt (exp (2 * c * t))).
  2: { replace (2 * c * t) with (c * t + c * t) by ring. rewrite exp_plus. apply sqrt_square, Rlt_le, exp_pos. }
  rewrite <- sqrt_mult by (try apply (ip_pos _ In); apply Rlt_le, exp_pos). apply sqrt_le_1_alt. unfold D in Q. lra.
Qed.

(** *** Whatever brakes synchronises *)
Section Brakes.
Variables (A : Y -> Y) (P y : R -> Y) (beta : R) (f : R -> R).
Hypotheses (Di : forall z, ip (A z) z <= 0) (Hb : 0 < beta) (H : driven A (fun _ => zero) P y)
  (Hf : forall t, 0 <= t -> 0 <= f t) (Br : forall t, 0 <= t -> brakes (beta * f t) P (y t) t).
Let E t := ip (y t) (y t) / 2.

(** the rate of the energy *)
Lemma braked_dini t : 0 <= t -> dini_le E t (- (beta * f t)).
Proof.
  intros Ht e He. pose proof (d_rate _ _ _ _ H) as Ra.
  destruct (energy_increment y P t (A (y t))) with (eps := e / 2) as (d1 & H1 & K1); try lra.
  - intros q Hq. destruct (Ra t Ht q Hq) as (d & Hd & Q). exists d; split; auto. intros h Hh. eapply Rle_trans; [|apply
    (Q h Hh)]. apply norm_by; [apply norm_pos|]. intros w. eapply Rle_trans; [|apply cauchy]. apply Req_le. lin. ring.
  - apply (driven_big _ _ _ _ t H Ht).
  - destruct (Br t Ht (e / 2)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros h Hh. specialize (K1 h ltac:(lra)).
    specialize (K2 h ltac:(lra)).
    cbv beta in K1. apply Rabs_inv in K1. pose proof (Di (y t)). fold (E (t + h)) (E t) in K1. nra.
Qed.

(** T2: the path of the slip costs beta times its length; so it is finite, *)
Theorem path_paid J : cont J -> (forall t, 0 <= t -> rderiv J t (f t)) -> forall r t, 0 <= r <= t -> beta * (J t - J r)
  <= E r - E t.
Proof.
  intros CJ HJ r t Hr. assert (Q : E t + beta * J t <= E r + beta * J r); [|lra].
  apply (dini_mono (fun u => E u + beta * J u)); auto.
  - apply cont_plus; [apply cont_energy, (d_cont _ _ _ _ H)|apply cont_scal; auto].
  - intros u Hu e He. destruct (braked_dini u ltac:(lra) (e / 2)) as (d1 & H1 & K1); [lra|].
    destruct (rderiv_scal beta _ _ _ (HJ u ltac:(lra)) (e / 2)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros h Hh.
    specialize (K1 h ltac:(lra)). specialize (K2 h ltac:(lra)). apply Rabs_inv in K2. nra.
Qed.

Let Ep t : 0 <= t -> 0 <= E t. Proof. intros _. unfold E. pose proof (ip_pos _ In (y t)). lra. Qed.

(** [inclusion-synchronises] Any force that brakes: the path of the slip is at most $E(0)/\beta$ long, what moves no
    faster has a limit at most $E/\beta$ away, and a slip that cannot jump tends to 0. *)
Theorem brakes_synchronise J : cont J -> (forall t, 0 <= t -> rderiv J t (f t)) ->
  (forall t, 0 <= t -> beta * (J t - J 0) <= E 0) /\
  (forall z, (forall r t, 0 <= r <= t -> Rabs (z t - z r) <= J t - J r) -> exists zl,
    (forall t, 0 <= t -> beta * Rabs (z t - zl) <= E t) /\
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> Rabs (z t - zl) <= e) /\
  (forall K, 0 < K -> (forall r t, 0 <= r <= t -> Rabs (f t - f r) <= K * (t - r)) ->
    forall e, 0 < e -> exists T, 0 <= T /\ forall t, T <= t -> f t <= e).
Proof.
  intros CJ HJ. pose proof (path_paid J CJ HJ) as Pay. assert (Em : forall r t, 0 <= r <= t -> E t <= E r).
  { intros r t Hr. apply dini_mono; auto; [apply cont_energy, (d_cont _ _ _ _ H)|]. intros u Hu e He.
    destruct (braked_dini u ltac:(lra) e He) as (d & Hd & K). exists d; split; auto. intros h Hh. specialize (K h Hh).
    specialize (Hf u ltac:(lra)). assert (0 <= beta * f u) by positive. nra. }
  split; [|split].
  - intros t Ht. pose proof (Pay 0 t ltac:(lra)). specialize (Ep t Ht). lra.
  - intros z Hz. apply (paid_converges E beta Ep Em Hb). intros r t Hr. eapply Rle_trans; [|apply Pay; auto].
    apply Rmult_le_compat_l; [lra|auto].
  - intros K HK Lf. apply (paid_vanishes E beta Ep Em Hb f J K); auto.
Qed.
End Brakes.
End Space.
