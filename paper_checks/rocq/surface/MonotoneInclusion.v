(** Dry friction in any number of directions: y' in A y + g - d phi (y), where -A is monotone and phi any function, in a
    space whose inner product gives the energy, |y|^2 / 2. Everything enters by its impulse, so that jumps are allowed;
    the inner product need not be definite. Two motions never part, and defects add up; friction that brakes has a
    finite path. *)
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
Definition vlittle (f : R -> Y) := forall eps, 0 < eps ->
  exists d, 0 < d /\ forall h, 0 < h < d -> norm (f h) <= eps * h.
(** l is the right derivative *)
Definition vderiv (f : R -> Y) t l := vlittle (fun h => minus (minus (f (t + h)) (f t)) (scal h l)).
(** continuity *)
Definition vcont (f : R -> Y) := forall t, 0 <= t -> forall e, 0 < e -> exists d, 0 < d /\
  forall u, 0 <= u -> Rabs (u - t) < d -> norm (minus (f u) (f t)) < e.

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
Proof. rewrite <- (scal_opp_one y). rewrite (ip_scal _ In). unfold opp, one; simpl. ring. Qed.
Lemma ip_minus y z w : ip (minus y z) w = ip y w - ip z w.
Proof. unfold minus. rewrite (ip_plus _ In), ip_opp. ring. Qed.
Lemma ip_zero y : ip zero y = 0.
Proof. pose proof (ip_plus _ In zero zero y) as Q. rewrite plus_zero_l in Q. lra. Qed.
Ltac lin := repeat first [rewrite ip_minus | rewrite (ip_plus _ In) | rewrite (ip_scal _ In) | rewrite ip_zero].

(** Cauchy and Schwarz *)
Lemma cauchy_abs y z : Rabs (ip y z) <= norm y * norm z.
Proof.
  assert (Q : forall p c, 0 <= p ^ 2 * ip y y + 2 * p * c * ip y z + c ^ 2 * ip z z).
  { intros p c. pose proof (ip_pos _ In (plus (scal p y) (scal c z))) as P. rewrite (ip_plus _ In), !(ip_scal _ In),
      !(ip_sym _ In _ (plus _ _)), !(ip_plus _ In), !(ip_scal _ In), (ip_sym _ In z y) in P. lra. }
  pose proof (ip_pos _ In y). pose proof (ip_pos _ In z). unfold norm. rewrite <- sqrt_mult, <- sqrt_Rsqr_abs by auto.
  apply sqrt_le_1_alt. unfold Rsqr. destruct (Req_dec (ip z z) 0) as [Z|N].
  - specialize (Q (ip y z) (- (ip y y + 1) / 2)). rewrite Z in *. nra.
  - specialize (Q (ip z z) (- ip y z)). nra.
Qed.
Lemma cauchy y z : ip y z <= norm y * norm z.
Proof. eapply Rle_trans; [apply Rle_abs|apply cauchy_abs]. Qed.
Lemma norm_pos y : 0 <= norm y. Proof. apply sqrt_pos. Qed.
Lemma norm_sq y : norm y * norm y = ip y y. Proof. apply sqrt_sqrt, (ip_pos _ In). Qed.
(** a norm from what a vector does to the others *)
Lemma norm_by u c : 0 <= c -> (forall w, ip u w <= c * norm w) -> norm u <= c.
Proof. intros Hc K. specialize (K u). rewrite <- norm_sq in K. nra. Qed.
(** the triangle inequality, of what acts on all vectors like a sum or a difference *)
Lemma norm_sum u v w k l : -1 <= k <= 1 -> -1 <= l <= 1 -> (forall z, ip u z = k * ip v z + l * ip w z) ->
  norm u <= norm v + norm w.
Proof.
  intros Hk Hl E. pose proof (norm_pos v). pose proof (norm_pos w). apply norm_by; [lra|]. intros z. rewrite E.
  pose proof (cauchy_abs v z) as A. pose proof (cauchy_abs w z) as B. apply Rabs_inv in A, B. nra.
Qed.
Lemma norm_minus u v : norm (minus u v) <= norm u + norm v.
Proof. apply norm_sum with 1 (-1); [lra|lra|intros; lin; ring]. Qed.
Lemma norm_plus u v : norm (plus u v) <= norm u + norm v.
Proof. apply norm_sum with 1 1; [lra|lra|intros; lin; ring]. Qed.
Lemma norm_scal c u : 0 <= c -> norm (scal c u) <= c * norm u.
Proof.
  intros Hc. apply norm_by; [apply Rmult_le_pos; auto using norm_pos|]. intros w. rewrite (ip_scal _ In), Rmult_assoc.
  apply Rmult_le_compat_l; auto using cauchy.
Qed.
(** a norm that is seen by products *)
Lemma norm_le u v : (forall w, ip u w = ip v w) -> norm u <= norm v.
Proof. intros E. apply norm_by; [apply norm_pos|]. intros w. rewrite E. apply cauchy. Qed.
Lemma vlittle_norm f : vlittle f <-> little (fun h => norm (f h)).
Proof.
  split; intros D e He; apply (soon (D e He)); intros h _; rewrite Rabs_pos_eq by apply norm_pos; auto.
Qed.

(** the increment of the energy *)
Lemma energy_increment y P t l : vderiv (fun r => plus (y r) (P r)) t l ->
  big (fun h => norm (minus (P (t + h)) (P t))) ->
  little (fun h => ip (y (t + h)) (y (t + h)) / 2 - ip (y t) (y t) / 2 - h * ip l (y t) + ip (minus (P (t + h)) (P t))
    (y t)).
Proof.
  intros D LP. set (er := fun h => minus (minus (plus (y (t + h)) (P (t + h))) (plus (y t) (P t)))
    (scal h l)) in D. set (dy := fun h => minus (y (t + h)) (y t)).
  assert (Ey : forall h w, ip (dy h) w = ip (er h) w + h * ip l w - ip (minus (P (t + h)) (P t)) w).
  { intros h w. unfold dy, er. lin. ring. }
  apply vlittle_norm in D. assert (B : big (fun h => norm (dy h))).
  { eapply big_le; [|exact (big_plus _ _ (big_plus _ _ (little_big _ D) (big_scal (norm l) _ big_id)) LP)]. intros h Hh.
    rewrite Rabs_pos_eq by apply norm_pos. eapply Rle_trans; [|apply Rle_abs]. fold (er h).
    pose proof (norm_sum (dy h) (plus (er h) (scal h l)) (minus (P (t + h)) (P t)) 1 (-1) ltac:(lra) ltac:(lra)) as N.
    eapply Rle_trans; [apply N; intros w; rewrite Ey; lin; ring|]. apply Rplus_le_compat_r.
    eapply Rle_trans; [apply norm_plus|]. apply Rplus_le_compat_l. rewrite Rmult_comm. apply norm_scal. lra. }
  assert (E1 : little (fun h => ip (er h) (y t))).
  { eapply little_le; [|exact (little_scal (norm (y t)) _ D)]. intros h _. eapply Rle_trans; [apply cauchy_abs|].
    eapply Rle_trans; [|apply Rle_abs]. fold (er h). lra. }
  eapply little_ext; [|exact (little_plus _ _ E1 (little_scal (/ 2) _ (big_mult _ _ B B)))]. intros h. cbv beta.
  rewrite norm_sq. assert (Q : ip (y (t + h)) (y (t + h)) = ip (y t) (y t) + 2 * ip (dy h) (y t) + ip (dy h) (dy h)).
  { unfold dy. rewrite !ip_minus, !(ip_sym _ In _ (minus _ _)), !ip_minus, (ip_sym _ In (y (t + h)) (y t)). ring. }
  rewrite Q, (Ey h (y t)). field.
Qed.

Lemma cont_energy y : vcont y -> cont (fun t => ip (y t) (y t) / 2).
Proof.
  intros C. assert (N : cont (fun t => norm (y t))).
  { intros t Ht e He. destruct (C t Ht e He) as (d & Hd & K). exists d; split; auto. intros u Hu Hd'.
    specialize (K u Hu Hd'). pose proof (norm_sum (y u) (minus (y u) (y t)) (y t) 1 1) as A.
    pose proof (norm_sum (y t) (minus (y u) (y t)) (y u) (-1) 1) as B.
    apply Rabs_def1; [cut (norm (y u) <= norm (minus (y u) (y t)) + norm (y t)); [lra|apply A]|
      cut (norm (y t) <= norm (minus (y u) (y t)) + norm (y u)); [lra|apply B]]; try lra; intros; lin; ring. }
  apply cont_ext with (fun t => / 2 * (norm (y t) * norm (y t))); [intros; rewrite norm_sq; field|].
  apply cont_scal, cont_mult; auto.
Qed.
Lemma vcont_minus y z : vcont y -> vcont z -> vcont (fun t => minus (y t) (z t)).
Proof.
  intros C D t Ht e He. destruct (C t Ht (e / 2)) as (d1 & H1 & K1); [lra|].
  destruct (D t Ht (e / 2)) as (d2 & H2 & K2); [lra|]. smaller d1 d2. intros u Hu Hd.
  eapply Rle_lt_trans with (norm (minus (y u) (y t)) + norm (minus (z u) (z t))).
  - apply norm_sum with 1 (-1); [lra|lra|]. intros w. lin. ring.
  - specialize (K1 u Hu ltac:(lra)). specialize (K2 u Hu ltac:(lra)). lra.
Qed.

Lemma driven_big A G P y t : driven A G P y -> 0 <= t -> big (fun h => norm (minus (P (t + h)) (P t))).
Proof.
  intros [(K & L) _ _] Ht. pose proof (Rabs_pos K). exists (Rabs K + 1), 1. repeat split; try lra. intros h Hh.
  rewrite Rabs_pos_eq by apply norm_pos. specialize (L t (t + h) ltac:(lra)). pose proof (Rle_abs K). nra.
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
  intros Ht e He.
  apply (soon_both (proj2 H t Ht (y' t) (e / 2) ltac:(lra)) (proj2 H' t Ht (y t) (e / 2) ltac:(lra))).
  intros h _ K1 K2. rewrite ip_minus, (ip_sym _ In _ (minus _ _)), (ip_sym _ In (P t) _), !ip_minus in K1.
  rewrite ip_minus, (ip_sym _ In _ (minus _ _)), (ip_sym _ In (P' t) _), !ip_minus in K2.
  rewrite !ip_minus, !(ip_sym _ In _ (minus _ _)), !ip_minus. lra.
Qed.

(** the rate of the distance *)
Lemma distance_dini t d : 0 <= t -> vderiv (fun r => minus (G r) (G' r)) t d ->
  dini_le D t (ip (plus (minus (A (y t)) (A (y' t))) d) (minus (y t) (y' t))).
Proof.
  intros Ht HG. destruct (proj1 H) as [_ _ Ra], (proj1 H') as [_ _ Ra'].
  apply (dini_increment D t _ _) with (2 := drags_monotone t Ht).
  eapply little_ext; [|refine (energy_increment (fun r => minus (y r) (y' r)) (fun r => minus (P r) (P' r)) t
    (plus (minus (A (y t)) (A (y' t))) d) _ _)].
  - intros h. unfold D. ring.
  - apply vlittle_norm. specialize (Ra t Ht). specialize (Ra' t Ht). apply vlittle_norm in Ra, Ra', HG.
    eapply little_le; [|exact (little_plus _ _ (little_plus _ _ Ra Ra') HG)]. intros h _. cbv beta.
    rewrite Rabs_pos_eq by apply norm_pos. eapply Rle_trans; [|apply Rle_abs].
    eapply Rle_trans; [|apply Rplus_le_compat_r, norm_minus]. apply norm_sum with 1 1; [lra|lra|]. intros w. lin. ring.
  - eapply big_le; [|exact (big_plus _ _ (driven_big _ _ _ _ t (proj1 H) Ht) (driven_big _ _ _ _ t (proj1 H') Ht))].
    intros h _. rewrite Rabs_pos_eq by apply norm_pos. eapply Rle_trans; [|apply Rle_abs].
    apply norm_sum with 1 (-1); [lra|lra|]. intros w. lin. ring.
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
  - intros u Hu. split; [apply norm_pos|split; [apply HJ; lra|]].
    apply dini_weaken with (2 := distance_dini u (d u) ltac:(lra) (HG u ltac:(lra))).
    pose proof (cauchy (d u) (minus (y u) (y' u))). pose proof (Mo (y u) (y' u)). rewrite Q, (ip_plus _ In) in *. lra.
Qed.
End Two.

(** one drive *)
Lemma no_defect (G : R -> Y) t : vderiv (fun r => minus (G r) (G r)) t zero.
Proof.
  intros q Hq. exists 1; split; [lra|]. intros h Hh. apply norm_by; [nra|]. intros w. lin. pose proof (norm_pos w).
  assert (0 <= q * h * norm w) by positive. lra.
Qed.

(** [inclusion-contraction] The flow of $y'\in Ay+g-\partial\varphi(y)$, $-A$ monotone, is non-expansive in the energy
    norm. *)
Theorem contracts A phi G P y P' y' r t : monotone A -> motion A phi G P y -> motion A phi G P' y' -> 0 <= r <= t ->
  norm (minus (y t) (y' t)) <= norm (minus (y r) (y' r)).
Proof.
  intros Mo H H' Hr. pose proof (defects_add A phi G P y G P' y' Mo H H' (fun _ => zero) (fun _ => 0) r t) as Q.
  rewrite Rminus_0_r, Rplus_0_r in Q. apply Q; auto using cont_const, no_defect. intros u Hu. unfold norm.
  rewrite ip_zero, sqrt_0. apply rderiv_const.
Qed.

(** where A parts two states at most at the rate c, so do their motions: a friction that falls with the speed at most at
  the slope l is monotone with l more, and l less of a damper *)
Theorem parts_at_most c A phi G P y P' y' t : 0 <= c ->
  (forall y z, ip (minus (A y) (A z)) (minus y z) <= c * ip (minus y z) (minus y z)) ->
  motion A phi G P y -> motion A phi G P' y' -> 0 <= t ->
  norm (minus (y t) (y' t)) <= exp (c * t) * norm (minus (y 0) (y' 0)).
Proof.
  intros Hc Ac H H' Ht. set (D := fun t => ip (minus (y t) (y' t)) (minus (y t) (y' t)) / 2).
  assert (Q : D t <= exp (2 * c * t) * D 0).
  { apply in_proportion; auto.
    - apply cont_energy, vcont_minus; [apply (d_cont _ _ _ _ (proj1 H))|apply (d_cont _ _ _ _ (proj1 H'))].
    - intros u Hu. apply dini_weaken with (2 := distance_dini A phi G P y G P' y' H H' u _ Hu (no_defect G u)).
      rewrite (ip_plus _ In), ip_zero. specialize (Ac (y u) (y' u)). unfold D. lra. }
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
  intros Ht. apply dini_weaken with (ip (A (y t)) (y t) - beta * f t); [specialize (Di (y t)); lra|].
  apply (dini_increment E t _ (fun h => ip (minus (P (t + h)) (P t)) (y t) - beta * f t * h)).
  - eapply little_ext; [|refine (energy_increment y P t (A (y t)) _ (driven_big _ _ _ _ t H Ht))].
    + intros h. unfold E. ring.
    + intros q Hq. apply (soon (d_rate _ _ _ _ H t Ht q Hq)). intros h _. apply Rle_trans, norm_le. intros w.
      lin. ring.
  - intros e He. apply (soon (Br t Ht e He)). intros h _ K. lra.
Qed.

(** T2: the path of the slip costs beta times its length; so it is finite, *)
Theorem path_paid J : cont J -> (forall t, 0 <= t -> rderiv J t (f t)) -> forall r t, 0 <= r <= t -> beta * (J t - J r)
  <= E r - E t.
Proof.
  intros CJ HJ r t. apply (paid_along E beta f J); auto using braked_dini. apply cont_energy, (d_cont _ _ _ _ H).
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
  { intros r t Hr. apply dini_mono; auto; [apply cont_energy, (d_cont _ _ _ _ H)|]. intros u Hu.
    apply dini_weaken with (2 := braked_dini u ltac:(lra)). specialize (Hf u ltac:(lra)).
    assert (0 <= beta * f u) by positive. lra. }
  split; [|split].
  - intros t Ht. pose proof (Pay 0 t ltac:(lra)). specialize (Ep t Ht). lra.
  - intros z Hz. apply (paid_converges E beta Ep Em Hb). intros r t Hr. eapply Rle_trans; [|apply Pay; auto].
    apply Rmult_le_compat_l; [lra|auto].
  - intros K HK Lf. apply (paid_vanishes E beta Ep Em Hb f J K); auto.
Qed.
End Brakes.
End Space.
